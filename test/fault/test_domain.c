/* SPDX-License-Identifier: MIT
 * test_domain.c - every bound that the library checks, from both sides: one value inside, one outside. */
#include <string.h>

#include "support/flash_sim.h"
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
    } bad[] = {{W, H, 1, 4, 3, 100, 63, "max_disparities"},    {W, H, 1, 20, 3, 100, 63, "max_disparities"},
               {W, H, 1, 4096, 3, 100, 63, "max_disparities"}, {W, H, 1, 16, 3, 100, 13, "max_pre_filter_cap"},
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

static stad_pair pair_at(int id, int x, int y, int side)
{
    stad_pair p;
    p.id = (int16_t)id;
    for (int k = 0; k < 4; k++) {
        p.left[k].x_q8 = (x + (k == 1 || k == 2 ? side : 0)) * 256;
        p.left[k].y_q8 = (y + (k >= 2 ? side : 0)) * 256;
        p.right[k].x_q8 = p.left[k].x_q8 - 5 * 256;
        p.right[k].y_q8 = p.left[k].y_q8;
    }
    return p;
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

static stad_setup some_setup(void)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = W;
    s.height = H;
    s.channels = 1;
    stad_params_default(&s.params, 16);
    stad_rig_identity(&s.rig, W, H);
    return s;
}

void test_setup_rig_that_is_not_its_own_is_refused(void)
{
    stad_setup s = some_setup();
    TEST_ASSERT_EQUAL(STAD_OK, stad_setup_check(&s));
    s.rig.width++;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&s));
    s = some_setup();
    s.rig.height++;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&s));
    for (int i = 0; i < 3; i++) { /* not corrected, so nothing but the identity */
        s = some_setup();
        *(i == 0 ? &s.rig.a_q16 : i == 1 ? &s.rig.b_q24 : &s.rig.c_q24) = 1;
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&s));
    }
}

/* Flash whose reads fail, or whose newest slot turns bad, from the n-th read on. */
static flash_sim sim;
static int reads_left, then_flip;

static int read_until(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    if (reads_left-- <= 0) {
        if (!then_flip)
            return -1;
        sim.bytes[STAD_SLOT_B][20] ^= 1;
        reads_left = 1000;
    }
    return sim_read(user, offset, bytes, count);
}

static void two_records(stad_flash *f, uint32_t first, uint32_t second)
{
    stad_setup s = some_setup();
    sim_init(&sim, 8, 1);
    *f = sim_flash(&sim);
    f->read = read_until;
    reads_left = 1000;
    then_flip = 0;
    stad_setup_pack(&s, first, sim.bytes[STAD_SLOT_A]);
    s.params.uniqueness_ratio = 7;
    stad_setup_pack(&s, second, sim.bytes[STAD_SLOT_B]);
}

void test_store_slot_that_rots_between_two_reads_gives_the_other(void)
{
    stad_flash f;
    stad_setup found;
    two_records(&f, 1, 2);
    reads_left = 2;
    then_flip = 1;
    TEST_ASSERT_EQUAL(STAD_SLOT_A, stad_store_load(&f, &found));
    TEST_ASSERT_EQUAL(0, found.params.uniqueness_ratio);
}

void test_store_twin_numbers_are_settled_one_way(void)
{
    stad_flash f;
    stad_setup found;
    two_records(&f, 5, 5);
    TEST_ASSERT_EQUAL(STAD_SLOT_A, stad_store_load(&f, &found));
}

void test_store_that_cannot_read_back_says_so(void)
{
    stad_flash f;
    stad_setup s = some_setup();
    two_records(&f, 1, 2);
    reads_left = 2;
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_store_save(&f, &s));
}

static stad_polygon square(int x0, int y0, int x1, int y1)
{
    stad_polygon p = {4, {{x0 * 256, y0 * 256}, {x1 * 256, y0 * 256}, {x1 * 256, y1 * 256}, {x0 * 256, y1 * 256}}};
    return p;
}

void test_truth_arguments_outside_are_refused(void)
{
    static stad_truth t;
    const int bad[][5] = {{2049, H, 0, 16, 1}, {W, 15, 0, 16, 1},     {W, 2049, 0, 16, 1},  {W, H, -2049, 16, 1}, {W, H, 2049, 16, 1},
                          {W, H, 0, 0, 1},     {W, H, 0, 2049, 1},    {W, H, 0, 16, -1},    {W, H, 0, 16, 17}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_init(&t, bad[i][0], bad[i][1], bad[i][2], bad[i][3], bad[i][4]));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    const stad_plane flat = {0, 0, 65536};
    const stad_plane steep[] = {{65536, 0, 0}, {-65536, 0, 0}, {0, 65536, 0}, {0, -65536, 0}, {0, 0, 2048 << 16}, {0, 0, -(2048 << 16)}};
    stad_polygon p = square(5, 5, 40, 15);
    for (size_t i = 0; i < sizeof steep / sizeof steep[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_plane(&t, &steep[i], &p));
    const stad_polygon far[] = {square(-4097, 5, 40, 15), square(5, 5, W + 4097, 15), square(5, -4097, 40, 15), square(5, 5, 40, H + 4097)};
    for (size_t i = 0; i < sizeof far / sizeof far[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_plane(&t, &flat, &far[i]));
    p.count = 2;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_plane(&t, &flat, &p));
    p.count = STAD_POLYGON_MAX + 1;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_mask(&t, &p));
}

