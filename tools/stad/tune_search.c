/* SPDX-License-Identifier: MIT
 * stad/tune_search.c - the loop of `stad tune`: ask, match, score, tell. */
#include <limits.h>
#include <stdio.h>
#include <string.h>

#include "interrupt.h"
#include "tool.h"
#include "tune_job.h"

static int scene_channels(const tune_job *j)
{
    return j->options.color ? 3 : 1;
}

static void take_range(params_some *some, const char *list, const scored_scene *c)
{
    params_some its;
    params_some_init(&its);
    its.value[FIELD_MIN_DISPARITY] = c->min_disparity;
    its.value[FIELD_NUM_DISPARITIES] = c->num_disparities;
    its.given = (c->min_disparity != INT_MAX ? 1u << FIELD_MIN_DISPARITY : 0u) |
                (c->num_disparities > 0 ? 1u << FIELD_NUM_DISPARITIES : 0u);
    its.path[FIELD_MIN_DISPARITY] = its.path[FIELD_NUM_DISPARITIES] = list;
    params_some_merge(some, &its);
}

/* What a scene starts from: the chosen set, then the file's values, then options and --start's (never both of a field), then what
 * the list says of this scene. */
static int base_of(const tune_job *j, scored_scene *c, tool_fail *f)
{
    params_some some = j->options.some;
    params_some_merge(&some, &j->start);
    take_range(&some, j->list, c);
    params_from_some(&c->base, &some, c->left.width, scene_channels(j));
    if (j->from == 'd') {
        stad_params_default(&c->base, c->base.num_disparities);
        for (int i = 0; i < FIELD_COUNT; i++)
            if (some.given >> i & 1)
                params_set(&c->base, i, some.value[i]);
    }
    tool_fail why;
    int status = params_check_text(&c->base, &some, j->how.mode, c->left.width, &why);
    if (status && j->list)
        return tool_fail_set(f, status, "scene %d: %.550s", (int)(c - j->set.scene), why.text);
    return status ? tool_fail_set(f, status, "%.550s", why.text) : TOOL_OK;
}

static stad_point point_of(const stad_params *p)
{
    stad_point x;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        x.v[i] = (int16_t)params_get(p, tune_field(i));
    return x;
}

static stad_params params_at(const stad_params *base, const stad_point *x)
{
    stad_params p = *base;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        params_set(&p, tune_field(i), x->v[i]);
    return p;
}

/* The library's bounds, widened to hold the start. */
static void configure(const tune_job *j, stad_tune_config *c, const stad_point *start)
{
    int purpose = j->how.cost == STAD_SCORE_BAD || j->how.cost == STAD_SCORE_D1 ? STAD_TUNE_FOR_BAD
                  : j->how.cost == STAD_SCORE_CHOW                              ? STAD_TUNE_FOR_CHOW
                                                                                : STAD_TUNE_FOR_ANY;
    stad_tune_config_stereo(c, purpose);
    c->method = (uint8_t)j->method;
    for (int i = 0; i < c->ladder_count && j->options.color; i++) { /* its points are for grey frames */
        c->ladder[i].v[STAD_TUNE_P1] = (int16_t)(3 * c->ladder[i].v[STAD_TUNE_P1]);
        c->ladder[i].v[STAD_TUNE_P2] = (int16_t)(3 * c->ladder[i].v[STAD_TUNE_P2]);
    }
    if (j->free_mask)
        c->free_mask = (uint8_t)j->free_mask;
    if (j->how.cost == STAD_SCORE_BAD) /* whether winners are kept or not: the same points */
        c->cheap_mask = 1u << STAD_TUNE_UNIQUENESS_RATIO | 1u << STAD_TUNE_DISP12_MAX_DIFF;
    c->seed = (uint32_t)j->seed;
    if (j->max_evals)
        c->budget = (int16_t)j->max_evals;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        if (start->v[i] < c->axis[i].lo)
            c->axis[i].lo = start->v[i];
        if (start->v[i] > c->axis[i].hi)
            c->axis[i].hi = start->v[i];
    }
}

