/* SPDX-License-Identifier: MIT
 * pixels -> [PREFILTER] -> [RANGE] -> cost; check -> [MEDIAN] -> disparity
 * port/isa/riscv_v/plane_row_rvv.c - prefilter, half-sample ranges and the 3x3 median; borders are left to C. */
#include <riscv_vector.h>

#include "kernel/kernel.h"
#include "../common/edge.h"

#define INLINE static inline __attribute__((always_inline))

/* The difference of the pixels at both sides. */
INLINE vint16m4_t slope(const uint8_t *row, size_t vl)
{
    return __riscv_vreinterpret_v_u16m4_i16m4(
        __riscv_vwsubu_vv_u16m4(__riscv_vle8_v_u8m2(row + 1, vl), __riscv_vle8_v_u8m2(row - 1, vl), vl));
}

void stad_prefilter_row_rvv(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width, int32_t channels,
                            int32_t cap, uint8_t *planes)
{
    uint8_t *gradient = planes, *intensity = planes + width;
    if (channels != 1 || width < 3) {
        stad_prefilter_row_c(above, row, below, width, channels, cap, planes);
        return;
    }
    for (size_t x = 1, end = (size_t)width - 1, vl; x < end; x += vl) {
        vl = __riscv_vsetvl_e8m2(end - x);
        const vint16m4_t mid = slope(row + x, vl), rim = __riscv_vadd_vv_i16m4(slope(above + x, vl), slope(below + x, vl), vl);
        const vint16m4_t sum = __riscv_vadd_vv_i16m4(__riscv_vadd_vv_i16m4(mid, mid, vl), rim, vl); /* within +-1020 */
        const vint16m4_t bound = __riscv_vmin_vx_i16m4(__riscv_vmax_vx_i16m4(sum, (int16_t)-cap, vl), (int16_t)cap, vl);
        const vint16m4_t shifted = __riscv_vadd_vx_i16m4(bound, (int16_t)cap, vl);
        /* modulo 256, as the specification has it */
        __riscv_vse8_v_u8m2(gradient + x, __riscv_vncvt_x_x_w_u8m2(__riscv_vreinterpret_v_i16m4_u16m4(shifted), vl), vl);
        __riscv_vse8_v_u8m2(intensity + x, __riscv_vle8_v_u8m2(row + x, vl), vl);
    }
    gradient[0] = gradient[width - 1] = intensity[0] = intensity[width - 1] = (uint8_t)(cap & 0xFF);
}

/* Stores a strip forwards, or backwards from its end. */
INLINE void put(uint8_t *to, vuint8m4_t v, int reverse, size_t vl)
{
    if (reverse)
        __riscv_vsse8_v_u8m4(to + vl - 1, -1, v, vl);
    else
        __riscv_vse8_v_u8m4(to, v, vl);
}

void stad_range_row_rvv(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    if (width < 3) {
        stad_range_row_c(plane, width, reverse, out);
        return;
    }
    for (size_t x = 1, end = (size_t)width - 1, vl; x < end; x += vl) {
        vl = __riscv_vsetvl_e8m4(end - x);
        uint8_t *to = out + (reverse ? (size_t)width - x - vl : x);
        const vuint8m4_t here = __riscv_vle8_v_u8m4(plane + x, vl);
        const vuint8m4_t before = __riscv_vaaddu_vv_u8m4(here, __riscv_vle8_v_u8m4(plane + x - 1, vl), __RISCV_VXRM_RDN, vl);
        const vuint8m4_t after = __riscv_vaaddu_vv_u8m4(here, __riscv_vle8_v_u8m4(plane + x + 1, vl), __RISCV_VXRM_RDN, vl);
        put(to, here, reverse, vl);
        put(to + width, __riscv_vminu_vv_u8m4(here, __riscv_vminu_vv_u8m4(before, after, vl), vl), reverse, vl);
        put(to + 2 * (ptrdiff_t)width, __riscv_vmaxu_vv_u8m4(here, __riscv_vmaxu_vv_u8m4(before, after, vl), vl), reverse, vl);
    }
    range_edge(plane, 1, width, out + (reverse ? width - 1 : 0));
    range_edge(plane + width - 1, -1, width, out + (reverse ? 0 : width - 1));
}

#define MIN(a, b) __riscv_vmin_vv_i16m2(a, b, vl)
#define MAX(a, b) __riscv_vmax_vv_i16m2(a, b, vl)

INLINE vint16m2_t median_of(vint16m2_t a, vint16m2_t b, vint16m2_t c, size_t vl)
{
    return MAX(MIN(a, b), MIN(MAX(a, b), c));
}

/* Low, mid and high of three rows at column x. */
#define SORTED(name, x)                                                                                                  \
    const vint16m2_t name##_a = __riscv_vle16_v_i16m2(above + (x), vl), name##_b = __riscv_vle16_v_i16m2(row + (x), vl), \
                     name##_c = __riscv_vle16_v_i16m2(below + (x), vl), name##_l = MIN(name##_a, name##_b),              \
                     name##_h = MAX(name##_a, name##_b), name##_low = MIN(name##_l, name##_c),                           \
                     name##_mid = MAX(name##_l, MIN(name##_h, name##_c)), name##_high = MAX(name##_h, name##_c)

void stad_median_row_rvv(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    if (width < 3) {
        stad_median_row_c(above, row, below, width, out);
        return;
    }
    for (size_t x = 1, end = (size_t)width - 1, vl; x < end; x += vl) {
        vl = __riscv_vsetvl_e16m2(end - x);
        SORTED(left, x - 1);
        SORTED(here, x);
        SORTED(right, x + 1);
        const vint16m2_t low = MAX(left_low, MAX(here_low, right_low)), high = MIN(left_high, MIN(here_high, right_high));
        __riscv_vse16_v_i16m2(out + x, median_of(low, median_of(left_mid, here_mid, right_mid, vl), high, vl), vl);
    }
    out[0] = median_edge(above, row, below, 0, 1);
    out[width - 1] = median_edge(above, row, below, width - 1, -1);
}
