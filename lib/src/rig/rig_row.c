/* SPDX-License-Identifier: MIT
 * raw rows, correction -> [rig/rig_row.c] -> corrected rows - cubic resampling, 4 taps each way at 16 phases.
 *
 * Positions run along a row in Q18: at most 2^11 px and 2^9 px of displacement, below 2^30, and the step's rounding of 2^-19
 * adds up to 2^11 * 2^-19 = 1/256 px over the longest row, less than a phase. */
#include "stad/rig.h"

#include <string.h>

#include "base/arith.h"

enum { BIAS_PX = 512, PHASE_BITS = 4, MAX_SLOPE_Q24 = 1 << 20, MAX_SHIFT_Q16 = 64 << 16 };

/* Cubic convolution with a = -1 in 1/64, each row sums to 64. Halfway between pixels it passes half of the Nyquist frequency
 * at 1.06 of its size; the customary a = -0.5 passes 0.88, and a blurred row is then matched against a sharp one. */
static const int8_t taps[16][4] = {
    {0, 64, 0, 0},    {-4, 64, 4, 0},   {-6, 62, 9, -1},  {-8, 60, 14, -2}, {-9, 57, 19, -3}, {-9, 53, 24, -4},
    {-9, 49, 30, -6}, {-9, 45, 35, -7}, {-8, 40, 40, -8}, {-7, 35, 45, -9}, {-6, 30, 49, -9}, {-4, 24, 53, -9},
    {-3, 19, 57, -9}, {-2, 14, 60, -8}, {-1, 9, 62, -6},  {0, 4, 64, -4},
};

/* Raw rows: row y lies at slot y modulo `slots`. */
typedef struct source {
    const uint8_t *pix;
    ptrdiff_t row_stride;
    int32_t pixel_stride, channels, slots;
} source;

/* A position that advances along a row, Q18 px. */
typedef struct walk {
    int32_t x_q18, y_q18, step_x_q18, step_y_q18;
} walk;

/* v / 64 to the nearest, for Q24 to Q18. */
static int32_t q24_to_q18(int64_t v)
{
    return (int32_t)((v + (v < 0 ? -32 : 32)) / 64);
}

static walk walk_row(const stad_rig *r, int32_t y)
{
    const int64_t from_x = -(r->width / 2), from_y = y - r->height / 2;
    const int64_t dx_q24 = r->c_q24 * from_x - r->b_q24 * from_y;
    const int64_t dy_q24 = r->b_q24 * from_x + r->c_q24 * from_y + (int64_t)r->a_q16 * 256;
    const walk w = {q24_to_q18(dx_q24), y * (1 << 18) + q24_to_q18(dy_q24), (1 << 18) + q24_to_q18(r->c_q24),
                    q24_to_q18(r->b_q24)};
    return w;
}

/* A position in 1/16 px, counted from BIAS_PX before the image so that it is not negative. */
static uint32_t position_q4(int32_t v_q18)
{
    return ((uint32_t)(v_q18 + (BIAS_PX << 18)) + (1u << 13)) >> 14;
}

static int32_t whole(uint32_t position)
{
    return (int32_t)(position >> PHASE_BITS) - BIAS_PX;
}

/* The corrections this file's arithmetic covers, and more than any that is worth applying. */
static int covered(const stad_rig *r)
{
    return r->a_q16 >= -MAX_SHIFT_Q16 && r->a_q16 <= MAX_SHIFT_Q16 && r->b_q24 >= -MAX_SLOPE_Q24 && r->b_q24 <= MAX_SLOPE_Q24 &&
           r->c_q24 >= -MAX_SLOPE_Q24 && r->c_q24 <= MAX_SLOPE_Q24 && r->width >= 16 && r->width <= STAD_MARK_MAX_SIZE &&
           r->height >= 16 && r->height <= STAD_MARK_MAX_SIZE;
}

static void point_at_rows(const source *s, int32_t y0, int32_t height, const uint8_t *row[4])
{
    for (int32_t k = 0; k < 4; k++)
        row[k] = s->pix + clamp_i32(y0 - 1 + k, 0, height - 1) % s->slots * s->row_stride;
}

static uint8_t blend(const uint8_t *const row[4], const int32_t column[4], const int8_t *across, const int8_t *down)
{
    int32_t sum = 0; /* Q12; |taps| sum to at most 96, so |sum| <= 255 * 96 * 96 < 2^22 */
    for (int32_t k = 0; k < 4; k++) {
        const int32_t x = column[k];
        sum += across[k] * (row[0][x] * down[0] + row[1][x] * down[1] + row[2][x] * down[2] + row[3][x] * down[3]);
    }
    return (uint8_t)(clamp_i32(sum + 2048, 0, 255 * 4096 + 4095) / 4096);
}

