/* SPDX-License-Identifier: MIT
 * common/raster_pnm.c - reads PGM and PPM, binary (P5, P6) and plain (P2, P3). */
#include "raster.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct pnm_text {
    const uint8_t *at, *end;
} pnm_text;

static void skip_space(pnm_text *t)
{
    while (t->at < t->end && (isspace(*t->at) || *t->at == '#')) {
        if (*t->at == '#')
            while (t->at < t->end && *t->at != '\n')
                t->at++;
        else
            t->at++;
    }
}

/* The next number, 0..65535, or -1. */
static int number(pnm_text *t)
{
    int v = 0;
    skip_space(t);
    if (t->at == t->end || !isdigit(*t->at))
        return -1;
    while (t->at < t->end && isdigit(*t->at)) {
        v = v * 10 + (*t->at++ - '0');
        if (v > 65535)
            return -1;
    }
    return v;
}

static int copy_binary(raster *r, pnm_text *t, size_t samples)
{
    size_t bytes = samples * (size_t)(r->bits / 8);
    if (t->at == t->end || !isspace(*t->at) || (size_t)(t->end - t->at) - 1 < bytes)
        return 0;
    memcpy(r->bytes, t->at + 1, bytes);
    return 1;
}

static int copy_plain(raster *r, pnm_text *t, size_t samples, int max)
{
    for (size_t i = 0; i < samples; i++) {
        int v = number(t);
        if (v < 0 || v > max)
            return 0;
        if (r->bits == 8) {
            r->bytes[i] = (uint8_t)v;
        } else {
            r->bytes[2 * i] = (uint8_t)(v >> 8);
            r->bytes[2 * i + 1] = (uint8_t)(v & 255);
        }
    }
    return 1;
}

int raster_read_pnm(raster *r, const uint8_t *file, size_t size, const char *path, tool_fail *f)
{
    pnm_text t = {file + 2, file + size};
    int kind = file[1] - '0';
    r->width = number(&t);
    r->height = number(&t);
    int max = number(&t);
    if (r->width < 0 || r->height < 0 || max < 1)
        return tool_fail_set(f, TOOL_FILE, "%s: bad PGM or PPM header", path);
    r->channels = kind == 3 || kind == 6 ? 3 : 1;
    r->bits = max > 255 ? 16 : 8;
    if (max != 255 && max != 65535)
        return tool_fail_set(f, TOOL_FILE, "%s: largest sample value %d; 255 and 65535 are read", path, max);
    int status = raster_alloc(r, path, f);
    if (status)
        return status;
    size_t samples = (size_t)r->width * (size_t)r->height * (size_t)r->channels;
    int whole = kind >= 5 ? copy_binary(r, &t, samples) : copy_plain(r, &t, samples, max);
    if (!whole)
        return tool_fail_set(f, TOOL_FILE, "%s: bad PGM or PPM: the file ends too early or holds no number", path);
    return TOOL_OK;
}
