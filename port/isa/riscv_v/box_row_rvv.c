/* SPDX-License-Identifier: MIT
 * cost -> [BOX] -> path
 * port/isa/riscv_v/box_row_rvv.c - vertical sums of cost rows, and the block costs slid along them. */
#include <riscv_vector.h>

#include "kernel/kernel.h"

/* A weight is 1, the first row's r + 1, or -1 for a row that leaves: a signed byte holds it. */
void stad_box_add_row_u8_rvv(int16_t *sum, const uint8_t *cost, int32_t n, int32_t weight)
{
    if (weight < INT8_MIN || weight > INT8_MAX) {
        stad_box_add_row_u8_c(sum, cost, n, weight);
        return;
    }
    for (size_t left = (size_t)n, vl; left > 0; left -= vl, sum += vl, cost += vl) {
        vl = __riscv_vsetvl_e8m4(left);
        const vuint8m4_t more = __riscv_vle8_v_u8m4(cost, vl);
        const vint16m8_t before = __riscv_vle16_v_i16m8(sum, vl);
        __riscv_vse16_v_i16m8(sum, __riscv_vwmaccsu_vx_i16m8(before, (int8_t)weight, more, vl), vl);
    }
}

/* Column x of the sums, and how far to the next one: columns outside repeat the border. */
static inline const int16_t *sum_column(const stad_slide_job *job, int32_t x)
{
    const int32_t last = job->columns - 1;
    return job->sum + (ptrdiff_t)(x < 0 ? 0 : x < last ? x : last) * job->disparities;
}

static inline ptrdiff_t to_next(const stad_slide_job *job, int32_t x)
{
    return x >= 0 && x < job->columns - 1 ? job->disparities : 0;
}

/* A strip of the whole run from disparity `at` on, the running sums in registers. `inside`: no column repeats. */
static inline __attribute__((always_inline)) void slide_strip(const stad_slide_job *job, size_t at, size_t vl, int inside,
                                                              int16_t *to)
{
    const ptrdiff_t n = job->disparities;
    const int32_t r = job->radius, last = job->columns - 1;
    const int16_t *in = sum_column(job, job->x - r) + at, *out = in;
    vint16m8_t run = __riscv_vmv_v_x_i16m8((int16_t)job->p2, vl);
    for (int32_t x = job->x - r; x <= job->x + r; x++) {
        run = __riscv_vadd_vv_i16m8(run, __riscv_vle16_v_i16m8(in, vl), vl);
        in += inside ? n : to_next(job, x);
    }
    __riscv_vse16_v_i16m8(to, run, vl);
    for (int32_t i = job->count - 1, x = job->x; i > 0; i--, x++) {
        run = __riscv_vadd_vv_i16m8(run, __riscv_vle16_v_i16m8(in, vl), vl);
        run = __riscv_vsub_vv_i16m8(run, __riscv_vle16_v_i16m8(out, vl), vl);
        to += n;
        __riscv_vse16_v_i16m8(to, run, vl);
        in += inside || x + r + 1 < last ? n : 0;
        out += inside || x >= r ? n : 0;
    }
}

void stad_slide_row_rvv(const stad_slide_job *job, int16_t *block)
{
    const size_t n = (size_t)job->disparities;
    const int inside = job->x >= job->radius && job->x + job->count + job->radius <= job->columns;
    for (size_t at = 0, vl; at < n; at += vl) {
        vl = __riscv_vsetvl_e16m8(n - at);
        if (inside)
            slide_strip(job, at, vl, 1, block + at);
        else
            slide_strip(job, at, vl, 0, block + at);
    }
}
