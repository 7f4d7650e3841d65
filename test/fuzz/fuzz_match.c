/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_match.c - any geometry, any parameters, any order of calls, any pixels: refused with a status, or right.
 *
 * The input's first bytes choose geometry, parameters and the order of calls; the rest are pixels, repeated as needed. Small
 * defined cases are held against the reference; all run on guarded buffers under the sanitizers. */
#include <string.h>

#include "fuzz/fuzz.h"
#include "stad/match.h"
#include "support/reference.h"
#include "support/subject.h"

static void drive(stad_match *m, const stad_geometry *g, const stad_params *p, bytes *b)
{
    size_t w = (size_t)g->width, h = (size_t)g->height, line = w * (size_t)g->channels;
    uint8_t *left = subject_alloc(line * h, 0, 1), *right = subject_alloc(line * h, 0, 2);
    int16_t *row = subject_alloc(w * 2, 0, 3), *map = calloc(w * h, 2), *expected = calloc(w * h, 2);
    int calls = 0, pushed = 0, pulled = 0;
    fill(left, line * h, b, 0);
    fill(right, line * h, b, 1);
    while (pulled < g->height && calls++ < 6 * g->height + 40) {
        int push = calls > 30 ? pushed < g->height && calls % 2 : next(b) % 2;
        int status =
            push ? stad_match_push(m, left + (size_t)(pushed % g->height) * line, right + (size_t)(pushed % g->height) * line)
                 : stad_match_pull(m, row);
        expect(status >= 0 || status == STAD_AGAIN || status == STAD_E_STATE);
        pushed += push && status == STAD_OK;
        if (!push && status >= 0) {
            memcpy(map + (size_t)status * w, row, w * 2);
            pulled++;
        }
    }
    expect(pulled == g->height && subject_guards_stand(row));
    if (w * h * (size_t)p->num_disparities < 20000) {
        stad_params raw = *p;
        raw.speckle_window_size = 0;
        expect(reference_match(&raw, g->mode, 0, left, right, g->width, g->height, g->channels, expected) == 0);
        expect(memcmp(expected, map, w * h * 2) == 0);
    }
    subject_free(left), subject_free(right), subject_free(row), free(map), free(expected);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    bytes b = {data, size};
    stad_geometry g;
    stad_params p;
    stad_match m;
    const char *culprit = NULL;
    size_t work_bytes;
    void *work;
    memset(&g, 0, sizeof g);
    p.num_disparities = number(&b, 48);
    p.min_disparity = (int16_t)(number(&b, 40) - 20);
    p.block_size = number(&b, 15);
    p.p1 = number(&b, 200);
    p.p2 = number(&b, 240);
    p.disp12_max_diff = number(&b, 4);
    p.pre_filter_cap = number(&b, 130);
    p.uniqueness_ratio = number(&b, 30);
    p.speckle_window_size = number(&b, 3);
    p.speckle_range = number(&b, 3);
    g.width = number(&b, 90);
    g.height = number(&b, 12);
    g.channels = (int16_t)(next(&b) & 1 ? 1 : next(&b));
    g.mode = (uint8_t)(next(&b) % 5);
    g.memory = (uint8_t)(next(&b) % 3);
    if (next(&b) % 8) { /* usually help it into the domain */
        p.num_disparities = (int16_t)((p.num_disparities / 16 + 1) * 16);
        stad_params_normalize(&p, g.mode);
    }
    g.max_disparities = (int16_t)(p.num_disparities + (next(&b) % 4 ? 0 : 16));
    g.max_block_size = (int16_t)(p.block_size + (next(&b) % 4 ? 0 : 2));
    g.max_p2 = (int16_t)(p.p2 < 32000 && next(&b) % 4 == 0 ? p.p2 + 500 : p.p2);
    g.max_pre_filter_cap = p.pre_filter_cap;
    if (stad_geometry_check(&g, &culprit) != STAD_OK) {
        expect(culprit != NULL && stad_match_bytes(&g) == 0);
        return 0;
    }
    work_bytes = stad_match_bytes(&g);
    if (work_bytes > 4000000 || (int64_t)g.width * g.height * g.max_disparities > 300000) {
        return 0; /* right, but slow under the sanitizers */
    }
    work = subject_alloc(work_bytes, 0, 4);
    expect(stad_match_init(&m, &g, work, work_bytes) == STAD_OK);
    if (stad_match_begin(&m, &p) == STAD_OK) {
        drive(&m, &g, &p, &b);
    } else {
        expect(stad_match_culprit(&m) != NULL);
    }
    expect(subject_guards_stand(work));
    subject_free(work);
    return 0;
}
