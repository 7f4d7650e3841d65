/* SPDX-License-Identifier: MIT
 * decode -> [mark/mark_refine.c] -> marks - moves each side onto the edge in the grey image.
 *
 * The corners are where the lines along the edges meet. Two passes, the second narrower: the first brings the window onto the
 * edge. */
#include "mark/mark_work.h"

/* Half pixels on each side of an edge that are looked at in the first pass. */
enum { REACH = MARK_MAX_REACH };

static int refine_once(const mark_work *w, mark_quad *quad, int32_t reach)
{
    mark_line side[4];
    for (int i = 0; i < 4; i++)
        if (!stad_mark_edge_line(w, quad->p[i], quad->p[(i + 1) % 4], reach, &side[i]))
            return 0;
    for (int i = 0; i < 4; i++)
        if (!stad_mark_line_meet(&side[(i + 3) % 4], &side[i], STAD_MARK_MAX_SIZE * 256, &quad->p[i]))
            return 0;
    return 1;
}

int stad_mark_refine(const mark_work *w, mark_quad *quad)
{
    return refine_once(w, quad, REACH) && refine_once(w, quad, REACH - 1);
}
