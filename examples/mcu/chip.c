/* SPDX-License-Identifier: MIT
 * examples/mcu/chip.c - programming only clears bits, erasing sets a sector. */
#include "chip.h"

#include <string.h>

enum { SECTOR = 256, SLOTS = 3 };

typedef struct chip {
    uint8_t cells[SLOTS * SECTOR];
    int32_t budget; /* bytes that can still be programmed before the power fails; -1: it does not */
} chip;

static chip flash_chip = {{0}, -1};

static int chip_read(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    memcpy(bytes, ((const chip *)user)->cells + offset, count);
    return 0;
}

static int chip_program(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    chip *c = user;
    const uint8_t *from = bytes;
    uint32_t i;
    for (i = 0; i < count; i++) {
        if (c->budget == 0)
            return 1;
        c->budget -= c->budget > 0;
        c->cells[offset + i] = (uint8_t)(c->cells[offset + i] & from[i]);
    }
    return 0;
}

static int chip_erase(void *user, uint32_t offset)
{
    memset(((chip *)user)->cells + offset, 0xff, SECTOR);
    return 0;
}

const stad_flash chip_flash = {chip_read, chip_program, chip_erase, &flash_chip, {0, SECTOR, 2 * SECTOR}, SECTOR, 4};

void chip_new(void)
{
    memset(flash_chip.cells, 0xff, sizeof flash_chip.cells);
    flash_chip.budget = -1;
}

void chip_power(int32_t bytes)
{
    flash_chip.budget = bytes;
}
