/* SPDX-License-Identifier: MIT
 * common/pfm.c - portable float maps: "Pf", width, height, a scale whose sign tells the byte order, rows bottom up. */
#include "grid.h"

#include <stdlib.h>
#include <string.h>

#include "grid_bytes.h"
#include "whole_file.h"

/* The header's length, or 0. The file ends with a zero byte beyond its size, so the text functions stop. */
static size_t parse_head(const uint8_t *file, size_t size, long *width, long *height, int *big_endian)
{
    const char *text = (const char *)file;
    char *end;
    if (size < 8 || strncmp(text, "Pf", 2) != 0 || !strchr(" \n\r\t", text[2]))
        return 0;
    *width = strtol(text + 2, &end, 10);
    *height = strtol(end, &end, 10);
    char *after = end;
    double scale = strtod(end, &end);
    if (end == after || scale == 0 || !strchr(" \n\r\t", *end) || !*end)
        return 0;
    *big_endian = scale > 0;
    if (*end == '\r' && end[1] == '\n')
        end++;
    return (size_t)(end + 1 - text);
}

static int read_body(grid *g, const uint8_t *file, size_t size, const char *path, tool_fail *f)
{
    long width, height;
    int big_endian;
    if (size >= 2 && memcmp(file, "PF", 2) == 0)
        return tool_fail_set(f, TOOL_FILE, "%s: a PFM of three channels; one is needed", path);
    size_t body = parse_head(file, size, &width, &height, &big_endian);
    if (body == 0 || body > size)
        return tool_fail_set(f, TOOL_FILE, "%s: not a .pfm file, or its header is damaged", path);
    int status = grid_alloc(g, width, height, path, f);
    if (status)
        return status;
    size_t n = (size_t)g->width * (size_t)g->height;
    if ((size - body) / 4 < n)
        return tool_fail_set(f, TOOL_FILE, "%s: bad .pfm: the file ends too early", path);
    for (int y = 0; y < g->height; y++) {
        const uint8_t *row = file + body + (size_t)(g->height - 1 - y) * (size_t)g->width * 4;
        for (int x = 0; x < g->width; x++)
            g->v[(size_t)y * (size_t)g->width + (size_t)x] = grid_number(row + 4 * (size_t)x, GRID_F32, big_endian);
    }
    return TOOL_OK;
}

int grid_read_pfm(grid *g, const char *path, tool_fail *f)
{
    uint8_t *file;
    size_t size;
    memset(g, 0, sizeof *g);
    int status = tool_read_whole(path, GRID_FILE_MAX, &file, &size, f);
    if (status == TOOL_OK)
        status = read_body(g, file, size, path, f);
    free(file);
    if (status)
        grid_free(g);
    return status;
}

static void put_float(FILE *to, float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    for (int i = 0; i < 4; i++)
        fputc((int)(bits >> (8 * i) & 255), to);
}

int pfm_write(const float *v, int width, int height, const char *path, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, path, f);
    if (status)
        return status;
    fprintf(out.stream, "Pf\n%d %d\n-1\n", width, height);
    for (int y = height - 1; y >= 0; y--)
        for (int x = 0; x < width; x++)
            put_float(out.stream, v[(size_t)y * (size_t)width + (size_t)x]);
    return tool_out_close(&out, 1, f);
}
