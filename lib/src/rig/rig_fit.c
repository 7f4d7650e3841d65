/* SPDX-License-Identifier: MIT
 * pairs -> [rig/rig_fit.c] -> verdict, correction - fits shift, turn and scale to the dy of marks. */
#include "stad/rig.h"

#include "base/affine.h"
#include "base/arith.h"
#include "base/log.h"

enum { GOOD_Q8 = 64, WATCH_Q8 = 128, CORRECT_Q8 = 2048, RESIDUAL_Q8 = 77, MIN_CORNERS = 8 };

void stad_rig_identity(stad_rig *r, int width, int height)
{
    r->a_q16 = r->b_q24 = r->c_q24 = 0;
    r->width = (int16_t)width;
    r->height = (int16_t)height;
}

/* dy of the model, Q16 px, at a corrected position given from the centre in px Q4. |b|, |c| < 2^24, position < 2^15. */
static int64_t model_dy_q16(const stad_rig *r, int32_t x_q4, int32_t y_q4)
{
    return r->a_q16 + ((int64_t)r->b_q24 * x_q4 + (int64_t)r->c_q24 * y_q4) / 4096;
}

/* From an image's centre, Q4. */
static int32_t from_centre_q4(int32_t v_q8, int16_t size)
{
    return (v_q8 - size / 2 * 256) / 16;
}

/* One round: positions are those that the correction found so far gives. */
static int fit_once(stad_rig *r, const stad_pair *pairs, int n)
{
    stad_affine_sums sums = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    stad_affine fit;
    for (int i = 0; i < n; i++) {
        stad_pair straight = pairs[i];
        stad_rig_straighten(r, &straight, 1);
        for (int k = 0; k < 4; k++)
            stad_affine_add(&sums, from_centre_q4(straight.right[k].x_q8, r->width),
                            from_centre_q4(pairs[i].left[k].y_q8, r->height),
                            clamp_i32(pairs[i].right[k].y_q8 - pairs[i].left[k].y_q8, -(1 << 20), 1 << 20));
    }
    /* v is in Q8 and x in Q4, so a slope of v over x in Q20 is one of px over px in Q24, and a in Q8 of v is Q16. */
    if (!stad_affine_solve(&sums, &fit))
        return 0;
    r->a_q16 = fit.a_q8;
    r->b_q24 = clamp_i32(fit.b_q20, -(1 << 22), 1 << 22);
    r->c_q24 = clamp_i32(fit.c_q20, -(1 << 22), 1 << 22);
    return 1;
}

/* Worst |dy| over the corners of the image, Q8 px. */
static int32_t worst_q8(const stad_rig *r)
{
    int64_t worst = 0;
    for (int k = 0; k < 4; k++) {
        const int32_t x = k % 2 ? r->width - 1 - r->width / 2 : -(r->width / 2);
        const int32_t y = k / 2 ? r->height - 1 - r->height / 2 : -(r->height / 2);
        const int64_t dy = model_dy_q16(r, x * 16, y * 16);
        worst = dy > worst ? dy : -dy > worst ? -dy : worst;
    }
    return (int32_t)(worst / 256);
}

/* Root mean square of what the correction leaves of dy, Q8 px. */
static int32_t rms_q8(const stad_rig *r, const stad_pair *pairs, int n)
{
    uint64_t sum = 0;
    for (int i = 0; i < n; i++) {
        stad_pair straight = pairs[i];
        stad_rig_straighten(r, &straight, 1);
        for (int k = 0; k < 4; k++) {
            const int64_t dy = straight.right[k].y_q8 - straight.left[k].y_q8;
            sum += (uint64_t)(dy * dy);
        }
    }
    return n > 0 ? sat_i32(stad_isqrt(sum / (4 * (uint64_t)n))) : 0;
}

/* Extent in x of the corners of the left view. */
static int32_t span_q8(const stad_pair *pairs, int n)
{
    int32_t low = INT32_MAX, high = 0;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 4; k++) {
            low = min_i32(low, pairs[i].left[k].x_q8);
            high = max_i32(high, pairs[i].left[k].x_q8);
        }
    return n > 0 ? high - low : 0;
}

static uint8_t verdict_of(const stad_rig_report *report)
{
    if (report->corners < MIN_CORNERS || report->rms_after_q8 > RESIDUAL_Q8 || report->worst_q8 > CORRECT_Q8)
        return STAD_RIG_FAIL;
    if (report->worst_q8 >= WATCH_Q8)
        return STAD_RIG_CORRECT;
    return report->worst_q8 >= GOOD_Q8 ? STAD_RIG_WATCH : STAD_RIG_GOOD;
}

int stad_rig_fit(stad_rig *r, stad_rig_report *report, const stad_pair *pairs, int n, int width, int height)
{
    STAD_ASSERT(r && report && (pairs || n <= 0));
    if (width < 16 || width > STAD_MARK_MAX_SIZE || height < 16 || height > STAD_MARK_MAX_SIZE || n < 0 ||
        n > STAD_AFFINE_MAX_POINTS / 4)
        return STAD_E_PARAM;
    stad_rig_identity(r, width, height);
    report->rms_before_q8 = rms_q8(r, pairs, n);
    report->span_q8 = span_q8(pairs, n);
    report->corners = (int16_t)(4 * n);
    if (report->corners < MIN_CORNERS || !fit_once(r, pairs, n) || !fit_once(r, pairs, n)) {
        stad_rig_identity(r, width, height);
        report->corners = (int16_t)min_i32(report->corners, MIN_CORNERS - 1);
    }
    report->rms_after_q8 = rms_q8(r, pairs, n);
    report->worst_q8 = worst_q8(r);
    report->verdict = verdict_of(report);
    report->advised =
        report->verdict == STAD_RIG_CORRECT || (report->verdict == STAD_RIG_WATCH && report->span_q8 * 3 >= width * 256);
    return report->verdict;
}
