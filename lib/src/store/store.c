/* SPDX-License-Identifier: MIT
 * setup -> pack -> [STORE] -> flash        store/store.c - two slots in turn, a third for the factory
 *
 * The invariant that survives any cut: the slot about to be erased is never the only one with a good record. Hence a
 * save first looks at both slots, writes the one that is bad or older, and leaves the other alone until the next
 * save. */
#include "stad/store.h"

#include <string.h>

#include "base/bytes.h"
#include "base/arith.h"

enum slot_state { SLOT_BAD, SLOT_GOOD, SLOT_UNREADABLE };

typedef struct slot_view {
    enum slot_state state;
    uint32_t sequence;
} slot_view;

#define MAX_GRANULE 64u
#define RECORD_ROOM 128u /* STAD_SETUP_BYTES rounded up to the largest granule */
typedef char record_fits[STAD_SETUP_BYTES <= RECORD_ROOM && RECORD_ROOM % MAX_GRANULE == 0 ? 1 : -1];

static uint32_t padded_bytes(const stad_flash *f)
{
    return (STAD_SETUP_BYTES + f->program_bytes - 1u) & ~(f->program_bytes - 1u);
}

/* Sectors that share no byte: the way from one to the other, either way round, is no shorter than a sector. */
static int apart(const stad_flash *f, int a, int b)
{
    return f->slot_offset[a] - f->slot_offset[b] + f->sector_bytes - 1u >= 2u * f->sector_bytes - 1u;
}

static int flash_fits(const stad_flash *f)
{
    uint32_t granule = f->program_bytes;
    if (!f->read || !f->program || !f->erase)
        return 0;
    if (granule - 1u >= MAX_GRANULE || (granule & (granule - 1u)) != 0 || f->sector_bytes < padded_bytes(f))
        return 0;
    return apart(f, STAD_SLOT_A, STAD_SLOT_B) && apart(f, STAD_SLOT_B, STAD_SLOT_FACTORY) &&
           apart(f, STAD_SLOT_A, STAD_SLOT_FACTORY);
}

/* What a slot holds; a good one goes to *setup. What is not good is read twice: a bus may slip once. */
static void look(const stad_flash *f, int slot, slot_view *view, stad_setup *setup)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    view->sequence = 0;
    for (int tries = 0; tries < 2; tries++) {
        view->state = SLOT_UNREADABLE;
        if (f->read(f->user, f->slot_offset[slot], bytes, STAD_SETUP_BYTES) != 0)
            continue;
        view->state = SLOT_BAD;
        if (stad_setup_unpack(bytes, STAD_SETUP_BYTES, setup, &view->sequence) != STAD_OK)
            continue;
        view->state = SLOT_GOOD;
        return;
    }
}

/* Sequence numbers go round: of two neighbours the later one is ahead by less than half the circle. */
static int is_later(uint32_t a, uint32_t b)
{
    return a != b && a - b < 0x80000000u;
}

/* The slot with the newest good record, or -1. */
static int newest(const slot_view view[2])
{
    if (view[0].state != SLOT_GOOD)
        return view[1].state == SLOT_GOOD ? STAD_SLOT_B : -1;
    if (view[1].state != SLOT_GOOD)
        return STAD_SLOT_A;
    return is_later(view[1].sequence, view[0].sequence) ? STAD_SLOT_B : STAD_SLOT_A;
}

int stad_store_load_slot(const stad_flash *flash, int slot, stad_setup *setup)
{
    slot_view view;
    if (!flash_fits(flash) || slot < STAD_SLOT_A || slot > STAD_SLOT_FACTORY)
        return STAD_E_PARAM;
    look(flash, slot, &view, setup);
    return view.state == SLOT_GOOD ? slot : STAD_E_CORRUPT;
}

int stad_store_load(const stad_flash *flash, stad_setup *setup)
{
    STAD_ASSERT(flash && setup);
    if (!flash_fits(flash))
        return STAD_E_PARAM;
    stad_setup other;
    slot_view view[2];
    look(flash, STAD_SLOT_A, &view[0], setup);
    look(flash, STAD_SLOT_B, &view[1], &other);
    int slot = newest(view);
    if (slot == STAD_SLOT_B)
        *setup = other;
    return slot >= 0 ? slot : stad_store_load_slot(flash, STAD_SLOT_FACTORY, setup);
}

/* Erases a slot, writes the record, reads it back. */
static int write_slot(const stad_flash *f, int slot, const stad_setup *setup, uint32_t sequence)
{
    uint8_t record[RECORD_ROOM];
    uint8_t back[STAD_SETUP_BYTES];
    uint32_t offset = f->slot_offset[slot];
    memset(record, 0xff, sizeof record);
    stad_setup_pack(setup, sequence, record);
    if (f->erase(f->user, offset) != 0 || f->program(f->user, offset, record, padded_bytes(f)) != 0)
        return STAD_E_CORRUPT;
    if (f->read(f->user, offset, back, STAD_SETUP_BYTES) != 0)
        return STAD_E_CORRUPT;
    return bytes_equal(record, back, STAD_SETUP_BYTES) ? slot : STAD_E_CORRUPT;
}

/* With nothing good to lose either slot will do, so a worn sector does not stop the first save. If the other slot could not
 * be read it may yet hold a good record, and a later one: it is erased once the new record stands. */
int stad_store_save(const stad_flash *flash, const stad_setup *setup)
{
    STAD_ASSERT(flash && setup);
    if (!flash_fits(flash) || stad_setup_check(setup) != STAD_OK)
        return STAD_E_PARAM;
    stad_setup found;
    slot_view view[2];
    look(flash, STAD_SLOT_A, &view[0], &found);
    look(flash, STAD_SLOT_B, &view[1], &found);
    int status = STAD_E_STATE, keep = newest(view);
    uint32_t sequence = view[max_i32(keep, 0)].sequence + 1u; /* that of a slot that is not good is 0 */
    for (int slot = STAD_SLOT_A; slot <= STAD_SLOT_B && status < 0; slot++) {
        const int other = STAD_SLOT_B - slot;
        if (keep != other && view[slot].state != SLOT_BAD)
            continue;
        status = write_slot(flash, slot, setup, sequence);
        if (status >= 0 && view[other].state == SLOT_UNREADABLE && flash->erase(flash->user, flash->slot_offset[other]) != 0)
            status = STAD_E_CORRUPT;
    }
    return status;
}

int stad_store_save_factory(const stad_flash *flash, const stad_setup *setup)
{
    stad_setup found;
    slot_view view;
    if (!flash_fits(flash) || stad_setup_check(setup) != STAD_OK)
        return STAD_E_PARAM;
    look(flash, STAD_SLOT_FACTORY, &view, &found);
    if (view.state != SLOT_BAD)
        return STAD_E_STATE;
    return write_slot(flash, STAD_SLOT_FACTORY, setup, 0);
}