void test_truth_boxes_and_rows_outside_are_refused(void)
{
    static stad_truth t;
    int32_t row[W];
    uint8_t label[W];
    const stad_plane flat = {0, 0, 65536};
    stad_polygon p = square(20, 5, 40, 15), right = square(W + 100, 5, W + 140, 15);
    const stad_box bad[] = {{-1, 0, 4, 4}, {0, -1, 4, 4}, {0, 0, 0, 4}, {0, 0, 4, 0}, {1, 0, W, 4}, {0, 1, 4, H}};
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    TEST_ASSERT_EQUAL(0, stad_truth_box(&t).width);
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&t, &flat, &right));
    TEST_ASSERT_LESS_OR_EQUAL(1, stad_truth_box(&t).width - 16);
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&t, &flat, &p));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_crop(&t, &bad[i]));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_truth_row(&t, 0, W - 1, row, label));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_truth_row(&t, -1, W, row, label));
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_truth_row(&t, H, W, row, label));
    const stad_plane beyond = {0, 0, -30 * 65536};
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, -32, 32, 0));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&t, &beyond, &p));
    for (int y = 0; y < H; y++)
        TEST_ASSERT_EQUAL(STAD_OK, stad_truth_row(&t, y, W, row, label));
}

void test_plane_slopes_beyond_one_are_refused(void)
{
    stad_plane plane;
    for (int axis = 0; axis < 2; axis++)
        for (int sign = -1; sign <= 1; sign += 2) {
            stad_pair pairs[2] = {pair_at(0, 4, 4, 12), pair_at(1, 30, 20, 12)};
            for (int i = 0; i < 8; i++) {
                stad_pair *p = &pairs[i / 4];
                int32_t at = axis ? p->left[i % 4].y_q8 : p->left[i % 4].x_q8;
                p->right[i % 4].x_q8 = p->left[i % 4].x_q8 - sign * at * 5 / 4;
            }
            TEST_ASSERT_EQUAL(STAD_E_RIG, stad_plane_fit(&plane, NULL, pairs, 2));
        }
    stad_pair line[3] = {pair_at(0, 4, 4, 0), pair_at(1, 8, 8, 0), pair_at(2, 20, 20, 0)};
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, stad_plane_fit(&plane, NULL, line, 3));
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, stad_plane_fit(&plane, NULL, line, 1025));
}

/* Corners anywhere and any camera: a status, or a truth whose rows can be had. */
void test_truth_of_any_marks_is_refused_or_sound(void)
{
    static stad_truth t;
    int32_t row[320];
    uint8_t label[320];
    uint32_t state = 12345;
    int sound = 0;
    for (int trial = 0; trial < 20000; trial++) {
        stad_pair pairs[4];
        int dice[12];
        for (int i = 0; i < 12; i++) {
            state = state * 1664525u + 1013904223u;
            dice[i] = (int)(state >> 10) % 4096;
        }
        int side = 10 + dice[0] % 40, tilt = dice[1] % 64 - 32, skew = dice[2] % 64 - 32, d = dice[3] % 80;
        for (int i = 0; i < 4; i++) {
            pairs[i] = pair_at(trial % 3 ? i : 4 + i % 2, 20 + (i == 1 || i == 2) * (60 + dice[4] % 160), 10 + (i >= 2) * (60 + dice[5] % 120), side);
            for (int k = 0; k < 4; k++) {
                stad_corner *l = &pairs[i].left[k], *r = &pairs[i].right[k];
                l->x_q8 += l->y_q8 * skew / 64;
                r->x_q8 = l->x_q8 - d * 256 - (l->x_q8 * tilt + l->y_q8 * skew) / 128;
                if (trial % 7 == 0 && i == 1)
                    r->x_q8 += dice[6] - 2048;
            }
        }
        stad_camera camera = {(dice[7] + 1) * (trial % 5 ? 64 : 1), dice[8] * 40, dice[9] * 40};
        TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, 320, 240, dice[10] % 40 - 20, 16 + dice[11] % 100, trial % 3));
        int status = stad_truth_from_target(&t, trial % 3 ? stad_target_relief() : stad_target_card(), pairs, 2 + trial % 3, &camera);
        TEST_ASSERT_TRUE(status > 0 || (status < 0 && status >= STAD_E_RIG));
        sound += status > 0;
        for (int y = 0; status > 0 && y < 240; y += 16)
            TEST_ASSERT_EQUAL(STAD_OK, stad_truth_row(&t, y, 320, row, label));
    }
    TEST_ASSERT_GREATER_THAN(100, sound);
}

