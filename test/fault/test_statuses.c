/* SPDX-License-Identifier: MIT
 * test_statuses.c - every status that a public function promises is got out of it, and together these are all of stad/status.h: a
 * new code without a call that answers it fails here. */
#include <stdio.h>
#include <string.h>

#include "support/flash_sim.h"
#include "stad/stad.h"
#include "unity.h"

enum { W = 48, H = 64 };

static const stad_geometry geometry = {W, H, 1, 16, 3, 100, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};
static uint8_t work[200000] STAD_ALIGNED;
static uint8_t pix[W * H * 3];
static int16_t disp[W * H];
static int reached[16];

void setUp(void)
{
}

void tearDown(void)
{
}

/* The status that a call must answer. */
static void answers(int expected, int got, const char *call)
{
    TEST_ASSERT_EQUAL_MESSAGE(expected, got, call);
    TEST_ASSERT_TRUE(expected < 0 && expected > -16);
    reached[-expected] = 1;
}

#define ANSWERS(expected, call) answers(expected, call, #call)

static stad_params small_params(void)
{
    stad_params p;
    stad_params_default(&p, 16);
    return p;
}

static void match_and_image(void)
{
    stad_match m;
    stad_geometry g = geometry;
    stad_params p = small_params();
    stad_image image = stad_image_packed(pix, W, H, 1), narrow = stad_image_packed(pix, W - 1, H, 1);
    size_t bytes = stad_match_bytes(&g);
    TEST_ASSERT_LESS_OR_EQUAL(sizeof work, bytes);
    g.max_block_size = 4;
    ANSWERS(STAD_E_PARAM, stad_geometry_check(&g, NULL));
    ANSWERS(STAD_E_PARAM, stad_match_init(&m, &g, work, bytes));
    ANSWERS(STAD_E_SIZE, stad_match_init(&m, &geometry, work, bytes - 1));
    ANSWERS(STAD_E_SIZE, stad_match_init(&m, &geometry, work + 1, bytes));
    ANSWERS(STAD_E_SIZE, stad_match_init(&m, &geometry, NULL, bytes));
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_init(&m, &geometry, work, bytes));
    ANSWERS(STAD_E_PARAM, stad_match_options(&m, 4));
    ANSWERS(STAD_E_STATE, stad_match_push(&m, pix, pix));
    ANSWERS(STAD_E_STATE, stad_match_pull(&m, disp));
    p.block_size = 5;
    ANSWERS(STAD_E_LIMIT, stad_match_begin(&m, &p));
    p.block_size = 4;
    ANSWERS(STAD_E_PARAM, stad_match_begin(&m, &p));
    p.block_size = 3;
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_begin(&m, &p));
    ANSWERS(STAD_AGAIN, stad_match_pull(&m, disp));
    int status, rows = 0;
    while ((status = stad_match_push(&m, pix, pix)) == STAD_OK)
        rows++;
    ANSWERS(STAD_AGAIN, status);
    TEST_ASSERT_LESS_THAN(H, rows);
    ANSWERS(STAD_E_SIZE, stad_match_frame(&m, &p, &image, &narrow, disp, W, NULL, 0));
    p.speckle_window_size = 4;
    ANSWERS(STAD_E_SIZE, stad_match_frame(&m, &p, &image, &image, disp, W, NULL, 0));
    ANSWERS(STAD_E_SIZE, stad_speckle_filter(disp, W, W, H, -16, 4, 16, work, 3));
    ANSWERS(STAD_E_PARAM, stad_params_check(&p, 9, W, NULL));
}

static void marks(void)
{
    stad_mark out[2];
    stad_mark_config c;
    stad_image image = stad_image_packed(pix, W, H, 1), two = stad_image_packed(pix, W, H, 2);
    size_t bytes = stad_mark_bytes(W, H);
    stad_mark_config_default(&c);
    c.max_hamming = 3;
    ANSWERS(STAD_E_PARAM, stad_mark_find(&image, &c, out, 2, work, bytes));
    ANSWERS(STAD_E_PARAM, stad_mark_find(&two, NULL, out, 2, work, bytes));
    ANSWERS(STAD_E_SIZE, stad_mark_find(&image, NULL, out, 2, work, bytes - 1));
}

static stad_pair pair_at(int id, int x, int y, int d, int dy)
{
    stad_pair p;
    p.id = (int16_t)id;
    for (int k = 0; k < 4; k++) {
        p.left[k].x_q8 = (x + (k == 1 || k == 2 ? 12 : 0)) * 256;
        p.left[k].y_q8 = (y + (k >= 2 ? 12 : 0)) * 256;
        p.right[k].x_q8 = p.left[k].x_q8 - d * 256;
        p.right[k].y_q8 = p.left[k].y_q8 + dy * 256;
    }
    return p;
}

