/* SPDX-License-Identifier: MIT
 * proof/prove_rig.c - rigs: any correction, fits of any corners within 2048 px, rows of images of up to 2048 x 2048 px (the
 * walk of positions) and 16 x 16 px (the samples).
 * SOURCES: rig/rig_fit.c rig/rig_apply.c rig/rig_row.c base/affine.c base/log.c
 * OPTIONS: -eva-min-loop-unroll 50 */
#include "proof/prove.h"
#include "stad/rig.h"

enum { PAIRS = 2, WIDTH = 16, HEIGHT = 16, CHANNELS = 3, REACH = 2048 * 256, MAX_DY = 2 };

static stad_rig any_rig(int32_t shift, int32_t slope, int width, int height)
{
    stad_rig r = {any(-shift, shift), any(-slope, slope), any(-slope, slope), (int16_t)width, (int16_t)height};
    return r;
}

static stad_corner any_corner(void)
{
    stad_corner c = {any(-REACH, REACH), any(-REACH, REACH)};
    return c;
}

static void prove_fit(void)
{
    stad_pair pairs[PAIRS];
    stad_rig r;
    stad_rig_report report;
    for (int i = 0; i < PAIRS; i++)
        for (int k = 0; k < 4; k++) {
            pairs[i].left[k] = any_corner();
            pairs[i].right[k] = any_corner();
        }
    if (stad_rig_fit(&r, &report, pairs, any(-1, PAIRS), any(-32768, 32767), any(-32768, 32767)) == STAD_E_PARAM)
        return;
    stad_rig_straighten(&r, pairs, PAIRS);
    r = any_rig(1 << 30, 1 << 22, any(16, 2048), any(16, 2048));
    stad_rig_apply(&r, any_corner());
}

static void prove_rows(void)
{
    static uint8_t out[WIDTH * CHANNELS], pix[WIDTH * HEIGHT * CHANNELS];
    int first, last;
    stad_rig r = any_rig(1 << 22, 1 << 20, any(16, 2048), any(16, 2048));
    stad_rig_rows(&r, any(0, 2047), &first, &last);
    any_u8(pix, sizeof pix);
    for (int channels = 1; channels <= CHANNELS; channels += 2) {
        stad_image image = stad_image_packed(pix, WIDTH, HEIGHT, channels);
        r = any_rig(INT32_MAX, INT32_MAX, WIDTH, HEIGHT);
        stad_rig_row(&r, &image, any(INT32_MIN, INT32_MAX), out);
        image.width = any(-100, 15);
        r.width = (int16_t)any(-32768, 32767);
        stad_rig_row(&r, &image, any(INT32_MIN, INT32_MAX), out);
    }
}

static void prove_stream(int channels)
{
    static uint8_t ring[STAD_RIG_BYTES(WIDTH, CHANNELS, MAX_DY)], row[WIDTH * CHANNELS];
    stad_rig_stream s;
    stad_rig r = any_rig(INT32_MAX, INT32_MAX, WIDTH, HEIGHT);
    any_u8(ring, sizeof ring);
    any_u8(row, sizeof row);
    if (stad_rig_begin(&s, &r, channels, MAX_DY, ring, sizeof ring) != STAD_OK)
        return;
    s.pushed = (int16_t)any(0, HEIGHT);
    s.pulled = (int16_t)any(0, HEIGHT);
    if (any(0, 1))
        stad_rig_push(&s, row);
    else
        stad_rig_pull(&s, row);
}

int main(void)
{
    prove_fit();
    prove_rows();
    for (int channels = 0; channels < 5; channels++)
        prove_stream(channels);
    return 0;
}
