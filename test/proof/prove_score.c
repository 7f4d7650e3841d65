/* SPDX-License-Identifier: MIT
 * proof/prove_score.c - scores: any config, rows of any disparity, label and grey, truth within 4096 px; then any cost from any
 * counts of 0, 1, 1000, 2^22 and 2^30 pixels.
 * SOURCES: score/score.c score/score_blind.c score/score_cost.c score/score_label.c base/log.c base/divide.c */
#include "proof/prove.h"
#include "stad/score.h"

enum { WIDTH = 12 };

static int16_t disp[WIDTH];
static int32_t truth[WIDTH], work[WIDTH];
static uint8_t label[WIDTH], left[WIDTH], right[WIDTH];

static void any_rows(void)
{
    any_i16(disp, WIDTH, -32768, 32767);
    any_u8(label, WIDTH);
    any_u8(left, WIDTH);
    any_u8(right, WIDTH);
    for (int i = 0; i < WIDTH; i++)
        truth[i] = any(0, 1) ? STAD_TRUTH_NONE : any(-(1 << 28) + 1, (1 << 28) - 1);
}

static stad_score_config any_config(void)
{
    stad_score_config c;
    c.min_disparity = (int16_t)any(-32768, 32767);
    c.num_disparities = (int16_t)any(-32768, 32767);
    c.threshold_q16 = any(INT32_MIN, INT32_MAX);
    c.cost = (uint8_t)any(0, 255);
    c.photo_limit = (uint8_t)any(0, 255);
    any_i16(c.weight_q8, STAD_SCORE_TERMS, -32768, 32767);
    return c;
}

static void any_counts(stad_score *s, int32_t most)
{
    const long long squares = most < 1 << 20 ? (long long)most << 42 : 1ll << 62;
    stad_score_counts n = {most,
                           most,
                           any(0, most),
                           any(0, most),
                           any(0, 1) * most,
                           any(0, 1) * most,
                           any(0, most),
                           any(0, most),
                           any64(0, squares),
                           any64(0, (long long)most << 29),
                           most,
                           any(0, 1) * most,
                           any(0, most),
                           any(0, most),
                           any64(0, (long long)most * 80 * 255)};
    s->counts = n;
    for (int i = 0; i < 32; i++)
        s->histogram[i] = any(0, most);
}

int main(void)
{
    static stad_score s;
    const int32_t pixels[5] = {0, 1, 1000, 1 << 22, 1 << 30};
    stad_score_config c = any_config();
    any_rows();
    stad_score_label_row(truth, any(0, WIDTH), label, work);
    if (stad_score_begin(&s, &c) != STAD_OK)
        return 0;
    any_counts(&s, 1 << 30);
    stad_score_row(&s, any(0, 2047), disp, truth, label, any(0, WIDTH));
    stad_score_row_blind(&s, any(0, 2047), disp, left, right, any(0, WIDTH));
    stad_score_frame_blind(&s, any(0, 1 << 22), any(0, 1 << 22));
    for (int i = 0; i < 5; i++) {
        any_counts(&s, pixels[i]);
        stad_score_end(&s);
        stad_score_cost_of(&s, any(INT32_MIN, INT32_MAX));
        stad_score_rmse_q16(&s);
        stad_score_mae_q16(&s);
    }
    return 0;
}
