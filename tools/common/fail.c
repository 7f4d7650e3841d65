/* SPDX-License-Identifier: MIT
 * common/fail.c - one line that names the culprit. */
#include "fail.h"

#include <stdarg.h>
#include <stdio.h>

int tool_fail_set(tool_fail *f, int status, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(f->text, sizeof f->text, format, args);
    va_end(args);
    f->status = status;
    return status;
}
