/* SPDX-License-Identifier: MIT
 * proof/wp_path.c - a step of one path for every number of disparities and all penalties: what SPEC 5 promises of a pixel's costs,
 * 0 <= L <= C and a least cost that leaves room for p2, follows from the same of the pixel before. Sums of any costs.
 * FUNCTIONS: stad_path_cost stad_path_sum step_one add_total */
#include "proof/contracts.h"
#include "kernel/path_step.h"

/* p[-1 .. 1] are at least m = delta - p2, and block holds p2: said without p2, block + p[] reaches delta. */
/*@ requires \valid_read(p + (-1 .. 1));
    requires 0 <= p[-1] && 0 <= p[0] && 0 <= p[1] && 1 <= p1 <= delta && 0 <= block;
    requires block + p[-1] >= delta && block + p[0] >= delta && block + p[1] >= delta;
    assigns \nothing;
    ensures 0 <= \result <= block;
    ensures block + p[0] - delta >= \result; */
static inline int16_t stad_path_cost(const int16_t *p, int16_t block, int16_t delta, int16_t p1);

/*@ requires 0 <= total && 0 <= path; assigns \nothing; ensures total <= \result && path <= 32767; */
static inline int16_t stad_path_sum(int16_t total, int16_t path);

/* A path: the costs it comes from, fences included, those it makes, and m + p2. */
/*@ predicate path(int16_t *from, int16_t *to, int16_t *block, integer n, integer delta, integer p1) =
        \valid_read(from + (-1 .. n)) && \valid(to + (0 .. n - 1)) && \separated(to + (0 .. n - 1), from + (-1 .. n)) &&
        \separated(to + (0 .. n - 1), block + (0 .. n - 1)) && 1 <= p1 <= delta &&
        (\forall integer d; -1 <= d <= n ==> 0 <= from[d]) &&
        (\forall integer d; 0 <= d < n ==> block[d] + from[d - 1] >= delta && block[d] + from[d] >= delta && block[d] + from[d + 1] >= delta);
    predicate made(int16_t *from, int16_t *to, int16_t *block, integer n, integer delta, integer least) =
        0 <= least && \forall integer d; 0 <= d < n ==> least <= to[d] <= block[d] && least <= block[d] + from[d] - delta; */

/*@ requires \valid(s) && s->disparities >= 0 && s->disparities % 8 == 0;
    requires \valid_read(block + (0 .. s->disparities - 1)) && path(from, to, block, s->disparities, s->delta[0], s->p1);
    requires \forall integer d; 0 <= d < s->disparities ==> 0 <= block[d];
    requires \separated(s, to + (0 .. s->disparities - 1), from + (-1 .. s->disparities)) && \separated(s, block + (0 .. s->disparities - 1));
    assigns to[0 .. s->disparities - 1], s->least[0];
    ensures made(from, to, block, s->disparities, s->delta[0], s->least[0]); */
static void step_one(const int16_t *restrict from, int16_t *restrict to, const int16_t *restrict block, stad_path_step *s);

/*@ requires disparities >= 0 && disparities % 8 == 0;
    requires \valid(total + (0 .. disparities - 1)) && \valid_read(path + (0 .. disparities - 1));
    requires \separated(total + (0 .. disparities - 1), path + (0 .. disparities - 1));
    requires \forall integer d; 0 <= d < disparities ==> 0 <= total[d] && 0 <= path[d];
    assigns total[0 .. disparities - 1]; */
static void add_total(int16_t *restrict total, const int16_t *restrict path, int32_t disparities);

#include "kernel/path_row.c"
