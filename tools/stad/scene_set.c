/* SPDX-License-Identifier: MIT
 * stad/scene_set.c - the pairs with truth that a search is scored on. */
#include "scene_set.h"

#include <cjson/cJSON.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/truth_marks.h"

#define LIST_SCENES 10000

static int set_alloc(scene_set *s, int count, tool_fail *f)
{
    s->scene = calloc((size_t)count, sizeof *s->scene);
    s->owned = calloc((size_t)count * 4, sizeof *s->owned);
    if (!s->scene || !s->owned)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for %d scenes", count);
    s->count = count;
    for (int i = 0; i < count; i++)
        s->scene[i].min_disparity = INT_MAX;
    return TOOL_OK;
}

int scene_set_single(scene_set *s, tool_fail *f)
{
    memset(s, 0, sizeof *s);
    return set_alloc(s, 1, f);
}

/* `name` in the folder of `list`, owned by the set. */
static const char *path_beside(scene_set *s, const char *list, const char *name)
{
    const char *slash = strrchr(list, '/');
    size_t folder = name[0] == '/' || !slash ? 0 : (size_t)(slash - list) + 1;
    char *path = malloc(folder + strlen(name) + 1);
    if (!path)
        return NULL;
    memcpy(path, list, folder);
    strcpy(path + folder, name);
    s->owned[s->owned_count++] = path;
    return path;
}

static int take_path(scene_set *s, const cJSON *item, const char *list, int i, const char *key, const char **path, tool_fail *f)
{
    const cJSON *name = cJSON_GetObjectItemCaseSensitive(item, key);
    if (!name && strcmp(key, "mask") == 0)
        return TOOL_OK;
    if (!cJSON_IsString(name))
        return tool_fail_set(f, TOOL_FILE, "%s: scene %d has no file name \"%s\"", list, i, key);
    *path = path_beside(s, list, name->valuestring);
    return *path ? TOOL_OK : tool_fail_set(f, TOOL_FILE, "%s: not enough memory", list);
}

static int take_scale(const cJSON *item, const char *list, int i, const char *truth, double *scale, tool_fail *f)
{
    const cJSON *number = cJSON_GetObjectItemCaseSensitive(item, "truth_scale");
    if (!number)
        return TOOL_OK;
    if (!cJSON_IsNumber(number) || !(number->valuedouble >= 1e-3 && number->valuedouble <= 65536))
        return tool_fail_set(f, TOOL_FILE, "%s: scene %d: \"truth_scale\" must be a number in 0.001..65536", list, i);
    if (!truth_has_scale(truth))
        return tool_fail_set(f, TOOL_FILE, "%s: scene %d: \"truth_scale\" has no effect: %s holds pixels", list, i, truth);
    *scale = number->valuedouble;
    return TOOL_OK;
}

/* A whole number in lo..2047, which is as far as disparities reach. */
static int take_whole(const cJSON *item, const char *list, int i, const char *key, int lo, int *v, tool_fail *f)
{
    const cJSON *number = cJSON_GetObjectItemCaseSensitive(item, key);
    if (!number)
        return TOOL_OK;
    const double value = cJSON_IsNumber(number) ? number->valuedouble : 0.5;
    if (!(value >= lo && value <= 2047) || floor(value) != value)
        return tool_fail_set(f, TOOL_FILE, "%s: scene %d: \"%s\" must be a whole number in %d..2047", list, i, key, lo);
    *v = (int)value;
    return TOOL_OK;
}

static int is_key(const char *name)
{
    static const char *const keys[] = {"left", "right", "truth", "mask", "truth_scale", "min_disparity", "num_disparities"};
    for (size_t i = 0; i < sizeof keys / sizeof keys[0]; i++)
        if (strcmp(keys[i], name) == 0)
            return 1;
    return 0;
}

/* Nothing that would be passed over in silence: a key that is unknown, or there twice. */
static int check_keys(const cJSON *item, const char *list, int i, tool_fail *f)
{
    if (!cJSON_IsObject(item))
        return tool_fail_set(f, TOOL_FILE, "%s: scene %d is no JSON object", list, i);
    for (const cJSON *member = item->child; member; member = member->next) {
        if (!is_key(member->string))
            return tool_fail_set(f, TOOL_FILE, "%s: scene %d: \"%s\" is no key of a scene", list, i, member->string);
        if (cJSON_GetObjectItemCaseSensitive(item, member->string) != member)
            return tool_fail_set(f, TOOL_FILE, "%s: scene %d: \"%s\" is there twice", list, i, member->string);
    }
    return TOOL_OK;
}

static int take_scene(scene_set *s, const cJSON *item, const char *list, int i, tool_fail *f)
{
    scored_scene *c = &s->scene[i];
    int status = check_keys(item, list, i, f);
    if (status == TOOL_OK)
        status = take_path(s, item, list, i, "left", &c->left_path, f);
    if (status == TOOL_OK)
        status = take_path(s, item, list, i, "right", &c->right_path, f);
    if (status == TOOL_OK)
        status = take_path(s, item, list, i, "truth", &c->truth_path, f);
    if (status == TOOL_OK)
        status = take_path(s, item, list, i, "mask", &c->mask_path, f);
    if (status == TOOL_OK)
        status = take_scale(item, list, i, c->truth_path, &c->truth_scale, f);
    if (status == TOOL_OK)
        status = take_whole(item, list, i, "min_disparity", -2047, &c->min_disparity, f);
    if (status == TOOL_OK)
        status = take_whole(item, list, i, "num_disparities", 1, &c->num_disparities, f);
    return status;
}

