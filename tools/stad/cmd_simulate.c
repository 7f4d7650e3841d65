/* SPDX-License-Identifier: MIT
 * stad/cmd_simulate.c - stad simulate: recorded frames through the code that a board runs. */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "simulate.h"
#include "tool.h"
#include "tune_job.h"

static const char help[] =
    "usage: stad simulate FOLDER [options]\n\n"
    "Replays recorded, rectified frames through the matcher, monitor, calibration and parameter store of the "
    "firmware.\n"
    "FOLDER: pairs of names that differ in left/right, _0/_1 or _L/_R; KITTI's image_0, image_1 and the "
    "like; EuRoC's cam0/data,\n"
    "cam1/data; folders left and right.\n\n"
    "  --side-by-side               pictures that hold both views\n"
    "  --size WxH                   FOLDER is a file of 8-bit frames, left and right in turns\n"
    "  --frames N                   at most the first N\n"
    "  --jobs N                     so many frames at a time, the same result (1)\n"
    "  --keep-going                 report and skip frames that cannot be read (else: stop, what was done is "
    "written)\n"
    "  --csv FILE, --json FILE      every frame; alarms, camera faults, runs, the setup in use and stored (an\n"
    "                               interrupt ends the recording: what was done is written)\n"
    "  --report FILE.html           the same to look at\n"
    "  --focal PX                   of both cameras; without it marks are not looked for, only the monitor "
    "runs\n"
    "  --center X,Y                 principal point (the middle); --baseline METRES for distances in the "
    "report\n"
    "  --calibrate-at K             begin a run at frame K, whatever the monitor says\n"
    "  --evaluations N              matches for the calibration between two frames (4)\n"
    "  --learn-frames N             from which the monitor learns what is usual (30)\n"
    "  --probation-frames N         after which an adopted set is looked at again, 0 = never (64)\n"
    "  --budget N                   evaluations of a run (the library's)\n"
    "  --cost bad|chow              (bad)\n"
    "  --noise SD, --gain PERCENT, --blur SD, --vignette PERCENT, --dim PERCENT   spoil the frames\n"
    "  --from K                     ... from frame K on (0)\n" MATCH_OPTIONS_HELP
    "\nExample: stad simulate recording --num-disparities 64 --focal 436.2 --baseline 0.11 --noise 15 --from "
    "40 --report r.html\n";

enum {
    OPT_SIDE = 1,
    OPT_SIZE,
    OPT_LIMIT,
    OPT_JOBS,
    OPT_KEEP,
    OPT_CSV,
    OPT_JSON,
    OPT_REPORT,
    OPT_FOCAL,
    OPT_CENTER,
    OPT_BASELINE,
    OPT_AT,
    OPT_EVALUATIONS,
    OPT_LEARN,
    OPT_BUDGET,
    OPT_PROBATION,
    OPT_COST,
    OPT_NOISE,
    OPT_GAIN,
    OPT_BLUR,
    OPT_VIGNETTE,
    OPT_DIM,
    OPT_FROM
};

