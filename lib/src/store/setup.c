/* SPDX-License-Identifier: MIT
 * setup -> [PACK] -> slot        store/setup.c - a setup as bytes, the same on every machine
 *
 * A cursor walks the record; writing and reading name the fields in the same order, and a test pins the bytes. */
#include "stad/store.h"
#include "store/crc32.h"

#include <string.h>
#include "base/arith.h"

#define MAGIC   0x44415453u /* "STAD" when the bytes are read in order */
#define VERSION 1u

typedef struct writer {
    uint8_t *at;
} writer;

typedef struct reader {
    const uint8_t *at;
} reader;

static void put(writer *w, uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        *w->at++ = (uint8_t)(value & 0xffu);
        value >>= 8;
    }
}

static void put_i16(writer *w, int16_t value)
{
    put(w, (uint32_t)value, 2);
}

static void put_i32(writer *w, int32_t value)
{
    put(w, (uint32_t)value, 4);
}

static uint32_t get(reader *r, int bytes)
{
    uint32_t value = 0;
    for (int i = 0; i < bytes; i++)
        value |= (uint32_t)*r->at++ << (8 * i);
    return value;
}

/* Two's complement without a narrowing cast that C leaves to the implementation. */
static int16_t get_i16(reader *r)
{
    int32_t value = (int32_t)get(r, 2);
    return (int16_t)(value >= 32768 ? value - 65536 : value);
}

static int32_t get_i32(reader *r)
{
    uint32_t value = get(r, 4);
    return value <= INT32_MAX ? (int32_t)value : -(int32_t)(UINT32_MAX - value) - 1;
}

static void put_params(writer *w, const stad_params *p)
{
    put_i16(w, p->min_disparity);
    put_i16(w, p->num_disparities);
    put_i16(w, p->block_size);
    put_i16(w, p->p1);
    put_i16(w, p->p2);
    put_i16(w, p->disp12_max_diff);
    put_i16(w, p->pre_filter_cap);
    put_i16(w, p->uniqueness_ratio);
    put_i32(w, p->speckle_window_size);
    put_i32(w, p->speckle_range);
}

static void get_params(reader *r, stad_params *p)
{
    p->min_disparity = get_i16(r);
    p->num_disparities = get_i16(r);
    p->block_size = get_i16(r);
    p->p1 = get_i16(r);
    p->p2 = get_i16(r);
    p->disp12_max_diff = get_i16(r);
    p->pre_filter_cap = get_i16(r);
    p->uniqueness_ratio = get_i16(r);
    p->speckle_window_size = get_i32(r);
    p->speckle_range = get_i32(r);
}

static void put_rig(writer *w, const stad_rig *r)
{
    put_i32(w, r->a_q16);
    put_i32(w, r->b_q24);
    put_i32(w, r->c_q24);
}

static void get_rig(reader *r, stad_setup *setup)
{
    stad_rig_identity(&setup->rig, setup->width, setup->height);
    setup->rig.a_q16 = get_i32(r);
    setup->rig.b_q24 = get_i32(r);
    setup->rig.c_q24 = get_i32(r);
}

/* No correction that stad_rig_fit() advises comes near these: 16 px, and 1/16 px per px; and none is 0. */
static int rig_fits(const stad_setup *s)
{
    const int32_t most = s->corrected ? 1 << 20 : 0; /* in Q16 px and in Q24 */
    const stad_rig *r = &s->rig;
    return r->width == s->width && r->height == s->height && r->a_q16 >= -most && r->a_q16 <= most && r->b_q24 >= -most &&
           r->b_q24 <= most && r->c_q24 >= -most && r->c_q24 <= most;
}

int stad_setup_check(const stad_setup *setup)
{
    if (setup->width <= 0 || setup->height <= 0 || !rig_fits(setup))
        return STAD_E_PARAM;
    if (setup->channels != 1 && setup->channels != 3)
        return STAD_E_PARAM;
    if (setup->corrected > 1 || setup->origin > STAD_ORIGIN_TUNED)
        return STAD_E_PARAM;
    return stad_params_check(&setup->params, setup->mode, setup->width, NULL);
}

void stad_setup_pack(const stad_setup *setup, uint32_t sequence, uint8_t *out)
{
    STAD_ASSERT(setup && out);
    writer w = {out};
    put(&w, MAGIC, 4);
    put(&w, VERSION, 2);
    put(&w, STAD_SETUP_BYTES, 2);
    put(&w, sequence, 4);
    put_i16(&w, setup->width);
    put_i16(&w, setup->height);
    *w.at++ = setup->mode;
    *w.at++ = setup->channels;
    *w.at++ = setup->origin;
    *w.at++ = setup->corrected;
    put_params(&w, &setup->params);
    put_rig(&w, &setup->rig);
    put(&w, stad_crc32(out, STAD_SETUP_BYTES - 4), 4);
}

static int header_fits(reader *r)
{
    return get(r, 4) == MAGIC && get(r, 2) == VERSION && get(r, 2) == STAD_SETUP_BYTES;
}

int stad_setup_unpack(const uint8_t *bytes, size_t n, stad_setup *setup, uint32_t *sequence)
{
    reader r = {bytes};
    if (n < STAD_SETUP_BYTES || !header_fits(&r))
        return STAD_E_CORRUPT;
    reader tail = {bytes + STAD_SETUP_BYTES - 4};
    if (get(&tail, 4) != stad_crc32(bytes, STAD_SETUP_BYTES - 4))
        return STAD_E_CORRUPT;
    stad_setup found;
    memset(&found, 0, sizeof found);
    uint32_t number = get(&r, 4);
    found.width = get_i16(&r);
    found.height = get_i16(&r);
    found.mode = *r.at++;
    found.channels = *r.at++;
    found.origin = *r.at++;
    found.corrected = *r.at++;
    get_params(&r, &found.params);
    get_rig(&r, &found);
    if (stad_setup_check(&found) != STAD_OK)
        return STAD_E_CORRUPT;
    *setup = found;
    *sequence = number;
    return STAD_OK;
}
