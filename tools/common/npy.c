/* SPDX-License-Identifier: MIT
 * common/npy.c - NumPy's array files: magic, version, length of a Python dictionary, the dictionary, the numbers. */
#include "grid.h"

#include <stdlib.h>
#include <string.h>

#include "grid_bytes.h"
#include "whole_file.h"

typedef struct npy_head {
    enum grid_kind kind;
    int big_endian;
    long width, height;
    size_t body; /* offset of the first number */
} npy_head;

static const char npy_magic[6] = {(char)0x93, 'N', 'U', 'M', 'P', 'Y'};

/* The value after 'key': in a dictionary printed by Python. */
static const char *value_of(const char *dict, const char *key)
{
    const char *at = strstr(dict, key);
    if (!at)
        return NULL;
    at += strlen(key);
    while (*at == ' ' || *at == ':')
        at++;
    return at;
}

static int parse_kind(const char *descr, npy_head *h)
{
    if (!descr || (descr[0] != '\'' && descr[0] != '"'))
        return 0;
    h->big_endian = descr[1] == '>';
    if (descr[1] != '<' && descr[1] != '>')
        return 0;
    if (strncmp(descr + 2, "i2", 2) == 0)
        h->kind = GRID_I16;
    else if (strncmp(descr + 2, "f4", 2) == 0)
        h->kind = GRID_F32;
    else if (strncmp(descr + 2, "f8", 2) == 0)
        h->kind = GRID_F64;
    else
        return 0;
    return descr[4] == descr[0];
}

static int parse_shape(const char *shape, npy_head *h)
{
    char *end;
    if (!shape || *shape != '(')
        return 0;
    h->height = strtol(shape + 1, &end, 10);
    if (end == shape + 1 || *end != ',')
        return 0;
    char *second = end + 1;
    h->width = strtol(second, &end, 10);
    if (end == second)
        return 0;
    while (*end == ' ' || *end == ',')
        end++;
    return *end == ')';
}

static int parse_head(const uint8_t *file, size_t size, const char *path, npy_head *h, tool_fail *f)
{
    if (size < 12 || memcmp(file, npy_magic, 6) != 0)
        return tool_fail_set(f, TOOL_FILE, "%s: not a .npy file", path);
    int wide = file[6] >= 2; /* from version 2 on the length has four bytes */
    size_t text = wide ? 12 : 10, length = (size_t)grid_word(file + 8, wide ? 4 : 2, 0);
    if (length > size - text)
        return tool_fail_set(f, TOOL_FILE, "%s: bad .npy: the file ends inside its header", path);
    char *dict = malloc(length + 1);
    if (!dict)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    memcpy(dict, file + text, length);
    dict[length] = 0;
    const char *order = value_of(dict, "'fortran_order'");
    int kind = parse_kind(value_of(dict, "'descr'"), h);
    int shape = parse_shape(value_of(dict, "'shape'"), h);
    int c_order = order && strncmp(order, "False", 5) == 0;
    free(dict);
    h->body = text + length;
    if (!kind)
        return tool_fail_set(f, TOOL_FILE, "%s: .npy of a type that is not int16, float32 or float64", path);
    if (!shape || !c_order)
        return tool_fail_set(f, TOOL_FILE, "%s: .npy that is not a two-dimensional array in C order", path);
    return TOOL_OK;
}

static int read_body(grid *g, const uint8_t *file, size_t size, const char *path, tool_fail *f)
{
    npy_head h = {0};
    int status = parse_head(file, size, path, &h, f);
    if (status == TOOL_OK)
        status = grid_alloc(g, h.width, h.height, path, f);
    if (status)
        return status;
    size_t n = (size_t)g->width * (size_t)g->height;
    if ((size - h.body) / (size_t)h.kind < n)
        return tool_fail_set(f, TOOL_FILE, "%s: bad .npy: the file ends too early", path);
    for (size_t i = 0; i < n; i++)
        g->v[i] = grid_number(file + h.body + i * (size_t)h.kind, h.kind, h.big_endian);
    g->integer = h.kind == GRID_I16;
    return TOOL_OK;
}

int grid_read_npy(grid *g, const char *path, tool_fail *f)
{
    uint8_t *file;
    size_t size;
    memset(g, 0, sizeof *g);
    int status = tool_read_whole(path, GRID_FILE_MAX, &file, &size, f);
    if (status == TOOL_OK && size > 4 && memcmp(file, "PK\003\004", 4) == 0) {
        uint8_t *archive = file;
        status = npz_first(archive, size, &file, &size, path, f);
        free(archive);
    }
    if (status == TOOL_OK)
        status = read_body(g, file, size, path, f);
    free(file);
    if (status)
        grid_free(g);
    return status;
}

/* The header's length is such that the numbers start at a multiple of 64, as NumPy has it. */
static void write_head(FILE *to, int width, int height)
{
    char dict[128];
    int n = snprintf(dict, sizeof dict, "{'descr': '<i2', 'fortran_order': False, 'shape': (%d, %d), }", height, width);
    int length = (10 + n + 1 + 63) / 64 * 64 - 10;
    fwrite(npy_magic, 1, sizeof npy_magic, to);
    fputc(1, to);
    fputc(0, to);
    fputc(length & 255, to);
    fputc(length >> 8, to);
    fprintf(to, "%-*s\n", length - 1, dict);
}

int npy_write_i16(const int16_t *v, int width, int height, const char *path, tool_fail *f)
{
    tool_out out;
    int status = tool_out_open(&out, path, f);
    if (status)
        return status;
    write_head(out.stream, width, height);
    size_t n = (size_t)width * (size_t)height;
    for (size_t i = 0; i < n; i++) {
        uint16_t u = (uint16_t)v[i];
        fputc(u & 255, out.stream);
        fputc(u >> 8, out.stream);
    }
    return tool_out_close(&out, 1, f);
}
