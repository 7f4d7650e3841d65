/* SPDX-License-Identifier: MIT
 * proof/prove_truth.c - truths: polygons and planes of any numbers refused or taken, boxes and crops of any, a plane fitted to the
 * corners of any two marks.
 * SOURCES: truth/truth.c truth/polygon.c truth/plane_fit.c base/affine.c base/log.c
 * OPTIONS: -eva-min-loop-unroll 9 */
#include "proof/prove.h"
#include "stad/truth.h"
#include "truth/plane_fit.h"
#include "truth/polygon.h"

enum { REACH = 2048 * 256 };

static stad_truth t;

static void prove_layer(int count)
{
    const stad_plane plane = {any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX)};
    stad_polygon where;
    where.count = count;
    for (int i = 0; i < STAD_POLYGON_MAX; i++) {
        where.p[i].x_q8 = any(INT32_MIN, INT32_MAX);
        where.p[i].y_q8 = any(INT32_MIN, INT32_MAX);
    }
    if (stad_truth_init(&t, any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX),
                        any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX)) != STAD_OK)
        return;
    stad_truth_add_plane(&t, &plane, &where);
    stad_truth_add_mask(&t, &where);
}

static void prove_box(void)
{
    stad_truth_init(&t, 320, 240, any(-2048, 2048), any(1, 2048), any(0, 16));
    t.count = 1;
    t.layer[0].is_mask = any(0, 1);
    t.layer[0].plane.a_q16 = any(-65535, 65535);
    t.layer[0].plane.b_q16 = any(-65535, 65535);
    t.layer[0].plane.c_q16 = any(-(1 << 30), 1 << 30);
    t.layer[0].where.count = 3;
    for (int i = 0; i < 3; i++) {
        t.layer[0].where.p[i].x_q8 = any(-(1 << 20), 3 << 19);
        t.layer[0].where.p[i].y_q8 = any(-(1 << 20), 3 << 19);
    }
    stad_truth_box(&t);
    const stad_box box = {(int16_t)any(-32768, 32767), (int16_t)any(-32768, 32767), (int16_t)any(-32768, 32767),
                          (int16_t)any(-32768, 32767)};
    stad_truth_crop(&t, &box);
}

static void prove_fit(void)
{
    stad_pair pairs[2];
    stad_plane plane;
    stad_plane_report report;
    for (int i = 0; i < 2; i++) {
        pairs[i].id = (int16_t)any(-32768, 32767);
        for (int k = 0; k < 4; k++) {
            pairs[i].left[k].x_q8 = any(0, REACH);
            pairs[i].left[k].y_q8 = any(0, REACH);
            pairs[i].right[k].x_q8 = any(0, REACH);
            pairs[i].right[k].y_q8 = any(0, REACH);
        }
    }
    stad_plane_fit(&plane, &report, pairs, any(0, 2));
}

int main(void)
{
    for (int count = 0; count <= STAD_POLYGON_MAX + 1; count++)
        prove_layer(count);
    prove_box();
    prove_fit();
    return 0;
}
