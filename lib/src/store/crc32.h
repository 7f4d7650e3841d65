/* SPDX-License-Identifier: MIT
 * store/crc32.h - the check of a stored record. */
#ifndef STAD_STORE_CRC32_H
#define STAD_STORE_CRC32_H

#include <stddef.h>
#include <stdint.h>

/* CRC-32 of n bytes: polynomial 0x04c11db7 reflected, start and final xor 0xffffffff. "123456789" gives 0xcbf43926. */
uint32_t stad_crc32(const uint8_t *bytes, size_t n);

#endif