static void resample(const stad_rig *r, const source *s, int32_t y, uint8_t *out)
{
    const uint8_t *row[4];
    int32_t column[4];
    walk w = walk_row(r, y);
    int32_t loaded = whole(position_q4(w.y_q18));
    point_at_rows(s, loaded, r->height, row);
    for (int32_t x = 0; x < r->width; x++) {
        const uint32_t px = position_q4(w.x_q18), py = position_q4(w.y_q18);
        if (whole(py) != loaded) {
            loaded = whole(py);
            point_at_rows(s, loaded, r->height, row);
        }
        for (int32_t k = 0; k < 4; k++)
            column[k] = clamp_i32(whole(px) - 1 + k, 0, r->width - 1) * s->pixel_stride;
        for (int32_t c = 0; c < s->channels; c++) {
            *out++ = blend(row, column, taps[px % 16], taps[py % 16]);
            for (int32_t k = 0; k < 4; k++)
                column[k]++;
        }
        w.x_q18 += w.step_x_q18;
        w.y_q18 += w.step_y_q18;
    }
}

void stad_rig_rows(const stad_rig *r, int y, int *first, int *last)
{
    const walk w = walk_row(r, y);
    const int32_t start = whole(position_q4(w.y_q18));
    const int32_t end = whole(position_q4(w.y_q18 + w.step_y_q18 * (r->width - 1)));
    *first = clamp_i32(min_i32(start, end) - 1, 0, r->height - 1);
    *last = clamp_i32(max_i32(start, end) + 2, 0, r->height - 1);
}

int stad_rig_row(const stad_rig *r, const stad_image *right, int y, uint8_t *out_row)
{
    STAD_ASSERT(r && right && out_row);
    if (!covered(r))
        return STAD_E_PARAM;
    if (right->width != r->width || right->height != r->height || y < 0 || y >= r->height)
        return STAD_E_SIZE;
    const source s = {right->pix, right->row_stride, right->pixel_stride, right->channels, r->height};
    resample(r, &s, y, out_row);
    return STAD_OK;
}

int stad_rig_begin(stad_rig_stream *s, const stad_rig *r, int channels, int max_dy, void *work, size_t work_bytes)
{
    if ((channels != 1 && channels != 3) || max_dy < 0 || max_dy > 16 || !covered(r))
        return STAD_E_PARAM;
    if (!work || work_bytes < STAD_RIG_BYTES(r->width, channels, max_dy))
        return STAD_E_SIZE;
    const int rows[2] = {0, r->height - 1};
    for (int k = 0; k < 2; k++) {
        const walk w = walk_row(r, rows[k]);
        const int32_t start = w.y_q18 - rows[k] * (1 << 18), end = start + w.step_y_q18 * (r->width - 1);
        if (max_i32(abs_i32(start), abs_i32(end)) > max_dy * (1 << 18))
            return STAD_E_LIMIT;
    }
    s->rig = *r;
    s->ring = work;
    s->channels = (int16_t)channels;
    s->ring_rows = (int16_t)STAD_RIG_RING(max_dy);
    s->pushed = s->pulled = 0;
    return STAD_OK;
}

int stad_rig_push(stad_rig_stream *s, const uint8_t *raw_row)
{
    STAD_ASSERT(s && raw_row && s->ring_rows > 0); /* begun */
    if (s->pushed == s->rig.height)
        return STAD_E_STATE;
    int first, last;
    stad_rig_rows(&s->rig, min_i32(s->pulled, s->rig.height - 1), &first, &last);
    if (s->pulled < s->rig.height && s->pushed - s->ring_rows >= first)
        return STAD_AGAIN;
    const size_t bytes = (size_t)s->rig.width * (size_t)s->channels;
    memcpy(s->ring + (size_t)(s->pushed % s->ring_rows) * bytes, raw_row, bytes);
    s->pushed++;
    return STAD_OK;
}

int stad_rig_pull(stad_rig_stream *s, uint8_t *out_row)
{
    STAD_ASSERT(s && out_row && s->ring_rows > 0);
    if (s->pulled == s->rig.height)
        return STAD_E_STATE;
    int first, last;
    stad_rig_rows(&s->rig, s->pulled, &first, &last);
    if (last >= s->pushed)
        return STAD_AGAIN;
    const source from = {s->ring, (ptrdiff_t)s->rig.width * s->channels, s->channels, s->channels, s->ring_rows};
    resample(&s->rig, &from, s->pulled, out_row);
    return s->pulled++;
}
