/* SPDX-License-Identifier: MIT
 * contour, refine -> [mark/mark_line.c] -> corners - lines of least squares from moments, in integers. */
#include "mark/mark_line.h"

#include "base/arith.h"
#include "base/log.h"

void stad_mark_moments_first(mark_moments *m, stad_corner origin)
{
    m->origin = origin;
    m->n = m->x = m->y = m->xx = m->xy = m->yy = 0;
}

void stad_mark_moments_add(mark_moments *m, int32_t x_q8, int32_t y_q8)
{
    const int64_t x = x_q8 - m->origin.x_q8, y = y_q8 - m->origin.y_q8;
    m->n++;
    m->x += x;
    m->y += y;
    m->xx += x * x;
    m->xy += x * y;
    m->yy += y * y;
}

/* The root rounds down to no less than either side, so nothing is cut here; it says so to the analysis. */
static int32_t unit_q14(int64_t side, int64_t length)
{
    return clamp_i64(side * 16384 / length, -16384, 16384);
}

int32_t stad_mark_unit_q14(int64_t x, int64_t y, int32_t *ux_q14, int32_t *uy_q14)
{
    int is_long = 0;
    while (x > (1 << 30) || x < -(1 << 30) || y > (1 << 30) || y < -(1 << 30)) {
        x /= 2;
        y /= 2;
        is_long = 1;
    }
    const int64_t length = (int64_t)stad_isqrt((uint64_t)(x * x + y * y));
    if (length == 0) {
        *ux_q14 = *uy_q14 = 0;
        return 0;
    }
    *ux_q14 = unit_q14(x, length);
    *uy_q14 = unit_q14(y, length);
    return is_long ? INT32_MAX : sat_i32(length);
}

int stad_mark_line_fit(const mark_moments *m, mark_line *line)
{
    if (m->n < 3)
        return 0;
    /* Means in Q8; (sum of squares) - (sum)^2 / n stays below the sum of squares. */
    const int64_t xx = m->xx - m->x * m->x / m->n, yy = m->yy - m->y * m->y / m->n, xy = m->xy - m->x * m->y / m->n;
    line->p.x_q8 = m->origin.x_q8 + (int32_t)(m->x / m->n);
    line->p.y_q8 = m->origin.y_q8 + (int32_t)(m->y / m->n);
    const int flat = xx >= yy;
    return stad_mark_unit_q14(flat ? xx : xy, flat ? xy : yy, &line->dx_q14, &line->dy_q14) > 0;
}

int32_t stad_mark_line_distance_q8(const mark_line *line, int32_t x_q8, int32_t y_q8)
{
    const int64_t x = x_q8 - line->p.x_q8, y = y_q8 - line->p.y_q8;
    return (int32_t)((y * line->dx_q14 - x * line->dy_q14) / 16384);
}

int stad_mark_line_meet(const mark_line *a, const mark_line *b, int32_t reach, stad_corner *p)
{
    /* Q28; of unit vectors the sine of the angle between them. */
    const int64_t sine = (int64_t)a->dx_q14 * b->dy_q14 - (int64_t)a->dy_q14 * b->dx_q14;
    if (sine < (1 << 25) && sine > -(1 << 25))
        return 0;
    const int64_t x = b->p.x_q8 - a->p.x_q8, y = b->p.y_q8 - a->p.y_q8;
    const int32_t low = -(reach >> 4), high = reach - low;
    /* |x dy - y dx| < 2^20 * 2^15 * 2 = 2^36, times 2^14 = 2^50; divided by >= 2^25: along < 2^25. */
    const int64_t along = (x * b->dy_q14 - y * b->dx_q14) * 16384 / sine;
    p->x_q8 = a->p.x_q8 + (int32_t)(along * a->dx_q14 / 16384);
    p->y_q8 = a->p.y_q8 + (int32_t)(along * a->dy_q14 / 16384);
    return p->x_q8 >= low && p->x_q8 <= high && p->y_q8 >= low && p->y_q8 <= high;
}
