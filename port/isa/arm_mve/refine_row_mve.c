/* SPDX-License-Identifier: MIT
 * best -> [REFINE] -> select
 * port/isa/arm_mve/refine_row_mve.c - the sub-pixel places of eight winners at once.
 *
 * With u, v the neighbours' distances from the least cost, c = max(u + v, 1) and k = floor(16 |u - v| / c), the parabola moves
 * a winner by (k + 1) / 2 where u >= v, else back by (k - 1) / 2, halves rounded down, at least 0. Bound: u + v <= 65534
 * where the least cost is not negative; other groups are left to C. */
#include <arm_mve.h>

#include "kernel/kernel.h"

/* Four bits of w / c, w <= c; 15 where they are equal, which (k + 1) / 2 and (k - 1) / 2 do not tell from 16. */
static inline uint16x8_t sixteenths(uint16x8_t w, uint16x8_t c)
{
    uint16x8_t k = vdupq_n_u16(0);
#pragma GCC unroll 4
    for (int bit = 0; bit < 4; bit++) {
        const uint16x8_t rest = vsubq_u16(c, w); /* 2 w >= c without 2 w, which might not fit */
        const mve_pred16_t one = vcmpcsq_u16(w, rest);
        k = vaddq_u16(k, k);
        k = vaddq_m_n_u16(k, k, 1, one);
        w = vpselq_u16(vsubq_u16(w, rest), vaddq_u16(w, w), one);
    }
    return k;
}

/* By how many sixteenths the parabola through before, least, after moves the winner. */
static inline int16x8_t moved(int16x8_t before, int16x8_t least, int16x8_t after)
{
    const uint16x8_t u = vreinterpretq_u16_s16(vsubq_s16(before, least)), v = vreinterpretq_u16_s16(vsubq_s16(after, least));
    const uint16x8_t k = sixteenths(vabdq_u16(u, v), vmaxq_u16(vaddq_u16(u, v), vdupq_n_u16(1)));
    const int16x8_t on = vreinterpretq_s16_u16(vrshrq_n_u16(k, 1));
    const int16x8_t back = vnegq_s16(vreinterpretq_s16_u16(vshrq_n_u16(vqsubq_n_u16(k, 1), 1)));
    return vpselq_s16(on, back, vcmpcsq_u16(u, v));
}

void stad_refine_row_mve(const int16_t *total, const stad_best *best, int32_t count, int32_t disparities, int16_t *fine)
{
    const uint16x8_t pixel = vidupq_n_u16(0, 1), third = vmulq_n_u16(pixel, 3); /* a stad_best is three cells */
    const uint16x8_t first = vmulq_n_u16(pixel, (uint16_t)disparities);
    for (; count >= 8; count -= 8, best += 8, fine += 8, total += 8 * (ptrdiff_t)disparities) {
        const int16x8_t index = vldrhq_gather_shifted_offset_s16(&best->index, third);
        const uint16x8_t place = vreinterpretq_u16_s16(index), at = vaddq_u16(first, place); /* of 8 * 2048 cells */
        const mve_pred16_t inside = vcmphiq_u16(vdupq_n_u16((uint16_t)(disparities - 2)), vsubq_n_u16(place, 1));
        const int16x8_t least = vldrhq_gather_shifted_offset_z_s16(total, at, inside);
        const int16x8_t before = vldrhq_gather_shifted_offset_z_s16(total - 1, at, inside);
        const int16x8_t after = vldrhq_gather_shifted_offset_z_s16(total + 1, at, inside);
        const int16x8_t whole = vshlq_n_s16(index, 4);
        if (vcmpltq_n_s16(least, 0) != 0)
            stad_refine_row_c(total, best, 8, disparities, fine);
        else
            vst1q_s16(fine, vaddq_m_s16(whole, whole, moved(before, least, after), inside));
    }
    stad_refine_row_c(total, best, count, disparities, fine);
}
