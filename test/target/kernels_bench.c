/* SPDX-License-Identifier: MIT
 * test/target/kernels_bench.c - draws with extremes often, inputs, and two outputs between guards. */
#include <string.h>

#include "kernels.h"

enum { FILL = 0xa7 };

uint8_t bytes_a[12 * WIDTH * 3], bytes_b[12 * WIDTH * 3];
int16_t words_a[CELLS + 16], words_b[CELLS + 16], words_c[CELLS + 16];

static uint32_t state;

uint32_t draw(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

int32_t between(int32_t low, int32_t high)
{
    return low + (int32_t)(draw() % (uint32_t)(high - low + 1));
}

int32_t value_to(int32_t top)
{
    const uint32_t kind = draw() % 8;
    return kind == 0 ? 0 : kind == 1 ? top : between(0, top);
}

void fill_u8(uint8_t *p, int32_t n, int32_t top)
{
    while (n-- > 0)
        *p++ = (uint8_t)value_to(top);
}

void fill_i16(int16_t *p, int32_t n, int32_t low, int32_t top)
{
    while (n-- > 0)
        *p++ = (int16_t)(low + value_to(top - low));
}

output mine, reference;

void prepare(uint32_t seed)
{
    state = seed * 2654435761u;
    memset(&mine, FILL, sizeof mine);
    memset(&reference, FILL, sizeof reference);
}

int same(void)
{
    size_t i;
    int good = memcmp(&mine, &reference, sizeof mine) == 0;
    for (i = 0; i < GUARD; i++)
        good &= mine.u8[i] == FILL && mine.u8[sizeof mine - 1 - i] == FILL;
    return good;
}
