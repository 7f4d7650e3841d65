/* SPDX-License-Identifier: MIT
 * examples/01_one_pair.c - a pair of frames in, disparity out, all memory static.
 *
 * The frames are random dots with a square that stands 9 px nearer; what is found is printed as a picture of digits. */
#include <stad/stad.h>
#include <stdio.h>

enum { W = 160, H = 48, D = 16, BLOCK = 5, P2 = 32 * BLOCK * BLOCK, CAP = 63 };

static uint8_t left[H][W], right[H][W];
static int16_t disp[H][W]; /* px * 16 */
static uint8_t work[STAD_MATCH_BYTES(W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST)] STAD_ALIGNED;

static void make_frames(void)
{
    uint32_t dice = 1;
    for (int y = 0; y < H; y++) {
        for (int x = 0; x < W; x++) {
            dice = dice * 1664525u + 1013904223u;
            left[y][x] = (uint8_t)(dice >> 24);
        }
        for (int x = 0; x < W; x++) {
            int in_square = y >= 12 && y < 36 && x >= 60 && x < 100;
            int from = x + (in_square ? 9 : 2); /* the disparity seen at x of the right frame */
            right[y][x] = left[y][from < W ? from : W - 1];
        }
    }
}

int main(void)
{
    static stad_match matcher;
    const stad_geometry geometry = {W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    stad_params params;
    make_frames();
    stad_params_sample(&params, D, BLOCK, 1);

    int status = stad_match_init(&matcher, &geometry, work, sizeof work);
    if (status == STAD_OK) {
        const stad_image l = stad_image_packed(&left[0][0], W, H, 1), r = stad_image_packed(&right[0][0], W, H, 1);
        status = stad_match_frame(&matcher, &params, &l, &r, &disp[0][0], W, NULL, 0);
    }
    if (status != STAD_OK) {
        const char *culprit = stad_match_culprit(&matcher);
        fprintf(stderr, "%s %s\n", stad_status_name(status), culprit ? culprit : "");
        return 1;
    }

    for (int y = 0; y < H; y += 4) {
        for (int x = D; x < W; x += 2)
            putchar(disp[y][x] < 0 ? '.' : '0' + (disp[y][x] + 8) / 16 % 10);
        putchar('\n');
    }
    return disp[H / 2][85] == 9 * 16 && disp[4][85] == 2 * 16 ? 0 : 1;
}
