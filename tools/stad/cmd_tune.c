/* SPDX-License-Identifier: MIT
 * stad/cmd_tune.c - stad tune: better parameters for pairs with ground truth. */
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../common/whole_file.h"
#include "interrupt.h"
#include "report.h"
#include "report_make.h"
#include "tool.h"
#include "tune_job.h"

static const char help[] =
    "usage: stad tune LEFT RIGHT --truth FILE [options]\n"
    "       stad tune LEFT RIGHT --fiducials --focal PX [options]\n"
    "       stad tune --scenes LIST.json [options]\n\n"
    "Searches the matcher's parameters for the least cost, by nonlinear conjugate gradient on the lattice of "
    "whole numbers.\n\n"
    "  --truth FILE, --mask FILE, --truth-scale S   as for `stad eval`\n"
    "  --scenes LIST.json   [{\"left\": FILE, \"right\": FILE, \"truth\": FILE, \"mask\": FILE, "
    "\"truth_scale\": S,\n"
    "                       \"min_disparity\": N, \"num_disparities\": N}, ...], the last four as needed; "
    "the mean cost counts\n"
    "  --fiducials          the frames show the target of `stad sheet`: its planes are the truth. With a\n"
    "                       board's loop this shares detector, rig check and truth alone: no penalty for going\n"
    "                       far from the start, and no other pose that has to confirm the result\n"
    "  --method ncg|ncg-paper|sd|hybrid|descent     (ncg)\n"
    "  --cost bad|chow|d1|rmse|mae|missing          (bad)\n"
    "  --threshold PX       error above which a pixel is wrong (1)\n"
    "  --max-evals N        distinct evaluations at most, 1..240 (100); an interrupt ends the search after the one at\n"
    "                       hand: what was found is written\n"
    "  --share N            frames whose winners are kept, 8 bytes a pixel each, the best N - 1 and the last:\n"
    "                       points that differ only in uniqueness_ratio or disp12_max_diff then need no matching\n"
    "                       (3; same result).\n"
    "                       For bad the search settles these two wherever it gets to: a third of its points\n"
    "  --seed N             0..4294967295, of the draws of hybrid, and of the crosses that end ncg and hybrid (0). The same\n"
    "                       seed and costs give the same search on every machine\n"
    "  --start default|sample|NAME=V,...            cv::StereoSGBM::create()'s own, its sample's (sample), "
    "values laid over\n"
    "                       (a file's too: --params);\n"
    "                       a value outside the bounds searched (stad/tune.h) widens them: block_size=21 lets\n"
    "                       every point have a block of up to 21\n"
    "  --free NAME,...      what may vary "
    "(p1,p2,block_size,uniqueness_ratio,pre_filter_cap,disp12_max_diff)\n"
    "  --json OUT           how it was searched, start, best, and the trace: [evaluation, cost, best so far, point]\n"
    "  --header OUT.h       the best parameters as C\n"
    "  --report OUT.html    before and after, to look at: one file\n"
    "  --focal PX, --center X,Y                     of both cameras, for --fiducials (the middle)\n"
    "  --baseline METRES    with --focal the report shows distances too\n" MATCH_OPTIONS_HELP
    "\nExample: stad tune left.png right.png --truth truth.pfm --num-disparities 64 --json tuned.json\n"
    "         stad match left.png right.png --params tuned.json -o disp.npy\n";

enum {
    OPT_TRUTH = 1,
    OPT_SCENES,
    OPT_MASK,
    OPT_SCALE,
    OPT_METHOD,
    OPT_COST,
    OPT_THRESHOLD,
    OPT_EVALS,
    OPT_SHARE,
    OPT_SEED,
    OPT_START,
    OPT_FREE,
    OPT_JSON,
    OPT_HEADER,
    OPT_REPORT,
    OPT_FOCAL,
    OPT_BASELINE,
    OPT_CENTER,
    OPT_FIDUCIALS
};

