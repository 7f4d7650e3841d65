/* SPDX-License-Identifier: MIT
 * stad/tool.h - what the commands of `stad` share. */
#ifndef STAD_TOOL_H
#define STAD_TOOL_H

#include "../common/fail.h"
#include "stad/target.h"

/* The commands. argv[0] is "stad NAME", which getopt_long puts in front of its own messages; the result is an exit status. */
int cmd_match(int argc, char **argv);
int cmd_eval(int argc, char **argv);
int cmd_tune(int argc, char **argv);
int cmd_plan(int argc, char **argv);
int cmd_scene(int argc, char **argv);
int cmd_sheet(int argc, char **argv);
int cmd_bench(int argc, char **argv);
int cmd_simulate(int argc, char **argv);

/* Prints a help text and says that all went well. */
int tool_help(const char *text);

/* Prints "stad NAME: what went wrong" and hands back the status. */
int tool_report(const char *command, const tool_fail *f);

/* The same for something that does not end the work. */
void tool_note(const char *command, const char *what, const tool_fail *f);

/* After an option that getopt_long has complained about already. */
int tool_usage(const char *command);

/* Exactly `count` words after the options, or a message that tells which are wanted. */
int tool_words(int argc, int first, int count, const char *wanted, tool_fail *f);

/* "1.5" within lo..hi, or a message that names the option. */
int tool_real(const char *option, const char *text, double lo, double hi, double *value, tool_fail *f);
int tool_whole(const char *option, const char *text, long lo, long hi, long *value, tool_fail *f);

/* An option that does nothing unless one of others is given, or when one is. Options are bits: TOOL_BIT(their code in getopt_long). */
typedef struct tool_vain {
    unsigned long long option, unless, when;
    const char *says; /* "--from has no effect without --noise" */
} tool_vain;

#define TOOL_BIT(code) (1ull << ((code) & 63))

/* Refuses the first option of the list that was given in vain. */
int tool_refuse_vain(const tool_vain *list, int count, unsigned long long given, tool_fail *f);

/* "X,Y", on the picture or not. */
int tool_point(const char *option, const char *text, double *x, double *y, tool_fail *f);

/* Both views' camera; a principal point that is not a number is the middle. */
stad_camera tool_camera(double focal_px, double cx, double cy, int width, int height);

/* A line that is rewritten on a terminal, and nothing at all elsewhere. */
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
void progress_line(const char *format, ...);
void progress_end(void);

/* Seconds of a steady clock. */
double tool_seconds(void);

#endif
