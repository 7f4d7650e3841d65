/* SPDX-License-Identifier: MIT
 * examples/04_store.c - parameters kept in flash, found again after a reset, whatever the power did in between.
 *
 * The flash is an array here: erasing sets bits, programming clears them, and the power can be cut after any byte. A board
 * puts its own three functions in their place. */
#include <stad/stad.h>
#include <stdio.h>
#include <string.h>

enum { SECTOR = 128, GRANULE = 4 };

static uint8_t flash_bytes[3 * SECTOR];
static int power = 1 << 30; /* bytes that can still be programmed or erased before it fails */

static int flash_read(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    (void)user;
    memcpy(bytes, flash_bytes + offset, count);
    return 0;
}

static int flash_program(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    (void)user;
    for (uint32_t i = 0; i < count; i++) {
        if (power-- <= 0)
            return -1;
        flash_bytes[offset + i] &= ((const uint8_t *)bytes)[i];
    }
    return 0;
}

static int flash_erase(void *user, uint32_t offset)
{
    (void)user;
    for (uint32_t i = 0; i < SECTOR; i++) {
        if (power-- <= 0)
            return -1;
        flash_bytes[offset + i] = 0xff;
    }
    return 0;
}

static const stad_flash flash = {flash_read, flash_program, flash_erase, NULL, {0, SECTOR, 2 * SECTOR}, SECTOR, GRANULE};

static stad_setup setup_with_p2(int p2)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = 320;
    s.height = 240;
    s.mode = STAD_MODE_SGBM;
    s.channels = 1;
    s.origin = STAD_ORIGIN_TUNED;
    stad_params_sample(&s.params, 64, 3, 1);
    s.params.p2 = (int16_t)p2;
    stad_rig_identity(&s.rig, s.width, s.height);
    return s;
}

int main(void)
{
    stad_setup found, factory = setup_with_p2(288), tuned = setup_with_p2(190);
    memset(flash_bytes, 0xff, sizeof flash_bytes);
    if (stad_store_save_factory(&flash, &factory) < 0 || stad_store_load(&flash, &found) != STAD_SLOT_FACTORY)
        return 1;
    printf("a new board starts with p2 %d\n", found.params.p2);
    if (stad_store_save(&flash, &tuned) < 0 || stad_store_load(&flash, &found) < 0)
        return 1;
    printf("after tuning and a reset: p2 %d\n", found.params.p2);

    int old = 0, fresh = 0, other = 0;
    for (int cut = 0; cut < 2 * SECTOR; cut++) { /* cut the power after every byte of the next save */
        stad_setup next = setup_with_p2(found.params.p2 + 1);
        power = cut;
        stad_store_save(&flash, &next);
        power = 1 << 30;
        const int16_t before = found.params.p2;
        if (stad_store_load(&flash, &found) < 0)
            return 1;
        old += found.params.p2 == before;
        fresh += found.params.p2 == before + 1;
        other += found.params.p2 != before && found.params.p2 != before + 1;
    }
    printf("%d saves cut short: %d times the set before, %d times the new one, %d times anything else\n", old + fresh + other,
           old, fresh, other);
    return found.params.p2 > 190 && old > 0 && other == 0 ? 0 : 1;
}
