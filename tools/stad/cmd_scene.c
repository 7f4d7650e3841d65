/* SPDX-License-Identifier: MIT
 * stad/cmd_scene.c - stad scene: draws a stereo pair with exact truth. */
#include <errno.h>
#include <getopt.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../common/grid.h"
#include "../scene/scene_draw.h"
#include "scene_folder.h"
#include "scene_frames.h"
#include "tool.h"

static const char help[] =
    "usage: stad scene -o FOLDER [options]\n\n"
    "Draws a pair of slanted planes with plates in front of them: left.png, right.png, disp.pfm (exact "
    "disparity of every left\n"
    "pixel) and nonocc.png (255 = the right camera sees it too). The same options give the same bytes "
    "everywhere.\n\n"
    "  -o, --output FOLDER          made when it is missing\n"
    "  --width W, --height H        px (640, 480)\n"
    "  --min-disparity N            (0)\n"
    "  --num-disparities N          the range that the disparities fill; --target: twice the target's (64)\n"
    "  --plates N                   1..63 (12)\n"
    "  --seed S                     another scene (1)\n"
    "  --noise N                    largest deviation of a pixel by camera noise, grey levels (6)\n"
    "  --gain PERCENT               the right camera's, against the left (100)\n\n"
    "  --target                     a recording instead: a room in which the calibration target is held up, "
    "NNN_left.png, ...\n"
    "                               FOLDER may hold no frames but those that are written anew\n"
    "  --frames N                   of it (16); --pgm: views as .pgm\n"
    "  --share PERCENT              of the image's width that the target takes (42)\n"
    "  --drift PX                   by which the right camera has sunk (0), --from K: from frame K on (0)\n\n"
    "Example: stad scene -o scene && stad match scene/left.png scene/right.png -o disp.pfm --num-disparities "
    "64\n";

typedef struct scene_job {
    const char *folder;
    long width, height, min_disparity, num_disparities, plates, seed, noise, gain, frames, from, share;
    double drift;
    int target, pgm;
    unsigned long long given;
} scene_job;

static const struct option longs[] = {{"output", required_argument, NULL, 'o'},
                                      {"width", required_argument, NULL, 'W'},
                                      {"height", required_argument, NULL, 'H'},
                                      {"min-disparity", required_argument, NULL, 'm'},
                                      {"num-disparities", required_argument, NULL, 'n'},
                                      {"plates", required_argument, NULL, 'p'},
                                      {"seed", required_argument, NULL, 's'},
                                      {"noise", required_argument, NULL, 'N'},
                                      {"gain", required_argument, NULL, 'g'},
                                      {"target", no_argument, NULL, 't'},
                                      {"pgm", no_argument, NULL, 'P'},
                                      {"frames", required_argument, NULL, 'f'},
                                      {"share", required_argument, NULL, 'S'},
                                      {"drift", required_argument, NULL, 'd'},
                                      {"from", required_argument, NULL, 'k'},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

static const tool_vain vain[] = {{TOOL_BIT('f'), TOOL_BIT('t'), 0, "--frames has no effect without --target"},
                                 {TOOL_BIT('d'), TOOL_BIT('t'), 0, "--drift has no effect without --target"},
                                 {TOOL_BIT('P'), TOOL_BIT('t'), 0, "--pgm has no effect without --target"},
                                 {TOOL_BIT('S'), TOOL_BIT('t'), 0, "--share has no effect without --target"},
                                 {TOOL_BIT('k'), TOOL_BIT('t'), 0, "--from has no effect without --target"},
                                 {TOOL_BIT('k'), TOOL_BIT('d'), 0, "--from has no effect without --drift"},
                                 {TOOL_BIT('p'), 0, TOOL_BIT('t'), "--plates has no effect with --target"},
                                 {TOOL_BIT('m'), 0, TOOL_BIT('t'), "--min-disparity does not go with --target"},
                                 {TOOL_BIT('g'), 0, TOOL_BIT('t'), "--gain does not go with --target"}};

static int take(scene_job *j, int code, tool_fail *f)
{
    switch (code) {
    case 'o':
        j->folder = optarg;
        return TOOL_OK;
    case 'W':
        return tool_whole("width", optarg, 16, 4096, &j->width, f);
    case 'H':
        return tool_whole("height", optarg, 16, 4096, &j->height, f);
    case 'm':
        return tool_whole("min-disparity", optarg, -1024, 1024, &j->min_disparity, f);
    case 'n':
        return tool_whole("num-disparities", optarg, 8, 1024, &j->num_disparities, f);
    case 'p':
        return tool_whole("plates", optarg, 1, SCENE_SURFACES - 1, &j->plates, f);
    case 's':
        return tool_whole("seed", optarg, 0, INT32_MAX, &j->seed, f);
    case 't':
        j->target = 1;
        return TOOL_OK;
    case 'P':
        j->pgm = 1;
        return TOOL_OK;
    case 'f':
        return tool_whole("frames", optarg, 1, 999, &j->frames, f);
    case 'd':
        return tool_real("drift", optarg, -32, 32, &j->drift, f);
    case 'k':
        return tool_whole("from", optarg, 0, 999, &j->from, f);
    case 'S':
        return tool_whole("share", optarg, 10, 90, &j->share, f);
    case 'N':
        return tool_whole("noise", optarg, 0, 255, &j->noise, f);
    default:
        return tool_whole("gain", optarg, 10, 400, &j->gain, f);
    }
}

static int read_options(scene_job *j, int argc, char **argv, tool_fail *f)
{
    int code;
    while ((code = getopt_long(argc, argv, "o:h", longs, NULL)) != -1) {
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        j->given |= TOOL_BIT(code);
        if (take(j, code, f))
            return tool_report(argv[0], f);
    }
    if (tool_words(argc, optind, 0, "only options are", f) || tool_refuse_vain(vain, sizeof vain / sizeof vain[0], j->given, f))
        return tool_report(argv[0], f);
    if (j->from >= j->frames) {
        tool_fail_set(f, TOOL_USAGE, "--from %ld: the recording has frames 0..%ld", j->from, j->frames - 1);
        return tool_report(argv[0], f);
    }
    if (!j->folder) {
        tool_fail_set(f, TOOL_USAGE, "-o FOLDER is wanted: where the scene goes");
        return tool_report(argv[0], f);
    }
    return -1;
}

static int write_picture(const picture *p, const char *folder, const char *name, tool_fail *f)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return picture_write_png(p, path, f);
}

