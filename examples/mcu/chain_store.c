/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_store.c - tune -> [STORE] -> reset -> match
 *
 * What was found goes to flash (chip.h). Then the power fails in the middle of the next save; after the reset the set before is still there. */
#include <string.h>

#include "chain.h"
#include "chip.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "stad/stad.h"
#include "stad/store.h"

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
    stad_setup saved, next, found;
    int first, torn, loaded;
    memset(&saved, 0, sizeof saved);
    chip_new();
    saved.width = rig->width;
    saved.height = rig->height;
    saved.mode = STAD_MODE_SGBM;
    saved.channels = 1;
    saved.origin = STAD_ORIGIN_TUNED;
    saved.corrected = 1;
    saved.params = *params;
    saved.rig = *rig;
    first = stad_store_save(&chip_flash, &saved);
    next = saved;
    next.params.uniqueness_ratio++;
    chip_power(STAD_SETUP_BYTES / 2);
    torn = stad_store_save(&chip_flash, &next);
    chip_power(-1);
    memset(&found, 0, sizeof found); /* the reset: nothing is left but the chip */
    loaded = stad_store_load(&chip_flash, &found);
    say("store: saved in slot ");
    say_dec(first);
    say(", next save torn, after the reset slot ");
    say_dec(loaded);
    say(" holds\n");
    return chain_agrees("store", hash_setup(&found), EXPECT_STORE) && first >= 0 && torn < 0 && loaded == first &&
           hash_setup(&found) == hash_setup(&saved);
}
