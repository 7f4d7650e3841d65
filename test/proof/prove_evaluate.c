/* SPDX-License-Identifier: MIT
 * proof/prove_evaluate.c - one evaluation: any request for any box of a frame of 16 x 16 px, 1 or 3 channels, corrected or not; frames of
 * any size, any workspace, a matcher that answers anything.
 * SOURCES: calib/evaluate.c calib/health.c
 * OPTIONS: -eva-min-loop-unroll 17
 * The matcher, the score, truth and correction touch the ends of what they may: that it is no more is proved of each. */
#include "calib/calib_parts.h"

#include "proof/prove.h"

enum { SIZE = 16, MATCH = 1024 };

static int width, channels;

size_t stad_match_bytes(const stad_geometry *g)
{
    return (size_t)any(0, 1) * MATCH;
}

int stad_match_init(stad_match *m, const stad_geometry *g, void *work, size_t work_bytes)
{
    uint8_t *p = work;
    //@ assert work_bytes == 0 || \valid(p + (0 .. work_bytes - 1));
    width = g->width;
    channels = g->channels;
    return any(-8, 0);
}

int stad_match_begin(stad_match *m, const stad_params *p)
{
    return any(-8, 0);
}

int stad_match_push(stad_match *m, const uint8_t *left_row, const uint8_t *right_row)
{
    if (left_row[0] + left_row[width * channels - 1] + right_row[0] + right_row[width * channels - 1] > 0)
        return any(-8, 1);
    return STAD_OK;
}

int stad_match_pull(stad_match *m, int16_t *disp_q4_row)
{
    disp_q4_row[0] = disp_q4_row[width - 1] = 0;
    return any(-8, SIZE);
}

int stad_truth_row(const stad_truth *t, int y, int row_width, int32_t *truth_q16_row, uint8_t *label_row)
{
    truth_q16_row[0] = truth_q16_row[width - 1] = 0;
    label_row[0] = label_row[width - 1] = 0;
    return any(-8, 0);
}

void stad_score_config_init(stad_score_config *s, int cost, int min_disparity, int num_disparities)
{
    s->threshold_q16 = 65536;
}

int stad_score_begin(stad_score *s, const stad_score_config *config)
{
    return any(-8, 0);
}

void stad_score_row(stad_score *s, int y, const int16_t *disp_q4_row, const int32_t *truth_q16_row, const uint8_t *label_row,
                    int row_width)
{
}

int32_t stad_score_end(const stad_score *s)
{
    return any(0, INT32_MAX);
}

int stad_rig_row(const stad_rig *r, const stad_image *right, int y, uint8_t *out_row)
{
    //@ assert 0 <= y < right->height;
    for (int i = 0; i < right->width * right->channels; i++)
        out_row[i] = (uint8_t)any(0, 255);
    return any(-8, 0);
}

static void prove(int planes)
{
    static stad_calib c;
    static stad_evaluator e;
    static uint8_t pix[2][SIZE * SIZE * 3];
    static uint8_t work[STAD_CALIB_ROWS_BYTES(SIZE, 3) + MATCH] __attribute__((aligned(16)));
    const stad_geometry g = {SIZE, SIZE, (int16_t)planes, 16, 11, 8192, 127, 0, 0};
    const stad_image left = stad_image_packed(pix[0], SIZE, SIZE, planes);
    const stad_image right = stad_image_packed(pix[1], SIZE, any(0, 1) ? SIZE : any(INT32_MIN, INT32_MAX), planes);
    stad_request r = {(uint8_t)any(0, 255), (uint8_t)any(0, 255), {0, 0, 0, 0}, {0}, {any(-1, 1), 0, 0, SIZE, SIZE}};
    c.config.geometry = g;
    any_u8(pix[0], sizeof pix[0]);
    any_u8(pix[1], sizeof pix[1]);
    //@ loop unroll 4;
    for (int x = 0; x < SIZE; x += 5) {
        r.box.x = (int16_t)x;
        r.box.y = (int16_t)x;
        r.box.width = (int16_t)any(1, SIZE - x);
        r.box.height = (int16_t)any(1, SIZE - x);
        stad_calib_evaluate(&c, &r, &e, &left, &right, any(0, 1) ? work : 0, (size_t)any(0, (int)sizeof work));
    }
    stad_calib_evaluate_bytes(&g);
}

int main(void)
{
    prove(1);
    prove(3);
    return 0;
}
