/* SPDX-License-Identifier: MIT
 * window -> [MODE] -> row
 * match/mode_sgbm.c - MODE_SGBM: five paths in one pass from the top, two sweeps a row (SPEC 6). */
#include "match/frame.h"
#include "base/arith.h"

int stad_mode_sgbm_step(stad_frame *f)
{
    const int32_t y = f->made;
    if (!frame_has_row(f, y + f->radius + 1))
        return STAD_AGAIN;
    if (y == 0) {
        stad_lanes_reset(f, &f->down);
        stad_window_start(f, 0, 0);
    }
    stad_window_go(f, y);
    f->oldest = max_i32(y - f->radius - 1, 0); /* the row that leaves next, and the one above it */
    stad_row_open(f);
    stad_sweep_streamed(f);
    stad_row_close(f);
    return STAD_OK;
}
