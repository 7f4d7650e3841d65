/* SPDX-License-Identifier: MIT
 * proof/prove_store.c - the store on flash that holds and answers anything, and any setup.
 * SOURCES: store/store.c store/setup.c store/crc32.c match/params.c rig/rig_fit.c rig/rig_apply.c base/affine.c base/log.c */
#include "proof/prove.h"
#include "stad/store.h"

static int read_any(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    (void)user, (void)offset;
    uint8_t *to = bytes;
    for (uint32_t i = 0; i < count && i < 128; i++)
        to[i] = (uint8_t)any(0, 255);
    return any(-1, 1);
}

static int program_any(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    (void)user, (void)offset;
    const uint8_t *from = bytes;
    return from[0] + from[count - 1] + any(-1, 1);
}

static int erase_any(void *user, uint32_t offset)
{
    (void)user, (void)offset;
    return any(-1, 1);
}

static stad_setup any_setup(void)
{
    stad_setup s;
    s.width = (int16_t)any(-32768, 32767);
    s.height = (int16_t)any(-32768, 32767);
    s.mode = (uint8_t)any(0, 255);
    s.channels = (uint8_t)any(0, 255);
    s.origin = (uint8_t)any(0, 255);
    s.corrected = (uint8_t)any(0, 255);
    s.params.min_disparity = (int16_t)any(-32768, 32767);
    s.params.num_disparities = (int16_t)any(-32768, 32767);
    s.params.block_size = (int16_t)any(-32768, 32767);
    s.params.p1 = (int16_t)any(-32768, 32767);
    s.params.p2 = (int16_t)any(-32768, 32767);
    s.params.disp12_max_diff = (int16_t)any(-32768, 32767);
    s.params.pre_filter_cap = (int16_t)any(-32768, 32767);
    s.params.uniqueness_ratio = (int16_t)any(-32768, 32767);
    s.params.speckle_window_size = any(INT32_MIN, INT32_MAX);
    s.params.speckle_range = any(INT32_MIN, INT32_MAX);
    s.rig.a_q16 = any(INT32_MIN, INT32_MAX);
    s.rig.b_q24 = any(INT32_MIN, INT32_MAX);
    s.rig.c_q24 = any(INT32_MIN, INT32_MAX);
    s.rig.width = (int16_t)any(-32768, 32767);
    s.rig.height = (int16_t)any(-32768, 32767);
    return s;
}

int main(void)
{
    uint8_t bytes[STAD_SETUP_BYTES], cut[STAD_SETUP_BYTES - 1];
    uint32_t sequence;
    stad_setup found, setup = any_setup();
    any_u8(bytes, STAD_SETUP_BYTES);
    any_u8(cut, STAD_SETUP_BYTES - 1);
    stad_setup_unpack(bytes, STAD_SETUP_BYTES, &found, &sequence);
    stad_setup_unpack(cut, (uint32_t)any(0, STAD_SETUP_BYTES - 1), &found, &sequence);
    stad_setup_pack(&setup, (uint32_t)any64(0, UINT32_MAX), bytes);
    for (int shift = 0; shift < 9; shift++) { /* every granule that is allowed, and two that are not */
        stad_flash f = {read_any,
                        any(0, 1) ? program_any : 0,
                        erase_any,
                        0,
                        {(uint32_t)any64(0, UINT32_MAX), (uint32_t)any64(0, UINT32_MAX), (uint32_t)any64(0, UINT32_MAX)},
                        (uint32_t)any64(0, UINT32_MAX),
                        shift < 8 ? 1u << shift : 3u};
        stad_store_load(&f, &found);
        stad_store_load_slot(&f, any(INT32_MIN, INT32_MAX), &found);
        stad_store_save(&f, &setup);
        stad_store_save_factory(&f, &setup);
    }
    return 0;
}
