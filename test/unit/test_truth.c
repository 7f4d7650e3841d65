/* SPDX-License-Identifier: MIT
 * unit/test_truth.c - planes, masks and hidden pixels against geometry worked out another way, and against rendered truth. */
#include "unity.h"

#include "mark_case.h"

#include "truth/polygon.h"

static char message[200];

void setUp(void)
{
}

void tearDown(void)
{
}

static stad_polygon box_of(int x0, int y0, int x1, int y1)
{
    const stad_polygon p = {4, {{x0 * 256, y0 * 256}, {x1 * 256, y0 * 256}, {x1 * 256, y1 * 256}, {x0 * 256, y1 * 256}}};
    return p;
}

static stad_plane plane_of(double a, double b, double c)
{
    const stad_plane p = {(int32_t)lround(a * 65536), (int32_t)lround(b * 65536), (int32_t)lround(c * 65536)};
    return p;
}

/* Four marks of 30 px in the corners of a 200 x 150 area, on the plane d = a x + b y + c. */
static void plane_pairs(stad_pair *pairs, double a, double b, double c)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            const double x = 90 + 160 * (i % 2) + 30 * (k == 1 || k == 2), y = 40 + 120 * (i / 2) + 30 * (k >= 2);
            pairs[i].id = (int16_t)i;
            pairs[i].left[k].x_q8 = (int32_t)lround(x * 256);
            pairs[i].left[k].y_q8 = pairs[i].right[k].y_q8 = (int32_t)lround(y * 256);
            pairs[i].right[k].x_q8 = (int32_t)lround((x - (a * x + b * y + c)) * 256);
        }
}

static void test_truth_plane_of_ideal_corners_recovered(void)
{
    static const double planes[][3] = {{0, 0, 20}, {0.1, 0, 10}, {0, 0.12, 5}, {-0.3, 0.2, 90}, {0.45, -0.4, 60}};
    for (unsigned i = 0; i < 5; i++) {
        stad_pair pairs[4];
        stad_plane plane;
        stad_plane_report report;
        plane_pairs(pairs, planes[i][0], planes[i][1], planes[i][2]);
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_plane_fit(&plane, &report, pairs, 4));
        TEST_ASSERT_EQUAL_INT(16, report.corners);
        TEST_ASSERT_EQUAL_INT(-1, report.dropped);
        for (int y = 0; y < 240; y += 60)
            for (int x = 0; x < 320; x += 80) {
                const double expected = planes[i][0] * x + planes[i][1] * y + planes[i][2];
                const double got = (plane.a_q16 * (double)x + plane.b_q16 * (double)y + plane.c_q16) / 65536;
                snprintf(message, sizeof message, "plane %u at %d %d: %.4f, not %.4f", i, x, y, got, expected);
                TEST_ASSERT_TRUE_MESSAGE(fabs(got - expected) < 0.02, message);
            }
    }
}

static void test_truth_worst_mark_dropped_once_then_refused(void)
{
    for (int bad = 0; bad < 4; bad++) {
        stad_pair pairs[4];
        stad_plane plane;
        stad_plane_report report;
        plane_pairs(pairs, 0.05, 0.1, 12);
        for (int k = 0; k < 4; k++)
            pairs[bad].right[k].x_q8 += 3 * 256;
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_plane_fit(&plane, &report, pairs, 4));
        TEST_ASSERT_EQUAL_INT(bad, report.dropped);
        TEST_ASSERT_EQUAL_INT(12, report.corners);
        TEST_ASSERT_INT_WITHIN(40, 3277, plane.a_q16);
        pairs[(bad + 1) % 4].right[0].x_q8 += 5 * 256;
        TEST_ASSERT_EQUAL_INT(STAD_E_NO_MARK, stad_plane_fit(&plane, &report, pairs, 4));
    }
}

static void test_truth_too_few_marks_or_too_steep_refused(void)
{
    stad_pair pairs[4];
    stad_plane plane;
    plane_pairs(pairs, 0.05, 0.1, 12);
    TEST_ASSERT_EQUAL_INT(STAD_E_NO_MARK, stad_plane_fit(&plane, NULL, pairs, 1));
    TEST_ASSERT_EQUAL_INT(STAD_E_NO_MARK, stad_plane_fit(&plane, NULL, pairs, 0));
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_plane_fit(&plane, NULL, pairs, 2));
    plane_pairs(pairs, 1.2, 0, 12);
    TEST_ASSERT_EQUAL_INT(STAD_E_RIG, stad_plane_fit(&plane, NULL, pairs, 4));
}

