/* SPDX-License-Identifier: MIT
 * disparity rows -> [SCORE BLIND] -> cost         score/score_blind.c - what can be said of a map without truth.
 *
 * Follows `bad` well, but tuned on alone it leads astray (docs/TUNING.md): use it beside truth, with a small weight. */
#include "stad/score.h"
#include "base/arith.h"

/* 5 * grey less the sum of the 5 px around x, so grey levels * 5, at columns held inside the row. */
static int32_t zero_mean_x5(const uint8_t *row, int x, int width)
{
    int32_t sum = 0;
    for (int i = -2; i <= 2; i++) {
        const int c = x + i;
        sum += row[c < 0 ? 0 : c >= width ? width - 1 : c];
    }
    const int c = x < 0 ? 0 : x >= width ? width - 1 : x;
    return 5 * row[c] - sum;
}

/* Grey levels * 80: at most 2 * 80 * 255, whatever the disparity. */
static int32_t photo_error(const uint8_t *left, const uint8_t *right, int x, int width, int disp_q4)
{
    const int column_q4 = x * 16 - disp_q4;
    const int column = column_q4 >= 0 ? column_q4 / 16 : -((15 - column_q4) / 16);
    const int part = column_q4 - column * 16; /* 0..15 */
    const int32_t a = zero_mean_x5(right, column, width);
    const int32_t b = zero_mean_x5(right, column + 1, width);
    const int32_t e = 16 * zero_mean_x5(left, x, width) - ((16 - part) * a + part * b);
    return e < 0 ? -e : e;
}

void stad_score_row_blind(stad_score *s, int y, const int16_t *disp_q4_row, const uint8_t *left_row, const uint8_t *right_row,
                          int width)
{
    STAD_ASSERT(s && s->config.num_disparities > 0 && s->config.photo_limit > 0); /* begun */
    const int min_q4 = s->config.min_disparity * 16;
    const int range_q4 = s->config.num_disparities * 16;
    const int32_t limit = 80 * s->config.photo_limit;
    const int from = min_q4 + range_q4 > 0 ? (min_q4 + range_q4) / 16 : 0;
    (void)y;
    for (int x = from; x < width; x++) {
        const int disp_q4 = disp_q4_row[x];
        s->counts.considered++;
        if (disp_q4 <= min_q4 - 16) {
            s->counts.photo_sum += limit / 2;
            continue;
        }
        const int32_t e = photo_error(left_row, right_row, x, width, disp_q4);
        const int bin = (disp_q4 - min_q4) * 32 / range_q4; /* subpixel steps can leave the range by half a pixel */
        s->counts.matched++;
        s->counts.photo_sum += e < limit ? e : limit;
        s->histogram[bin < 0 ? 0 : bin > 31 ? 31 : bin]++;
    }
}

void stad_score_frame_blind(stad_score *s, int32_t speckle, int32_t inconsistent)
{
    s->counts.speckle += speckle;
    s->counts.inconsistent += inconsistent;
}
