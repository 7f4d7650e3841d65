/* SPDX-License-Identifier: MIT
 * median -> [SPECKLE] -> disparity
 * match/speckle.c - removes small connected components of a disparity map (SPEC 9).
 *
 * One label a pixel: the index of a pixel nearer to the component's root, or minus the component's size at the root itself.
 * A union hangs the smaller tree under the larger, and look-ups halve the path they walk: depth stays below log2(pixels). */
#include "stad/match.h"
#include "base/arith.h"

typedef struct field {
    const int16_t *disp;
    ptrdiff_t stride;
    int32_t width, height, none, max_diff;
    int32_t *label;
} field;

static int32_t root_of(int32_t *label, int32_t i)
{
    while (label[i] >= 0) {
        const int32_t parent = label[i];
        if (label[parent] >= 0)
            label[i] = label[parent];
        i = parent;
    }
    return i;
}

static void join(int32_t *label, int32_t i, int32_t j)
{
    int32_t a = root_of(label, i), b = root_of(label, j);
    if (a == b)
        return;
    if (label[a] > label[b]) { /* sizes are negative: b is the larger */
        const int32_t swap = a;
        a = b;
        b = swap;
    }
    label[a] += label[b];
    label[b] = a;
}

static int belongs(const field *f, int32_t here, int32_t other)
{
    return other != f->none && abs_i32(here - other) <= f->max_diff;
}

static void join_row(const field *f, int32_t y)
{
    const int16_t *row = f->disp + y * f->stride, *above = row - (y > 0 ? f->stride : 0);
    int32_t i = y * f->width;
    for (int32_t x = 0; x < f->width; x++, i++) {
        f->label[i] = -1;
        if (row[x] == f->none)
            continue;
        if (x > 0 && belongs(f, row[x], row[x - 1]))
            join(f->label, i - 1, i);
        if (y > 0 && belongs(f, row[x], above[x]))
            join(f->label, i - f->width, i);
    }
}

int32_t stad_speckle_filter(int16_t *disp_q4, ptrdiff_t disp_stride, int32_t width, int32_t height, int16_t none_q4,
                            int32_t max_size, int32_t max_diff_q4, void *work, size_t work_bytes)
{
    const field f = {disp_q4, disp_stride, width, height, none_q4, max_diff_q4, work};
    int32_t removed = 0;
    if (width < 1 || height < 1 || height > INT32_MAX / width)
        return STAD_E_SIZE;
    if (!work || (uintptr_t)work % sizeof(int32_t) != 0 || work_bytes < STAD_SPECKLE_BYTES(width, height))
        return STAD_E_SIZE;
    for (int32_t y = 0; y < height; y++)
        join_row(&f, y);
    for (int32_t y = 0, i = 0; y < height; y++)
        for (int32_t x = 0; x < width; x++, i++) {
            int16_t *v = disp_q4 + y * disp_stride + x;
            if (*v != none_q4 && -f.label[root_of(f.label, i)] <= max_size) {
                *v = none_q4;
                removed++;
            }
        }
    return removed;
}