static int write_truth(const int32_t *q16, int width, int height, const char *folder, tool_fail *f)
{
    char path[4096];
    size_t n = (size_t)width * (size_t)height;
    float *px = malloc(n * sizeof *px);
    if (!px)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for the truth");
    for (size_t i = 0; i < n; i++)
        px[i] = (float)(q16[i] / 65536.0);
    snprintf(path, sizeof path, "%s/disp.pfm", folder);
    int status = pfm_write(px, width, height, path, f);
    free(px);
    return status;
}

static int record_target(const scene_job *j, tool_fail *f)
{
    const scene_frames s = {j->folder,        (int)j->width,
                            (int)j->height,   (int)j->num_disparities,
                            (int)j->frames,   (unsigned)j->seed,
                            (double)j->noise, j->drift,
                            (int)j->from,     j->pgm,
                            (int)j->share};
    return scene_frames_write(&s, f);
}

static int draw_plates(const scene_job *j, tool_fail *f)
{
    static scene s; /* some KiB, and it points into itself */
    picture left, right, visible;
    int32_t *truth;
    scene_random(&s, (int)j->width, (int)j->height, (int)j->min_disparity, (int)j->num_disparities, (int)j->plates,
                 (uint32_t)j->seed);
    s.camera_noise = (int)j->noise;
    s.right_gain_q8 = (int)(j->gain * 256 / 100);
    int status = scene_render(&s, &left, &right, &truth, &visible, f);
    if (status)
        return status;
    status = write_picture(&left, j->folder, "left.png", f);
    if (status == TOOL_OK)
        status = write_picture(&right, j->folder, "right.png", f);
    if (status == TOOL_OK)
        status = write_picture(&visible, j->folder, "nonocc.png", f);
    if (status == TOOL_OK)
        status = write_truth(truth, s.width, s.height, j->folder, f);
    free(truth);
    picture_free(&left);
    picture_free(&right);
    picture_free(&visible);
    return status;
}

static int work(const scene_job *j, tool_fail *f)
{
    if (strlen(j->folder) > 4000)
        return tool_fail_set(f, TOOL_USAGE, "the folder's name is too long");
    if (mkdir(j->folder, 0777) && errno != EEXIST)
        return tool_fail_set(f, TOOL_FILE, "%s: cannot be made: %s", j->folder, strerror(errno));
    if (scene_folder_check(j->folder, j->target ? (int)j->frames : 0, j->pgm, f))
        return f->status;
    return j->target ? record_target(j, f) : draw_plates(j, f);
}

int cmd_scene(int argc, char **argv)
{
    scene_job j = {NULL, 640, 480, 0, 64, 12, 1, 6, 100, 16, 0, 42, 0, 0, 0, 0};
    tool_fail f = {0};
    int status = read_options(&j, argc, argv, &f);
    if (status >= 0)
        return status;
    return work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
}
