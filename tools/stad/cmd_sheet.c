/* SPDX-License-Identifier: MIT
 * stad/cmd_sheet.c - stad sheet: the printable calibration target. */
#include <getopt.h>
#include <stdio.h>
#include <string.h>

#include "../sheet/sheet.h"
#include "tool.h"

static const char help[] = "usage: stad sheet -o FILE.pdf|FILE.svg [options]\n\n"
                           "Writes the calibration target in true scale: the base with its marks and a ruler "
                           "to check the print by, the raised parts as\n"
                           "nets to cut (solid lines), fold (dashed) and glue, and a page on how to build "
                           "and mount it. SVG: one file a page, FILE-1.svg\n"
                           "and on. The same options give the same bytes everywhere.\n\n"
                           "  -o, --output FILE            .pdf or .svg\n"
                           "  --paper a4|letter            (a4), lying\n"
                           "  --target relief|card         the relief to tune on, or the flat card to hold "
                           "in front of it (relief)\n\n"
                           "Example: stad sheet -o target.pdf --paper letter\n";

static const struct option longs[] = {{"output", required_argument, NULL, 'o'},
                                      {"paper", required_argument, NULL, 'p'},
                                      {"target", required_argument, NULL, 't'},
                                      {"help", no_argument, NULL, 'h'},
                                      {NULL, 0, NULL, 0}};

typedef struct sheet_job {
    const char *path, *paper, *target;
} sheet_job;

static const stad_target *target_named(const char *name)
{
    if (strcmp(name, "relief") == 0)
        return stad_target_relief();
    return strcmp(name, "card") == 0 ? stad_target_card() : NULL;
}

static int run(const sheet_job *j, tool_fail *f)
{
    const sheet_paper *paper = sheet_paper_named(j->paper);
    const stad_target *target = target_named(j->target);
    if (!j->path)
        return tool_fail_set(f, TOOL_USAGE, "-o FILE is missing");
    if (!paper)
        return tool_fail_set(f, TOOL_USAGE, "--paper %s: a4 or letter", j->paper);
    if (!target)
        return tool_fail_set(f, TOOL_USAGE, "--target %s: relief or card", j->target);
    return sheet_write(target, paper, j->path, f);
}

int cmd_sheet(int argc, char **argv)
{
    sheet_job job = {NULL, "a4", "relief"};
    tool_fail f = {TOOL_OK, ""};
    int code;
    while ((code = getopt_long(argc, argv, "o:h", longs, NULL)) != -1) {
        if (code == 'h')
            return tool_help(help);
        if (code == '?')
            return tool_usage(argv[0]);
        *(code == 'o' ? &job.path : code == 'p' ? &job.paper : &job.target) = optarg;
    }
    if (tool_words(argc, optind, 0, "no further words", &f) != TOOL_OK || run(&job, &f) != TOOL_OK)
        return tool_report(argv[0], &f);
    return TOOL_OK;
}