/* Two planes: the nearer wins where they overlap, and hides a strip of the farther one to its left. */
static void test_truth_near_plane_wins_and_hides_a_strip(void)
{
    enum { W = 200 };
    int32_t truth[W];
    uint8_t label[W];
    const stad_plane far = plane_of(0, 0, 10), near = plane_of(0, 0, 25);
    const stad_polygon all = box_of(-10, -10, 300, 100), part = box_of(100, 10, 140, 50);
    for (int order = 0; order < 2; order++) {
        stad_truth t;
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_init(&t, W, 60, 0, 32, 0));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_add_plane(&t, order ? &near : &far, order ? &part : &all));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_add_plane(&t, order ? &far : &near, order ? &all : &part));
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_row(&t, 30, W, truth, label));
        for (int x = 0; x < W; x++) {
            /* Right position x - 10 is covered by 100 - 25 .. 140 - 25 of the near plane: x in 85 .. 125, minus 100 ... */
            const int on_part = x >= 100 && x <= 140, hidden = x >= 85 && x < 100;
            const int expected = x < 32 ? STAD_LABEL_IGNORED : hidden ? STAD_LABEL_OCCLUDED : STAD_LABEL_VISIBLE;
            snprintf(message, sizeof message, "order %d x %d", order, x);
            TEST_ASSERT_EQUAL_INT_MESSAGE(expected, label[x], message);
            if (expected != STAD_LABEL_IGNORED)
                TEST_ASSERT_EQUAL_INT_MESSAGE((on_part ? 25 : 10) * 65536, truth[x], message);
        }
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_row(&t, 55, W, truth, label));
        TEST_ASSERT_EQUAL_INT(STAD_LABEL_VISIBLE, label[90]);
        TEST_ASSERT_EQUAL_INT(10 * 65536, truth[120]);
    }
}

static void test_truth_mask_covers_only_what_was_before(void)
{
    enum { W = 200 };
    int32_t truth[W];
    uint8_t label[W];
    stad_truth t;
    const stad_plane far = plane_of(0, 0, 10), on_top = plane_of(0, 0, 5);
    const stad_polygon all = box_of(0, 0, 199, 59), hole = box_of(100, 0, 140, 59), island = box_of(110, 0, 120, 59);
    stad_truth_init(&t, W, 60, 0, 16, 1);
    stad_truth_add_plane(&t, &far, &all);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_add_mask(&t, &hole));
    stad_truth_add_plane(&t, &on_top, &island);
    stad_truth_row(&t, 30, W, truth, label);
    for (int x = 16; x < 198; x++) {
        int expected = x >= 99 && x <= 141 ? STAD_LABEL_IGNORED : STAD_LABEL_VISIBLE;
        if (x >= 111 && x <= 119)
            expected = STAD_LABEL_OCCLUDED; /* farther than the plane behind it: hidden by that plane in the right view */
        snprintf(message, sizeof message, "x %d", x);
        TEST_ASSERT_EQUAL_INT_MESSAGE(expected, label[x], message);
    }
}

static void test_truth_columns_without_full_range_not_scored(void)
{
    static const int ranges[][2] = {{0, 16}, {5, 32}, {-20, 16}, {-8, 24}};
    int32_t truth[100];
    uint8_t label[100];
    for (unsigned i = 0; i < 4; i++) {
        stad_truth t;
        const stad_plane plane = plane_of(0, 0, 0.5);
        const stad_polygon all = box_of(-50, -50, 150, 150);
        stad_truth_init(&t, 100, 60, ranges[i][0], ranges[i][1], 0);
        stad_truth_add_plane(&t, &plane, &all);
        stad_truth_row(&t, 3, 100, truth, label);
        const int first = ranges[i][0] + ranges[i][1] > 0 ? ranges[i][0] + ranges[i][1] : 0;
        const int last = ranges[i][0] < 0 ? 99 + ranges[i][0] : 99;
        for (int x = 0; x < 100; x++)
            TEST_ASSERT_EQUAL_INT(x >= first && x <= last, label[x] != STAD_LABEL_IGNORED);
        TEST_ASSERT_EQUAL_INT(60 * (last - first + 1), stad_truth_pixels(&t));
    }
}

