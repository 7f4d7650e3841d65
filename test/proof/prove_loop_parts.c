/* SPDX-License-Identifier: MIT
 * proof/prove_loop_parts.c - what the loop asks of a frame's marks, pictures and costs: two pairs against a pool and a pose of any two;
 * views of 16 x 16 px of any pixels, any parameters the matcher takes, any costs.
 * SOURCES: calib/pairs.c calib/health.c calib/points.c calib/presets.c calib/rule.c rig/rig_fit.c rig/rig_apply.c base/affine.c base/log.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 33 */
#include "calib/calib_parts.h"

#include "proof/prove.h"

enum { SIZE = 16, PAIRS = 2, REACH = 2048 * 256 };

static stad_calib c;

/* -- what is not asked here, but called -------------------------------------------------------------------------- */

int stad_params_check(const stad_params *p, int mode, int width, const char **culprit)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

void stad_tune_config_stereo(stad_tune_config *config, int purpose)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        config->axis[i].lo = config->axis[i].hi = (int16_t)any(0, 32767);
}

/* -- pairs ------------------------------------------------------------------------------------------------------- */

static void any_pairs(stad_pair *pairs)
{
    for (int i = 0; i < PAIRS; i++) {
        pairs[i].id = (int16_t)any(0, STAD_MARK_IDS - 1);
        for (int k = 0; k < 4; k++) {
            const stad_corner left = {any(-REACH / 8, REACH + REACH / 8), any(-REACH / 8, REACH + REACH / 8)};
            const stad_corner right = {any(-REACH / 8, REACH + REACH / 8), any(-REACH / 8, REACH + REACH / 8)};
            pairs[i].left[k] = left;
            pairs[i].right[k] = right;
        }
    }
}

static void prove_pairs(void)
{
    stad_pair pairs[PAIRS], room[PAIRS];
    stad_rig_report report;
    const stad_rig rig = {any(-(1 << 30), 1 << 30), any(-(1 << 22), 1 << 22), any(-(1 << 22), 1 << 22), 2048, 2048};
    any_pairs(pairs);
    any_pairs(c.pose[0].pairs);
    any_pairs(c.pool);
    c.config.pose_px = (int16_t)any(0, 1000);
    for (c.pose[0].count = 0; c.pose[0].count <= PAIRS; c.pose[0].count++)
        stad_calib_is_another_pose(&c, pairs, PAIRS);
    for (c.pooled = 0; c.pooled <= PAIRS; c.pooled++)
        stad_calib_is_still(&c, pairs, PAIRS);
    stad_calib_rig_verdict(&rig, pairs, PAIRS, room, &report);
}

/* -- pictures ---------------------------------------------------------------------------------------------------- */

static void prove_views(int channels)
{
    static uint8_t pix[2][SIZE * SIZE * 3];
    stad_calib_view view[2] = {{{0}, 0, 0}, {{0}, 0, 0}};
    const stad_image left = stad_image_packed(pix[0], SIZE, SIZE, channels),
                     right = stad_image_packed(pix[1], SIZE, any(0, SIZE), channels);
    any_u8(pix[0], sizeof pix[0]);
    any_u8(pix[1], sizeof pix[1]);
    c.config.geometry.width = c.config.geometry.height = SIZE;
    c.config.still = (uint8_t)any(0, 1);
    for (int i = 0; i < 6; i++)
        stad_calib_views_fault(&c, view, any(0, 1) ? &left : 0, any(0, 1) ? &right : 0);
}

/* -- points and costs -------------------------------------------------------------------------------------------- */

static stad_point any_point(void)
{
    stad_point x;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        x.v[i] = (int16_t)any(0, 32767);
    x.v[STAD_TUNE_UNIQUENESS_RATIO] = (int16_t)any(0, 99);
    return x;
}

static void prove_costs(void)
{
    const stad_point a = any_point(), b = any_point();
    stad_point p;
    const char *name;
    stad_tune_config config;
    stad_params params = {0};
    params = stad_calib_params_at(&params, &a);
    stad_calib_point_of(&params);
    stad_calib_point_equal(&a, &b);
    c.config.geometry.max_p2 = (int16_t)any(0, 32767);
    stad_calib_fits(&c.config.geometry, &params);
    stad_calib_tune_config(&c, any(2, STAD_TUNE_LOG), &config);
    stad_calib_preset(any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), &p, any(0, 1) ? &name : 0);
    stad_calib_raised(any(0, INT32_MAX), stad_calib_handicap_q16(any(INT32_MIN, INT32_MAX)));
    stad_calib_penalised(&a, &b, any(0, INT32_MAX), any(0, 65536));
    stad_calib_margin(any(0, INT32_MAX), any(INT32_MIN, INT32_MAX), any(0, STAD_COST_ONE));
    stad_calib_is_better(any(0, INT32_MAX), any(0, INT32_MAX), any(0, STAD_COST_ONE));
}

int main(void)
{
    prove_pairs();
    prove_views(1);
    prove_views(3);
    prove_costs();
    return 0;
}
