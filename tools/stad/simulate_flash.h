/* SPDX-License-Identifier: MIT
 * stad/simulate_flash.h - flash in memory, for the store of a simulated board. */
#ifndef STAD_SIMULATE_FLASH_H
#define STAD_SIMULATE_FLASH_H

#include "simulate.h"

/* All sectors erased. `s` stays where it is from here on. */
void sim_flash_init(sim_flash *s);

#endif
