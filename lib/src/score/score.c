/* SPDX-License-Identifier: MIT
 * disparity rows -> [SCORE] -> cost         score/score.c - counts disparity rows against truth rows.
 *
 * Everything is an integer: a disparity becomes px * 65536 exactly (<< 12), so no comparison with a threshold is rounded. */
#include "stad/score.h"

#include <string.h>

void stad_score_config_init(stad_score_config *c, int cost, int min_disparity, int num_disparities)
{
    memset(c, 0, sizeof *c);
    c->min_disparity = (int16_t)min_disparity;
    c->num_disparities = (int16_t)num_disparities;
    c->threshold_q16 = 65536;
    c->cost = (uint8_t)cost;
    c->photo_limit = 16;
}

int stad_score_begin(stad_score *s, const stad_score_config *c)
{
    memset(s, 0, sizeof *s);
    if (c->num_disparities <= 0 || c->threshold_q16 < 0 || c->photo_limit == 0 ||
        c->cost > STAD_SCORE_WEIGHTED)
        return STAD_E_PARAM;
    for (int i = 0; i < STAD_SCORE_TERMS; i++) {
        if (c->weight_q8[i] < 0)
            return STAD_E_PARAM;
    }
    s->config = *c;
    return STAD_OK;
}

/* First scored column. */
static int first_column(const stad_score_config *c)
{
    const int x = c->min_disparity + c->num_disparities;
    return x > 0 ? x : 0;
}

static void count_error(stad_score_counts *n, int32_t threshold_q16, int visible, int32_t disp_q16, int32_t truth_q16)
{
    const int64_t signed_error = (int64_t)disp_q16 - truth_q16;
    const int64_t error =
        signed_error < 0 ? -signed_error : signed_error; /* < 2^29: both sides are below 4096 px */
    const int64_t size = truth_q16 < 0 ? -(int64_t)truth_q16 : truth_q16;
    const int wrong = error > threshold_q16;
    const int d1 = error > 3 * 65536 && error * 20 > size;
    if (!visible) {
        n->wrong_occluded += wrong;
        n->d1_occluded += d1;
        return;
    }
    const int64_t error_q8 =
        (error + 128) >> 8; /* < 2^21, its square < 2^42: 2^21 pixels at the far end of the range */
    n->wrong_visible += wrong;
    n->d1_visible += d1;
    n->abs_sum_q16 += error;
    n->square_sum_q16 += error_q8 * error_q8;
}

void stad_score_row(stad_score *s, int y, const int16_t *disp_q4_row, const int32_t *truth_q16_row,
                    const uint8_t *label_row, int width)
{
    const int none_q4 = (s->config.min_disparity - 1) * 16;
    stad_score_counts n = s->counts; /* counted apart from s, which any store might alias */
    (void)y;
    for (int x = first_column(&s->config); x < width; x++) {
        if (label_row[x] == STAD_LABEL_IGNORED || truth_q16_row[x] == STAD_TRUTH_NONE)
            continue;
        const int visible = label_row[x] == STAD_LABEL_VISIBLE;
        const int missing = disp_q4_row[x] <= none_q4;
        n.visible += visible;
        n.occluded += !visible;
        n.missing_visible += missing & visible;
        n.missing_occluded += missing & !visible;
        if (!missing)
            count_error(&n, s->config.threshold_q16, visible, disp_q4_row[x] * 4096, truth_q16_row[x]);
    }
    s->counts = n;
}
