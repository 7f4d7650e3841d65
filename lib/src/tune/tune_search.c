/* SPDX-License-Identifier: MIT
 * starts -> [SEARCH] -> crosses         tune/tune_search.c - a descent, and what a search that has converged does with its budget.
 *
 * Leap, and descend anew from where that leads; descend from the best point of another block, for as long as that may come to
 * more; then crosses of the best points. */
#include "tune/tune_search.h"
#include "tune/tune_cross.h"
#include "tune/tune_descent.h"

#define LEAP_PARTS 4

/* The best of the points met so far whose block is not the best one's, or -1. */
static int best_of_another_block(const stad_tune *t)
{
    const int block = t->point[t->lead].v[STAD_TUNE_BLOCK_SIZE];
    int best = -1;
    for (int i = 0; i < t->cursor; i++) {
        if (t->cost[i] != STAD_COST_FAILED && t->point[i].v[STAD_TUNE_BLOCK_SIZE] != block &&
            (best < 0 || t->cost[i] < t->cost[best]))
            best = i;
    }
    return best;
}

void stad_tune_search(stad_tune *t)
{
    tune_walk w;
    int leapt;
    if (!stad_tune_descend(t, &w, t->lead, TUNE_REACH_FIRST, TUNE_INFINITY) || t->config.patience)
        return;
    if (!stad_tune_leap(t, &w, LEAP_PARTS, &leapt))
        return;
    if (leapt && !stad_tune_descend(t, &w, t->lead, TUNE_REACH_AGAIN, TUNE_INFINITY))
        return;
    const int other = best_of_another_block(t);
    if (other < 0 || stad_tune_descend(t, &w, other, TUNE_REACH_AGAIN, t->cost[t->lead]))
        stad_tune_cross(t);
}
