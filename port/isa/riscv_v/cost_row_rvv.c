/* SPDX-License-Identifier: MIT
 * range -> [COST] -> box
 * port/isa/riscv_v/cost_row_rvv.c - pixel costs, a strip of disparities at once, in bytes.
 *
 * low <= value <= high, so of max(0, u - high) and max(0, low - u) one is zero: their maximum is their OR. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

#define INLINE static inline __attribute__((always_inline))

/* A left sample of a plane, lows and highs a width further each; values, lows and highs of the right row from the column
 * that disparity `at` meets. */
typedef struct plane_pair {
    const uint8_t *left, *right, *right_low, *right_high;
    ptrdiff_t width;
} plane_pair;

INLINE plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x, size_t at)
{
    const ptrdiff_t width = job->width;
    const uint8_t *right = job->right + plane * 3 * width + (width - 1 - x + job->min_disparity) + at;
    const plane_pair p = {job->left + plane * 3 * width + x, right, right + width, right + 2 * width, width};
    return p;
}

/* To the next column. Each address in a register of its own, or clang adds `at` at every load. */
INLINE void plane_next(plane_pair *p)
{
    p->left++;
    p->right--;
    p->right_low--;
    p->right_high--;
    __asm__("" : "+r"(p->right), "+r"(p->right_low), "+r"(p->right_high));
}

/* max(u - v, 0). */
INLINE vuint8m2_t floor_below(uint8_t u, vuint8m2_t v, size_t vl)
{
    return __riscv_vsub_vv_u8m2(__riscv_vmaxu_vx_u8m2(v, u, vl), v, vl);
}

INLINE vuint8m2_t distance(const plane_pair *p, size_t vl)
{
    const uint8_t here = p->left[0], here_low = p->left[p->width], here_high = p->left[2 * p->width];
    const vuint8m2_t value = __riscv_vle8_v_u8m2(p->right, vl), low = __riscv_vle8_v_u8m2(p->right_low, vl);
    const vuint8m2_t high = __riscv_vle8_v_u8m2(p->right_high, vl);
    const vuint8m2_t to_right = __riscv_vor_vv_u8m2(floor_below(here, high, vl), __riscv_vssubu_vx_u8m2(low, here, vl), vl);
    const vuint8m2_t to_left =
        __riscv_vor_vv_u8m2(__riscv_vssubu_vx_u8m2(value, here_high, vl), floor_below(here_low, value, vl), vl);
    return __riscv_vminu_vv_u8m2(to_right, to_left, vl);
}

/* A strip of the whole run, from disparity `at` on. */
INLINE void run_strip(const stad_cost_job *job, size_t at, size_t vl, uint8_t *cost)
{
    plane_pair gradient = pair_at(job, 0, job->x, at), intensity = pair_at(job, 1, job->x, at);
    const ptrdiff_t n = job->disparities;
    for (int32_t i = job->count; i > 0; i--, cost += n) {
        const vuint8m2_t quarter = __riscv_vsrl_vx_u8m2(distance(&intensity, vl), 2, vl);
        __riscv_vse8_v_u8m2(cost, __riscv_vadd_vv_u8m2(distance(&gradient, vl), quarter, vl), vl);
        plane_next(&gradient);
        plane_next(&intensity);
    }
}

void stad_cost_row_u8_rvv(const stad_cost_job *job, uint8_t *cost)
{
    const size_t n = (size_t)job->disparities;
    if (job->channels != 1) {
        stad_cost_row_u8_c(job, cost);
        return;
    }
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e8m2(n - at);
        run_strip(job, at, vl, cost + at);
    }
}
