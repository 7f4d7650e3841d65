/* SPDX-License-Identifier: MIT
 * truth rows -> [LABEL] -> score         score/score_label.c - what the right camera cannot see, from dense truth.
 *
 * Two sweeps over a row: every left pixel leaves its disparity on the two right columns it lands between, the largest
 * winning; then a pixel is occluded where something more than 1 px nearer has landed on its own column. */
#include "stad/score.h"

static int32_t floor_q16(int32_t v)
{
    return v / 65536 - (v % 65536 < 0);
}

static void land(int32_t *nearest, int width, int column, int32_t truth)
{
    if (column >= 0 && column < width && nearest[column] < truth)
        nearest[column] = truth;
}

void stad_score_label_row(const int32_t *truth_q16_row, int width, uint8_t *label_row, int32_t *work)
{
    for (int x = 0; x < width; x++)
        work[x] = STAD_TRUTH_NONE;
    for (int x = 0; x < width; x++) {
        const int32_t truth = truth_q16_row[x];
        if (truth == STAD_TRUTH_NONE)
            continue;
        const int shift = floor_q16(truth); /* x - d lies in [x - shift - 1, x - shift] */
        land(work, width, x - shift, truth);
        if (truth != shift * 65536)
            land(work, width, x - shift - 1, truth);
    }
    for (int x = 0; x < width; x++) {
        const int32_t truth = truth_q16_row[x];
        label_row[x] = STAD_LABEL_IGNORED;
        if (truth == STAD_TRUTH_NONE)
            continue;
        const int column = x - floor_q16(truth + 32768); /* x - d rounded */
        const int hidden = column < 0 || column >= width || work[column] > truth + 65536;
        label_row[x] = hidden ? STAD_LABEL_OCCLUDED : STAD_LABEL_VISIBLE;
    }
}
