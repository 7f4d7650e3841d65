/* SPDX-License-Identifier: MIT
 * stad/cmd_match.c - stad match: a pair in, a disparity map out. */
#include <getopt.h>
#include <string.h>

#include "../common/colour.h"
#include "../common/engine.h"
#include "../common/whole_file.h"
#include "match_options.h"
#include "tool.h"

static const char help[] = "usage: stad match LEFT RIGHT -o OUT [options]\n\n"
                           "Disparity of a rectified pair (8-bit PNG, PGM or PPM), bit for bit what cv::StereoSGBM computes.\n\n"
                           "  -o, --output OUT             .npy  int16, disparity * 16: the array OpenCV's compute() returns\n"
                           "                               .pfm  pixels, none = +inf\n"
                           "                               .png  16 bits, disparity * 256, none = 0\n"
                           "  --preview FILE.png           the map in colours, to look at\n"
                           "  --confidence FILE.png        by how much the best disparity wins, 0..255\n"
                           "  --right FILE                 disparity of the right view, as the left-right check sees "
                           "it\n" MATCH_OPTIONS_HELP "\nIn brackets: what holds when the option is left out. A value that OpenCV "
                           "would repair in silence is refused.\n\n"
                           "Example: stad match left.png right.png -o disp.npy --num-disparities 64 --preview disp.png\n";

typedef struct match_job {
    match_options options;
    const char *left, *right, *out, *preview, *confidence, *right_out;
} match_job;

enum { OPT_PREVIEW = 'P', OPT_CONFIDENCE = 'C', OPT_RIGHT = 'R' };

static const struct option longs[] = {MATCH_OPTIONS,
                                      {"output", required_argument, NULL, 'o'},
                                      {"preview", required_argument, NULL, OPT_PREVIEW},
                                      {"confidence", required_argument, NULL, OPT_CONFIDENCE},
                                      {"right", required_argument, NULL, OPT_RIGHT},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

/* -1: go on; else an exit status. */
static int read_options(match_job *j, int argc, char **argv, tool_fail *f)
{
    int code, mine;
    match_options_init(&j->options);
    while ((code = getopt_long(argc, argv, "o:h", longs, NULL)) != -1) {
        int status = match_options_take(&j->options, code, optarg, &mine, f);
        if (status)
            return tool_report(argv[0], f);
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (code == 'o')
            j->out = optarg;
        else if (code == OPT_PREVIEW)
            j->preview = optarg;
        else if (code == OPT_CONFIDENCE)
            j->confidence = optarg;
        else if (code == OPT_RIGHT)
            j->right_out = optarg;
    }
    if (tool_words(argc, optind, 2, "LEFT and RIGHT are", f))
        return tool_report(argv[0], f);
    j->left = argv[optind];
    j->right = argv[optind + 1];
    return -1;
}

/* Every output is looked at before the work is done. */
static int check_outputs(const match_job *j, const stad_params *p, tool_fail *f)
{
    const char *pictures[2] = {j->preview, j->confidence};
    const char *const outs[] = {j->out, j->preview, j->confidence, j->right_out};
    const char *const ins[] = {j->left, j->right, j->options.params_path};
    int status = tool_out_apart(outs, 4, ins, 3, f);
    if (status == TOOL_OK)
        status = disparity_check_path(j->out, p->min_disparity, p->num_disparities, f);
    if (status == TOOL_OK && j->right_out)
        status = disparity_check_path(j->right_out, p->min_disparity, p->num_disparities, f);
    for (int i = 0; i < 2 && status == TOOL_OK; i++) {
        if (pictures[i] && !tool_has_suffix(pictures[i], ".png"))
            status = tool_fail_set(f, TOOL_USAGE, "%s: is written as .png", pictures[i]);
        else if (pictures[i])
            status = tool_out_check(pictures[i], f);
    }
    return status;
}

static int write_outputs(const match_job *j, const stad_params *p, const disparity *d, const picture *sure,
                         const disparity *right, tool_fail *f)
{
    int status = disparity_write(d, j->out, f);
    if (status == TOOL_OK && j->confidence)
        status = picture_write_png(sure, j->confidence, f);
    if (status == TOOL_OK && j->right_out)
        status = disparity_write(right, j->right_out, f);
    if (status == TOOL_OK && j->preview) {
        picture colours;
        status = colour_disparity(&colours, d, p->num_disparities, f);
        if (status == TOOL_OK)
            status = picture_write_png(&colours, j->preview, f);
        picture_free(&colours);
    }
    return status;
}

static int match_pair(const match_job *j, const stad_params *p, const picture *left, const picture *right, tool_fail *f)
{
    stad_geometry g =
        engine_geometry(p, match_options_mode(&j->options), j->options.memory, left->width, left->height, left->channels);
    disparity d = {0}, right_d = {0};
    picture sure = {0};
    engine_extras extras = {j->confidence ? &sure : NULL, j->right_out ? &right_d : NULL};
    engine e;
    int status = engine_open(&e, &g, f);
    if (status)
        return status;
    status = engine_run(&e, p, left, right, &d, &extras, f);
    if (status == TOOL_OK)
        status = write_outputs(j, p, &d, &sure, &right_d, f);
    disparity_free(&d);
    disparity_free(&right_d);
    picture_free(&sure);
    engine_close(&e);
    return status;
}

static int work(match_job *j, tool_fail *f)
{
    picture left, right;
    stad_params p;
    if (!j->out)
        return tool_fail_set(f, TOOL_USAGE, "-o OUT is wanted: where the disparity map goes");
    int status = match_options_file(&j->options, f);
    if (status == TOOL_OK)
        status = engine_read_pair(&left, &right, j->left, j->right, j->options.color, f);
    if (status)
        return status;
    status = match_options_params(&j->options, left.width, left.channels, &p, f);
    if (status == TOOL_OK)
        status = check_outputs(j, &p, f);
    if (status == TOOL_OK)
        status = match_pair(j, &p, &left, &right, f);
    picture_free(&left);
    picture_free(&right);
    return status;
}

int cmd_match(int argc, char **argv)
{
    match_job j = {0};
    tool_fail f = {0};
    int status = read_options(&j, argc, argv, &f);
    if (status >= 0)
        return status;
    return work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
}
