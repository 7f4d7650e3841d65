/* SPDX-License-Identifier: MIT
 * stad/tool.c - what the commands of `stad` share. */
#include "tool.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

int tool_help(const char *text)
{
    fputs(text, stdout);
    return TOOL_OK;
}

int tool_report(const char *command, const tool_fail *f)
{
    progress_end();
    fprintf(stderr, "%s: %s\n", command, f->text);
    return f->status;
}

void tool_note(const char *command, const char *what, const tool_fail *f)
{
    progress_end();
    fprintf(stderr, "%s: %s%s\n", command, what, f->text);
}

int tool_usage(const char *command)
{
    fprintf(stderr, "%s: see `%s --help`\n", command, command);
    return TOOL_USAGE;
}

int tool_words(int argc, int first, int count, const char *wanted, tool_fail *f)
{
    if (argc - first == count)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "%s wanted, and %s given", wanted,
                         argc - first < count ? "too few words were" : "more was");
}

int tool_real(const char *option, const char *text, double lo, double hi, double *value, tool_fail *f)
{
    char *end;
    errno = 0;
    *value = strtod(text, &end);
    if (end == text || *end || errno || !(*value >= lo && *value <= hi))
        return tool_fail_set(f, TOOL_USAGE, "--%s %s: must be a number in %g..%g", option, text, lo, hi);
    return TOOL_OK;
}

int tool_whole(const char *option, const char *text, long lo, long hi, long *value, tool_fail *f)
{
    char *end;
    errno = 0;
    *value = strtol(text, &end, 10);
    if (end == text || *end || errno || *value < lo || *value > hi)
        return tool_fail_set(f, TOOL_USAGE, "--%s %s: must be a whole number in %ld..%ld", option, text, lo, hi);
    return TOOL_OK;
}

int tool_refuse_vain(const tool_vain *list, int count, unsigned long long given, tool_fail *f)
{
    for (int i = 0; i < count; i++)
        if ((given & list[i].option) && ((given & list[i].when) || (list[i].unless && !(given & list[i].unless))))
            return tool_fail_set(f, TOOL_USAGE, "%s", list[i].says);
    return TOOL_OK;
}

int tool_point(const char *option, const char *text, double *x, double *y, tool_fail *f)
{
    char end;
    if (sscanf(text, "%lf,%lf%c", x, y, &end) == 2 && fabs(*x) < 1e5 && fabs(*y) < 1e5)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_USAGE, "--%s %s: must be X,Y in pixels", option, text);
}

stad_camera tool_camera(double focal_px, double cx, double cy, int width, int height)
{
    const double x = isnan(cx) ? (width - 1) / 2.0 : cx, y = isnan(cy) ? (height - 1) / 2.0 : cy;
    const stad_camera c = {(int32_t)lround(focal_px * 256), (int32_t)lround(x * 256), (int32_t)lround(y * 256)};
    return c;
}

static int progress_shown;

void progress_line(const char *format, ...)
{
    va_list args;
    if (!isatty(STDERR_FILENO))
        return;
    fputc('\r', stderr);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fputs("\033[K", stderr);
    fflush(stderr);
    progress_shown = 1;
}

void progress_end(void)
{
    if (progress_shown)
        fputc('\n', stderr);
    progress_shown = 0;
}

double tool_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
