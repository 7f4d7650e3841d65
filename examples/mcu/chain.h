/* SPDX-License-Identifier: MIT
 * examples/mcu/chain.h - the steps of the firmware; each prints a line and answers whether its hash is the expected one. */
#ifndef CHAIN_H
#define CHAIN_H

#include <stddef.h>
#include <stdint.h>

#include "stad/params.h"
#include "stad/rig.h"

/* Workspace that the steps use in turn; HH of the small scene is the largest. */
extern uint8_t work[];
extern const size_t work_bytes;

/* Matches the made-up scenes in every mode. */
int chain_match(void);

/* Watches live frames until the monitor asks for a recalibration. */
int chain_watch(void);

/* Finds marks in both views and the correction of the right one. */
int chain_marks(stad_rig *rig);

/* Tunes the matcher on a small scene whose truth is known; the best parameters in *best. */
int chain_tune(stad_params *best);

/* Saves, loses power in the next save, resets and loads. */
int chain_store(const stad_params *params, const stad_rig *rig);

/* Prints "<name>: <hash> ok", or what was expected; answers whether they agree. */
int chain_agrees(const char *name, uint32_t hash, uint32_t expected);

#endif
