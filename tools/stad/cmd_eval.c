/* SPDX-License-Identifier: MIT
 * stad/cmd_eval.c - stad eval: a disparity map against ground truth. */
#include <cjson/cJSON.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#include "../common/whole_file.h"
#include "measure.h"
#include "report_make.h"
#include "tool.h"

static const char help[] =
    "usage: stad eval DISP TRUTH --min-disparity N --num-disparities N [options]\n\n"
    "How far a disparity map is from the truth. Scored are pixels whose truth is known, from column min + "
    "num disparities on.\n"
    "DISP: .npy (int16, * 16, or float), .pfm, .png (16 bits, * 256). TRUTH: the same, .npz,\n"
    "or 8 bits with --truth-scale.\n\n"
    "  --min-disparity N, --num-disparities N   as matched\n"
    "  --mask FILE          which pixels both cameras see: 0 and 128 = hidden, else visible (without: found "
    "from the truth)\n"
    "  --truth-scale S      steps per pixel of a truth that is a .png or .pgm (256 for 16 bits)\n"
    "  --threshold PX       error above which a pixel is wrong, for chow (1)\n"
    "  --json               one JSON object on the standard output; fractions, px for rmse and mae\n"
    "  --report OUT.html    map, truth and errors, to look at: one file\n"
    "  --focal PX, --baseline METRES            of the rig: the report shows distances too\n\n"
    "bad      (wrong + missing) / visible; `estimated`: wrong / visible with a disparity\n"
    "chow     (2 wrong_visible + 2 wrong_occluded + missing_visible) / (2 (visible + occluded))\n"
    "D1       bad, but wrong is an error above 3 px and above 5 %\n"
    "density  visible with a disparity / visible; rmse, mae: over these\n\n"
    "Example: stad eval disp.npy truth.pfm --min-disparity 0 --num-disparities 64\n";

typedef struct eval_job {
    const char *disp, *truth, *mask;
    long min_disparity, num_disparities;
    double scale, threshold;
    int json;
    const char *report;
    char *command; /* as typed, for the report */
    report_rig rig;
} eval_job;

enum {
    OPT_MIN = 'm',
    OPT_NUM = 'n',
    OPT_MASK = 'k',
    OPT_SCALE = 's',
    OPT_THRESHOLD = 't',
    OPT_JSON = 'j',
    OPT_REPORT = 'r',
    OPT_FOCAL = 'f',
    OPT_BASELINE = 'b'
};

