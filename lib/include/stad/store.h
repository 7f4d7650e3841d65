/* SPDX-License-Identifier: MIT
 * stad/store.h - parameters and rig correction in flash, so that no power cut and no flipped bit brings back garbage.
 *
 * Two slots of one sector each are written in turn, and a third, the factory slot, once. A record is
 *
 *     0 magic "STAD"   4 version u16   6 bytes u16   8 sequence u32   12 fields ...   last 4: CRC-32 of all before
 *
 * little-endian whatever the machine; docs/STORE.md lists the fields. The newest good record wins; a slot that holds the only good
 * record is never erased, and a record is read back before the save is called done. Cut anywhere, a load finds the
 * old set or the new one; a save that says done is what loads.
 *
 * Flash is reached through three functions of the caller's; nothing is kept between calls, nothing allocated. Not for two
 * tasks at once on the same slots. */
#ifndef STAD_STORE_H
#define STAD_STORE_H

#include <stddef.h>
#include <stdint.h>

#include "stad/params.h"
#include "stad/rig.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where a setup came from; kept beside it for the log of whoever reads it. */
enum stad_origin { STAD_ORIGIN_FACTORY = 0, STAD_ORIGIN_PRESET = 1, STAD_ORIGIN_TUNED = 2 };

/* What a board needs to match as it did before the reset. */
typedef struct stad_setup {
    int16_t width, height; /* px of the frames it was made for */
    uint8_t mode;          /* enum stad_mode */
    uint8_t channels;      /* 1 or 3 */
    uint8_t origin;        /* enum stad_origin */
    uint8_t corrected;     /* 1: `rig` is to be applied to the right view; 0: `rig` is the identity */
    stad_params params;    /* to match with */
    stad_rig rig;          /* for frames of width x height; the identity unless `corrected` */
} stad_setup;

#define STAD_SETUP_BYTES 60 /* of a packed record; a sector must hold it, rounded up to the program granule */

/* Packs a setup into out[STAD_SETUP_BYTES]. */
void stad_setup_pack(const stad_setup *setup, uint32_t sequence, uint8_t *out);

/* The reverse, from n bytes that nobody vouches for. STAD_E_CORRUPT: too short, wrong magic, length or CRC, an
 * unknown version, or a field outside its domain; `setup` and `sequence` are then untouched. */
int stad_setup_unpack(const uint8_t *bytes, size_t n, stad_setup *setup, uint32_t *sequence);

/* STAD_OK, or STAD_E_PARAM when a field is outside its domain: what pack refuses to check and save and unpack do. */
int stad_setup_check(const stad_setup *setup);

/* Sectors of the store. */
enum stad_slot { STAD_SLOT_A = 0, STAD_SLOT_B = 1, STAD_SLOT_FACTORY = 2 };

/* The caller's flash. Offsets are his own; each slot is one sector. A function returns 0, or anything else for a
 * failure. A slot whose reading fails or brings no good record is read once more; if that fails, the slot is unreadable. */
typedef struct stad_flash {
    int (*read)(void *user, uint32_t offset, void *bytes, uint32_t count);          /* any offset and count within a slot */
    int (*program)(void *user, uint32_t offset, const void *bytes, uint32_t count); /* count: a multiple of the granule */
    int (*erase)(void *user, uint32_t offset);                                      /* the sector at offset, to 0xff */
    void *user;                                                                     /* handed to the three */
    uint32_t slot_offset[3]; /* by enum stad_slot; at least sector_bytes apart */
    uint32_t sector_bytes;   /* smallest of the three sectors */
    uint32_t program_bytes;  /* program granule: a power of two, 1..64 */
} stad_flash;

/* Reads the newest good setup, else the factory's. Returns the slot (enum stad_slot) it came from; STAD_E_CORRUPT: no
 * slot holds a good one, `setup` is untouched; STAD_E_PARAM: the flash is described wrongly. */
int stad_store_load(const stad_flash *flash, stad_setup *setup);

/* Reads one slot only. */
int stad_store_load_slot(const stad_flash *flash, int slot, stad_setup *setup);

/* Writes a setup to the slot that is not the newest good one. Returns that slot when it reads back as written. An unreadable
 * slot is erased: to be written when the other one is good (torn flash with error correction reads so, and a load would not have
 * found it either), else after the new record stands, so that what it may hold cannot come back as the newer.
 * STAD_E_PARAM: the setup or the flash is outside its domain; STAD_E_CORRUPT: the flash would not take it (a load
 * still finds what it found before, or, if only the reading back or the last erasing failed, the new one); STAD_E_STATE: nothing
 * was erased, for both slots are unreadable; if that lasts, erase one yourself.
 * Worst case: six reads, two erases, two programs. */
int stad_store_save(const stad_flash *flash, const stad_setup *setup);

/* Writes the factory slot, once: STAD_E_STATE when it holds a good setup already or is unreadable; else as stad_store_save(). */
int stad_store_save_factory(const stad_flash *flash, const stad_setup *setup);

#ifdef __cplusplus
}
#endif

#endif
