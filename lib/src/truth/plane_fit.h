/* SPDX-License-Identifier: MIT
 * truth/plane_fit.h - stad_plane_fit() over a choice of identities. */
#ifndef STAD_TRUTH_PLANE_FIT_H
#define STAD_TRUTH_PLANE_FIT_H

#include "stad/truth.h"

/* As stad_plane_fit(), over the pairs whose identity has its bit set in `ids`. */
int stad_plane_fit_ids(stad_plane *plane, stad_plane_report *report, const stad_pair *pairs, int n, uint32_t ids);

#endif
