/* SPDX-License-Identifier: MIT
 * support/flash_sim.h - three sectors of NOR flash that can lose power at any byte, tear, flip and stick.
 *
 * Programming only clears bits and only within granules that the last erase left blank; erasing sets a sector to 0xff. Every byte
 * that an operation touches counts; when the count reaches `cut_at` the power goes: that byte is left half done, the rest
 * as it was, and every later call fails. */
#ifndef FLASH_SIM_H
#define FLASH_SIM_H

#include <stdint.h>
#include <string.h>

#include "stad/store.h"

#define SIM_SECTOR 128

/* What an interrupted erase leaves in the sector. */
enum sim_tear { TEAR_PREFIX = 0, TEAR_BYTES = 1, TEAR_BITS = 2, TEAR_KINDS = 3 };

typedef struct flash_sim {
    uint8_t bytes[3][SIM_SECTOR];
    uint32_t granule;
    long cut_at; /* touched bytes until the power goes; negative = never */
    long touched;
    int dead; /* the power is off */
    enum sim_tear tear;
    int stuck[3]; /* 1: the sector ignores erase and program, and says it obeyed */
    int unreadable[3];
    uint32_t slips; /* bit k: the k-th read from now on fails */
    int refuses;    /* 1: program reports failure without touching anything */
    int wear[3];    /* erases */
    int violations; /* programs onto unblank bytes, or off the granule, or outside */
    uint32_t random;
} flash_sim;

static inline uint32_t sim_random(flash_sim *s)
{
    s->random ^= s->random << 13;
    s->random ^= s->random >> 17;
    s->random ^= s->random << 5;
    return s->random;
}

static inline int sim_power_goes(flash_sim *s)
{
    if (s->cut_at >= 0 && s->touched >= s->cut_at)
        s->dead = 1;
    s->touched++;
    return s->dead;
}

static inline int sim_read(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    flash_sim *s = (flash_sim *)user;
    uint32_t sector = offset / SIM_SECTOR, slips = s->slips & 1u;
    s->slips >>= 1;
    if (slips || s->dead || sector > 2 || offset % SIM_SECTOR + count > SIM_SECTOR || s->unreadable[sector])
        return -1;
    memcpy(bytes, s->bytes[sector] + offset % SIM_SECTOR, count);
    return 0;
}

static inline int sim_program(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    flash_sim *s = (flash_sim *)user;
    uint32_t sector = offset / SIM_SECTOR, at = offset % SIM_SECTOR;
    const uint8_t *in = (const uint8_t *)bytes;
    if (s->dead || s->refuses)
        return -1;
    if (sector > 2 || at + count > SIM_SECTOR || at % s->granule || count % s->granule) {
        s->violations++;
        return -1;
    }
    for (uint32_t i = 0; i < count; i++) {
        uint8_t *cell = &s->bytes[sector][at + i];
        if (*cell != 0xff && !s->stuck[sector])
            s->violations++;
        uint8_t cleared = (uint8_t)~in[i];
        if (sim_power_goes(s))
            cleared = (uint8_t)(cleared & sim_random(s));
        if (!s->stuck[sector])
            *cell = (uint8_t)(*cell & ~cleared);
        if (s->dead)
            return -1;
    }
    return 0;
}

/* The cells that an interrupted erase had not come to, by the kind of tear. */
static inline void sim_tear_erase(flash_sim *s, uint8_t *sector, uint32_t done)
{
    for (uint32_t i = 0; i < SIM_SECTOR; i++) {
        uint32_t dice = sim_random(s);
        if (s->tear == TEAR_PREFIX)
            sector[i] = i < done ? 0xff : (uint8_t)(sector[i] | (i == done ? dice & 0xff : 0));
        else if (s->tear == TEAR_BYTES)
            sector[i] = dice % SIM_SECTOR < done ? 0xff : sector[i];
        else
            sector[i] = (uint8_t)(sector[i] | (dice % SIM_SECTOR < done ? dice >> 8 & 0xff : 0));
    }
}

static inline int sim_erase(void *user, uint32_t offset)
{
    flash_sim *s = (flash_sim *)user;
    uint32_t sector = offset / SIM_SECTOR;
    if (s->dead || sector > 2 || offset % SIM_SECTOR) {
        s->violations += !s->dead;
        return -1;
    }
    s->wear[sector]++;
    for (uint32_t i = 0; i < SIM_SECTOR; i++)
        if (sim_power_goes(s)) {
            if (!s->stuck[sector])
                sim_tear_erase(s, s->bytes[sector], i);
            return -1;
        }
    if (!s->stuck[sector])
        memset(s->bytes[sector], 0xff, SIM_SECTOR);
    return 0;
}

/* A blank flash with that program granule. */
static inline void sim_init(flash_sim *s, uint32_t granule, uint32_t seed)
{
    memset(s, 0, sizeof *s);
    memset(s->bytes, 0xff, sizeof s->bytes);
    s->granule = granule;
    s->cut_at = -1;
    s->random = seed ? seed : 1;
}

static inline stad_flash sim_flash(flash_sim *s)
{
    stad_flash f = {sim_read, sim_program, sim_erase, s, {0, SIM_SECTOR, 2 * SIM_SECTOR}, SIM_SECTOR, s->granule};
    return f;
}

/* Power back on. */
static inline void sim_restart(flash_sim *s)
{
    s->dead = 0;
    s->cut_at = -1;
    s->touched = 0;
    s->slips = 0;
}

#endif