void test_truth_cameras_outside_are_refused(void)
{
    static stad_truth t;
    const stad_pair pairs[2] = {pair_at(0, 4, 4, 12), pair_at(1, 30, 4, 12)};
    const int32_t most = 1 << 20;
    const stad_camera bad[] = {{16 * 256 - 1, 0, 0}, {most, 0, 0}, {200 * 256, most, 0}, {200 * 256, 0, most}, {200 * 256, -most, 0}, {200 * 256, 0, -most}};
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_from_target(&t, stad_target_relief(), pairs, 2, &bad[i]));
}

void test_calib_setups_of_another_geometry_are_refused(void)
{
    static stad_calib c;
    stad_calib_config config;
    const stad_camera camera = {200 * 256, W * 128, H * 128};
    stad_calib_config_default(&config, &geometry, stad_target_relief(), &camera);
    config.min_block_size = 1;
    stad_setup s = some_setup();
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&c, &config, &s));
    for (int i = 0; i < 8; i++) {
        s = some_setup();
        s.width = s.rig.width = (int16_t)(W + (i == 0));
        s.height = s.rig.height = (int16_t)(H + (i == 1));
        s.mode = (uint8_t)(i == 2);
        s.channels = (uint8_t)(i == 3 ? 3 : 1);
        s.params.num_disparities = i == 4 ? 24 : 16;
        s.params.block_size = i == 5 ? 5 : 3;
        s.params.p2 = (int16_t)(i == 6 ? 101 : 50);
        s.params.pre_filter_cap = (int16_t)(i == 7 ? 65 : 63);
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_calib_init(&c, &config, &s));
    }
}

void test_calib_presets_outside_are_refused(void)
{
    stad_point x;
    const char *name = NULL;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_preset(0, 3, &x, &name));
    TEST_ASSERT_NOT_NULL(name);
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_preset(STAD_PRESETS - 1, 1, &x, NULL));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_calib_preset(-1, 1, &x, NULL));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_calib_preset(STAD_PRESETS, 1, &x, NULL));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_calib_preset(0, 2, &x, NULL));
}

void test_calib_evaluation_that_does_not_fit_fails(void)
{
    static stad_calib c;
    static stad_evaluator e;
    stad_calib_config config;
    stad_request r;
    const stad_camera camera = {200 * 256, W * 128, H * 128};
    const stad_image good = stad_image_packed(pix, W, H, 1);
    stad_image bad[3] = {good, good, good};
    stad_setup s = some_setup();
    const size_t bytes = stad_calib_evaluate_bytes(&geometry);
    stad_geometry none = geometry;
    bad[0].width--;
    bad[1].height--;
    bad[2].channels = 3;
    none.width = 0;
    TEST_ASSERT_EQUAL(0, stad_calib_evaluate_bytes(&none));
    TEST_ASSERT_EQUAL(0, stad_calib_frame_bytes(8, 8));
    stad_calib_config_default(&config, &geometry, stad_target_relief(), &camera);
    config.min_block_size = 1;
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&c, &config, &s));
    memset(&r, 0, sizeof r);
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, bytes));
    r.want = STAD_WANT_MATCH;
    r.params = s.params;
    r.rig = s.rig;
    for (int i = 0; i < 3; i++) {
        TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &bad[i], &good, work, bytes));
        TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &bad[i], work, bytes));
    }
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, NULL, bytes));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, 7));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work + 1, bytes));
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, bytes)); /* an empty box */
    stad_box box = {0, 0, W, H};
    r.box = box;
    r.params.block_size = 2;
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, bytes));
    r.params.block_size = 3;
    r.rig.a_q16 = INT32_MAX;
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, bytes));
    stad_rig_identity(&r.rig, W, H); /* the truth is of another box: no pose was seen */
    TEST_ASSERT_EQUAL(STAD_COST_FAILED, stad_calib_evaluate(&c, &r, &e, &good, &good, work, bytes));
    stad_score_config sc;
    config.threshold_q16 = 0;
    stad_calib_score_config(&c, &r, &sc);
    TEST_ASSERT_EQUAL(16, sc.num_disparities);
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
    RUN_TEST(test_setup_rig_that_is_not_its_own_is_refused);
    RUN_TEST(test_store_slot_that_rots_between_two_reads_gives_the_other);
    RUN_TEST(test_store_twin_numbers_are_settled_one_way);
    RUN_TEST(test_store_that_cannot_read_back_says_so);
    RUN_TEST(test_truth_arguments_outside_are_refused);
    RUN_TEST(test_truth_boxes_and_rows_outside_are_refused);
    RUN_TEST(test_plane_slopes_beyond_one_are_refused);
    RUN_TEST(test_truth_of_any_marks_is_refused_or_sound);
    RUN_TEST(test_truth_cameras_outside_are_refused);
    RUN_TEST(test_calib_setups_of_another_geometry_are_refused);
    RUN_TEST(test_calib_presets_outside_are_refused);
    RUN_TEST(test_calib_evaluation_that_does_not_fit_fails);
    return UNITY_END();
}