static const struct option longs[] = {MATCH_OPTIONS,
                                      {"side-by-side", no_argument, NULL, OPT_SIDE},
                                      {"size", required_argument, NULL, OPT_SIZE},
                                      {"frames", required_argument, NULL, OPT_LIMIT},
                                      {"jobs", required_argument, NULL, OPT_JOBS},
                                      {"keep-going", no_argument, NULL, OPT_KEEP},
                                      {"csv", required_argument, NULL, OPT_CSV},
                                      {"json", required_argument, NULL, OPT_JSON},
                                      {"report", required_argument, NULL, OPT_REPORT},
                                      {"focal", required_argument, NULL, OPT_FOCAL},
                                      {"center", required_argument, NULL, OPT_CENTER},
                                      {"baseline", required_argument, NULL, OPT_BASELINE},
                                      {"calibrate-at", required_argument, NULL, OPT_AT},
                                      {"evaluations", required_argument, NULL, OPT_EVALUATIONS},
                                      {"learn-frames", required_argument, NULL, OPT_LEARN},
                                      {"probation-frames", required_argument, NULL, OPT_PROBATION},
                                      {"budget", required_argument, NULL, OPT_BUDGET},
                                      {"cost", required_argument, NULL, OPT_COST},
                                      {"noise", required_argument, NULL, OPT_NOISE},
                                      {"gain", required_argument, NULL, OPT_GAIN},
                                      {"blur", required_argument, NULL, OPT_BLUR},
                                      {"vignette", required_argument, NULL, OPT_VIGNETTE},
                                      {"dim", required_argument, NULL, OPT_DIM},
                                      {"from", required_argument, NULL, OPT_FROM},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

#define CALIBRATES TOOL_BIT(OPT_FOCAL)
#define ANY_SPOIL  (TOOL_BIT(OPT_NOISE) | TOOL_BIT(OPT_GAIN) | TOOL_BIT(OPT_BLUR) | TOOL_BIT(OPT_VIGNETTE) | TOOL_BIT(OPT_DIM))

static const tool_vain vain[] = {
    {TOOL_BIT(OPT_CENTER), CALIBRATES, 0, "--center has no effect without --focal: no mark is looked for"},
    {TOOL_BIT(OPT_AT), CALIBRATES, 0, "--calibrate-at has no effect without --focal: no mark is looked for"},
    {TOOL_BIT(OPT_EVALUATIONS), CALIBRATES, 0, "--evaluations has no effect without --focal"},
    {TOOL_BIT(OPT_PROBATION), CALIBRATES, 0, "--probation-frames has no effect without --focal"},
    {TOOL_BIT(OPT_BUDGET), CALIBRATES, 0, "--budget has no effect without --focal"},
    {TOOL_BIT(OPT_COST), CALIBRATES, 0, "--cost has no effect without --focal"},
    {TOOL_BIT(OPT_BASELINE), CALIBRATES, 0, "--baseline has no effect without --focal"},
    {TOOL_BIT(OPT_BASELINE), TOOL_BIT(OPT_REPORT), 0, "--baseline has no effect without --report"},
    {TOOL_BIT(OPT_FROM), ANY_SPOIL, 0, "--from has no effect without --noise, --gain, --blur, --vignette or --dim"},
    {TOOL_BIT(OPT_SIDE), 0, TOOL_BIT(OPT_SIZE), "--side-by-side has no effect with --size"}};

static int take_size(simulation *s, const char *text, tool_fail *f)
{
    char end;
    if (sscanf(text, "%5dx%5d%c", &s->raw_width, &s->raw_height, &end) == 2 && s->raw_width >= 16 && s->raw_height >= 16 &&
        s->raw_width <= PICTURE_SIDE_MAX && s->raw_height <= PICTURE_SIDE_MAX)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "--size %s: must be WIDTHxHEIGHT, each in 16..%d", text, PICTURE_SIDE_MAX);
}

static int take_cost(simulation *s, const char *name, tool_fail *f)
{
    s->cost = tune_cost_of(name);
    if (s->cost == STAD_SCORE_BAD || s->cost == STAD_SCORE_CHOW)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "--cost %s: must be bad or chow", name);
}

static int take_degrade(degrade *d, int code, tool_fail *f)
{
    long from;
    int status;
    switch (code) {
    case OPT_NOISE:
        return tool_real("noise", optarg, 0, 128, &d->noise, f);
    case OPT_GAIN:
        return tool_real("gain", optarg, 1, 400, &d->gain, f);
    case OPT_BLUR:
        return tool_real("blur", optarg, 0, 9, &d->blur, f);
    case OPT_VIGNETTE:
        return tool_real("vignette", optarg, 0, 100, &d->vignette, f);
    case OPT_DIM:
        return tool_real("dim", optarg, 0, 100, &d->dim, f);
    default:
        status = tool_whole("from", optarg, 0, INT32_MAX, &from, f);
        d->from = (int)from;
        return status;
    }
}