/* A matcher with room for every point that the search may ask for. */
static int open_engine(const tune_job *j, scored_scene *c, const stad_tune_config *config, tool_fail *f)
{
    stad_geometry g = engine_geometry(&c->base, j->how.mode, j->how.memory, c->left.width, c->left.height, c->left.channels);
    g.max_block_size = config->axis[STAD_TUNE_BLOCK_SIZE].hi;
    g.max_p2 = config->axis[STAD_TUNE_P2].hi;
    g.max_pre_filter_cap = config->axis[STAD_TUNE_PRE_FILTER_CAP].hi;
    int status = engine_open(&c->engine, &g, f);
    return status ? status : engine_keep(&c->engine, (int)j->share, f);
}

/* Truth that no parameters can reach is worth a word; none that they can, an error. */
static int note_range(const scored_scene *c, tool_fail *f)
{
    int32_t low = c->base.min_disparity * 65536, high = low + (c->base.num_disparities - 1) * 65536;
    size_t n = (size_t)c->truth.width * (size_t)c->truth.height, seen = 0, outside = 0;
    for (size_t i = 0; i < n; i++)
        if (c->truth.label[i] == STAD_LABEL_VISIBLE) {
            seen++;
            outside += c->truth.q16[i] < low || c->truth.q16[i] > high;
        }
    tool_fail note = {0};
    if (outside * 100 < seen || outside == 0)
        return TOOL_OK;
    if (outside == seen)
        return tool_fail_set(f, TOOL_USAGE, "%s: all of its truth lies outside the disparities searched, %d .. %d", c->left_path,
                             c->base.min_disparity, c->base.min_disparity + c->base.num_disparities - 1);
    tool_fail_set(&note, TOOL_OK, ": %.1f %% of its truth lies outside the disparities searched, %d .. %d",
                  100.0 * (double)outside / (double)seen, c->base.min_disparity,
                  c->base.min_disparity + c->base.num_disparities - 1);
    tool_note("stad tune", c->left_path, &note);
    return TOOL_OK;
}

static int take_base(const tune_job *j, scored_scene *c, tool_fail *f)
{
    stad_camera camera = tool_camera(j->rig.focal_px, j->cx, j->cy, c->left.width, c->left.height);
    int status = base_of(j, c, f);
    if (status == TOOL_OK)
        status = scene_find_truth(c, &camera, f);
    if (status == TOOL_OK)
        status = note_range(c, f);
    return status;
}

static int prepare(tune_job *j, tool_fail *f)
{
    stad_tune_config config;
    const char *culprit = NULL;
    int status = scene_set_read(&j->set, j->options.color, f);
    for (int i = 0; i < j->set.count && status == TOOL_OK; i++)
        status = take_base(j, &j->set.scene[i], f);
    if (status)
        return status;
    stad_point start = point_of(&j->set.scene[0].base);
    configure(j, &config, &start);
    if (stad_tune_config_check(&config, &culprit) != STAD_OK || stad_tune_init(&j->tune, &config, &start) != STAD_OK)
        return tool_fail_set(f, TOOL_USAGE, "the tuner refuses %s", culprit ? culprit : "its configuration");
    for (int i = 0; i < j->set.count && status == TOOL_OK; i++)
        status = open_engine(j, &j->set.scene[i], &config, f);
    return status;
}

/* The mean cost over the scenes; a scene that cannot be matched so fails the point. */
static int cost_at(tune_job *j, const stad_point *x, int32_t *cost_q20, tool_fail *f)
{
    int64_t sum = 0;
    for (int i = 0; i < j->set.count; i++) {
        stad_params p = params_at(&j->set.scene[i].base, x);
        int32_t cost;
        int status = scene_cost(&j->set.scene[i], &p, &j->how, &cost, f);
        if (status)
            return status;
        if (cost == STAD_COST_FAILED) {
            *cost_q20 = STAD_COST_FAILED;
            return TOOL_OK;
        }
        sum += cost;
    }
    *cost_q20 = (int32_t)((sum + j->set.count / 2) / j->set.count);
    return TOOL_OK;
}

