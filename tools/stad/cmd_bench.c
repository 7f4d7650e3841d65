/* SPDX-License-Identifier: MIT
 * stad/cmd_bench.c - stad bench: time per pixel and disparity, on a scene of its own. */
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../common/engine.h"
#include "../scene/scene_draw.h"
#include "match_options.h"
#include "tool.h"

static const char help[] =
    "usage: stad bench [options]\n\n"
    "Time to match a frame, and per pixel and disparity: CPU time of one thread, median over the frames.\n"
    "Without --mode all four are timed (3way where it takes the disparities), on a grey scene. The first line\n"
    "names the kernels in use, which the variable STAD_ISA may hold down as --isa does.\n\n"
    "  --width W, --height H        (640, 480)\n"
    "  --frames N                   (9)\n"
    "  --isa c|sse41|avx2|avx512    at most this tier of kernels on x86 (all that the CPU has)\n" MATCH_OPTIONS_HELP_FOR(
        "all four") "\nExample: stad bench --num-disparities 128 --mode sgbm\n";

typedef struct bench_job {
    match_options options;
    long width, height, frames;
} bench_job;

static const struct option longs[] = {MATCH_OPTIONS,
                                      {"width", required_argument, NULL, 'W'},
                                      {"height", required_argument, NULL, 'H'},
                                      {"frames", required_argument, NULL, 'n'},
                                      {"isa", required_argument, NULL, 'i'},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

/* The x86 port exports the name of the tier in use; another port does not have it. */
const char *stad_x86_tier_name(void) __attribute__((weak));

/* `from`: --isa, or the variable that the library looks at when it first matches; any other word would do nothing there. */
static int check_isa(const char *from, const char *name, tool_fail *f)
{
    if (!stad_x86_tier_name)
        return tool_fail_set(f, TOOL_USAGE, "%s %s: this program has the kernels of port/isa/" STAD_PORT " alone", from, name);
    if (strcmp(name, "c") && strcmp(name, "sse41") && strcmp(name, "avx2") && strcmp(name, "avx512"))
        return tool_fail_set(f, TOOL_USAGE, "%s %s: must be c, sse41, avx2 or avx512", from, name);
    return TOOL_OK;
}

static int take_isa(const char *name, tool_fail *f)
{
    int status = check_isa("--isa", name, f);
    if (status)
        return status;
    if (setenv("STAD_ISA", name, 1))
        return tool_fail_set(f, TOOL_USAGE, "--isa %s: the environment cannot be changed", name);
    return TOOL_OK;
}

static int take(bench_job *j, int code, tool_fail *f)
{
    if (code == 'i')
        return take_isa(optarg, f);
    if (code == 'W')
        return tool_whole("width", optarg, 32, 4096, &j->width, f);
    if (code == 'H')
        return tool_whole("height", optarg, 16, 4096, &j->height, f);
    return tool_whole("frames", optarg, 1, 1000, &j->frames, f);
}

static int read_options(bench_job *j, int argc, char **argv, tool_fail *f)
{
    int code, mine;
    match_options_init(&j->options);
    while ((code = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
        int status = match_options_take(&j->options, code, optarg, &mine, f);
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (status == TOOL_OK && !mine)
            status = take(j, code, f);
        if (status)
            return tool_report(argv[0], f);
    }
    return tool_words(argc, optind, 0, "only options are", f) ? tool_report(argv[0], f) : -1;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static double cpu_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Median seconds of a frame, the first one (which touches the memory) left out. */
static int time_frames(engine *e, const bench_job *j, const stad_params *p, const picture *pair, double *median, tool_fail *f)
{
    disparity d = {0};
    double *seconds = calloc((size_t)j->frames, sizeof *seconds);
    int status = seconds ? engine_run(e, p, &pair[0], &pair[1], &d, NULL, f) : tool_fail_set(f, TOOL_FILE, "not enough memory");
    for (long i = 0; i < j->frames && status == TOOL_OK; i++) {
        double start = cpu_seconds();
        status = engine_run(e, p, &pair[0], &pair[1], &d, NULL, f);
        seconds[i] = cpu_seconds() - start;
    }
    if (status == TOOL_OK) {
        qsort(seconds, (size_t)j->frames, sizeof *seconds, by_value);
        *median = seconds[j->frames / 2];
    }
    free(seconds);
    disparity_free(&d);
    return status;
}

static int bench_mode(const bench_job *j, int mode, const picture *pair, tool_fail *f)
{
    stad_params p;
    engine e;
    double median;
    match_options options = j->options;
    options.some.mode = mode;
    int status = match_options_params(&options, pair->width, pair->channels, &p, f);
    if (status)
        return status;
    stad_geometry g = engine_geometry(&p, mode, options.memory, pair->width, pair->height, pair->channels);
    status = engine_open(&e, &g, f);
    if (status)
        return status;
    status = time_frames(&e, j, &p, pair, &median, f);
    const int low = p.min_disparity < 0 ? p.min_disparity : 0, end = p.min_disparity + p.num_disparities;
    double columns = pair->width + low - (end > 0 ? end : 0);
    if (status == TOOL_OK)
        printf("%-5s %dx%d, %d disparities, block %d, %s: %8.3f ms, %6.3f ns per pixel and disparity, %zu "
               "bytes\n",
               params_mode_name(mode), pair->width, pair->height, p.num_disparities, p.block_size,
               options.memory == STAD_MEMORY_FAST ? "fast" : "small", 1e3 * median,
               1e9 * median / (columns * pair->height * p.num_disparities), e.work_bytes);
    engine_close(&e);
    return status;
}

static int draw_pair(const bench_job *j, picture *pair, tool_fail *f)
{
    static scene s;
    int32_t *truth;
    picture visible;
    scene_random(&s, (int)j->width, (int)j->height, 0, 64, 12, 1);
    s.camera_noise = 6;
    int status = scene_render(&s, &pair[0], &pair[1], &truth, &visible, f);
    if (status == TOOL_OK) {
        free(truth);
        picture_free(&visible);
    }
    return status;
}

/* The mode asked for, else every one; but 3WAY only where it takes the disparities. */
static int is_timed(const bench_job *j, int mode, const picture *pair)
{
    const int only = j->options.some.mode;
    stad_params p;
    tool_fail unused = {0};
    match_options options = j->options;
    if (only >= 0 || mode != STAD_MODE_3WAY)
        return only < 0 || only == mode;
    options.some.mode = STAD_MODE_SGBM;
    if (match_options_params(&options, pair->width, pair->channels, &p, &unused) || p.num_disparities % 16 == 0)
        return 1;
    printf("3way  left out: %d disparities are no multiple of 16\n", p.num_disparities);
    return 0;
}

static int work(bench_job *j, tool_fail *f)
{
    picture pair[2];
    const char *isa = getenv("STAD_ISA");
    int status = isa && *isa ? check_isa("STAD_ISA", isa, f) : TOOL_OK;
    if (status == TOOL_OK)
        status = match_options_file(&j->options, f);
    if (status == TOOL_OK && j->options.color)
        status = tool_fail_set(f, TOOL_USAGE, "--color: the scene that is timed is grey");
    if (status == TOOL_OK)
        status = draw_pair(j, pair, f);
    if (status)
        return status;
    printf("kernels: %s\n", stad_x86_tier_name ? stad_x86_tier_name() : STAD_PORT);
    for (int mode = 0; mode < 4 && status == TOOL_OK; mode++)
        if (is_timed(j, mode, pair))
            status = bench_mode(j, mode, pair, f);
    picture_free(&pair[0]);
    picture_free(&pair[1]);
    return status;
}

int cmd_bench(int argc, char **argv)
{
    static bench_job j;
    tool_fail f = {0};
    j.width = 640;
    j.height = 480;
    j.frames = 9;
    int status = read_options(&j, argc, argv, &f);
    if (status >= 0)
        return status;
    return work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
}