static const struct option longs[] = {MATCH_OPTIONS,
                                      {"truth", required_argument, NULL, OPT_TRUTH},
                                      {"scenes", required_argument, NULL, OPT_SCENES},
                                      {"mask", required_argument, NULL, OPT_MASK},
                                      {"truth-scale", required_argument, NULL, OPT_SCALE},
                                      {"method", required_argument, NULL, OPT_METHOD},
                                      {"cost", required_argument, NULL, OPT_COST},
                                      {"threshold", required_argument, NULL, OPT_THRESHOLD},
                                      {"max-evals", required_argument, NULL, OPT_EVALS},
                                      {"share", required_argument, NULL, OPT_SHARE},
                                      {"seed", required_argument, NULL, OPT_SEED},
                                      {"start", required_argument, NULL, OPT_START},
                                      {"free", required_argument, NULL, OPT_FREE},
                                      {"json", required_argument, NULL, OPT_JSON},
                                      {"header", required_argument, NULL, OPT_HEADER},
                                      {"report", required_argument, NULL, OPT_REPORT},
                                      {"focal", required_argument, NULL, OPT_FOCAL},
                                      {"baseline", required_argument, NULL, OPT_BASELINE},
                                      {"center", required_argument, NULL, OPT_CENTER},
                                      {"fiducials", no_argument, NULL, OPT_FIDUCIALS},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

static const tool_vain vain[] = {
    {TOOL_BIT(OPT_TRUTH), 0, TOOL_BIT(OPT_SCENES), "--truth has no effect with --scenes: the list names it"},
    {TOOL_BIT(OPT_MASK), 0, TOOL_BIT(OPT_SCENES), "--mask has no effect with --scenes: the list names it"},
    {TOOL_BIT(OPT_SCALE), 0, TOOL_BIT(OPT_SCENES) | TOOL_BIT(OPT_FIDUCIALS),
     "--truth-scale has no effect with --scenes or --fiducials"},
    {TOOL_BIT(OPT_FIDUCIALS), 0, TOOL_BIT(OPT_SCENES), "--fiducials has no effect with --scenes"},
    {TOOL_BIT(OPT_CENTER), TOOL_BIT(OPT_FIDUCIALS), 0, "--center has no effect without --fiducials"},
    {TOOL_BIT(OPT_FOCAL), TOOL_BIT(OPT_FIDUCIALS) | TOOL_BIT(OPT_BASELINE), 0,
     "--focal has no effect without --fiducials, or --baseline and --report"},
    {TOOL_BIT(OPT_BASELINE), TOOL_BIT(OPT_FOCAL), 0, "--baseline has no effect without --focal"},
    {TOOL_BIT(OPT_BASELINE), TOOL_BIT(OPT_REPORT), 0, "--baseline has no effect without --report"}};

/* Calls `take` for every part of "a,b,c", which is cut up. */
static int each_part(char *list, int (*take)(tune_job *, char *, tool_fail *), tune_job *j, tool_fail *f)
{
    int status = TOOL_OK;
    for (char *part = list; part && status == TOOL_OK;) {
        char *comma = strchr(part, ',');
        if (comma)
            *comma = 0;
        status = take(j, part, f);
        part = comma ? comma + 1 : NULL;
    }
    return status;
}

static int take_start(tune_job *j, char *part, tool_fail *f)
{
    char *equals = strchr(part, '=');
    if (!equals && (strcmp(part, "default") == 0 || strcmp(part, "sample") == 0)) {
        if (j->from && j->from != part[0])
            return tool_fail_set(f, TOOL_USAGE, "--start default and --start sample: one of them, not both");
        j->from = part[0];
        return TOOL_OK;
    }
    if (equals)
        *equals = 0;
    int field = params_field_find(part);
    if (!equals || field < 0)
        return tool_fail_set(f, TOOL_USAGE, "--start %s: must be default, sample, or NAME=VALUE of a parameter", part);
    if (j->start.given >> field & 1)
        return tool_fail_set(f, TOOL_USAGE, "--start %s: it is there twice", part);
    tool_fail why;
    j->start.path[field] = "--start";
    if (params_some_set(&j->start, field, equals + 1, &why) == TOOL_OK)
        return TOOL_OK;
    const char *colon = strstr(why.text, ": "); /* behind "--p1 99999" */
    return tool_fail_set(f, why.status, "--start %.80s=%.80s%.400s", part, equals + 1, colon ? colon : "");
}

static int take_free(tune_job *j, char *part, tool_fail *f)
{
    int field = params_field_find(part);
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        if (tune_field(i) == field) {
            j->free_mask |= 1u << i;
            return TOOL_OK;
        }
    return tool_fail_set(f, TOOL_USAGE, "--free %s: can be p1, p2, block_size, uniqueness_ratio, pre_filter_cap, disp12_max_diff",
                         part);
}

static int take_name(const char *option, int *to, int found, tool_fail *f)
{
    *to = found;
    if (found >= 0)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "--%s %s: there is none of that name; see --help", option, optarg);
}