int scene_set_list(scene_set *s, const char *path, tool_fail *f)
{
    memset(s, 0, sizeof *s);
    cJSON *list = json_read(path, f);
    if (!list)
        return f->status;
    int status = TOOL_OK, count = cJSON_GetArraySize(list);
    if (!cJSON_IsArray(list) || count < 1 || count > LIST_SCENES)
        status = tool_fail_set(f, TOOL_FILE, "%s: not a JSON array of 1..%d scenes", path, LIST_SCENES);
    else
        status = set_alloc(s, count, f);
    for (int i = 0; i < count && status == TOOL_OK; i++)
        status = take_scene(s, cJSON_GetArrayItem(list, i), path, i, f);
    cJSON_Delete(list);
    return status;
}

static int read_scene(scored_scene *c, int color, tool_fail *f)
{
    int status = engine_read_pair(&c->left, &c->right, c->left_path, c->right_path, color, f);
    if (status || c->fiducials)
        return status;
    status = truth_read(&c->truth, c->truth_path, c->truth_scale, c->min_disparity == INT_MAX ? 0 : c->min_disparity, f);
    if (status == TOOL_OK && c->mask_path)
        status = truth_mask(&c->truth, c->mask_path, f);
    if (status == TOOL_OK && (c->truth.width != c->left.width || c->truth.height != c->left.height))
        status = tool_fail_set(f, TOOL_USAGE, "%s is %d x %d, the images are %d x %d", c->truth_path, c->truth.width,
                               c->truth.height, c->left.width, c->left.height);
    return status;
}

int scene_set_read(scene_set *s, int color, tool_fail *f)
{
    int status = TOOL_OK;
    for (int i = 0; i < s->count && status == TOOL_OK; i++)
        status = read_scene(&s->scene[i], color, f);
    return status;
}

void scene_set_free(scene_set *s)
{
    for (int i = 0; i < s->count; i++) {
        picture_free(&s->scene[i].left);
        picture_free(&s->scene[i].right);
        truth_free(&s->scene[i].truth);
        disparity_free(&s->scene[i].disp);
        disparity_free(&s->scene[i].best);
        bad_bounds_free(&s->scene[i].bounds);
        engine_close(&s->scene[i].engine);
    }
    for (int i = 0; i < s->owned_count; i++)
        free(s->owned[i]);
    free(s->owned);
    free(s->scene);
    memset(s, 0, sizeof *s);
}

int scene_find_truth(scored_scene *c, const stad_camera *camera, tool_fail *f)
{
    char names[256];
    if (!c->fiducials)
        return TOOL_OK;
    snprintf(names, sizeof names, "%.120s, %.120s", c->left_path, c->right_path);
    return truth_from_marks(&c->truth, &c->left, &c->right, &c->base, camera, names, f);
}

/* `bad` needs no more than how many pixels are wrong or missing; the other costs take all counts. */
static int count(scored_scene *c, stad_score *score, tool_fail *f)
{
    if (score->config.cost != STAD_SCORE_BAD) {
        measure_feed(score, &c->disp, &c->truth);
        return TOOL_OK;
    }
    int status = c->bounds.least ? TOOL_OK : bad_bounds_make(&c->bounds, &c->truth, &score->config, f);
    if (status)
        return status;
    score->counts.visible = c->bounds.visible;
    score->counts.wrong_visible = bad_bounds_count(&c->bounds, &c->disp);
    return TOOL_OK;
}

int scene_cost(scored_scene *c, const stad_params *p, const scoring *how, int32_t *cost_q20, tool_fail *f)
{
    stad_score score;
    stad_score_config config;
    *cost_q20 = STAD_COST_FAILED;
    if (stad_params_check(p, how->mode, c->left.width, NULL) != STAD_OK)
        return TOOL_OK;
    int status = engine_run(&c->engine, p, &c->left, &c->right, &c->disp, NULL, f);
    if (status)
        return status;
    stad_score_config_init(&config, how->cost, p->min_disparity, p->num_disparities);
    config.threshold_q16 = (int32_t)(how->threshold * 65536 + 0.5);
    if (stad_score_begin(&score, &config) != STAD_OK)
        return tool_fail_set(f, TOOL_USAGE, "the scorer refuses min_disparity %d, num_disparities %d, threshold %g",
                             p->min_disparity, p->num_disparities, how->threshold);
    status = count(c, &score, f);
    *cost_q20 = status ? STAD_COST_FAILED : stad_score_end(&score);
    engine_share_judge(&c->engine.share, *cost_q20);
    return status;
}

void scene_keep(scored_scene *c)
{
    disparity last = c->disp;
    c->disp = c->best;
    c->best = last;
}
