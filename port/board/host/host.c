/* SPDX-License-Identifier: MIT
 * board/host/host.c - the board that is an ordinary process: the reference of every other, and user-mode emulation. */
#include <stdio.h>
#include <stdlib.h>

#include "../board.h"

void board_print(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

void board_exit(int code)
{
    exit(code);
}

long board_read_file(const char *path, void *to, long bytes)
{
    FILE *file = fopen(path, "rb");
    long read;
    if (file == NULL)
        return -1;
    read = (long)fread(to, 1, (size_t)bytes, file);
    fclose(file);
    return read;
}

size_t board_stack_used(void)
{
    return 0;
}
