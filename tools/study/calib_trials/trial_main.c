/* SPDX-License-Identifier: MIT
 * calib_trials/trial_main.c - one open scene under one kind of degradation: the loop with each rule, beside ncg on the scene's own truth.
 *
 *     calib-trial LEFT RIGHT DISPARITY NUM_DISPARITIES KIND SEED [MASK|-] [FULL_EVALUATIONS]
 *
 * Prints one line of JSON. Bad shares in percent, over the scene outside the target. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "trial.h"

#define MAX_BLOCK 11
#define MAX_P2    8192
#define MAX_CAP   127

typedef struct bench {
    trial_scene scene;
    trial_frame frame[2];
    engine engine;
    stad_geometry geometry;
    stad_setup start;
    void *work;
    size_t work_bytes;
    unsigned seed;
    int judge_pixels; /* of truth on the other pose */
} bench;

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

static void set_up(bench *b)
{
    tool_fail f;
    const trial_scene *s = &b->scene;
    stad_geometry g = {(int16_t)s->width, (int16_t)s->height, 1, (int16_t)s->disparities, MAX_BLOCK, MAX_P2, MAX_CAP,
                       STAD_MODE_SGBM,    STAD_MEMORY_FAST};
    b->geometry = g;
    if (engine_open(&b->engine, &g, &f) != TOOL_OK) {
        fprintf(stderr, "%s\n", f.text);
        exit(f.status);
    }
    b->work_bytes = larger(stad_calib_frame_bytes(s->width, s->height), stad_calib_evaluate_bytes(&g)) + STAD_ALIGN;
    b->work_bytes = b->work_bytes / STAD_ALIGN * STAD_ALIGN;
    void *work = NULL;
    if (posix_memalign(&work, STAD_ALIGN, b->work_bytes) != 0)
        exit(TOOL_FILE);
    b->work = work;
    memset(&b->start, 0, sizeof b->start);
    b->start.width = g.width;
    b->start.height = g.height;
    b->start.channels = 1;
    stad_params_sample(&b->start.params, s->disparities, 3, 1);
    stad_rig_identity(&b->start.rig, g.width, g.height);
}

static void show(const bench *b, stad_calib *c, int which)
{
    const stad_image left = picture_view(&b->frame[which].left), right = picture_view(&b->frame[which].right);
    const int status = stad_calib_frame(c, &left, &right, b->work, b->work_bytes);
    if (status < 0)
        fprintf(stderr, "frame %d: %s, fault %d\n", which, stad_status_name(status), stad_calib_report_of(c)->fault);
}

/* Set in use and presets: cost on the tuning pose, on the other pose, bad share of the rest; percent. */
static double rest_bad(bench *b, const stad_params *p);

static void print_ladder(bench *b, stad_calib *c)
{
    static stad_evaluator evaluator;
    stad_request r;
    stad_point x;
    stad_calib_want(c, &r);
    for (int i = -1; i < STAD_PRESETS; i++) {
        double q[2];
        if (i >= 0) {
            stad_calib_preset(i, 1, &x, NULL);
            r.params.p1 = x.v[STAD_TUNE_P1];
            r.params.p2 = x.v[STAD_TUNE_P2];
            r.params.block_size = x.v[STAD_TUNE_BLOCK_SIZE];
            r.params.uniqueness_ratio = x.v[STAD_TUNE_UNIQUENESS_RATIO];
            r.params.pre_filter_cap = (int16_t)(x.v[STAD_TUNE_PRE_FILTER_CAP] | 1);
            r.params.disp12_max_diff = x.v[STAD_TUNE_DISP12_MAX_DIFF];
        }
        for (int hold = 0; hold < 2; hold++) {
            const stad_image left = picture_view(&b->frame[hold].left), right = picture_view(&b->frame[hold].right);
            r.hold = (uint8_t)hold;
            r.box = c->pose[hold].box;
            q[hold] = stad_calib_evaluate(c, &r, &evaluator, &left, &right, b->work, b->work_bytes) / 10485.76;
        }
        printf("%s[%.4f, %.4f, %.4f]", i < 0 ? "\"ladder\": [" : ", ", q[0], q[1], rest_bad(b, &r.params));
    }
    printf("], ");
}

/* Runs the loop to its end; with `ladder` set, prints what the presets are worth when the trial begins. */
static stad_calib_report run(bench *b, int rule, int tunes, int ladder, stad_params *adopted)
{
    static stad_calib c;
    static stad_evaluator evaluator;
    stad_calib_config config;
    stad_request r;
    target_camera camera = trial_camera(&b->scene);
    stad_camera fixed = target_camera_fixed(&camera);
    stad_calib_config_default(&config, &b->geometry, stad_target_relief(), &fixed);
    config.rule = (uint8_t)rule;
    config.tunes = (uint8_t)tunes;
    config.probation_frames = 0;
    config.still = 1;
    config.patience = 8; /* confirming a correction takes frames at rest */
    if (getenv("STAD_PENALTY"))
        config.penalty_q16 = (int32_t)(atof(getenv("STAD_PENALTY")) * 65536);
    if (stad_calib_init(&c, &config, &b->start) != STAD_OK)
        exit(2);
    stad_calib_start(&c);
    while (stad_calib_want(&c, &r) != STAD_WANT_NOTHING) {
        if (r.want == STAD_WANT_FRAME) {
            show(b, &c, r.hold);
        } else if (r.want == STAD_WANT_MATCH) {
            if (ladder)
                print_ladder(b, &c);
            ladder = 0;
            const stad_image left = picture_view(&b->frame[r.hold].left), right = picture_view(&b->frame[r.hold].right);
            stad_calib_cost(&c, stad_calib_evaluate(&c, &r, &evaluator, &left, &right, b->work, b->work_bytes));
        } else {
            stad_calib_saved(&c, 0);
        }
    }
    *adopted = stad_calib_setup(&c)->params;
    b->judge_pixels = stad_truth_pixels(&c.pose[1].truth);
    return *stad_calib_report_of(&c);
}

