/* SPDX-License-Identifier: MIT
 * best -> [WINNERS] -> select
 * match/winners.c - the winners of a frame, kept row by row as the rows are made, and read again in that order.
 *
 * A row of them is `width` records of four int16: place, cost and rival of the winner, then its sub-pixel place, of which
 * the first `columns` are used: first all records of stad_best, then the refined places. */
#include <string.h>

#include "match/frame.h"
#include "base/arith.h"

#define NO_WINNERS INT16_MIN /* place of the first: 3WAY leaves rows without any (SPEC 7) */

static stad_best *best_of_row(const stad_winners *w, int32_t row)
{
    return (stad_best *)(void *)((uint8_t *)w->memory + (size_t)row * STAD_WINNERS_ROW(w->width));
}

static int16_t *fine_of_row(const stad_winners *w, int32_t row)
{
    return (int16_t *)(void *)(best_of_row(w, row) + w->width);
}

size_t stad_winners_bytes(const stad_geometry *g)
{
    return stad_geometry_check(g, NULL) == STAD_OK ? STAD_WINNERS_BYTES(g->width, g->height) : 0;
}

int stad_winners_init(stad_winners *w, const stad_geometry *g, void *memory, size_t bytes)
{
    memset(w, 0, sizeof *w);
    const size_t need = stad_winners_bytes(g);
    if (need == 0)
        return STAD_E_PARAM;
    if (!memory || (uintptr_t)memory % sizeof(int16_t) != 0 || bytes < need)
        return STAD_E_SIZE;
    w->width = g->width;
    w->height = g->height;
    w->mode = g->mode;
    w->memory = memory;
    return STAD_OK;
}

void stad_winners_forget(stad_winners *w)
{
    w->rows = 0;
}

int stad_winners_serve(const stad_winners *w, const stad_params *p)
{
    const stad_params *q = &w->params;
    return w->rows == w->height && w->rows > 0 && q->min_disparity == p->min_disparity &&
           q->num_disparities == p->num_disparities && q->block_size == p->block_size && q->p1 == p->p1 && q->p2 == p->p2 &&
           q->pre_filter_cap == p->pre_filter_cap;
}

void stad_winners_open(stad_frame *f)
{
    f->best = best_of_row(f->keep, f->made);
    f->fine = fine_of_row(f->keep, f->made);
    f->best->index = NO_WINNERS;
}

int stad_winners_step(stad_frame *f)
{
    const stad_best *best = best_of_row(f->again, f->made);
    stad_row_open(f);
    if (best->index != NO_WINNERS)
        stad_row_select(f, best, fine_of_row(f->again, f->made), 0, f->columns);
    stad_row_close(f);
    return STAD_OK;
}
