/* SPDX-License-Identifier: MIT
 * presets/derive.c - the preset ladder: ncg with full truth over several scenes at once, under one kind of degradation each.
 *
 *     preset-derive EVALUATIONS (LEFT RIGHT DISPARITY NUM_DISPARITIES MASK|-)...
 *
 * The cost of a point under a kind is the mean over scenes of bad(point) / bad(sample). Prints one JSON object: for each kind, and for all kinds
 * together, the best point, and its cost under every kind. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../calib_trials/trial.h"

#define SCENES 16

typedef struct design {
    trial_scene scene[SCENES];
    trial_frame frame[SCENES][TARGET_KINDS];
    engine engine[SCENES];
    double sample[SCENES][TARGET_KINDS];
    int scenes;
} design;

static design all;

static stad_params params_of(const trial_scene *s, const stad_point *x)
{
    stad_params p;
    stad_params_sample(&p, s->disparities, 3, 1);
    p.p1 = x->v[STAD_TUNE_P1];
    p.p2 = x->v[STAD_TUNE_P2];
    p.block_size = x->v[STAD_TUNE_BLOCK_SIZE];
    p.uniqueness_ratio = x->v[STAD_TUNE_UNIQUENESS_RATIO];
    p.pre_filter_cap = (int16_t)(x->v[STAD_TUNE_PRE_FILTER_CAP] | 1);
    p.disp12_max_diff = x->v[STAD_TUNE_DISP12_MAX_DIFF];
    return p;
}

static double ratio(int scene, int kind, const stad_point *x)
{
    stad_params p = params_of(&all.scene[scene], x);
    return trial_bad(&all.engine[scene], &all.scene[scene], &all.frame[scene][kind], &p, NULL) / all.sample[scene][kind];
}

/* kind TARGET_KINDS: all of them. */
static double cost(int kind, const stad_point *x)
{
    double sum = 0;
    int n = 0;
    for (int k = 0; k < TARGET_KINDS; k++)
        for (int i = 0; i < all.scenes && (k == kind || kind == TARGET_KINDS); i++, n++)
            sum += ratio(i, k, x);
    return sum / n;
}

static void load(int argc, char **argv)
{
    tool_fail f = {0, ""};
    for (int a = 0; a + 4 < argc && all.scenes < SCENES; a += 5) {
        const int i = all.scenes++;
        trial_scene *s = &all.scene[i];
        if (trial_read(s, argv[a], argv[a + 1], argv[a + 2], strcmp(argv[a + 4], "-") ? argv[a + 4] : NULL, atoi(argv[a + 3]),
                       &f) != TOOL_OK) {
            fprintf(stderr, "preset-derive: %s\n", f.text);
            exit(f.status);
        }
        const stad_geometry g = {(int16_t)s->width, (int16_t)s->height, 1, (int16_t)s->disparities, 11, 8192, 127,
                                 STAD_MODE_SGBM,    STAD_MEMORY_FAST};
        if (engine_open(&all.engine[i], &g, &f) != TOOL_OK)
            exit(f.status);
        for (int k = 0; k < TARGET_KINDS; k++) {
            stad_params sample;
            stad_params_sample(&sample, s->disparities, 3, 1);
            trial_compose(&all.frame[i][k], s, TRIAL_WITHOUT_TARGET, k, 1000u + (unsigned)i);
            all.sample[i][k] = trial_bad(&all.engine[i], s, &all.frame[i][k], &sample, NULL);
        }
    }
}

static stad_point derive(int kind, int evaluations)
{
    static stad_tune t;
    stad_tune_config config;
    stad_point x, start = {{72, 288, 3, 10, 63, 1}};
    stad_tune_config_stereo(&config, STAD_TUNE_FOR_ANY);
    config.axis[STAD_TUNE_BLOCK_SIZE].lo = 3;
    config.budget = (int16_t)evaluations;
    if (stad_tune_init(&t, &config, &start) != STAD_OK)
        exit(TOOL_USAGE);
    while (stad_tune_ask(&t, &x) == 1)
        stad_tune_tell(&t, (int32_t)(cost(kind, &x) * STAD_COST_ONE));
    stad_tune_best(&t, &x, NULL);
    return x;
}

int main(int argc, char **argv)
{
    if (argc < 7) {
        fprintf(stderr, "usage: preset-derive EVALUATIONS (LEFT RIGHT DISPARITY NUM_DISPARITIES MASK|-)...\n");
        return TOOL_USAGE;
    }
    load(argc - 2, argv + 2);
    printf("{\n");
    for (int kind = 0; kind <= TARGET_KINDS; kind++) {
        const stad_point x = derive(kind, atoi(argv[1]));
        printf("\"%s\": {\"point\": [%d, %d, %d, %d, %d, %d], \"under\": [", kind < TARGET_KINDS ? target_kind_name(kind) : "all",
               x.v[0], x.v[1], x.v[2], x.v[3], x.v[4], x.v[5]);
        for (int k = 0; k < TARGET_KINDS; k++)
            printf("%s%.4f", k ? ", " : "", cost(k, &x));
        printf("]}%s\n", kind < TARGET_KINDS ? "," : "");
        fflush(stdout);
    }
    printf("}\n");
    return TOOL_OK;
}