static int take(tune_job *j, int code, tool_fail *f)
{
    scored_scene *one = &j->set.scene[0];
    switch (code) {
    case OPT_TRUTH:
        one->truth_path = optarg;
        return TOOL_OK;
    case OPT_MASK:
        one->mask_path = optarg;
        return TOOL_OK;
    case OPT_SCALE:
        return tool_real("truth-scale", optarg, 1e-3, 65536, &one->truth_scale, f);
    case OPT_SCENES:
        j->list = optarg;
        return TOOL_OK;
    case OPT_METHOD:
        return take_name("method", &j->method, tune_method_of(optarg), f);
    case OPT_COST:
        return take_name("cost", &j->how.cost, tune_cost_of(optarg), f);
    case OPT_THRESHOLD:
        return tool_real("threshold", optarg, 0, 4095, &j->how.threshold, f);
    case OPT_EVALS:
        return tool_whole("max-evals", optarg, 1, STAD_TUNE_LOG, &j->max_evals, f);
    case OPT_SHARE:
        return tool_whole("share", optarg, 0, STAD_TUNE_LOG, &j->share, f);
    case OPT_SEED:
        return tool_whole("seed", optarg, 0, UINT32_MAX, &j->seed, f);
    case OPT_START:
        return each_part(optarg, take_start, j, f);
    case OPT_FREE:
        return each_part(optarg, take_free, j, f);
    case OPT_JSON:
        j->json = optarg;
        return TOOL_OK;
    case OPT_HEADER:
        j->header = optarg;
        return TOOL_OK;
    case OPT_REPORT:
        j->report = optarg;
        return TOOL_OK;
    case OPT_FOCAL:
    case OPT_BASELINE:
        return report_rig_option(&j->rig, code == OPT_FOCAL, optarg, f);
    case OPT_CENTER:
        return tool_point("center", optarg, &j->cx, &j->cy, f);
    default:
        one->fiducials = 1;
        return TOOL_OK;
    }
}

/* A value said twice: by --start and by the option of that name. */
static int check_start(const tune_job *j, tool_fail *f)
{
    for (int i = 0; i < FIELD_COUNT; i++)
        if (j->start.given & j->options.some.given & 1u << i)
            return tool_fail_set(f, TOOL_USAGE, "--start %s=%ld and --%s %ld: one of them, not both", params_field_name(i),
                                 j->start.value[i], params_field_option(i), j->options.some.value[i]);
    return TOOL_OK;
}

/* A named start that nothing is left of, because the file says it all. */
static int check_file(const tune_job *j, tool_fail *f)
{
    if (!j->from || !j->options.params_path || j->options.some.given != (1u << FIELD_COUNT) - 1)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "--start %s has no effect: %s and the options hold every parameter",
                         j->from == 'd' ? "default" : "sample", j->options.params_path);
}

