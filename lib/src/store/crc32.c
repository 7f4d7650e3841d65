/* SPDX-License-Identifier: MIT
 * setup -> [CRC] -> slot        store/crc32.c - CRC-32, a bit at a time
 *
 * A record has 60 bytes and is checked a few times a recalibration: no table is worth its flash. Up to 91,607 bits
 * this polynomial finds every change of three bits, and every burst up to 32. */
#include "store/crc32.h"

uint32_t stad_crc32(const uint8_t *bytes, size_t n)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < n; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = (crc >> 1) ^ (crc & 1u ? 0xedb88320u : 0u);
    }
    return ~crc;
}
