/* SPDX-License-Identifier: MIT
 * support/pair_at.h - a mark seen by both cameras where a test wants it. */
#ifndef TEST_SUPPORT_PAIR_AT_H
#define TEST_SUPPORT_PAIR_AT_H

#include "stad/mark.h"

/* An upright square of `side` px with its upper left corner at (x, y), 5 px further left in the right view. */
static inline stad_pair pair_at(int id, int x, int y, int side)
{
    stad_pair p;
    p.id = (int16_t)id;
    for (int k = 0; k < 4; k++) {
        p.left[k].x_q8 = (x + (k == 1 || k == 2 ? side : 0)) * 256;
        p.left[k].y_q8 = (y + (k >= 2 ? side : 0)) * 256;
        p.right[k].x_q8 = p.left[k].x_q8 - 5 * 256;
        p.right[k].y_q8 = p.left[k].y_q8;
    }
    return p;
}

#endif
