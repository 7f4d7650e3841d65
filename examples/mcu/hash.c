/* SPDX-License-Identifier: MIT
 * examples/mcu/hash.c - CRC-32 of numbers by value, so that every byte order gives the same. */
#include "hash.h"

uint32_t hash_add(uint32_t hash, uint32_t value, int bytes)
{
    int bit;
    for (; bytes > 0; bytes--, value >>= 8) {
        hash ^= value & 0xff;
        for (bit = 0; bit < 8; bit++)
            hash = (hash >> 1) ^ (0xedb88320u & (0u - (hash & 1)));
    }
    return hash;
}

uint32_t hash_row(uint32_t hash, const int16_t *row, int count)
{
    int i;
    for (i = 0; i < count; i++)
        hash = hash_add(hash, (uint16_t)row[i], 2);
    return hash;
}
