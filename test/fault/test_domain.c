/* SPDX-License-Identifier: MIT
 * test_domain.c - every bound of matcher, marks, rig, monitor and scores, from both sides: one value inside, one outside. */
#include <string.h>

#include "support/pair_at.h"
#include "stad/stad.h"
#include "unity.h"

enum { W = 48, H = 20 };

static uint8_t work[200000] STAD_ALIGNED;
static uint8_t pix[W * H * 3];
static int16_t disp[W * H];

void setUp(void)
{
}

void tearDown(void)
{
}

static const stad_geometry geometry = {W, H, 1, 16, 3, 100, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};

void test_geometry_fields_outside_are_named(void)
{
    stad_match m;
    const char *culprit = NULL;
    struct {
        int16_t width, height, channels, disparities, block, p2, cap;
        const char *name;
    } bad[] = {{W, H, 1, 4, 3, 100, 63, "max_disparities"},
               {W, H, 1, 20, 3, 100, 63, "max_disparities"},
               {W, H, 1, 4096, 3, 100, 63, "max_disparities"},
               {W, H, 1, 16, 3, 100, 13, "max_pre_filter_cap"},
               {W, H, 1, 16, 3, 100, 64, "max_pre_filter_cap"}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        stad_geometry g = {bad[i].width, bad[i].height, bad[i].channels, bad[i].disparities, bad[i].block,
                           bad[i].p2,    bad[i].cap,    STAD_MODE_HH,    STAD_MEMORY_FAST};
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_geometry_check(&g, &culprit));
        TEST_ASSERT_EQUAL_STRING(bad[i].name, culprit);
        TEST_ASSERT_EQUAL(0, stad_match_part(&g, 0, &culprit));
    }
    TEST_ASSERT_EQUAL(0, stad_match_part(&geometry, -1, &culprit));
    TEST_ASSERT_NULL(culprit);
    TEST_ASSERT_GREATER_THAN(0, stad_match_part(&geometry, 0, NULL));
    memset(&m, 0, sizeof m);
    stad_params p;
    stad_params_default(&p, 16);
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_match_begin(&m, &p));
}

void test_frame_images_that_do_not_fit_are_refused(void)
{
    stad_match m;
    stad_params p;
    const stad_image good = stad_image_packed(pix, W, H, 1);
    stad_image bad[5] = {good, good, good, good, good};
    bad[0].pix = NULL;
    bad[1].width = W - 1;
    bad[2].height = H + 1;
    bad[3].channels = 3;
    bad[4].pixel_stride = 0;
    stad_params_default(&p, 16);
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_init(&m, &geometry, work, sizeof work));
    for (int i = 0; i < 5; i++) {
        TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame(&m, &p, &bad[i], &good, disp, W, NULL, 0));
        TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame(&m, &p, &good, &bad[i], disp, W, NULL, 0));
    }
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame(&m, &p, &good, &good, NULL, W, NULL, 0));
    p.block_size = 2;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_match_frame(&m, &p, &good, &good, disp, W, NULL, 0));
    p.block_size = 3;
    p.speckle_window_size = 5;
    uint8_t *room = work + 100000;
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame(&m, &p, &good, &good, disp, W, room + 1, 50000));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_match_frame(&m, &p, &good, &good, disp, W, room, STAD_SPECKLE_BYTES(W, H) - 1));
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_frame(&m, &p, &good, &good, disp, W, room, STAD_SPECKLE_BYTES(W, H)));
}

void test_pull_without_a_place_for_disparities_goes_on(void)
{
    stad_match m;
    stad_params p;
    int rows = 0;
    stad_params_default(&p, 16);
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_init(&m, &geometry, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_OK, stad_match_begin(&m, &p));
    for (int y = 0; y < H; y++) {
        TEST_ASSERT_EQUAL(STAD_OK, stad_match_push(&m, pix, pix));
        while (stad_match_pull_all(&m, NULL, NULL, NULL) >= 0)
            rows++;
    }
    while (stad_match_pull_all(&m, NULL, NULL, NULL) >= 0)
        rows++;
    TEST_ASSERT_EQUAL(H, rows);
}

void test_speckle_sizes_and_workspaces_outside_are_refused(void)
{
    size_t bytes = STAD_SPECKLE_BYTES(W, H);
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, 0, H, -16, 4, 16, work, bytes));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, W, 0, -16, 4, 16, work, bytes));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, 70000, 70000, -16, 4, 16, work, bytes));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, W, H, -16, 4, 16, NULL, bytes));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, W, H, -16, 4, 16, work + 1, bytes));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_speckle_filter(disp, W, W, H, -16, 4, 16, work, bytes - 1));
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_speckle_filter(disp, W, W, H, -16, 4, 16, work, bytes));
}