static void rigs(void)
{
    stad_rig r;
    stad_rig_report report;
    stad_rig_stream s;
    stad_pair pair = pair_at(0, 10, 2, 3, 0);
    stad_image image = stad_image_packed(pix, W, H, 1);
    ANSWERS(STAD_E_PARAM, stad_rig_fit(&r, &report, &pair, 1, 15, H));
    stad_rig_identity(&r, W, H);
    ANSWERS(STAD_E_SIZE, stad_rig_row(&r, &image, H, work));
    r.a_q16 = 65 << 16;
    ANSWERS(STAD_E_PARAM, stad_rig_row(&r, &image, 0, work));
    r.a_q16 = 3 << 16;
    ANSWERS(STAD_E_LIMIT, stad_rig_begin(&s, &r, 1, 2, work, sizeof work));
    ANSWERS(STAD_E_SIZE, stad_rig_begin(&s, &r, 1, 4, work, 5));
    ANSWERS(STAD_E_PARAM, stad_rig_begin(&s, &r, 2, 4, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_OK, stad_rig_begin(&s, &r, 1, 4, work, sizeof work));
    ANSWERS(STAD_AGAIN, stad_rig_pull(&s, pix));
    int status, row = 0;
    while ((status = stad_rig_push(&s, pix)) == STAD_OK)
        row++;
    ANSWERS(STAD_AGAIN, status);
    while (row < H || s.pulled < H) {
        row += stad_rig_push(&s, pix) == STAD_OK;
        stad_rig_pull(&s, pix);
    }
    ANSWERS(STAD_E_STATE, stad_rig_push(&s, pix));
    ANSWERS(STAD_E_STATE, stad_rig_pull(&s, pix));
}

static void truths(void)
{
    static stad_truth t;
    int32_t row[W];
    uint8_t label[W];
    stad_polygon square = {4, {{256, 256}, {9000, 256}, {9000, 3000}, {256, 3000}}};
    stad_plane plane = {0, 0, 5 * 65536}, steep = {70000, 0, 0};
    stad_box outside = {0, 0, W + 1, H};
    stad_pair pairs[2] = {pair_at(0, 2, 2, 3, 0), pair_at(1, 30, 2, 40, 0)};
    ANSWERS(STAD_E_PARAM, stad_truth_init(&t, 15, H, 0, 16, 1));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    ANSWERS(STAD_E_PARAM, stad_truth_add_plane(&t, &steep, &square));
    while (t.count < STAD_TRUTH_LAYERS)
        TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&t, &plane, &square));
    ANSWERS(STAD_E_LIMIT, stad_truth_add_plane(&t, &plane, &square));
    ANSWERS(STAD_E_LIMIT, stad_truth_add_mask(&t, &square));
    ANSWERS(STAD_E_SIZE, stad_truth_row(&t, H, W, row, label));
    ANSWERS(STAD_E_PARAM, stad_truth_crop(&t, &outside));
    ANSWERS(STAD_E_NO_MARK, stad_plane_fit(&plane, NULL, pairs, 1));
    for (int k = 0; k < 4; k++) /* a wall: 1.3 px of disparity a column over both marks */
        for (int i = 0; i < 2; i++)
            pairs[i].right[k].x_q8 = pairs[i].left[k].x_q8 - pairs[i].left[k].x_q8 * 13 / 10;
    ANSWERS(STAD_E_RIG, stad_plane_fit(&plane, NULL, pairs, 2));
    ANSWERS(STAD_E_PARAM, stad_truth_from_target(&t, stad_target_relief(), pairs, 2, NULL));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    ANSWERS(STAD_E_NO_MARK, stad_truth_from_target(&t, stad_target_card(), pairs, 2, NULL));
}

static void score_tune_monitor_depth(void)
{
    stad_score s;
    stad_score_config c;
    static stad_tune t;
    stad_tune_config tc;
    stad_point x = {{40, 150, 3, 0, 21, 8}};
    int32_t cost;
    stad_monitor m;
    stad_monitor_config mc;
    stad_match_counts none = {0, 0, 0, 0, 0, 0};
    stad_depth depth = {0, 0, -16};
    uint16_t mm[1];
    stad_score_config_init(&c, STAD_SCORE_BAD, 0, 0);
    ANSWERS(STAD_E_PARAM, stad_score_begin(&s, &c));
    stad_tune_config_stereo(&tc, STAD_TUNE_FOR_ANY);
    TEST_ASSERT_EQUAL(STAD_OK, stad_tune_init(&t, &tc, &x));
    ANSWERS(STAD_E_STATE, stad_tune_best(&t, &x, &cost));
    ANSWERS(STAD_E_PARAM, stad_tune_tell(&t, -1));
    ANSWERS(STAD_E_PARAM, stad_tune_trace(&t, 0, &x, &cost));
    tc.budget = 0;
    ANSWERS(STAD_E_PARAM, stad_tune_config_check(&tc, NULL));
    ANSWERS(STAD_E_PARAM, stad_tune_init(&t, &tc, &x));
    ANSWERS(STAD_E_STATE, stad_tune_tell(&t, 7));
    stad_monitor_defaults(&mc);
    TEST_ASSERT_EQUAL(STAD_OK, stad_monitor_init(&m, &mc));
    ANSWERS(STAD_E_PARAM, stad_monitor_frame(&m, &none));
    mc.learn_frames = 1;
    ANSWERS(STAD_E_PARAM, stad_monitor_init(&m, &mc));
    ANSWERS(STAD_E_PARAM, stad_depth_row(&depth, disp, 1, mm));
}

