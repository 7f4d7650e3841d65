/* SPDX-License-Identifier: MIT
 * test_domain_loop.c - every bound of store, truths and the loop, from both sides: one value inside, one outside. */
#include <string.h>

#include "support/flash_sim.h"
#include "support/pair_at.h"
#include "stad/stad.h"
#include "unity.h"

enum { W = 48, H = 20 };

static uint8_t work[200000] STAD_ALIGNED;
static uint8_t pix[W * H * 3];

void setUp(void)
{
}

void tearDown(void)
{
}

static const stad_geometry geometry = {W, H, 1, 16, 3, 100, 63, STAD_MODE_SGBM, STAD_MEMORY_FAST};

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

void test_store_slot_that_rots_before_its_reading_gives_the_other(void)
{
    stad_flash f;
    stad_setup found;
    for (int reads = 0; reads < 3; reads++) { /* B is read second, and once: what rots later was sound when it was read */
        two_records(&f, 1, 2);
        reads_left = reads;
        then_flip = 1;
        TEST_ASSERT_EQUAL(reads < 2 ? STAD_SLOT_A : STAD_SLOT_B, stad_store_load(&f, &found));
        TEST_ASSERT_EQUAL(reads < 2 ? 0 : 7, found.params.uniqueness_ratio);
    }
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
    const int bad[][5] = {{2049, H, 0, 16, 1}, {W, 15, 0, 16, 1},  {W, 2049, 0, 16, 1}, {W, H, -2049, 16, 1}, {W, H, 2049, 16, 1},
                          {W, H, 0, 0, 1},     {W, H, 0, 2049, 1}, {W, H, 0, 16, -1},   {W, H, 0, 16, 17}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_init(&t, bad[i][0], bad[i][1], bad[i][2], bad[i][3], bad[i][4]));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&t, W, H, 0, 16, 1));
    const stad_plane flat = {0, 0, 65536};
    const stad_plane steep[] = {{65536, 0, 0},  {-65536, 0, 0},     {0, 65536, 0},
                                {0, -65536, 0}, {0, 0, 2048 << 16}, {0, 0, -(2048 << 16)}};
    stad_polygon p = square(5, 5, 40, 15);
    for (size_t i = 0; i < sizeof steep / sizeof steep[0]; i++)
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_plane(&t, &steep[i], &p));
    const stad_polygon far[] = {square(-4097, 5, 40, 15), square(5, 5, W + 4097, 15), square(5, -4097, 40, 15),
                                square(5, 5, 40, H + 4097)};
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
            pairs[i] = pair_at(trial % 3 ? i : 4 + i % 2, 20 + (i == 1 || i == 2) * (60 + dice[4] % 160),
                               10 + (i >= 2) * (60 + dice[5] % 120), side);
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
        int status =
            stad_truth_from_target(&t, trial % 3 ? stad_target_relief() : stad_target_card(), pairs, 2 + trial % 3, &camera);
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
    const stad_camera bad[] = {{16 * 256 - 1, 0, 0}, {most, 0, 0},          {200 * 256, most, 0},
                               {200 * 256, 0, most}, {200 * 256, -most, 0}, {200 * 256, 0, -most}};
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
    RUN_TEST(test_setup_rig_that_is_not_its_own_is_refused);
    RUN_TEST(test_store_slot_that_rots_before_its_reading_gives_the_other);
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