static int take(simulation *s, int code, tool_fail *f)
{
    switch (code) {
    case OPT_SIDE:
        s->side_by_side = 1;
        return TOOL_OK;
    case OPT_KEEP:
        s->keep_going = 1;
        return TOOL_OK;
    case OPT_CSV:
        s->csv = optarg;
        return tool_out_check(optarg, f);
    case OPT_JSON:
        s->json = optarg;
        return tool_out_check(optarg, f);
    case OPT_REPORT:
        s->report = optarg;
        return tool_out_check(optarg, f);
    case OPT_SIZE:
        return take_size(s, optarg, f);
    case OPT_JOBS:
        return tool_whole("jobs", optarg, 1, 256, &s->jobs, f);
    case OPT_LIMIT:
        return tool_whole("frames", optarg, 1, INT32_MAX, &s->limit, f);
    case OPT_FOCAL:
    case OPT_BASELINE:
        return code == OPT_FOCAL ? tool_real("focal", optarg, 16, 1e5, &s->rig.focal_px, f)
                                 : tool_real("baseline", optarg, 1e-4, 1e3, &s->rig.baseline_m, f);
    case OPT_CENTER:
        return tool_point("center", optarg, &s->cx, &s->cy, f);
    case OPT_AT:
        return tool_whole("calibrate-at", optarg, 0, INT32_MAX, &s->calibrate_at, f);
    case OPT_EVALUATIONS:
        return tool_whole("evaluations", optarg, 1, 1000, &s->evaluations_per_frame, f);
    case OPT_LEARN:
        return tool_whole("learn-frames", optarg, 2, 1000, &s->learn_frames, f);
    case OPT_BUDGET:
        return tool_whole("budget", optarg, 4, STAD_TUNE_LOG, &s->budget, f);
    case OPT_PROBATION:
        return tool_whole("probation-frames", optarg, 0, 32767, &s->probation_frames, f);
    case OPT_COST:
        return take_cost(s, optarg, f);
    default:
        return take_degrade(&s->bad, code, f);
    }
}

static int read_options(simulation *s, int argc, char **argv, tool_fail *f)
{
    int code, mine;
    match_options_init(&s->options);
    while ((code = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
        int status = match_options_take(&s->options, code, optarg, &mine, f);
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (status == TOOL_OK && !mine) {
            s->given |= TOOL_BIT(code);
            status = take(s, code, f);
        }
        if (status)
            return tool_report(argv[0], f);
    }
    if (tool_refuse_vain(vain, sizeof vain / sizeof vain[0], s->given, f))
        return tool_report(argv[0], f);
    if (tool_words(argc, optind, 1, "FOLDER is", f))
        return tool_report(argv[0], f);
    s->where = argv[optind];
    return -1;
}

static int work(simulation *s, tool_fail *f)
{
    tool_fail later = {0};
    int status = match_options_file(&s->options, f);
    if (status == TOOL_OK && s->options.color && degrade_any(&s->bad))
        status = tool_fail_set(f, TOOL_USAGE, "--color: frames are spoilt in grey only");
    if (status)
        return status;
    status = simulate_run(s, f);
    if (status && s->row_count == 0) /* nothing was done */
        return status;
    int written = s->csv ? simulate_write_csv(s, &later) : TOOL_OK;
    if (written == TOOL_OK && s->json)
        written = simulate_write_json(s, &later);
    if (written == TOOL_OK && s->report)
        written = simulate_write_report(s, &later);
    simulate_print(s);
    if (status == TOOL_OK && written)
        *f = later;
    else if (written)
        tool_note("stad simulate", "", &later);
    return status ? status : written;
}

int cmd_simulate(int argc, char **argv)
{
    static simulation s; /* holds a board */
    tool_fail f = {0};
    s.cx = s.cy = (double)NAN;
    s.bad.gain = 100;
    s.calibrate_at = s.probation_frames = -1;
    s.evaluations_per_frame = 4;
    s.jobs = 1;
    s.command = report_command(argc, argv);
    int status = read_options(&s, argc, argv, &f);
    if (status < 0)
        status = work(&s, &f) ? tool_report(argv[0], &f) : TOOL_OK;
    simulate_free(&s);
    return status;
}
