/* SPDX-License-Identifier: MIT
 * examples/mcu/chain.h - the steps of the firmware; each prints a line and answers whether its hash is the expected one. */
#ifndef CHAIN_H
#define CHAIN_H

#include <stddef.h>
#include <stdint.h>

/* Workspace that the steps use in turn; HH of the small scene is the largest. */
extern uint8_t work[];
extern const size_t work_bytes;

/* Matches the made-up scenes in every mode. */
int chain_match(void);

/* Tunes the matcher on a small scene whose truth is known. */
int chain_tune(void);

/* Prints "<name>: <hash> ok", or what was expected; answers whether they agree. */
int chain_agrees(const char *name, uint32_t hash, uint32_t expected);

#endif
