/* SPDX-License-Identifier: MIT
 * refine -> [SELECT] -> check
 * kernel/select_row.c - winners to disparities; each winner votes for the right view.
 *
 * The uniqueness test asks for a rival outside +-1 that is nearly as good; all forms of it are monotone in the rival's
 * cost, so the least rival (the runner-up) decides. Bounds: costs are int16, so every product with 100 fits int32. */
#include "kernel/kernel.h"
#include "base/arith.h"

static int is_ambiguous(const stad_select_job *job, const stad_best *best)
{
    const int32_t rest = 100 - job->uniqueness_ratio;
    if (!job->floor_rule)
        return best->runner_up * rest < best->least * 100;
    return job->uniqueness_ratio > 0 && best->runner_up < wrap_i16(100 * best->least / rest + 1);
}

/* The uniqueness margin on a scale of 255: how much cheaper the winner is than the runner-up. */
static uint8_t margin(const stad_best *best)
{
    if (best->runner_up <= 0 || best->least >= best->runner_up)
        return 0;
    return narrow_u8((best->runner_up - max_i32(best->least, 0)) * 255 / best->runner_up);
}

/* Both values are stored either way: whether a vote wins is a coin's toss that a branch would often guess wrong. */
static void vote(const stad_select_job *job, int32_t x, const stad_best *best)
{
    const int32_t disparity = best->index + job->min_disparity, right = x - disparity;
    if (right < 0 || right >= job->width)
        return;
    const int16_t cost = job->vote_cost[right], held = job->vote_disp[right];
    job->vote_cost[right] = min_i16(cost, best->least);
    job->vote_disp[right] = cost > best->least ? narrow_i16(disparity) : held;
}

void stad_select_row_c(stad_select_job *job)
{
    STAD_ASSERT(job->x >= 0 && job->x + job->count <= job->width && job->uniqueness_ratio < 100);
    const stad_select_job j = *job; /* the rows written to might alias job itself */
    int32_t firm = 0, rejected = 0;
    for (int32_t i = j.count - 1; i >= 0; i--) {
        const stad_best *best = &j.best[i];
        const int32_t x = j.x + i;
        firm += 75 * best->runner_up >= 100 * best->least;
        if (is_ambiguous(&j, best)) {
            rejected++;
            continue;
        }
        vote(&j, x, best);
        j.disp[x] = wrap_i16(j.fine[i] + 16 * j.min_disparity);
        if (j.confidence)
            j.confidence[x] = margin(best);
    }
    job->firm += firm;
    job->rejected += rejected;
}
