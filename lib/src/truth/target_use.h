/* SPDX-License-Identifier: MIT
 * truth/target_use.h - can a target be used, and which marks does it carry. */
#ifndef STAD_TARGET_USE_H
#define STAD_TARGET_USE_H

#include "stad/target.h"

/* 1: a truth can be made from it with this camera; `camera` NULL: with none. */
int stad_target_fits(const stad_target *target, const stad_camera *camera);

/* Bit i: it carries mark i. */
uint32_t stad_target_ids(const stad_target *target);

#endif
