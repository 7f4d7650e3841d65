/* SPDX-License-Identifier: MIT
 * disparity rows -> [SCORE] -> cost         score/score.c - counts disparity rows against truth rows.
 *
 * Everything is an integer: a disparity becomes px * 65536 exactly (<< 12), so no comparison with a threshold is rounded. */
#include "stad/score.h"

#include <string.h>

#include "base/arith.h"

void stad_score_config_init(stad_score_config *c, int cost, int min_disparity, int num_disparities)
{
    STAD_ASSERT(cost >= 0 && cost <= STAD_SCORE_WEIGHTED);
    memset(c, 0, sizeof *c);
    c->min_disparity = narrow_i16(min_disparity);
    c->num_disparities = narrow_i16(num_disparities);
    c->threshold_q16 = 65536;
    c->cost = (uint8_t)cost;
    c->photo_limit = 16;
}

int stad_score_begin(stad_score *s, const stad_score_config *c)
{
    memset(s, 0, sizeof *s);
    if (c->num_disparities <= 0 || c->threshold_q16 < 0 || c->photo_limit == 0 || c->cost > STAD_SCORE_WEIGHTED)
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

/* So are most rows of sparse truth. */
static int all_ignored(const uint8_t *label, int width)
{
    int any = 0;
    for (int x = 0; x < width; x++)
        any |= label[x] ^ STAD_LABEL_IGNORED;
    return !any;
}

/* The size of a difference, by arithmetic that wraps: a pixel that is not scored may hold anything. */
static int32_t size_of(uint32_t difference)
{
    const uint32_t sign = 0u - (difference >> 31);
    return (int32_t)(((difference ^ sign) - sign) & INT32_MAX);
}

/* The error of a pixel; < 2^29 if it is scored: both sides are below 4096 px. */
static int32_t error_of(int16_t disp_q4, int32_t truth_q16)
{
    return size_of((uint32_t)(disp_q4 * 4096) - (uint32_t)truth_q16);
}

#define STRETCH 255 /* pixels: their counts fit 8 bits */

/* What a stretch adds: four counts of 8 bits each in `seen` and in `wrong`; sums over visible pixels that have a disparity. */
typedef struct stretch {
    uint32_t seen;  /* visible, occluded, missing visible, missing occluded, from bit 0 up */
    uint32_t wrong; /* wrong visible, wrong occluded, d1 visible, d1 occluded */
    uint64_t sum_q16, square_sum_q16;
} stretch;

/* No pixel branches, and few things are added up, so that a compiler can take several pixels at once. */
static stretch count_stretch(const stad_score_config *c, const int16_t *disp_q4, const int32_t *truth_q16, const uint8_t *label,
                             int from, int to)
{
    stretch n = {0, 0, 0, 0};
    const int32_t none_q4 = (c->min_disparity - 1) * 16, threshold_q16 = c->threshold_q16;
    for (int x = from; x < to; x++) {
        const uint32_t known = (uint32_t)-((label[x] != STAD_LABEL_IGNORED) & (truth_q16[x] != STAD_TRUTH_NONE));
        const uint32_t side = known & (label[x] == STAD_LABEL_VISIBLE ? 1u : 256u);
        const uint32_t missing = (uint32_t)-(disp_q4[x] <= none_q4);
        const uint32_t matched = side & ~missing;
        const int32_t error = error_of(disp_q4[x], truth_q16[x]);
        const int32_t twenty = 20 * min_i32(error, 1 << 24); /* above 2^28, which no truth is, from there on */
        const uint32_t wrong = (uint32_t)-(error > threshold_q16);
        const uint32_t d1 = (uint32_t)-((error > 3 * 65536) & (twenty > size_of((uint32_t)truth_q16[x])));
        const uint32_t counted = (uint32_t)error & (0u - (matched & 1u));
        const uint32_t error_q8 = (counted + 128) >> 8; /* < 2^21, its square < 2^42: 2^21 pixels at the far end of the range */
        n.seen += side + ((side & missing) << 16);
        n.wrong += (matched & wrong) + ((matched & d1) << 16);
        n.sum_q16 += counted;
        n.square_sum_q16 += (uint64_t)error_q8 * error_q8;
    }
    return n;
}

static int32_t eight_bits(uint32_t counts, int at)
{
    return (int32_t)(counts >> (8 * at) & 255u);
}

static void add_stretch(stad_score_counts *n, const stretch *more)
{
    n->visible += eight_bits(more->seen, 0);
    n->occluded += eight_bits(more->seen, 1);
    n->missing_visible += eight_bits(more->seen, 2);
    n->missing_occluded += eight_bits(more->seen, 3);
    n->wrong_visible += eight_bits(more->wrong, 0);
    n->wrong_occluded += eight_bits(more->wrong, 1);
    n->d1_visible += eight_bits(more->wrong, 2);
    n->d1_occluded += eight_bits(more->wrong, 3);
    n->abs_sum_q16 += (int64_t)more->sum_q16;
    n->square_sum_q16 += (int64_t)more->square_sum_q16;
}

void stad_score_row(stad_score *s, int y, const int16_t *disp_q4_row, const int32_t *truth_q16_row, const uint8_t *label_row,
                    int width)
{
    STAD_ASSERT(s && s->config.num_disparities > 0); /* begun */
    (void)y;
    if (all_ignored(label_row, width))
        return;
    for (int x = first_column(&s->config); x < width; x += STRETCH) {
        const stretch n = count_stretch(&s->config, disp_q4_row, truth_q16_row, label_row, x, min_i32(width, x + STRETCH));
        add_stretch(&s->counts, &n);
    }
}
