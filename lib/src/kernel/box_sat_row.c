/* SPDX-License-Identifier: MIT
 * cost -> [BOX] -> path
 * kernel/box_sat_row.c - the block cost where int16 can saturate: horizontal sums first, in the order of SPEC 4. */
#include "kernel/kernel.h"
#include "base/arith.h"

/* The running horizontal sum of one cost row. */
typedef struct runner {
    const void *cost;
    int16_t *hs;
    int wide, add_first;
} runner;

static inline int16_t cost_at(const runner *row, const stad_box_sat_job *job, int32_t x, int32_t d)
{
    const ptrdiff_t i = (ptrdiff_t)x * job->disparities + d;
    return row->wide ? (int16_t)((const uint16_t *)row->cost)[i] : ((const uint8_t *)row->cost)[i]; /* <= 954 */
}

/* hs(0): every term is >= 0, so one saturation at the end equals saturating at each. (r+1) * 954 fits int32. */
static void start(const runner *row, const stad_box_sat_job *job)
{
    for (int32_t d = 0; d < job->disparities; d++) {
        int32_t sum = (job->radius + 1) * cost_at(row, job, 0, d);
        for (int32_t x = 1; x <= job->radius; x++)
            sum += cost_at(row, job, x, d);
        row->hs[d] = sat_i16(sum);
    }
}

static void advance(const runner *row, const stad_box_sat_job *job, int32_t x)
{
    const int32_t in = min_i32(x + job->radius, job->columns - 1), out = max_i32(x - job->radius - 1, 0);
    for (int32_t d = 0; d < job->disparities; d++) {
        const int16_t plus = cost_at(row, job, in, d), minus = cost_at(row, job, out, d);
        row->hs[d] = row->add_first ? sub_sat_i16(add_sat_i16(row->hs[d], plus), minus)
                                    : add_sat_i16(sub_sat_i16(row->hs[d], minus), plus);
    }
}

static void combine(const stad_box_sat_job *job, int add_first, int16_t *block)
{
    for (int32_t d = 0; d < job->disparities; d++)
        block[d] = add_first ? sub_sat_i16(add_sat_i16(block[d], job->hs_in[d]), job->hs_out[d])
                             : add_sat_i16(sub_sat_i16(block[d], job->hs_out[d]), job->hs_in[d]);
}

static void gain(const stad_box_sat_job *job, int16_t *block)
{
    for (int32_t d = 0; d < job->disparities; d++) /* weight <= 16384: the product fits int32 */
        block[d] = add_sat_i16(block[d], sat_i16(job->weight * job->hs_in[d]));
}

void stad_box_sat_row_c(const stad_box_sat_job *job, int16_t *block)
{
    const runner in = {job->in, job->hs_in, job->wide, job->in_add_first};
    const runner out = {job->out, job->hs_out, job->wide, job->out_add_first};
    for (int32_t x = 0; x < job->columns; x++, block += job->disparities) {
        if (x == 0)
            start(&in, job);
        else
            advance(&in, job, x);
        if (job->start) {
            gain(job, block);
            continue;
        }
        if (x == 0)
            start(&out, job);
        else
            advance(&out, job, x);
        combine(job, x == 0 ? job->first_column_add_first : job->add_first, block);
    }
}
