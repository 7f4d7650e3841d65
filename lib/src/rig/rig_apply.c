/* SPDX-License-Identifier: MIT
 * correction -> [rig/rig_apply.c] -> positions - where a pixel of the corrected right image comes from, and back. */
#include "stad/rig.h"

/* The displacement from corrected to raw at a corrected point, Q8 px. |b|, |c| <= 2^22, position < 2^20: below 2^43. */
static stad_corner displacement(const stad_rig *r, stad_corner p)
{
    const int64_t x = p.x_q8 - r->width / 2 * 256, y = p.y_q8 - r->height / 2 * 256;
    const int64_t half = 1 << 23;
    const int64_t dx_q32 = r->c_q24 * x - r->b_q24 * y, dy_q32 = r->b_q24 * x + r->c_q24 * y + r->a_q16 * ((int64_t)1 << 16);
    const stad_corner d = {(int32_t)((dx_q32 + (dx_q32 < 0 ? -half : half)) / (1 << 24)),
                           (int32_t)((dy_q32 + (dy_q32 < 0 ? -half : half)) / (1 << 24))};
    return d;
}

stad_corner stad_rig_apply(const stad_rig *r, stad_corner corrected)
{
    const stad_corner d = displacement(r, corrected);
    const stad_corner raw = {corrected.x_q8 + d.x_q8, corrected.y_q8 + d.y_q8};
    return raw;
}

/* Solves p + displacement(p) = raw by repetition: the slopes are below 1/4, three rounds leave 1/64 of the first step's error,
 * and of a real drift (below 1/50) less than the last bit. */
static stad_corner straighten(const stad_rig *r, stad_corner raw)
{
    stad_corner p = raw;
    for (int i = 0; i < 4; i++) {
        const stad_corner d = displacement(r, p);
        p.x_q8 = raw.x_q8 - d.x_q8;
        p.y_q8 = raw.y_q8 - d.y_q8;
    }
    return p;
}

void stad_rig_straighten(const stad_rig *r, stad_pair *pairs, int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 4; k++)
            pairs[i].right[k] = straighten(r, pairs[i].right[k]);
}
