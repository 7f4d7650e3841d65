/* SPDX-License-Identifier: MIT
 * tune/tune_wolfe.h - the textbook descent shared by the methods kept for comparison. */
#ifndef STAD_TUNE_WOLFE_H
#define STAD_TUNE_WOLFE_H

#include "tune/tune_core.h"

#define WOLFE_ONE        4096 /* line search length 1 in Q12: the longest coordinate moves one step */
#define WOLFE_SLOPE_MOST (1 << 24)

/* All coordinates as if continuous, Q16: log2 variables, block as (b - 1) / 2, disp12 as its log2. */
typedef struct wolfe_spot {
    int32_t z[STAD_TUNE_DIMS];
    int32_t slope[STAD_TUNE_DIMS]; /* cost per step, Q20 */
    int32_t cost;
} wolfe_spot;

typedef struct wolfe_way {
    int32_t way[STAD_TUNE_DIMS];  /* direction, Q20 like a slope */
    int32_t diff[STAD_TUNE_DIMS]; /* distance of the differences, Q16 */
    int32_t longest;              /* of way */
} wolfe_way;

/* Runs it from the start of the search. `conjugate`: 1 for PR+ directions, 0 for steepest descent. */
void stad_tune_wolfe_run(stad_tune *t, int conjugate);

void stad_tune_wolfe_from(const stad_tune *t, const stad_point *x, int32_t *z);
int stad_tune_wolfe_cost(stad_tune *t, const int32_t *z, int32_t *cost);

/* Central differences. A difference of nothing doubles its distance for the next time, up to one step. */
int stad_tune_wolfe_gradient(stad_tune *t, wolfe_way *d, wolfe_spot *s);

/* Strong Wolfe by bisection, first length *a_q12. *moved: `s` is a better spot with its gradient, at *a_q12. */
int stad_tune_wolfe_search(stad_tune *t, wolfe_way *d, wolfe_spot *s, int32_t *a_q12, int *moved);

/* a . b of slopes and directions, each |.| <= 2^25: below 2^53. */
int64_t stad_tune_wolfe_dot(const int32_t *a, const int32_t *b);

#endif
