/* SPDX-License-Identifier: MIT
 * examples/mcu/chip.h - flash for a firmware without any: an array that behaves like one, and loses power when asked to. */
#ifndef CHIP_H
#define CHIP_H

#include "stad/store.h"

extern const stad_flash chip_flash;

/* All erased, power on. */
void chip_new(void);

/* Bytes that can still be programmed before the power fails; -1: it does not. */
void chip_power(int32_t bytes);

#endif
