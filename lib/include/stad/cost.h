/* SPDX-License-Identifier: MIT
 * stad/cost.h - the unit in which score speaks to tune.
 *
 * A cost is an int32 in Q20: 0 is a perfect disparity map, STAD_COST_ONE (1 << 20) everything wrong. Costs above
 * STAD_COST_ONE are allowed (weighted sums, other problems); negative ones are not. */
#ifndef STAD_COST_H
#define STAD_COST_H

#include <stdint.h>

#define STAD_COST_ONE ((int32_t)1 << 20) /* everything wrong */

/* What is told when a point could not be scored: a frame was lost, no pixel had truth, the match was refused. */
#define STAD_COST_FAILED INT32_MAX

#endif
