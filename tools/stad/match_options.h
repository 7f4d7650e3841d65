/* SPDX-License-Identifier: MIT
 * stad/match_options.h - the options that say how to match, shared by every command that matches. */
#ifndef STAD_MATCH_OPTIONS_H
#define STAD_MATCH_OPTIONS_H

#include "../common/params_text.h"
#include "stad/match.h"

/* What getopt_long returns for them: OPT_FIELD plus the field, then these. */
#define OPT_FIELD 0x100
enum match_option_code { OPT_MODE = 0x200, OPT_PARAMS, OPT_MEMORY, OPT_COLOR, OPT_GRAY };

/* For a table of getopt_long. */
/* clang-format off */
#define MATCH_OPTIONS                                                                   \
    {"min-disparity", required_argument, NULL, OPT_FIELD + FIELD_MIN_DISPARITY},         \
    {"num-disparities", required_argument, NULL, OPT_FIELD + FIELD_NUM_DISPARITIES},     \
    {"block-size", required_argument, NULL, OPT_FIELD + FIELD_BLOCK_SIZE},               \
    {"p1", required_argument, NULL, OPT_FIELD + FIELD_P1},                               \
    {"p2", required_argument, NULL, OPT_FIELD + FIELD_P2},                               \
    {"disp12-max-diff", required_argument, NULL, OPT_FIELD + FIELD_DISP12_MAX_DIFF},     \
    {"pre-filter-cap", required_argument, NULL, OPT_FIELD + FIELD_PRE_FILTER_CAP},       \
    {"uniqueness-ratio", required_argument, NULL, OPT_FIELD + FIELD_UNIQUENESS_RATIO},   \
    {"speckle-window-size", required_argument, NULL, OPT_FIELD + FIELD_SPECKLE_WINDOW_SIZE}, \
    {"speckle-range", required_argument, NULL, OPT_FIELD + FIELD_SPECKLE_RANGE},         \
    {"mode", required_argument, NULL, OPT_MODE},                                         \
    {"params", required_argument, NULL, OPT_PARAMS},                                     \
    {"memory", required_argument, NULL, OPT_MEMORY},                                     \
    {"color", no_argument, NULL, OPT_COLOR},                                             \
    {"gray", no_argument, NULL, OPT_GRAY}
/* clang-format on */

/* The same for a help text; `otherwise` says what holds without --mode. */
#define MATCH_OPTIONS_HELP MATCH_OPTIONS_HELP_FOR("sgbm")
#define MATCH_OPTIONS_HELP_FOR(otherwise)                                                                                   \
    "  --mode sgbm|hh|3way|hh4      as cv::StereoSGBM's modes (" otherwise ")\n"                                            \
    "  --min-disparity N            smallest disparity searched, px (0)\n"                                                  \
    "  --num-disparities N          how many, a multiple of 8, in 3way of 16 (an eighth of the width)\n"                    \
    "  --block-size N               side of the matching block, odd (3)\n"                                                  \
    "  --p1 N, --p2 N               costs of small and large disparity steps (8 c b^2, 32 c b^2)\n"                         \
    "  --disp12-max-diff N          largest left-right difference, px (1)\n"                                                \
    "  --pre-filter-cap N           clip of the prefilter, odd, at least 15 (63)\n"                                         \
    "  --uniqueness-ratio N         percent by which the best must win (10)\n"                                              \
    "  --speckle-window-size N, --speckle-range N   speckle filter (0 = off)\n"                                             \
    "  --params FILE.json           parameters by name, or what `stad tune` or `stad simulate --json` wrote; options win\n" \
    "  --memory fast|small          same result, more time or more memory (fast)\n"                                         \
    "  --gray, --color              match on grey (default) or on three channels\n"

typedef struct match_options {
    params_some some; /* from options */
    const char *params_path;
    int memory, color, gray; /* gray: only that it was said */
} match_options;

void match_options_init(match_options *o);

/* Takes one option; *mine says whether it was one of these. */
int match_options_take(match_options *o, int code, const char *argument, int *mine, tool_fail *f);

/* Reads the parameter file, if one was named, below the options. Once, after all options are in. */
int match_options_file(match_options *o, tool_fail *f);

int match_options_mode(const match_options *o);

/* The parameters for images of this shape, checked. */
int match_options_params(const match_options *o, int width, int channels, stad_params *p, tool_fail *f);

#endif
