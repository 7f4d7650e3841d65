/* SPDX-License-Identifier: MIT
 * stad/simulate_flash.c - flash in memory: erasing sets every bit, programming only clears them. */
#include "simulate_flash.h"

#include <string.h>

static int read_bytes(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    memcpy(bytes, (const uint8_t *)user + offset, count);
    return 0;
}

static int program_bytes(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    uint8_t *to = (uint8_t *)user + offset;
    for (uint32_t i = 0; i < count; i++)
        to[i] &= ((const uint8_t *)bytes)[i];
    return 0;
}

static int erase_sector(void *user, uint32_t offset)
{
    memset((uint8_t *)user + offset, 0xff, SIM_SECTOR);
    return 0;
}

void sim_flash_init(sim_flash *s)
{
    const stad_flash flash = {read_bytes, program_bytes, erase_sector, s->bytes, {0, SIM_SECTOR, 2 * SIM_SECTOR}, SIM_SECTOR, 4};
    memset(s->bytes, 0xff, sizeof s->bytes);
    s->flash = flash;
}
