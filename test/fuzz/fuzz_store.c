/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_store.c - any bytes in flash, any granule, any faults, any order of calls: what is loaded is always a setup of
 * the domain, what was saved is loaded again, and a record that unpacks packs to the same bytes.
 * SEES: fault */
#include <string.h>

#include "support/flash_sim.h"
#include "fuzz/fuzz.h"
#include "stad/store.h"
#include "store/crc32.h"

static void seal(uint8_t *record)
{
    uint32_t crc = stad_crc32(record, STAD_SETUP_BYTES - 4);
    for (int i = 0; i < 4; i++) {
        record[STAD_SETUP_BYTES - 4 + i] = (uint8_t)(crc >> 8 * i);
    }
}

/* A setup near the domain; the fuzzer leaves it where it likes. */
static stad_setup some_setup(bytes *b)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = (int16_t)(320 + (next(b) > 250 ? next_i16(b) % 400 : 0));
    s.height = number(b, 200);
    s.mode = (uint8_t)(next(b) % 5);
    s.channels = (uint8_t)(next(b) % 4 ? 1 : next(b));
    s.origin = (uint8_t)(next(b) % 4);
    s.corrected = (uint8_t)(next(b) % 3);
    stad_params_sample(&s.params, 16 * (1 + next(b) % 4), 1 + next(b) % 8, 1);
    s.params.p1 = number(b, 60);
    s.params.p2 = number(b, 200);
    stad_rig_identity(&s.rig, s.width, s.height);
    if (s.corrected) {
        s.rig.a_q16 = next_i32(b) >> (next(b) % 16);
        s.rig.b_q24 = next_i32(b) >> (next(b) % 16);
        s.rig.c_q24 = next_i32(b) >> (next(b) % 16);
    }
    return s;
}

static void unpack_anything(bytes *b)
{
    uint8_t record[STAD_SETUP_BYTES + 4], again[STAD_SETUP_BYTES], packed[STAD_SETUP_BYTES];
    size_t n = (size_t)next(b) % sizeof record;
    uint32_t sequence = 77;
    stad_setup found, before;
    stad_setup valid = some_setup(b);
    uint32_t before_sequence = (uint32_t)next_i32(b);
    stad_setup_pack(&valid, before_sequence, record);
    for (int i = next(b) % 8; i > 0; i--) {
        record[next(b) % STAD_SETUP_BYTES] = (uint8_t)next(b);
    }
    stad_setup_pack(&valid, before_sequence, packed);
    int forged = next(b) % 2;
    if (forged) {
        seal(record);
    }
    uint8_t *exact = malloc(n ? n : 1); /* so that a read past n is seen */
    expect(exact);
    memcpy(exact, record, n);
    memset(&found, 0x5a, sizeof found);
    before = found;
    int status = stad_setup_unpack(exact, n, &found, &sequence);
    if (status == STAD_OK) {
        expect(stad_setup_check(&found) == STAD_OK);
        stad_setup_pack(&found, sequence, again);
        expect(memcmp(again, exact, sizeof again) == 0);
        expect(forged || memcmp(packed, exact, sizeof packed) == 0);
    } else {
        expect(status == STAD_E_CORRUPT && sequence == 77 && memcmp(&found, &before, sizeof found) == 0);
    }
    free(exact);
}

static int same(const stad_setup *a, const stad_setup *b)
{
    uint8_t x[STAD_SETUP_BYTES], y[STAD_SETUP_BYTES];
    stad_setup_pack(a, 0, x);
    stad_setup_pack(b, 0, y);
    return memcmp(x, y, sizeof x) == 0;
}

static void save(flash_sim *s, const stad_flash *f, bytes *b)
{
    stad_setup setup = some_setup(b), before, after;
    int had = stad_store_load(f, &before);
    int status = next(b) % 8 ? stad_store_save(f, &setup) : stad_store_save_factory(f, &setup);
    expect(status < 3 && status >= STAD_E_CORRUPT);
    expect(status == STAD_E_PARAM || stad_setup_check(&setup) == STAD_OK);
    int has = stad_store_load(f, &after);
    expect(s->dead || s->unreadable[0] || s->unreadable[1] || status < 0 || status == STAD_SLOT_FACTORY ||
           (has == status && same(&after, &setup)));
    sim_restart(s);
    memset(s->unreadable, 0, sizeof s->unreadable);
    has = stad_store_load(f, &after); /* the power is back: the old or the new */
    expect(had < 0 || (has >= 0 && (same(&after, &before) || same(&after, &setup))));
}

static void operate(flash_sim *s, const stad_flash *f, bytes *b)
{
    stad_setup found;
    int op = next(b) % 16, slot = next(b);
    if (op < 6) {
        s->cut_at = slot % 4 ? -1 : next(b) * 2;
        s->tear = (enum sim_tear)(slot % TEAR_KINDS);
        save(s, f, b);
    } else if (op < 9) {
        fill(s->bytes[slot % 3], SIM_SECTOR, b, (size_t)op);
    } else if (op < 10) {
        s->bytes[slot % 3][next(b) % SIM_SECTOR] ^= (uint8_t)next(b);
    } else if (op < 11) {
        s->stuck[slot % 3] = next(b) % 2;
    } else if (op < 12) {
        s->refuses = next(b) % 2;
    } else if (op < 13) {
        stad_setup setup = some_setup(b); /* a sealed record that no save wrote */
        stad_setup_pack(&setup, (uint32_t)next_i32(b), s->bytes[slot % 3]);
    } else if (op < 14) {
        unpack_anything(b);
    } else {
        int status = op < 15 ? stad_store_load(f, &found) : stad_store_load_slot(f, slot % 5 - 1, &found);
        expect(status < 0 || stad_setup_check(&found) == STAD_OK);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    flash_sim s;
    bytes b = {data, size};
    sim_init(&s, 1u << next(&b) % 7, (uint32_t)next(&b) + 1);
    stad_flash f = sim_flash(&s);
    if (next(&b) == 0) {
        f.program_bytes = (uint32_t)next_i32(&b);
        f.sector_bytes = (uint32_t)next(&b);
        stad_setup found;
        int status = stad_store_load(&f, &found);
        expect(status == STAD_E_PARAM || status == STAD_E_CORRUPT);
        return 0;
    }
    for (int i = 0; i < 60 && b.left; i++) {
        operate(&s, &f, &b);
    }
    return 0;
}
