/* SPDX-License-Identifier: MIT
 * examples/mcu/hash.h - CRC-32 of numbers by value, so that every byte order gives the same. */
#ifndef HASH_H
#define HASH_H

#include <stdint.h>

#define HASH_START 0xffffffffu

/* Takes `bytes` bytes of value into the hash, lowest first. */
uint32_t hash_add(uint32_t hash, uint32_t value, int bytes);

/* Takes `count` disparities into the hash. */
uint32_t hash_row(uint32_t hash, const int16_t *row, int count);

#endif
