/* SPDX-License-Identifier: MIT
 * costs -> [WINDOW] -> sweep
 * match/window_sat.c - C where int16 can saturate: it depends on its past then, and only moves down (SPEC 4). */
#include "match/frame.h"
#include "base/arith.h"

static stad_box_sat_job sat_job(const stad_frame *f, int32_t in, int32_t out)
{
    const int three_way = f->g.mode == STAD_MODE_3WAY;
    const int32_t d = f->p.num_disparities, early = f->window_top + f->radius;
    stad_box_sat_job job = {NULL,
                            NULL,
                            f->hs,
                            f->hs + d,
                            f->columns,
                            d,
                            f->radius,
                            1,
                            f->wide,
                            0,
                            three_way || in <= early,
                            three_way || out <= early,
                            1,
                            three_way};
    return job;
}

void stad_window_sat_start(stad_frame *f, int32_t top)
{
    const int32_t last = f->g.height - 1;
    stad_row_fill(f->window, f->columns * f->p.num_disparities, f->p.p2);
    for (int32_t k = top; k <= top + f->radius; k++) {
        const int32_t y = min_i32(k, last);
        stad_box_sat_job job = sat_job(f, y, y);
        job.in = stad_costs_row(f, y, 0);
        job.start = 1;
        job.weight = k == top ? f->radius + 1 : 1;
        stad_box_sat_row(&job, f->window);
    }
}

void stad_window_sat_go(stad_frame *f, int32_t y)
{
    const int32_t in = min_i32(y + f->radius, f->g.height - 1), out = max_i32(y - f->radius - 1, f->window_top);
    stad_box_sat_job job = sat_job(f, in, out);
    job.out = stad_costs_row(f, out, 1);
    job.in = stad_costs_row(f, in, 0);
    job.first_column_add_first = f->g.mode == STAD_MODE_3WAY || y + f->radius < f->g.height;
    stad_box_sat_row(&job, f->window);
}
