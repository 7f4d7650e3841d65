/* SPDX-License-Identifier: MIT
 * pairs -> [truth/plane_fit.c] -> planes - the plane of disparity through the corners of marks. */
#include "stad/truth.h"

#include "base/affine.h"
#include "base/arith.h"
#include "base/log.h"
#include "truth/plane_fit.h"

enum { MAX_RMS_Q8 = 64, MIN_MARKS = 2 };

/* Fitted about (x0, y0), px, so that sums stay small. */
typedef struct fitted {
    stad_affine affine;
    int32_t x0, y0;
} fitted;

static int32_t disparity_q8(const stad_pair *pair, int k)
{
    return pair->left[k].x_q8 - pair->right[k].x_q8;
}

/* A choice of pairs: those whose identity has its bit set, but not the one at index `without` (-1: none). */
typedef struct choice {
    const stad_pair *pairs;
    int n, without;
    uint32_t ids;
} choice;

static int chosen(const choice *c, int i)
{
    return i != c->without && (c->ids >> (c->pairs[i].id & 31) & 1u);
}

/* Sets the centre of the chosen left corners, px, and returns the number of marks. */
static int centre(const choice *c, fitted *f)
{
    int64_t x = 0, y = 0;
    int marks = 0;
    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < 4 && chosen(c, i); k++) {
            x += c->pairs[i].left[k].x_q8;
            y += c->pairs[i].left[k].y_q8;
            marks += k == 0;
        }
    f->x0 = marks ? (int32_t)(x / (4 * marks) / 256) : 0;
    f->y0 = marks ? (int32_t)(y / (4 * marks) / 256) : 0;
    return marks;
}

static int32_t from_x0_q4(const fitted *f, stad_corner p)
{
    return (p.x_q8 - f->x0 * 256) / 16;
}

static int32_t from_y0_q4(const fitted *f, stad_corner p)
{
    return (p.y_q8 - f->y0 * 256) / 16;
}

/* Root mean square of what the fit leaves of the chosen disparities, Q8 px. */
static int32_t rms_q8(const choice *c, const fitted *f)
{
    uint64_t sum = 0;
    uint32_t used = 0;
    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < 4 && chosen(c, i); k++) {
            const stad_corner p = c->pairs[i].left[k];
            const int64_t at_q8 = stad_affine_at_q8(&f->affine, from_x0_q4(f, p), from_y0_q4(f, p)) / 256;
            const int64_t off = disparity_q8(&c->pairs[i], k) - at_q8;
            sum += (uint64_t)(off * off);
            used++;
        }
    return used ? sat_i32(stad_isqrt(sum / used)) : INT32_MAX;
}

/* Fits the chosen pairs. Returns the rms, INT32_MAX when there is no fit. */
static int32_t fit(const choice *c, fitted *f)
{
    stad_affine_sums sums = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < 4 && chosen(c, i); k++) {
            const stad_corner p = c->pairs[i].left[k];
            const int32_t d_q8 = clamp_i32(disparity_q8(&c->pairs[i], k), -(1 << 20), 1 << 20);
            stad_affine_add(&sums, from_x0_q4(f, p), from_y0_q4(f, p), d_q8);
        }
    return stad_affine_solve(&sums, &f->affine) ? rms_q8(c, f) : INT32_MAX;
}

/* Leaves out the mark without which the others fit best: an outlier bends the fit of all so much that it need not be the one
 * with the largest residual. */
static int32_t fit_without_worst(choice *c, fitted *f)
{
    int best = -1;
    int32_t least = INT32_MAX;
    for (int i = 0; i < c->n; i++) {
        c->without = -1;
        if (!chosen(c, i))
            continue;
        c->without = i;
        const int32_t rms = fit(c, f);
        if (rms < least) {
            least = rms;
            best = i;
        }
    }
    c->without = best;
    return fit(c, f);
}

/* From about the centre to about the origin. Slopes: px Q8 over px Q4 in Q20 is px over px in Q24. */
static int to_plane(const fitted *f, stad_plane *plane)
{
    const int32_t a = (f->affine.b_q20 + (f->affine.b_q20 < 0 ? -128 : 128)) / 256;
    const int32_t b = (f->affine.c_q20 + (f->affine.c_q20 < 0 ? -128 : 128)) / 256;
    if (a <= -65536 || a >= 65536 || b <= -65536 || b >= 65536)
        return STAD_E_RIG;
    plane->a_q16 = a;
    plane->b_q16 = b;
    plane->c_q16 = f->affine.a_q8 - a * f->x0 - b * f->y0; /* |a x0| < 2^27 */
    return STAD_OK;
}

int stad_plane_fit_ids(stad_plane *plane, stad_plane_report *report, const stad_pair *pairs, int n, uint32_t ids)
{
    stad_plane_report numbers = {0, 0, -1};
    choice c = {pairs, n, -1, ids};
    fitted f = {{0, 0, 0}, 0, 0};
    if (report)
        *report = numbers;
    if (n < MIN_MARKS || n > STAD_AFFINE_MAX_POINTS / 4)
        return STAD_E_NO_MARK;
    const int marks = centre(&c, &f);
    if (marks < MIN_MARKS)
        return STAD_E_NO_MARK;
    numbers.rms_q8 = fit(&c, &f);
    if (numbers.rms_q8 > MAX_RMS_Q8 && marks > MIN_MARKS)
        numbers.rms_q8 = fit_without_worst(&c, &f);
    if (c.without >= 0)
        numbers.dropped = pairs[c.without].id;
    numbers.corners = (int16_t)(4 * (c.without < 0 ? marks : marks - 1));
    if (report)
        *report = numbers;
    return numbers.rms_q8 > MAX_RMS_Q8 ? STAD_E_NO_MARK : to_plane(&f, plane);
}

int stad_plane_fit(stad_plane *plane, stad_plane_report *report, const stad_pair *pairs, int n)
{
    return stad_plane_fit_ids(plane, report, pairs, n, 0xFFFFFFFFu);
}
