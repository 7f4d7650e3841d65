/* SPDX-License-Identifier: MIT
 * unit/calib_pump.h - a pump without pixels: what a test of its decisions begins with. Include it once in a program. */
#ifndef TEST_UNIT_CALIB_PUMP_H
#define TEST_UNIT_CALIB_PUMP_H

#include <string.h>

#include "calib/calib_parts.h"
#include "unity.h"

static stad_calib calib;
static stad_calib_config config;
static stad_setup setup;

/* Points of 100 as a cost. */
#define POINTS(p) ((int32_t)((p) * (STAD_COST_ONE / 100)))

void setUp(void)
{
    const stad_geometry g = {320, 240, 1, 64, 11, 4096, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_camera camera = {256 * 200, 256 * 160, 256 * 120};
    stad_calib_config_default(&config, &g, stad_target_relief(), &camera);
    memset(&setup, 0, sizeof setup);
    setup.width = 320;
    setup.height = 240;
    setup.channels = 1;
    stad_params_sample(&setup.params, 64, 3, 1);
    stad_rig_identity(&setup.rig, 320, 240);
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
}

void tearDown(void)
{
}

/* Truth of one plane over most of the frame, as if two poses had been held. */
static void hold_poses(void)
{
    const stad_plane plane = {0, 0, 20 * 65536};
    const stad_polygon where = {4, {{80 * 256, 20 * 256}, {300 * 256, 20 * 256}, {300 * 256, 220 * 256}, {80 * 256, 220 * 256}}};
    for (int i = 0; i < 2; i++) {
        stad_truth_init(&calib.pose[i].truth, 320, 240, 0, 64, 1);
        TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&calib.pose[i].truth, &plane, &where));
        calib.pose[i].box = stad_truth_box(&calib.pose[i].truth);
    }
}

#endif
