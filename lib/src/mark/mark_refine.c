/* SPDX-License-Identifier: MIT
 * decode -> [mark/mark_refine.c] -> marks - moves each side onto the edge in the grey image.
 *
 * Along each side at most 64 normals, a line through where they cross the edge, the ends left out; the corners are where the
 * lines meet. Two passes, the second narrower: the first brings the window onto the edge. */
#include "mark/mark_work.h"
#include "mark/mark_line.h"

#include "base/arith.h"

enum { NORMALS = 64 };

/* The line along the edge from corner a to corner b. */
static int refine_side(const mark_work *w, stad_corner a, stad_corner b, int32_t reach, mark_line *line)
{
    int32_t ux_q14, uy_q14;
    const int32_t dx = b.x_q8 - a.x_q8, dy = b.y_q8 - a.y_q8;
    const int32_t length_q8 = stad_mark_unit_q14(dx, dy, &ux_q14, &uy_q14);
    const int32_t count = clamp_i32(length_q8 / 256, 8, NORMALS);
    const int32_t skip = max_i32(1, count / 16);
    mark_moments m;
    stad_mark_moments_first(&m, a);
    for (int32_t i = skip; i < count - skip; i++) {
        /* Less than 2^20 * 2^7 = 2^27. */
        const stad_corner p = {a.x_q8 + dx * (2 * i + 1) / (2 * count), a.y_q8 + dy * (2 * i + 1) / (2 * count)};
        int32_t offset_q8;
        if (stad_mark_edge_q8(w, p, uy_q14, -ux_q14, reach, &offset_q8))
            stad_mark_moments_add(&m, p.x_q8 + uy_q14 * offset_q8 / 16384, p.y_q8 - ux_q14 * offset_q8 / 16384);
    }
    return m.n * 2 >= count - 2 * skip && stad_mark_line_fit(&m, line);
}

static int refine_once(const mark_work *w, mark_quad *quad, int32_t reach)
{
    mark_line side[4];
    for (int i = 0; i < 4; i++)
        if (!refine_side(w, quad->p[i], quad->p[(i + 1) % 4], reach, &side[i]))
            return 0;
    for (int i = 0; i < 4; i++)
        if (!stad_mark_line_meet(&side[(i + 3) % 4], &side[i], &quad->p[i]))
            return 0;
    return 1;
}

int stad_mark_refine(const mark_work *w, mark_quad *quad)
{
    return refine_once(w, quad, MARK_REACH) && refine_once(w, quad, MARK_REACH - 1);
}
