/* SPDX-License-Identifier: MIT
 * stad/cmd_plan.c - stad plan: how many bytes a matcher takes, before anything is built for a board. */
#include <cjson/cJSON.h>
#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "../common/params_text.h"
#include "plan_board.h"
#include "stad/match.h"
#include "tool.h"

static const char help[] =
    "usage: stad plan --width W --height H --num-disparities D [options]\n\n"
    "Bytes of the matcher's workspace by part, for every mode and memory plan. The speckle filter's labels "
    "are extra, needed\n"
    "only where it is on.\n\n"
    "  --width W, --height H        of the frames, px\n"
    "  --num-disparities D          the largest that will be used\n"
    "  --block-size B               the largest that will be used (3)\n"
    "  --channels C                 1 or 3 (1)\n"
    "  --max-p2 N                   the largest p2; up to 255 the small plan stores paths in bytes (32 C "
    "B^2)\n"
    "  --max-pre-filter-cap N       the largest cap (63)\n"
    "  --board NAME                 what of it fits a board of port/board, and about how many instructions a "
    "frame takes\n"
    "  --json                       one JSON object: {\"sgbm\": {\"fast\": {\"total\": N, \"parts\": ...}, "
    "\"small\": ...}, ...}\n\n"
    "Example: stad plan --width 320 --height 240 --num-disparities 64 --block-size 5\n";

enum plan_field { PLAN_WIDTH, PLAN_HEIGHT, PLAN_NUM, PLAN_BLOCK, PLAN_CHANNELS, PLAN_P2, PLAN_CAP, PLAN_FIELDS };

static const char *const names[PLAN_FIELDS] = {"width",    "height", "num-disparities",   "block-size",
                                               "channels", "max-p2", "max-pre-filter-cap"};

static const struct option longs[] = {{"width", required_argument, NULL, PLAN_WIDTH},
                                      {"height", required_argument, NULL, PLAN_HEIGHT},
                                      {"num-disparities", required_argument, NULL, PLAN_NUM},
                                      {"block-size", required_argument, NULL, PLAN_BLOCK},
                                      {"channels", required_argument, NULL, PLAN_CHANNELS},
                                      {"max-p2", required_argument, NULL, PLAN_P2},
                                      {"max-pre-filter-cap", required_argument, NULL, PLAN_CAP},
                                      {"board", required_argument, NULL, 'b'},
                                      {"json", no_argument, NULL, 'j'},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

typedef struct plan_job {
    long v[PLAN_FIELDS];
    int json;
    const plan_board *board; /* or NULL */
} plan_job;

static int read_board(plan_job *j, tool_fail *f)
{
    char names_of_all[256];
    j->board = plan_board_named(optarg);
    if (j->board)
        return TOOL_OK;
    plan_board_names(names_of_all, sizeof names_of_all);
    return tool_fail_set(f, TOOL_USAGE, "--board %s: not one of %s", optarg, names_of_all);
}

static int read_options(plan_job *j, int argc, char **argv, tool_fail *f)
{
    int code;
    while ((code = getopt_long(argc, argv, "h", longs, NULL)) != -1) {
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        if (code == 'j')
            j->json = 1;
        else if (code == 'b') {
            if (read_board(j, f))
                return tool_report(argv[0], f);
        } else if (tool_whole(names[code], optarg, 1, INT16_MAX, &j->v[code], f))
            return tool_report(argv[0], f);
    }
    if (tool_words(argc, optind, 0, "only options are", f))
        return tool_report(argv[0], f);
    return -1;
}

/* stad_geometry_check() in words: option, value, and what is allowed. */
static int refused(const plan_job *j, const char *culprit, tool_fail *f)
{
    static const struct {
        const char *culprit, *allowed;
        enum plan_field field;
    } rules[] = {{"channels", "1 or 3", PLAN_CHANNELS},
                 {"max_disparities", "a multiple of 8 in 8..4088", PLAN_NUM},
                 {"max_block_size", "odd and at least 1", PLAN_BLOCK},
                 {"max_p2", "at least 2", PLAN_P2},
                 {"max_pre_filter_cap", "odd and at least 15", PLAN_CAP}};
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++)
        if (strcmp(culprit, rules[i].culprit) == 0)
            return tool_fail_set(f, TOOL_USAGE, "--%s %ld: must be %s", names[rules[i].field], j->v[rules[i].field],
                                 rules[i].allowed);
    return tool_fail_set(f, TOOL_USAGE, "%ld x %ld frames, %ld disparities: no matcher can be so large", j->v[PLAN_WIDTH],
                         j->v[PLAN_HEIGHT], j->v[PLAN_NUM]);
}

static int geometry_of(const plan_job *j, int mode, int memory, stad_geometry *g, tool_fail *f)
{
    const char *culprit = NULL;
    long p2 = j->v[PLAN_P2] ? j->v[PLAN_P2] : 32 * j->v[PLAN_CHANNELS] * j->v[PLAN_BLOCK] * j->v[PLAN_BLOCK];
    *g = (stad_geometry){.width = (int16_t)j->v[PLAN_WIDTH],
                         .height = (int16_t)j->v[PLAN_HEIGHT],
                         .channels = (int16_t)j->v[PLAN_CHANNELS],
                         .max_disparities = (int16_t)j->v[PLAN_NUM],
                         .max_block_size = (int16_t)j->v[PLAN_BLOCK],
                         .max_p2 = (int16_t)(p2 > INT16_MAX ? INT16_MAX : p2),
                         .max_pre_filter_cap = (int16_t)j->v[PLAN_CAP],
                         .mode = (uint8_t)mode,
                         .memory = (uint8_t)memory};
    if (stad_geometry_check(g, &culprit) == STAD_OK)
        return TOOL_OK;
    return refused(j, culprit ? culprit : "", f);
}

