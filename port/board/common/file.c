/* SPDX-License-Identifier: MIT
 * board/common/file.c - files of the host, by semihosting. */
#include <stddef.h>

#include "../board.h"
#include "semihost.h"

enum { SYS_OPEN = 0x01, SYS_CLOSE = 0x02, SYS_READ = 0x06, READ_BINARY = 1 };

static size_t length_of(const char *text)
{
    size_t n = 0;
    while (text[n] != '\0')
        n++;
    return n;
}

long board_read_file(const char *path, void *to, long bytes)
{
    const uintptr_t open[3] = {(uintptr_t)path, READ_BINARY, length_of(path)};
    const intptr_t handle = board_semihost(SYS_OPEN, open);
    const uintptr_t read[3] = {(uintptr_t)handle, (uintptr_t)to, (uintptr_t)bytes}, close[1] = {(uintptr_t)handle};
    intptr_t left;
    if (handle < 0)
        return -1;
    left = board_semihost(SYS_READ, read); /* what it did not read */
    board_semihost(SYS_CLOSE, close);
    return left < 0 || left > bytes ? -1 : bytes - (long)left;
}