static void keep_all(tune_job *j)
{
    for (int i = 0; i < j->set.count; i++)
        scene_keep(&j->set.scene[i]);
}

/* Every measure at the point whose maps are kept, means over the scenes. */
static int describe(tune_job *j, const stad_point *x, int32_t cost_q20, tune_point *at, tool_fail *f)
{
    int status = TOOL_OK;
    *at = (tune_point){.params = params_at(&j->set.scene[0].base, x), .cost = (double)cost_q20 / STAD_COST_ONE};
    for (int i = 0; i < j->set.count && status == TOOL_OK; i++) {
        const scored_scene *c = &j->set.scene[i];
        measures m;
        status = measure_at(&m, &c->best, &c->truth, c->base.num_disparities, j->how.threshold, f);
        at->bad += m.bad_at_threshold / j->set.count;
        at->chow += m.chow / j->set.count;
        at->rmse += m.rmse / j->set.count;
        at->density += m.density / j->set.count;
    }
    return status;
}

/* The first point, which the search asks for again if it lies on its lattice. */
static int take_start(tune_job *j, const stad_point *x, int32_t *cost_q20, tool_fail *f)
{
    int status = cost_at(j, x, cost_q20, f);
    if (status == TOOL_OK && *cost_q20 == STAD_COST_FAILED)
        status = tool_fail_set(f, TOOL_USAGE,
                               "no pixel of a scene can be scored: the truth lies left of column min + num disparities");
    if (status)
        return status;
    keep_all(j);
    return describe(j, x, *cost_q20, &j->first, f);
}

static void show_progress(const tune_job *j, int32_t best)
{
    stad_tune_counts n = stad_tune_counts_of(&j->tune);
    progress_line("%3d / %d evaluations, %s %.3f %%", n.evaluations, j->tune.config.budget, tune_cost_name(j->how.cost),
                  100.0 * best / STAD_COST_ONE);
}

/* Asks, evaluates and tells until the search ends, or a signal ends it. The start as it was given, which the lattice may not
 * hold, is the best until something costs less; of equals the earliest. The maps of the best are kept. */
static int run(tune_job *j, const stad_point *start, int32_t start_cost, tool_fail *f)
{
    int32_t best = start_cost;
    stad_point x, best_x = *start;
    while (!interrupt_seen() && stad_tune_ask(&j->tune, &x) == 1) {
        const int known = memcmp(&x, start, sizeof x) == 0;
        int32_t cost = start_cost;
        int status = known ? TOOL_OK : cost_at(j, &x, &cost, f);
        if (status)
            return status;
        stad_tune_tell(&j->tune, cost);
        if (cost < best) {
            best = cost;
            best_x = x;
            keep_all(j);
        }
        show_progress(j, best);
    }
    return describe(j, &best_x, best, &j->best, f);
}

int tune_search(tune_job *j, tool_fail *f)
{
    double begin = tool_seconds();
    int32_t cost;
    int status = prepare(j, f);
    if (status)
        return status;
    interrupt_watch();
    stad_point start = point_of(&j->set.scene[0].base);
    status = take_start(j, &start, &cost, f);
    if (status == TOOL_OK)
        status = run(j, &start, cost, f);
    if (status == TOOL_OK && interrupt_seen())
        snprintf(j->stopped, sizeof j->stopped, "interrupted after %d of %d evaluations",
                 stad_tune_counts_of(&j->tune).evaluations, j->tune.config.budget);
    j->seconds = tool_seconds() - begin;
    interrupt_leave();
    progress_end();
    return status;
}