static int take_words(tune_job *j, int argc, char **argv, tool_fail *f)
{
    if (!j->list && argc - optind < 2)
        return tool_fail_set(f, TOOL_USAGE,
                             argc == optind ? "LEFT and RIGHT are missing" : "RIGHT is missing: LEFT and RIGHT are wanted");
    if (tool_words(argc, optind, j->list ? 0 : 2, j->list ? "--scenes alone is" : "LEFT and RIGHT are", f))
        return f->status;
    if (j->list)
        return TOOL_OK;
    const scored_scene *one = &j->set.scene[0];
    if (!one->truth_path && !one->fiducials)
        return tool_fail_set(f, TOOL_USAGE, "--truth FILE, --fiducials or --scenes LIST.json is wanted: what to tune on");
    if (one->truth_path && one->truth_scale > 0 && !truth_has_scale(one->truth_path))
        return tool_fail_set(f, TOOL_USAGE, "--truth-scale has no effect: %s holds pixels", one->truth_path);
    if (one->fiducials && (one->truth_path || one->mask_path || j->rig.focal_px <= 0))
        return tool_fail_set(f, TOOL_USAGE, "--fiducials goes with --focal PX, and without --truth and --mask");
    j->set.scene[0].left_path = argv[optind];
    j->set.scene[0].right_path = argv[optind + 1];
    return TOOL_OK;
}

static int read_options(tune_job *j, int argc, char **argv, tool_fail *f)
{
    int code, mine;
    unsigned long long given = 0;
    match_options_init(&j->options);
    params_some_init(&j->start);
    j->share = 3;
    while ((code = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
        int status = match_options_take(&j->options, code, optarg, &mine, f);
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (status == TOOL_OK && !mine) {
            given |= TOOL_BIT(code);
            status = take(j, code, f);
        }
        if (status)
            return tool_report(argv[0], f);
    }
    if (tool_refuse_vain(vain, sizeof vain / sizeof vain[0], given, f) || check_start(j, f))
        return tool_report(argv[0], f);
    return take_words(j, argc, argv, f) ? tool_report(argv[0], f) : -1;
}

static int check_apart(const tune_job *j, tool_fail *f)
{
    const char *const outs[] = {j->json, j->header, j->report};
    const char *const files[] = {j->options.params_path, j->list};
    int status = tool_out_apart(outs, 3, files, 2, f);
    for (int i = 0; i < j->set.count && status == TOOL_OK; i++) {
        const scored_scene *c = &j->set.scene[i];
        const char *const ins[] = {c->left_path, c->right_path, c->truth_path, c->mask_path};
        status = tool_out_apart(outs, 3, ins, 4, f);
    }
    return status;
}

static int check_outputs(const tune_job *j, tool_fail *f)
{
    int status = check_apart(j, f);
    if (status == TOOL_OK && j->json)
        status = tool_out_check(j->json, f);
    if (status == TOOL_OK && j->header)
        status = tool_out_check(j->header, f);
    if (status == TOOL_OK && j->report)
        status = tool_out_check(j->report, f);
    return status;
}

static int work(tune_job *j, tool_fail *f)
{
    int status = match_options_file(&j->options, f);
    if (status == TOOL_OK)
        status = check_file(j, f);
    j->how.mode = match_options_mode(&j->options);
    j->how.memory = j->options.memory;
    if (status == TOOL_OK && j->list) {
        scene_set_free(&j->set);
        status = scene_set_list(&j->set, j->list, f);
    }
    if (status == TOOL_OK)
        status = check_outputs(j, f);
    if (status == TOOL_OK)
        status = tune_search(j, f);
    if (status == TOOL_OK && j->json)
        status = tune_write_json(j, f);
    if (status == TOOL_OK && j->header)
        status = tune_write_header(j, f);
    if (status == TOOL_OK && j->report)
        status = report_tune(j->report, j->command, &j->rig, j, f);
    if (status == TOOL_OK)
        tune_print(j);
    if (status == TOOL_OK && j->stopped[0])
        status = tool_fail_set(f, 128 + interrupt_seen(), "%s", j->stopped);
    return status;
}

int cmd_tune(int argc, char **argv)
{
    static tune_job j; /* holds the tuner's log */
    tool_fail f = {0};
    j.how.threshold = 1;
    j.cx = j.cy = (double)NAN;
    if (scene_set_single(&j.set, &f))
        return tool_report(argv[0], &f);
    j.command = report_command(argc, argv);
    int status = read_options(&j, argc, argv, &f);
    if (status < 0)
        status = work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
    scene_set_free(&j.set);
    free(j.command);
    return status;
}