static void test_truth_crop_gives_the_rows_of_the_frame(void)
{
    int32_t truth[CASE_WIDTH], cropped[CASE_WIDTH];
    uint8_t label[CASE_WIDTH], cropped_label[CASE_WIDTH];
    const mark_case c = case_of(2);
    const stad_camera camera = target_camera_fixed(&c.camera);
    stad_pair pairs[32];
    stad_truth t, crop;
    case_render(&c);
    const int n = case_pairs(pairs, 32);
    stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
    TEST_ASSERT_TRUE(stad_truth_from_target(&t, c.target, pairs, n, &camera) > 0);
    const stad_box box = stad_truth_box(&t);
    crop = t;
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_crop(&crop, &box));
    for (int y = 0; y < CASE_HEIGHT; y++) {
        stad_truth_row(&t, y, CASE_WIDTH, truth, label);
        const int inside = y >= box.y && y < box.y + box.height;
        if (inside)
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_row(&crop, y - box.y, box.width, cropped, cropped_label));
        for (int x = 0; x < CASE_WIDTH; x++) {
            const int k = x - box.x;
            const int here = inside && k >= 0 && k < box.width ? cropped_label[k] : STAD_LABEL_IGNORED;
            snprintf(message, sizeof message, "x %d y %d", x, y);
            TEST_ASSERT_EQUAL_INT_MESSAGE(label[x], here, message);
            if (here != STAD_LABEL_IGNORED)
                TEST_ASSERT_EQUAL_INT_MESSAGE(truth[x], cropped[k], message);
        }
    }
    const stad_box outside = {0, 0, CASE_WIDTH + 1, 10};
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_crop(&crop, &outside));
}

/* The whole way: rendered frames, detector, truth of base and relief, against the renderer's rays. */
static void test_truth_rendered_relief_within_a_sixteenth(void)
{
    static float exact[CASE_PIXELS];
    static uint8_t exact_label[CASE_PIXELS], which[CASE_PIXELS];
    int32_t truth[CASE_WIDTH];
    uint8_t label[CASE_WIDTH];
    for (unsigned seed = 21; seed <= 25; seed++) {
        const mark_case c = case_of(seed);
        const stad_camera camera = target_camera_fixed(&c.camera);
        stad_pair pairs[32];
        stad_truth t;
        int scored = 0, off = 0, seen_wrong = 0, outside = 0;
        case_render(&c);
        target_truth(&case_scene, &c.camera, exact, exact_label, which);
        const int n = case_pairs(pairs, 32);
        stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
        snprintf(message, sizeof message, "seed %u: %d pairs", seed, n);
        TEST_ASSERT_TRUE_MESSAGE(stad_truth_from_target(&t, c.target, pairs, n, &camera) >= 7, message);
        for (int y = 0; y < CASE_HEIGHT; y++) {
            stad_truth_row(&t, y, CASE_WIDTH, truth, label);
            for (int x = 0; x < CASE_WIDTH; x++) {
                const int k = y * CASE_WIDTH + x;
                if (label[x] == STAD_LABEL_IGNORED)
                    continue;
                scored++;
                outside += !which[k];
                off += !(fabs(truth[x] / 65536.0 - (double)exact[k]) <= 1 / 16.0);
                seen_wrong += label[x] != exact_label[k];
            }
        }
        snprintf(message, sizeof message, "seed %u: %d scored, %d off, %d labels wrong, %d outside", seed, scored, off,
                 seen_wrong, outside);
        TEST_ASSERT_TRUE_MESSAGE(scored > 8000, message);
        TEST_ASSERT_TRUE_MESSAGE(off * 20 <= scored, message);
        TEST_ASSERT_TRUE_MESSAGE(seen_wrong * 500 <= scored && outside * 500 <= scored, message);
    }
}

static void test_truth_flat_card_needs_no_camera(void)
{
    mark_case c = case_of(7);
    stad_pair pairs[32];
    stad_truth t;
    c.target = stad_target_card();
    c.pose.centre.z = 480;
    case_render(&c);
    const int n = case_pairs(pairs, 32);
    TEST_ASSERT_EQUAL_INT(2, n);
    stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
    TEST_ASSERT_EQUAL_INT(1, stad_truth_from_target(&t, c.target, pairs, n, NULL));
    stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
    TEST_ASSERT_EQUAL_INT(STAD_E_NO_MARK, stad_truth_from_target(&t, c.target, pairs, 1, NULL));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_from_target(&t, stad_target_relief(), pairs, n, NULL));
}