static void print_params(const char *name, const stad_params *p)
{
    printf("\"%s_params\": [%d, %d, %d, %d, %d, %d], ", name, p->p1, p->p2, p->block_size, p->uniqueness_ratio, p->pre_filter_cap,
           p->disp12_max_diff);
}

/* The rest, seen through both poses' frames: their mean. */
static double rest_bad(bench *b, const stad_params *p)
{
    return (trial_bad(&b->engine, &b->scene, &b->frame[0], p, NULL) + trial_bad(&b->engine, &b->scene, &b->frame[1], p, NULL)) /
           2;
}

static void try_rule(bench *b, const char *name, int rule, int tunes)
{
    stad_params p = b->start.params;
    stad_calib_report r = run(b, rule, tunes, rule == STAD_RULE_DEFAULT && !tunes, &p);
    print_params(name, &p);
    printf("\"%s\": {\"bad\": %.4f, \"outcome\": %d, \"fault\": %d, \"evaluations\": %d, \"preset\": %d, "
           "\"tuned\": %d, "
           "\"tune\": [%.3f, %.3f], \"judge\": [%.3f, %.3f], \"verdict\": %d, \"worst_px\": %.3f}, ",
           name, rest_bad(b, &p), r.outcome, r.fault, r.evaluations, r.preset, r.tuned, r.tune_before_q20 / 10485.76,
           r.tune_after_q20 / 10485.76, r.judge_before_q20 / 10485.76, r.judge_after_q20 / 10485.76, r.verdict_before,
           r.rig.worst_q8 / 256.0);
}

/* What the scene's own truth would give: ncg on the rest of pose 0, scored like everything else. */
static void try_full(bench *b, int evaluations)
{
    static stad_tune t;
    stad_tune_config config;
    stad_point x;
    stad_params p = b->start.params;
    int32_t cost;
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_BAD);
    config.budget = (int16_t)evaluations;
    const stad_point start = {{p.p1, p.p2, p.block_size, p.uniqueness_ratio, p.pre_filter_cap, p.disp12_max_diff}};
    if (stad_tune_init(&t, &config, &start) != STAD_OK)
        exit(2);
    for (;;) {
        const int more = stad_tune_ask(&t, &x);
        if (!more)
            stad_tune_best(&t, &x, &cost);
        p.p1 = x.v[0];
        p.p2 = x.v[1];
        p.block_size = x.v[2];
        p.uniqueness_ratio = x.v[3];
        p.pre_filter_cap = (int16_t)(x.v[4] | 1);
        p.disp12_max_diff = x.v[5];
        if (!more)
            break;
        cost = STAD_COST_FAILED;
        trial_bad(&b->engine, &b->scene, &b->frame[0], &p, &cost);
        stad_tune_tell(&t, cost);
    }
    print_params("full", &p);
    printf("\"full\": {\"bad\": %.4f, \"evaluations\": %d}, ", rest_bad(b, &p), stad_tune_counts_of(&t).evaluations);
}

int main(int argc, char **argv)
{
    static bench b;
    tool_fail f = {0, ""};
    if (argc < 7) {
        fprintf(stderr, "usage: calib-trial LEFT RIGHT DISPARITY NUM_DISPARITIES KIND SEED [MASK|-] "
                        "[FULL_EVALUATIONS]\n");
        return TOOL_USAGE;
    }
    const int kind = atoi(argv[5]);
    b.seed = (unsigned)strtoul(argv[6], NULL, 10);
    if (trial_read(&b.scene, argv[1], argv[2], argv[3], argc > 7 && strcmp(argv[7], "-") ? argv[7] : NULL, atoi(argv[4]), &f) !=
        TOOL_OK) {
        fprintf(stderr, "calib-trial: %s\n", f.text);
        return f.status;
    }
    set_up(&b);
    for (int i = 0; i < 2; i++)
        trial_compose(&b.frame[i], &b.scene, i, kind, b.seed);
    if (getenv("STAD_SHOW")) {
        picture_write_png(&b.frame[0].left, "trial-left.png", &f);
        picture_write_png(&b.frame[0].right, "trial-right.png", &f);
        picture_write_png(&b.frame[1].left, "trial-other.png", &f);
    }
    printf("{\"kind\": \"%s\", \"seed\": %u, ", target_kind_name(kind), b.seed);
    if (getenv("STAD_PICK_ONLY") == NULL) {
        try_rule(&b, "default", STAD_RULE_DEFAULT, 1);
        try_rule(&b, "strict", STAD_RULE_STRICT, 1);
        try_rule(&b, "none", STAD_RULE_NONE, 1);
    }
    try_rule(&b, "pick", STAD_RULE_DEFAULT, 0);
    if (argc > 8 && atoi(argv[8]) > 0)
        try_full(&b, atoi(argv[8]));
    printf("\"pixels\": %d, \"in_use\": %.4f}\n", b.judge_pixels, rest_bad(&b, &b.start.params));
    return TOOL_OK;
}
