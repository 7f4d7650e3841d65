/* SPDX-License-Identifier: MIT
 * common/whole_file.h - files are read whole, and written whole or not at all. */
#ifndef TOOL_WHOLE_FILE_H
#define TOOL_WHOLE_FILE_H

#include <stddef.h>
#include <stdio.h>

#include "fail.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Reads a file of at most `max` bytes into *bytes (malloc; the caller frees), with a zero byte after its end. */
int tool_read_whole(const char *path, size_t max, unsigned char **bytes, size_t *size, tool_fail *f);

/* A file under way, one at a time. It is written beside its final name and renamed at the end, so that a reader never sees half
 * of it and a failure or a signal leaves what was there before. A symbolic link stays: the file it names is written. A device
 * or a pipe is written as it is. */
typedef struct tool_out {
    FILE *stream;
    char *final;  /* the name it gets */
    char *beside; /* the name it has until then; NULL for a device or a pipe */
} tool_out;

/* Can `path` be written? Answers before the work is done, not after; changes nothing. */
int tool_out_check(const char *path, tool_fail *f);

/* Is every output another file than all inputs and all other outputs, whatever the names? NULL: not wanted. */
int tool_out_apart(const char *const *out, int outs, const char *const *in, int ins, tool_fail *f);

int tool_out_open(tool_out *o, const char *path, tool_fail *f);

/* Ends the file: `ok` nonzero keeps it, zero drops it (and the call returns f->status). A full disk shows here. */
int tool_out_close(tool_out *o, int ok, tool_fail *f);

/* Does `path` end in `suffix` (".png"), in any case? */
int tool_has_suffix(const char *path, const char *suffix);

#ifdef __cplusplus
}
#endif

#endif