void test_mark_images_and_configs_outside_are_refused(void)
{
    stad_mark out[2];
    stad_mark_config c;
    const int32_t sizes[][2] = {{15, 20}, {2049, 20}, {20, 15}, {20, 2049}};
    stad_image image = stad_image_packed(pix, W, H, 1);
    for (int i = 0; i < 4; i++)
        TEST_ASSERT_EQUAL(0, stad_mark_bytes(sizes[i][0], sizes[i][1]));
    const uint8_t contrasts[] = {7, 129};
    for (int i = 0; i < 2; i++) {
        stad_mark_config_default(&c);
        c.min_contrast = contrasts[i];
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_mark_find(&image, &c, out, 2, work, sizeof work));
    }
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_mark_find(&image, NULL, out, -1, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_mark_find(&image, NULL, out, 2, NULL, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_mark_find(&image, NULL, out, 2, work + 1, sizeof work - 1));
    TEST_ASSERT_EQUAL(0, stad_mark_cell(-1, 2, 2) & ~1);
    TEST_ASSERT_EQUAL(0, stad_mark_cell(STAD_MARK_IDS, 2, 2) & ~1);
    TEST_ASSERT_EQUAL(0, stad_mark_cell(0, 0, 3));
    TEST_ASSERT_EQUAL(0, stad_mark_cell(0, 7, 3));
    TEST_ASSERT_EQUAL(0, stad_mark_cell(0, 3, 0));
    TEST_ASSERT_EQUAL(0, stad_mark_cell(0, 3, 7));
}

void test_mark_seen_by_one_camera_is_no_pair(void)
{
    stad_mark left[3], right[3];
    stad_pair out[3];
    memset(left, 0, sizeof left);
    memset(right, 0, sizeof right);
    for (int i = 0; i < 3; i++)
        left[i].id = right[i].id = (int16_t)i;
    TEST_ASSERT_EQUAL(1, stad_mark_pair(left, 2, right + 1, 2, out, 3));
    TEST_ASSERT_EQUAL(1, out[0].id);
    TEST_ASSERT_EQUAL(2, stad_mark_pair(left, 3, right, 3, out, 2));
}

void test_rig_sizes_and_numbers_outside_are_refused(void)
{
    stad_rig r;
    stad_rig_report report;
    const stad_pair pairs[2] = {pair_at(0, 5, 5, 0), pair_at(1, 5, 5, 0)};
    const int sizes[][2] = {{15, 20}, {2049, 20}, {20, 15}, {20, 2049}};
    for (int i = 0; i < 4; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_fit(&r, &report, pairs, 2, sizes[i][0], sizes[i][1]));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_fit(&r, &report, pairs, -1, W, H));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_fit(&r, &report, pairs, 1025, W, H));
    TEST_ASSERT_EQUAL(STAD_RIG_FAIL, stad_rig_fit(&r, &report, pairs, 2, W, H)); /* all corners on one point */
    TEST_ASSERT_LESS_THAN(8, report.corners);
    TEST_ASSERT_EQUAL(STAD_RIG_FAIL, stad_rig_fit(&r, &report, NULL, 0, W, H));
}

