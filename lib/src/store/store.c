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

static int flash_fits(const stad_flash *f)
{
    uint32_t granule = f->program_bytes;
    if (!f->read || !f->program || !f->erase)
        return 0;
    if (granule == 0 || granule > MAX_GRANULE || (granule & (granule - 1u)) != 0)
        return 0;
    if (f->slot_offset[0] == f->slot_offset[1] || f->slot_offset[1] == f->slot_offset[2] ||
        f->slot_offset[0] == f->slot_offset[2])
        return 0;
    return f->sector_bytes >= padded_bytes(f);
}

/* What a slot holds; a good one goes to *setup unless that is NULL. */
static slot_view look(const stad_flash *f, int slot, stad_setup *setup)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    stad_setup found;
    slot_view view = {SLOT_BAD, 0};
    if (f->read(f->user, f->slot_offset[slot], bytes, STAD_SETUP_BYTES) != 0) {
        view.state = SLOT_UNREADABLE;
        return view;
    }
    if (stad_setup_unpack(bytes, STAD_SETUP_BYTES, &found, &view.sequence) != STAD_OK)
        return view;
    view.state = SLOT_GOOD;
    if (setup)
        *setup = found;
    return view;
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
    if (!flash_fits(flash) || slot < STAD_SLOT_A || slot > STAD_SLOT_FACTORY)
        return STAD_E_PARAM;
    return look(flash, slot, setup).state == SLOT_GOOD ? slot : STAD_E_CORRUPT;
}

int stad_store_load(const stad_flash *flash, stad_setup *setup)
{
    STAD_ASSERT(flash && setup);
    if (!flash_fits(flash))
        return STAD_E_PARAM;
    slot_view view[2] = {look(flash, STAD_SLOT_A, NULL), look(flash, STAD_SLOT_B, NULL)};
    int slot = newest(view);
    if (slot >= 0 && stad_store_load_slot(flash, slot, setup) == slot)
        return slot;
    /* none, or the newest went bad between two reads: any good one that is left */
    for (slot = STAD_SLOT_A; slot <= STAD_SLOT_FACTORY; slot++)
        if (look(flash, slot, setup).state == SLOT_GOOD)
            return slot;
    return STAD_E_CORRUPT;
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

/* With nothing good to lose, either slot will do, so a worn sector does not stop the first save. */
static int write_any(const stad_flash *f, const slot_view view[2], const stad_setup *setup)
{
    int status = STAD_E_STATE;
    for (int slot = STAD_SLOT_A; slot <= STAD_SLOT_B && status < 0; slot++)
        if (view[slot].state == SLOT_BAD)
            status = write_slot(f, slot, setup, 1);
    return status;
}

int stad_store_save(const stad_flash *flash, const stad_setup *setup)
{
    STAD_ASSERT(flash && setup);
    if (!flash_fits(flash) || stad_setup_check(setup) != STAD_OK)
        return STAD_E_PARAM;
    slot_view view[2] = {look(flash, STAD_SLOT_A, NULL), look(flash, STAD_SLOT_B, NULL)};
    int keep = newest(view);
    if (keep < 0)
        return write_any(flash, view, setup);
    return write_slot(flash, 1 - keep, setup, view[keep].sequence + 1u);
}

int stad_store_save_factory(const stad_flash *flash, const stad_setup *setup)
{
    if (!flash_fits(flash) || stad_setup_check(setup) != STAD_OK)
        return STAD_E_PARAM;
    if (look(flash, STAD_SLOT_FACTORY, NULL).state != SLOT_BAD)
        return STAD_E_STATE;
    return write_slot(flash, STAD_SLOT_FACTORY, setup, 0);
}