static const struct option longs[] = {{"min-disparity", required_argument, NULL, OPT_MIN},
                                      {"num-disparities", required_argument, NULL, OPT_NUM},
                                      {"mask", required_argument, NULL, OPT_MASK},
                                      {"truth-scale", required_argument, NULL, OPT_SCALE},
                                      {"threshold", required_argument, NULL, OPT_THRESHOLD},
                                      {"json", no_argument, NULL, OPT_JSON},
                                      {"report", required_argument, NULL, OPT_REPORT},
                                      {"focal", required_argument, NULL, OPT_FOCAL},
                                      {"baseline", required_argument, NULL, OPT_BASELINE},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

static int take(eval_job *j, int code, tool_fail *f)
{
    switch (code) {
    case OPT_MIN:
        return tool_whole("min-disparity", optarg, -2047, 2046, &j->min_disparity, f);
    case OPT_NUM:
        return tool_whole("num-disparities", optarg, 1, 4094, &j->num_disparities, f);
    case OPT_SCALE:
        return tool_real("truth-scale", optarg, 1e-3, 65536, &j->scale, f);
    case OPT_THRESHOLD:
        return tool_real("threshold", optarg, 0, 4095, &j->threshold, f);
    case OPT_MASK:
        j->mask = optarg;
        return TOOL_OK;
    case OPT_REPORT:
        j->report = optarg;
        return tool_out_check(optarg, f);
    case OPT_FOCAL:
    case OPT_BASELINE:
        return report_rig_option(&j->rig, code == OPT_FOCAL, optarg, f);
    default:
        j->json = 1;
        return TOOL_OK;
    }
}

static int read_options(eval_job *j, int argc, char **argv, tool_fail *f)
{
    int code;
    while ((code = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (take(j, code, f))
            return tool_report(argv[0], f);
    }
    if (tool_words(argc, optind, 2, "DISP and TRUTH are", f))
        return tool_report(argv[0], f);
    j->disp = argv[optind];
    j->truth = argv[optind + 1];
    return -1;
}

static cJSON *by_threshold(const double *v)
{
    cJSON *o = cJSON_CreateObject();
    char name[16];
    for (int i = 0; i < MEASURE_THRESHOLDS; i++) {
        snprintf(name, sizeof name, "%g", measure_threshold[i]);
        cJSON_AddNumberToObject(o, name, v[i]);
    }
    return o;
}

static cJSON *counts_json(const stad_score_counts *c)
{
    cJSON *o = cJSON_CreateObject();
    cJSON_AddNumberToObject(o, "scored", (double)c->visible + c->occluded);
    cJSON_AddNumberToObject(o, "visible", c->visible);
    cJSON_AddNumberToObject(o, "occluded", c->occluded);
    cJSON_AddNumberToObject(o, "wrong_visible", c->wrong_visible);
    cJSON_AddNumberToObject(o, "wrong_occluded", c->wrong_occluded);
    cJSON_AddNumberToObject(o, "missing_visible", c->missing_visible);
    cJSON_AddNumberToObject(o, "missing_occluded", c->missing_occluded);
    return o;
}

static void print_json(const measures *m)
{
    cJSON *o = cJSON_CreateObject();
    cJSON_AddItemToObject(o, "bad", by_threshold(m->bad));
    cJSON_AddItemToObject(o, "bad_estimated", by_threshold(m->bad_estimated));
    cJSON_AddNumberToObject(o, "threshold", m->threshold);
    cJSON_AddNumberToObject(o, "chow", m->chow);
    cJSON_AddNumberToObject(o, "d1", m->d1);
    cJSON_AddNumberToObject(o, "d1_estimated", m->d1_estimated);
    cJSON_AddNumberToObject(o, "rmse", m->rmse);
    cJSON_AddNumberToObject(o, "mae", m->mae);
    cJSON_AddNumberToObject(o, "density", m->density);
    cJSON_AddItemToObject(o, "counts", counts_json(&m->counts));
    char *text = cJSON_Print(o);
    if (text)
        puts(text);
    cJSON_free(text);
    cJSON_Delete(o);
}

static void print_table(const measures *m)
{
    printf("%-14s %9s %11s\n", "", "visible", "estimated");
    for (int i = 0; i < MEASURE_THRESHOLDS; i++)
        printf("bad %3.1f px     %8.3f %% %9.3f %%\n", measure_threshold[i], 100 * m->bad[i], 100 * m->bad_estimated[i]);
    printf("D1             %8.3f %% %9.3f %%\n", 100 * m->d1, 100 * m->d1_estimated);
    printf("chow           %8.3f %%   (above %g px)\n", 100 * m->chow, m->threshold);
    printf("density        %8.3f %%\n", 100 * m->density);
    printf("rmse           %8.4f px\n", m->rmse);
    printf("mae            %8.4f px\n", m->mae);
    printf("pixels         %d visible, %d occluded\n", m->counts.visible, m->counts.occluded);
}

static int work(const eval_job *j, tool_fail *f)
{
    disparity d = {0};
    truth_map t = {0};
    measures m;
    if (j->min_disparity == INT16_MAX || j->num_disparities == 0)
        return tool_fail_set(f, TOOL_USAGE, "--min-disparity and --num-disparities are wanted: the range that was matched");
    const char *const ins[] = {j->disp, j->truth, j->mask};
    int status = tool_out_apart(&j->report, 1, ins, 3, f);
    if (status == TOOL_OK)
        status = disparity_read(&d, j->disp, (int)j->min_disparity, f);
    if (status == TOOL_OK)
        status = truth_read(&t, j->truth, j->scale, (int)j->min_disparity, f);
    if (status == TOOL_OK && j->mask)
        status = truth_mask(&t, j->mask, f);
    if (status == TOOL_OK)
        status = measure(&m, &d, &t, (int)j->num_disparities, j->threshold, f);
    if (status == TOOL_OK && j->report)
        status = report_eval(j->report, j->command, &j->rig, &d, &t, (int)j->num_disparities, &m, f);
    if (status == TOOL_OK && j->json)
        print_json(&m);
    else if (status == TOOL_OK)
        print_table(&m);
    disparity_free(&d);
    truth_free(&t);
    return status;
}

int cmd_eval(int argc, char **argv)
{
    eval_job j = {.min_disparity = INT16_MAX, .threshold = 1};
    tool_fail f = {0};
    j.command = report_command(argc, argv);
    int status = read_options(&j, argc, argv, &f);
    if (status < 0)
        status = work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
    free(j.command);
    return status;
}