/* A leaning sheet gives a wrong focal length or principal point away; one seen head on cannot. */
static void test_truth_wrong_camera_makes_no_sheet(void)
{
    static const double factors[] = {0.3, 0.5, 0.7, 1.4, 2.0, 5.0};
    stad_pair pairs[32];
    stad_truth t;
    for (unsigned seed = 31; seed <= 35; seed++) {
        mark_case c = case_of(seed);
        c.pose.pitch = 0.5;
        case_render(&c);
        const int n = case_pairs(pairs, 32);
        for (unsigned i = 0; i < 6; i++) {
            stad_camera camera = target_camera_fixed(&c.camera);
            camera.f_q8 = (int32_t)(camera.f_q8 * factors[i]);
            stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
            snprintf(message, sizeof message, "seed %u, focal length times %.1f", seed, factors[i]);
            TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_E_RIG, stad_truth_from_target(&t, c.target, pairs, n, &camera), message);
        }
        stad_camera aside = target_camera_fixed(&c.camera);
        aside.cx_q8 = aside.cy_q8 = 0;
        stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
        TEST_ASSERT_EQUAL_INT(STAD_E_RIG, stad_truth_from_target(&t, c.target, pairs, n, &aside));
        c.pose.pitch = c.pose.yaw = 0;
        case_render(&c);
        stad_camera camera = target_camera_fixed(&c.camera);
        camera.f_q8 *= 2;
        stad_truth_init(&t, CASE_WIDTH, CASE_HEIGHT, 0, 64, 1);
        TEST_ASSERT_GREATER_THAN(0, stad_truth_from_target(&t, c.target, pairs, case_pairs(pairs, 32), &camera));
    }
}

static void test_truth_bad_polygons_and_planes_refused(void)
{
    stad_truth t;
    const stad_plane plane = plane_of(0, 0, 10), steep = plane_of(1.0, 0, 0), deep = plane_of(0, 0, 2048);
    stad_polygon p = box_of(10, 10, 50, 50);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_init(&t, 15, 60, 0, 16, 0));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_init(&t, 100, 60, 0, 0, 0));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_init(&t, 100, 60, 0, 16, 17));
    stad_truth_init(&t, 100, 60, 0, 16, 0);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_add_plane(&t, &steep, &p));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_add_plane(&t, &deep, &p));
    p.count = 2;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_add_plane(&t, &plane, &p));
    p.count = 4;
    p.p[2].x_q8 = p.p[0].x_q8 + 256; /* dented */
    p.p[2].y_q8 = p.p[0].y_q8 + 256;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_add_plane(&t, &plane, &p));
    p = box_of(10, 10, 10 + 5000, 50);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_truth_add_mask(&t, &p));
    p = box_of(10, 10, 50, 50);
    for (int i = 0; i < STAD_TRUTH_LAYERS; i++)
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_truth_add_plane(&t, &plane, &p));
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_truth_add_plane(&t, &plane, &p));
}

static void test_truth_hull_holds_all_points(void)
{
    target_random r;
    target_random_seed(&r, 9);
    for (int n = 0; n < 300; n++) {
        stad_corner points[8], kept[8];
        stad_polygon hull;
        for (int i = 0; i < 8; i++) {
            points[i].x_q8 = (int32_t)(target_random_uniform(&r) * 9) * 256;
            points[i].y_q8 = (int32_t)(target_random_uniform(&r) * 9) * 256;
        }
        memcpy(kept, points, sizeof kept);
        if (!stad_polygon_hull(points, 8, &hull))
            continue;
        for (int i = 0; i < hull.count; i++)
            for (int k = 0; k < 8; k++) {
                snprintf(message, sizeof message, "case %d side %d of %d point %d", n, i, hull.count, k);
                TEST_ASSERT_TRUE_MESSAGE(stad_polygon_turn(hull.p[i], hull.p[(i + 1) % hull.count], kept[k]) >= 0, message);
            }
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_truth_plane_of_ideal_corners_recovered);
    RUN_TEST(test_truth_worst_mark_dropped_once_then_refused);
    RUN_TEST(test_truth_too_few_marks_or_too_steep_refused);
    RUN_TEST(test_truth_near_plane_wins_and_hides_a_strip);
    RUN_TEST(test_truth_mask_covers_only_what_was_before);
    RUN_TEST(test_truth_columns_without_full_range_not_scored);
    RUN_TEST(test_truth_crop_gives_the_rows_of_the_frame);
    RUN_TEST(test_truth_rendered_relief_within_a_sixteenth);
    RUN_TEST(test_truth_flat_card_needs_no_camera);
    RUN_TEST(test_truth_wrong_camera_makes_no_sheet);
    RUN_TEST(test_truth_bad_polygons_and_planes_refused);
    RUN_TEST(test_truth_hull_holds_all_points);
    return UNITY_END();
}
