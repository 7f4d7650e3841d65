/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_store.c - tune -> [STORE] -> reset -> match
 *
 * What was found goes to flash, here an array that behaves like one: programming only clears bits, erasing sets a sector.
 * Then the power fails in the middle of the next save; after the reset the set before is still there. */
#include <string.h>

#include "chain.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "stad/stad.h"
#include "stad/store.h"

enum { SECTOR = 256, SLOTS = 3 };

typedef struct chip {
    uint8_t cells[SLOTS * SECTOR];
    int32_t budget; /* bytes that can still be programmed before the power fails; -1: it does not */
} chip;

static chip flash_chip;

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

static uint32_t hash_setup(const stad_setup *s)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    uint32_t hash = HASH_START;
    size_t i;
    stad_setup_pack(s, 1, bytes);
    for (i = 0; i < sizeof bytes; i++)
        hash = hash_add(hash, bytes[i], 1);
    return hash;
}

int chain_store(const stad_params *params, const stad_rig *rig)
{
    static const stad_flash flash = {chip_read,  chip_program, chip_erase, &flash_chip, {0, SECTOR, 2 * SECTOR},
                                     SECTOR, 4};
    stad_setup saved, next, found;
    int first, torn, loaded;
    memset(&saved, 0, sizeof saved);
    memset(flash_chip.cells, 0xff, sizeof flash_chip.cells);
    saved.width = rig->width;
    saved.height = rig->height;
    saved.mode = STAD_MODE_SGBM;
    saved.channels = 1;
    saved.origin = STAD_ORIGIN_TUNED;
    saved.corrected = 1;
    saved.params = *params;
    saved.rig = *rig;
    flash_chip.budget = -1;
    first = stad_store_save(&flash, &saved);
    next = saved;
    next.params.uniqueness_ratio++;
    flash_chip.budget = STAD_SETUP_BYTES / 2;
    torn = stad_store_save(&flash, &next);
    flash_chip.budget = -1;
    memset(&found, 0, sizeof found); /* the reset: nothing is left but the chip */
    loaded = stad_store_load(&flash, &found);
    say("store: saved in slot ");
    say_dec(first);
    say(", next save torn, after the reset slot ");
    say_dec(loaded);
    say(" holds\n");
    return chain_agrees("store", hash_setup(&found), EXPECT_STORE) && first >= 0 && torn < 0 && loaded == first &&
           hash_setup(&found) == hash_setup(&saved);
}