static stad_setup some_setup(void)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = W;
    s.height = H;
    s.channels = 1;
    s.params = small_params();
    stad_rig_identity(&s.rig, W, H);
    return s;
}

static void store(void)
{
    flash_sim sim;
    sim_init(&sim, 8, 1);
    stad_flash f = sim_flash(&sim);
    stad_setup setup = some_setup(), bad = setup;
    uint32_t sequence;
    bad.width = 0;
    ANSWERS(STAD_E_PARAM, stad_setup_check(&bad));
    ANSWERS(STAD_E_CORRUPT, stad_setup_unpack(pix, sizeof pix, &setup, &sequence));
    ANSWERS(STAD_E_CORRUPT, stad_store_load(&f, &setup));
    ANSWERS(STAD_E_CORRUPT, stad_store_load_slot(&f, STAD_SLOT_A, &setup));
    ANSWERS(STAD_E_PARAM, stad_store_load_slot(&f, 3, &setup));
    ANSWERS(STAD_E_PARAM, stad_store_save(&f, &bad));
    ANSWERS(STAD_E_PARAM, stad_store_save_factory(&f, &bad));
    TEST_ASSERT_EQUAL(STAD_SLOT_FACTORY, stad_store_save_factory(&f, &setup));
    ANSWERS(STAD_E_STATE, stad_store_save_factory(&f, &setup));
    sim.refuses = 1;
    ANSWERS(STAD_E_CORRUPT, stad_store_save(&f, &setup));
    sim.unreadable[0] = sim.unreadable[1] = 1;
    ANSWERS(STAD_E_STATE, stad_store_save(&f, &setup));
    f.program_bytes = 3;
    ANSWERS(STAD_E_PARAM, stad_store_load(&f, &setup));
    ANSWERS(STAD_E_PARAM, stad_store_save(&f, &setup));
}

static void calib(void)
{
    static stad_calib c;
    stad_calib_config config;
    stad_setup setup = some_setup();
    const stad_camera camera = {200 * 256, W * 128, H * 128};
    static uint8_t other_pix[sizeof pix];
    stad_image image = stad_image_packed(pix, W, H, 1), other = stad_image_packed(other_pix, W, H, 1);
    size_t bytes = stad_calib_frame_bytes(W, H);
    stad_point point;
    TEST_ASSERT_LESS_OR_EQUAL(sizeof work, bytes);
    stad_calib_config_default(&config, &geometry, stad_target_relief(), &camera);
    config.budget = 3;
    ANSWERS(STAD_E_PARAM, stad_calib_init(&c, &config, &setup));
    config.budget = 40;
    config.min_block_size = 1;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&c, &config, &setup));
    ANSWERS(STAD_E_STATE, stad_calib_frame(&c, &image, &image, work, bytes));
    ANSWERS(STAD_E_STATE, stad_calib_cost(&c, 1));
    ANSWERS(STAD_E_STATE, stad_calib_saved(&c, 0));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_start(&c));
    ANSWERS(STAD_E_STATE, stad_calib_start(&c));
    ANSWERS(STAD_E_SIZE, stad_calib_frame(&c, &image, &image, work, bytes - 1));
    ANSWERS(STAD_AGAIN, stad_calib_frame(&c, &image, NULL, work, bytes));
    memset(pix, 3, sizeof pix);
    ANSWERS(STAD_E_CORRUPT, stad_calib_frame(&c, &image, &image, work, bytes));
    for (size_t i = 0; i < sizeof pix; i++) {
        pix[i] = (uint8_t)(i * 37);
        other_pix[i] = (uint8_t)(i * 41);
    }
    ANSWERS(STAD_E_CORRUPT, stad_calib_frame(&c, &image, &image, work, bytes));
    other_pix[0] ^= 1;
    pix[0] ^= 1;
    ANSWERS(STAD_E_NO_MARK, stad_calib_frame(&c, &image, &other, work, bytes));
    ANSWERS(STAD_E_PARAM, stad_calib_preset(STAD_PRESETS, 1, &point, NULL));
}

void test_status_every_promised_one_is_answered(void)
{
    match_and_image();
    marks();
    rigs();
    truths();
    score_tune_monitor_depth();
    store();
    calib();
}

void test_status_all_of_the_header_are_reached(void)
{
    char text[60];
    for (int status = -1; strcmp(stad_status_name(status), "STAD_E_UNKNOWN") != 0; status--) {
        snprintf(text, sizeof text, "no test produces %s", stad_status_name(status));
        TEST_ASSERT_TRUE_MESSAGE(status > -16 && reached[-status], text);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_status_every_promised_one_is_answered);
    RUN_TEST(test_status_all_of_the_header_are_reached);
    return UNITY_END();
}
