/* SPDX-License-Identifier: MIT
 * common/fail.h - how the tools say what went wrong: an exit status and one line that names the culprit. */
#ifndef TOOL_FAIL_H
#define TOOL_FAIL_H

#ifdef __cplusplus
extern "C" {
#endif

/* The exit statuses of every tool. */
enum tool_exit {
    TOOL_OK = 0,
    TOOL_REFUSED = 1, /* a comparison or an acceptance failed */
    TOOL_USAGE = 2,   /* bad usage or parameter */
    TOOL_FILE = 3     /* a file cannot be read or written, or is malformed */
};

/* Filled by the first call that fails; the caller owns it, and whoever is outermost prints it. */
typedef struct tool_fail {
    int status;
    char text[600];
} tool_fail;

/* Keeps status and text, and returns the status. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
int tool_fail_set(tool_fail *f, int status, const char *format, ...);

#ifdef __cplusplus
}
#endif

#endif