void test_rig_rows_refuse_what_they_do_not_cover(void)
{
    const stad_image image = stad_image_packed(pix, W, H, 1);
    const stad_rig good = {0, 0, 0, W, H};
    stad_rig bad[10] = {good, good, good, good, good, good, good, good, good, good};
    bad[0].a_q16 = (64 << 16) + 1;
    bad[1].a_q16 = -(64 << 16) - 1;
    bad[2].b_q24 = (1 << 20) + 1;
    bad[3].b_q24 = -(1 << 20) - 1;
    bad[4].c_q24 = (1 << 20) + 1;
    bad[5].c_q24 = -(1 << 20) - 1;
    bad[6].width = 15;
    bad[7].width = 2049;
    bad[8].height = 15;
    bad[9].height = 2049;
    for (int i = 0; i < 10; i++) {
        stad_rig_stream s;
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_row(&bad[i], &image, 0, work));
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_begin(&s, &bad[i], 1, 2, work, sizeof work));
    }
    stad_image narrow = image, low = image;
    narrow.width--;
    low.height--;
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_rig_row(&good, &narrow, 0, work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_rig_row(&good, &low, 0, work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_rig_row(&good, &image, -1, work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_rig_row(&good, &image, H, work));
    stad_rig_stream s;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_begin(&s, &good, 1, -1, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_rig_begin(&s, &good, 1, 17, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_rig_begin(&s, &good, 1, 2, NULL, sizeof work));
}

void test_monitor_waits_without_end(void)
{
    stad_monitor m;
    const stad_match_counts counts = {100, 50, 0, 0, 0, 0};
    TEST_ASSERT_EQUAL(STAD_OK, stad_monitor_init(&m, NULL));
    m.since_look = INT32_MAX;
    stad_monitor_frame(&m, &counts);
    TEST_ASSERT_EQUAL(INT32_MAX, m.since_look);
    TEST_ASSERT_EQUAL(1, stad_monitor_look_due(&m));
}

void test_score_blind_at_the_edges_of_a_row(void)
{
    stad_score s;
    stad_score_config c;
    uint8_t left[8], right[8];
    int16_t q4[8] = {-2000, 2000, -480, 31, -513, 480, 16, 0};
    for (int i = 0; i < 8; i++) {
        left[i] = (uint8_t)(i * 31);
        right[i] = (uint8_t)(255 - i * i * 5);
    }
    stad_score_config_init(&c, STAD_SCORE_BLIND, -32, 16); /* scored from column 0 */
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&s, &c));
    stad_score_row_blind(&s, 0, q4, left, right, 8);
    TEST_ASSERT_EQUAL(8, s.counts.considered);
    TEST_ASSERT_EQUAL(7, s.counts.matched); /* -2000 is below the range: none */
    TEST_ASSERT_EQUAL(7, s.histogram[31] + s.histogram[0] + s.histogram[4]);
    c.photo_limit = 255;
    c.min_disparity = 0;
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&s, &c));
    stad_score_row_blind(&s, 0, q4, left, left, 8);
    TEST_ASSERT_EQUAL(0, s.counts.considered);
}

void test_score_costs_at_the_ends(void)
{
    stad_score s;
    stad_score_config c;
    stad_score_config_init(&c, STAD_SCORE_WEIGHTED, 0, 16);
    c.weight_q8[STAD_SCORE_BAD] = INT16_MAX;
    c.weight_q8[STAD_SCORE_CHOW] = INT16_MAX;
    for (int i = STAD_SCORE_RMSE; i <= STAD_SCORE_MISSING; i++)
        c.weight_q8[i] = INT16_MAX;
    TEST_ASSERT_EQUAL(STAD_OK, stad_score_begin(&s, &c));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_score_cost_of(&s, STAD_SCORE_WEIGHTED));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_score_cost_of(&s, -1));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_score_end(&s)); /* no pixel */
    s.counts.visible = 10;
    s.counts.missing_visible = 10;
    TEST_ASSERT_EQUAL((5 * (int64_t)STAD_COST_ONE * INT16_MAX + 128) >> 8 < STAD_COST_FAILED, 1);
    TEST_ASSERT_GREATER_THAN(STAD_COST_ONE, stad_score_end(&s));
    s.counts.wrong_visible = INT32_MAX;
    s.counts.visible = 1;
    TEST_ASSERT_EQUAL(STAD_COST_FAILED - 1, stad_score_end(&s)); /* counts that cannot be, held to the largest cost */
    s.counts.photo_sum = (int64_t)1 << 50;
    s.counts.considered = 1;
    TEST_ASSERT_EQUAL(STAD_COST_FAILED - 1, stad_score_cost_of(&s, STAD_SCORE_PHOTO));
    s.counts.photo_sum = (int64_t)1 << 62;
    TEST_ASSERT_EQUAL(STAD_COST_FAILED - 1, stad_score_cost_of(&s, STAD_SCORE_PHOTO));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_geometry_fields_outside_are_named);
    RUN_TEST(test_frame_images_that_do_not_fit_are_refused);
    RUN_TEST(test_pull_without_a_place_for_disparities_goes_on);
    RUN_TEST(test_speckle_sizes_and_workspaces_outside_are_refused);
    RUN_TEST(test_mark_images_and_configs_outside_are_refused);
    RUN_TEST(test_mark_seen_by_one_camera_is_no_pair);
    RUN_TEST(test_rig_sizes_and_numbers_outside_are_refused);
    RUN_TEST(test_rig_rows_refuse_what_they_do_not_cover);
    RUN_TEST(test_monitor_waits_without_end);
    RUN_TEST(test_score_blind_at_the_edges_of_a_row);
    RUN_TEST(test_score_costs_at_the_ends);
    return UNITY_END();
}
