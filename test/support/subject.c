/* SPDX-License-Identifier: MIT
 * support/subject.c - runs the library on a case. */
#include "subject.h"

#include <stdlib.h>
#include <string.h>

#define GUARD 64

/* Lies just before the bytes that subject_alloc hands out, in front of the leading guard. */
typedef struct block {
    void *raw;
    size_t bytes;
    uint32_t seed;
} block;

static uint8_t guard_byte(uint32_t seed, size_t i)
{
    return (uint8_t)hash_pair(seed, (uint32_t)i);
}

static block header_of(const void *p)
{
    block b;
    memcpy(&b, (const uint8_t *)p - GUARD - sizeof b, sizeof b);
    return b;
}

void *subject_alloc(size_t bytes, size_t offset, uint32_t seed)
{
    size_t room = sizeof(block) + GUARD + 2 * STAD_ALIGN;
    uint8_t *raw = malloc(room + offset + bytes + GUARD), *p;
    block b = {raw, bytes, seed};
    if (!raw) {
        return NULL;
    }
    p = raw + room;
    p += (STAD_ALIGN - (uintptr_t)p % STAD_ALIGN) % STAD_ALIGN; /* at most STAD_ALIGN - 1: room has two */
    p -= STAD_ALIGN;
    p += offset;
    memcpy(p - GUARD - sizeof b, &b, sizeof b);
    for (size_t i = 0; i < GUARD; i++) {
        p[(ptrdiff_t)i - GUARD] = guard_byte(seed, i);
        p[bytes + i] = guard_byte(seed + 1, i);
    }
    for (size_t i = 0; i < bytes; i++) {
        p[i] = (uint8_t)hash_u32(seed + (uint32_t)i);
    }
    return p;
}

int subject_guards_stand(const void *p)
{
    const uint8_t *q = p;
    block b = header_of(p);
    for (size_t i = 0; i < GUARD; i++) {
        if (q[(ptrdiff_t)i - GUARD] != guard_byte(b.seed, i) || q[b.bytes + i] != guard_byte(b.seed + 1, i)) {
            return 0;
        }
    }
    return 1;
}

void subject_free(void *p)
{
    if (p) {
        free(header_of(p).raw);
    }
}

stad_geometry subject_geometry(const test_case *c, const stad_params *n)
{
    stad_geometry g;
    memset(&g, 0, sizeof g);
    g.width = (int16_t)c->width;
    g.height = (int16_t)c->height;
    g.channels = (int16_t)c->channels;
    g.max_disparities = n->num_disparities;
    g.max_block_size = n->block_size;
    g.max_p2 = n->p2;
    g.max_pre_filter_cap = n->pre_filter_cap;
    g.mode = (uint8_t)c->mode;
    g.memory = (uint8_t)c->memory;
    return g;
}

/* Pushes and pulls in a random order until every row is out. */
static int run_rows(stad_match *m, const test_case *c, const stad_params *p, const uint8_t *left, const uint8_t *right,
                    int16_t *disp, const char **why)
{
    size_t line = (size_t)c->width * (size_t)c->channels;
    uint32_t order = c->interleave;
    int pushed = 0, pulled = 0, status = stad_match_begin(m, p), idle = 0;
    int eager = rng_range(&order, 1, 9);
    int16_t *row = subject_alloc((size_t)c->width * 2, 0, order);
    *why = "stad_match_begin";
    while (status >= 0 && pulled < c->height && idle < 1000) {
        if (pushed < c->height && rng_range(&order, 1, 10) <= eager) {
            *why = "stad_match_push";
            status = stad_match_push(m, left + (size_t)pushed * line, right + (size_t)pushed * line);
            pushed += status == STAD_OK;
        } else {
            *why = "stad_match_pull";
            status = stad_match_pull(m, row);
            if (status >= 0) {
                memcpy(disp + (size_t)status * (size_t)c->width, row, (size_t)c->width * 2);
                pulled++;
            }
        }
        idle = status == STAD_AGAIN ? idle + 1 : 0;
        status = status == STAD_AGAIN ? STAD_OK : status;
    }
    if (status >= 0 && pulled < c->height) {
        *why = "no row comes out";
        status = STAD_AGAIN;
    }
    status = status >= 0 && !subject_guards_stand(row) ? SUBJECT_GUARD : status;
    subject_free(row);
    return status;
}

static int run_frame(stad_match *m, const test_case *c, const stad_params *p, const uint8_t *left, const uint8_t *right,
                     int16_t *disp, void *speckle, size_t speckle_bytes)
{
    stad_image l = stad_image_packed(left, c->width, c->height, c->channels);
    stad_image r = stad_image_packed(right, c->width, c->height, c->channels);
    return stad_match_frame(m, p, &l, &r, disp, c->width, speckle, speckle_bytes);
}

int subject_run(const test_case *c, int form, const uint8_t *left, const uint8_t *right, int16_t *disp_q4, const char **why)
{
    stad_match m;
    stad_params p = c->params;
    stad_geometry g;
    size_t bytes, px = (size_t)c->width * (size_t)c->height, speckle_bytes;
    void *work, *speckle = NULL;
    int16_t *disp = subject_alloc(px * 2, 0, c->interleave + 1);
    int status, bound = 0;
    stad_params_normalize(&p, c->mode);
    g = subject_geometry(c, &p);
    bytes = stad_match_bytes(&g);
    speckle_bytes = p.speckle_window_size > 0 ? STAD_SPECKLE_BYTES((size_t)c->width, (size_t)c->height) : 0;
    work = subject_alloc(bytes, 0, c->interleave + 2);
    speckle = speckle_bytes ? subject_alloc(speckle_bytes, 0, c->interleave + 3) : NULL;
    *why = "stad_geometry_check";
    status = stad_geometry_check(&g, why);
    if (status >= 0) {
        *why = "stad_match_init";
        status = stad_match_init(&m, &g, work, bytes);
        bound = status >= 0;
    }
    if (status >= 0 && form == SUBJECT_FRAME) {
        *why = "stad_match_frame";
        status = run_frame(&m, c, &p, left, right, disp, speckle, speckle_bytes);
    } else if (status >= 0) {
        status = run_rows(&m, c, &p, left, right, disp, why);
        if (status >= 0 && speckle) {
            *why = "stad_speckle_filter";
            status = (int)stad_speckle_filter(disp, c->width, c->width, c->height, (int16_t)((p.min_disparity - 1) * 16),
                                              p.speckle_window_size, 16 * p.speckle_range, speckle, speckle_bytes);
        }
    }
    if (bound && (status == STAD_E_PARAM || status == STAD_E_LIMIT) && stad_match_culprit(&m)) {
        *why = stad_match_culprit(&m);
    }
    memcpy(disp_q4, disp, px * 2);
    if (status >= 0 &&
        !(subject_guards_stand(work) && subject_guards_stand(disp) && (!speckle || subject_guards_stand(speckle)))) {
        *why = "bytes outside a buffer were written";
        status = SUBJECT_GUARD;
    }
    subject_free(work);
    subject_free(speckle);
    subject_free(disp);
    return status < 0 ? status : 0;
}