static cJSON *plan_json(const stad_geometry *g, const plan_board *board)
{
    const char *name;
    size_t bytes;
    cJSON *o = cJSON_CreateObject(), *parts = cJSON_CreateObject();
    cJSON_AddNumberToObject(o, "total", (double)stad_match_bytes(g));
    for (int i = 0; (bytes = stad_match_part(g, i, &name)), name != NULL; i++)
        cJSON_AddNumberToObject(parts, name, (double)bytes);
    cJSON_AddItemToObject(o, "parts", parts);
    cJSON_AddNumberToObject(o, "speckle_labels", (double)STAD_SPECKLE_BYTES(g->width, g->height));
    if (board) {
        cJSON_AddNumberToObject(o, "board_left", (double)plan_board_left(board, g));
        if (plan_board_instructions(board, g) > 0)
            cJSON_AddNumberToObject(o, "board_instructions", plan_board_instructions(board, g));
    }
    return o;
}

/* One line a plan: what is left of the board's memory, what a frame takes. */
static void print_fit(const stad_geometry *g, const plan_board *board)
{
    const long left = plan_board_left(board, g);
    const double instructions = plan_board_instructions(board, g);
    printf("%-5s %-6s %10zu bytes  %s %ld %s", params_mode_name(g->mode), g->memory == STAD_MEMORY_FAST ? "fast" : "small",
           stad_match_bytes(g), left >= 0 ? "fits," : "does NOT fit,", left >= 0 ? left : -left, left >= 0 ? "left" : "too many");
    if (left >= 0 && instructions > 0)
        printf("; about %.1f million instructions a frame", instructions / 1e6);
    else if (left >= 0)
        printf("; instructions not counted for these settings");
    putchar('\n');
}

static void print_plan(const stad_geometry *g)
{
    const char *name;
    size_t bytes;
    printf("%s, %s: %zu bytes\n", params_mode_name(g->mode), g->memory == STAD_MEMORY_FAST ? "fast" : "small",
           stad_match_bytes(g));
    for (int i = 0; (bytes = stad_match_part(g, i, &name)), name != NULL; i++)
        if (bytes)
            printf("    %10zu  %s\n", bytes, name);
}

/* All modes and plans; those that the library refuses end the work. */
static int work(const plan_job *j, tool_fail *f)
{
    static const char *const plans[2] = {"fast", "small"};
    cJSON *all = cJSON_CreateObject();
    stad_geometry first;
    int status = geometry_of(j, 0, 0, &first, f);
    if (status == TOOL_OK && j->board && !j->json)
        plan_board_print(j->board, &first);
    for (int mode = 0; mode < 4 && status == TOOL_OK; mode++) {
        cJSON *both = cJSON_AddObjectToObject(all, params_mode_name(mode));
        for (int memory = 0; memory < 2 && status == TOOL_OK; memory++) {
            stad_geometry g;
            status = geometry_of(j, mode, memory, &g, f);
            if (status == TOOL_OK && j->json)
                cJSON_AddItemToObject(both, plans[memory], plan_json(&g, j->board));
            else if (status == TOOL_OK && j->board)
                print_fit(&g, j->board);
            else if (status == TOOL_OK)
                print_plan(&g);
        }
    }
    if (status == TOOL_OK && j->json) {
        char *text = cJSON_Print(all);
        if (text)
            puts(text);
        cJSON_free(text);
    } else if (status == TOOL_OK) {
        if (j->board && geometry_of(j, STAD_MODE_SGBM, STAD_MEMORY_SMALL, &first, f) == TOOL_OK)
            plan_board_print_loop(j->board, &first);
        printf("speckle filter, where it is on: %zu bytes of labels beside it\n",
               (size_t)STAD_SPECKLE_BYTES(j->v[PLAN_WIDTH], j->v[PLAN_HEIGHT]));
        printf("struct stad_match: %zu bytes\n", sizeof(stad_match));
    }
    cJSON_Delete(all);
    return status;
}

int cmd_plan(int argc, char **argv)
{
    plan_job j = {{0}, 0, NULL};
    tool_fail f = {0};
    j.v[PLAN_BLOCK] = 3;
    j.v[PLAN_CHANNELS] = 1;
    j.v[PLAN_CAP] = 63;
    int status = read_options(&j, argc, argv, &f);
    if (status >= 0)
        return status;
    for (int i = 0; i <= PLAN_NUM; i++)
        if (j.v[i] == 0) {
            tool_fail_set(&f, TOOL_USAGE, "--%s is wanted", names[i]);
            return tool_report(argv[0], &f);
        }
    return work(&j, &f) ? tool_report(argv[0], &f) : TOOL_OK;
}
