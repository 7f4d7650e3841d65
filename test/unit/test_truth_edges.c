/* SPDX-License-Identifier: MIT
 * unit/test_truth_edges.c - targets partly behind the camera, out of range, or more than a truth can hold: told, never drawn. */
#include <string.h>

#include "stad/truth.h"
#include "truth/polygon.h"
#include "truth/sheet_pose.h"
#include "truth/truth_part.h"
#include "unity.h"

enum { W = 320, H = 240, ONE = 1 << 24 };

static stad_truth truth;
static sheet_pose pose;

/* A sheet that faces the camera, a pixel a millimetre, 20 px of disparity. P = ((x - cx) / d, (y - cy) / d, f / d). */
void setUp(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&truth, W, H, 0, 64, 1));
    memset(&pose, 0, sizeof pose);
    pose.camera.f_q8 = 200 * 256;
    pose.camera.cx_q8 = 160 * 256;
    pose.camera.cy_q8 = 120 * 256;
    pose.origin[2] = 10 * (int64_t)ONE;
    pose.along_x[0] = pose.along_y[1] = ONE / 20;
    pose.up[2] = -ONE / 20;
}

void tearDown(void)
{
}

static stad_target_facet facet_at(int x, int y, int h)
{
    const int16_t x0 = (int16_t)x, y0 = (int16_t)y, x1 = (int16_t)(x + 40), y1 = (int16_t)(y + 40), z = (int16_t)h;
    const stad_target_facet f = {0, {x0, x1, x1, x0}, {y0, y0, y1, y1}, {z, z, z, z}};
    return f;
}

static stad_target target_of(const stad_target_facet *facets, int count)
{
    const stad_target t = {"test", 100, 100, 48, 0, 1, (int16_t)count, NULL, NULL, facets};
    return t;
}

static void test_truth_point_in_front_is_seen_where_it_is(void)
{
    sheet_sight s;
    TEST_ASSERT_EQUAL(1, stad_sheet_see(&pose, 0, 0, 0, &s));
    TEST_ASSERT_EQUAL(160 * 256, s.p.x_q8);
    TEST_ASSERT_EQUAL(20 * 65536, s.d_q16);
    TEST_ASSERT_EQUAL(1, stad_sheet_see(&pose, 0, 0, 100, &s));
    TEST_ASSERT_INT_WITHIN(16, 40 * 65536, s.d_q16); /* a twentieth is no binary fraction */
}

static void test_truth_point_out_of_sight_is_not_seen(void)
{
    sheet_sight s;
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, 0, 0, 200, &s)); /* in the camera */
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, 32000, 0, 0, &s));
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, -32000, 0, 0, &s));
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, 0, 32000, 0, &s));
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, 0, -32000, 0, &s));
    pose.origin[2] = ONE / 20; /* 4000 px of disparity */
    TEST_ASSERT_EQUAL(0, stad_sheet_see(&pose, 0, 0, 0, &s));
}

static void test_truth_sheet_without_extent_has_no_pose(void)
{
    const stad_target_tag tags[2] = {{0, 0, 0}, {1, 100, 100}};
    const stad_target t = {"test", 200, 200, 48, 2, 0, 0, tags, NULL, NULL};
    const stad_plane base = {0, 0, 20 * 65536};
    stad_pair pairs[2];
    memset(pairs, 0, sizeof pairs);
    pairs[1].id = 1;
    TEST_ASSERT_EQUAL(0, stad_sheet_pose(&pose, &t, &pose.camera, &base, pairs, 2, 3));
}

static void test_truth_facet_behind_the_camera_is_told(void)
{
    stad_target_facet f = facet_at(0, 0, 10);
    TEST_ASSERT_EQUAL(1, stad_truth_add_facet(&truth, &pose, &f));
    f.h_mm[2] = 300;
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, stad_truth_add_facet(&truth, &pose, &f));
}

static void test_truth_facet_beyond_the_last_layer_is_told(void)
{
    const stad_target_facet f = facet_at(0, 0, 10);
    for (int i = 0; i < STAD_TRUTH_LAYERS; i++)
        TEST_ASSERT_EQUAL(1, stad_truth_add_facet(&truth, &pose, &f));
    TEST_ASSERT_EQUAL(STAD_E_LIMIT, stad_truth_add_facet(&truth, &pose, &f));
}

static void test_truth_outline_of_too_many_corners_is_told(void)
{
    const stad_target_facet f[2] = {facet_at(0, 0, 10), facet_at(40, 0, 10)};
    stad_target t = target_of(f, 2);
    TEST_ASSERT_EQUAL(STAD_E_LIMIT, stad_truth_add_outline(&truth, &pose, &t, 0));
    t.facet_count = 1;
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_outline(&truth, &pose, &t, 0));
}

static void test_truth_outline_out_of_sight_is_told(void)
{
    stad_target_facet f = facet_at(0, 0, 10);
    const stad_target t = target_of(&f, 1);
    f.h_mm[1] = 300;
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, stad_truth_add_outline(&truth, &pose, &t, 0));
    f = facet_at(0, 0, -1); /* its foot in the camera, its top before it */
    pose.origin[2] = 0;
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, stad_truth_add_outline(&truth, &pose, &t, 0));
}

static void test_truth_hull_of_too_many_corners_is_none(void)
{
    stad_corner p[12];
    stad_polygon hull;
    for (int i = 0; i < 12; i++) {
        p[i].x_q8 = i * 256;
        p[i].y_q8 = i * i * 64;
    }
    TEST_ASSERT_EQUAL(0, stad_polygon_hull(p, 12, &hull));
    for (int i = 0; i < 12; i++)
        p[i].y_q8 = -i * i * 64;
    TEST_ASSERT_EQUAL(0, stad_polygon_hull(p, 12, &hull));
    TEST_ASSERT_EQUAL(1, stad_polygon_hull(p, 6, &hull));
    TEST_ASSERT_EQUAL(6, hull.count);
}

static const stad_polygon narrow = {4, {{10 * 256, 50 * 256}, {40 * 256, 50 * 256}, {40 * 256, 90 * 256}, {10 * 256, 90 * 256}}};

/* Each corner is looked at before any two are subtracted. */
static void test_truth_corners_anywhere_are_refused(void)
{
    const stad_plane plane = {0, 0, 20 * 65536};
    const int32_t far[4] = {INT32_MIN, INT32_MAX, -4097 * 256, (4097 + W) * 256};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 8; k++) {
            stad_polygon p = narrow;
            *(k % 2 ? &p.p[k / 2].x_q8 : &p.p[k / 2].y_q8) = far[i];
            TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_plane(&truth, &plane, &p));
            TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_truth_add_mask(&truth, &p));
        }
}

static void test_truth_left_of_the_searched_columns_has_no_box(void)
{
    const stad_plane plane = {0, 0, 20 * 65536};
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&truth, &plane, &narrow));
    TEST_ASSERT_EQUAL(0, stad_truth_box(&truth).width);
}

static void test_truth_beyond_the_right_border_is_hidden(void)
{
    static int32_t row[W];
    static uint8_t label[W];
    const stad_plane plane = {0, 0, -6 * 65536};
    const stad_polygon right = {4, {{280 * 256, 50 * 256}, {319 * 256, 50 * 256}, {319 * 256, 90 * 256}, {280 * 256, 90 * 256}}};
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&truth, W, H, -4, 16, 0));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_add_plane(&truth, &plane, &right));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_row(&truth, 70, W, row, label));
    TEST_ASSERT_EQUAL(1, label[W - 1 - 6]);
    TEST_ASSERT_EQUAL(2, label[W - 1 - 5]); /* searched, but its counterpart is outside */
    TEST_ASSERT_EQUAL(0, label[W - 1]);
}

/* -- whole targets --------------------------------------------------------------------------------------------------------- */

static const stad_camera camera = {200 * 256, 160 * 256, 120 * 256};

/* The relief's marks as the sheet of setUp() shows them, a pixel a millimetre. */
static int relief_pairs(stad_pair *pairs)
{
    const stad_target *t = stad_target_relief();
    for (int i = 0; i < t->tag_count; i++)
        for (int k = 0; k < 4; k++) {
            pairs[i].id = t->tags[i].id;
            pairs[i].left[k].x_q8 = 256 * (50 + t->tags[i].x_mm + (k == 1 || k == 2 ? t->tag_mm : 0));
            pairs[i].left[k].y_q8 = 256 * (30 + t->tags[i].y_mm + (k >= 2 ? t->tag_mm : 0));
            pairs[i].right[k] = pairs[i].left[k];
            pairs[i].right[k].x_q8 -= 20 * 256;
        }
    return t->tag_count;
}

static int from(const stad_target *t)
{
    stad_pair pairs[8];
    int n = relief_pairs(pairs);
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&truth, W, H, 0, 64, 1));
    pairs[n] = pairs[0];
    pairs[n].id = 100; /* no mark of any target */
    return stad_truth_from_target(&truth, t, pairs, n + 1, &camera);
}

static void test_truth_that_no_column_can_score_has_no_pixels(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&truth, W, H, -2048, 16, 1)); /* columns end left of the image */
    TEST_ASSERT_EQUAL(0, stad_truth_pixels(&truth));
    TEST_ASSERT_EQUAL(STAD_OK, stad_truth_init(&truth, W, H, 2048, 16, 1)); /* begin right of it */
    TEST_ASSERT_EQUAL(0, stad_truth_pixels(&truth));
}

static void test_truth_of_the_relief_ignores_marks_of_no_target(void)
{
    TEST_ASSERT_GREATER_THAN(5, from(stad_target_relief()));
}

static void test_truth_of_too_many_parts_is_refused(void)
{
    stad_target t = *stad_target_relief();
    t.part_count = 33;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, from(&t));
}

static void test_truth_part_without_facets_is_told(void)
{
    stad_target t = *stad_target_relief();
    t.part_count = 7;
    TEST_ASSERT_EQUAL(STAD_E_LIMIT, from(&t));
}

static void test_truth_part_out_of_sight_is_told(void)
{
    stad_target t = *stad_target_relief();
    stad_target_facet far = facet_at(20000, 0, 10);
    t.part_count = t.facet_count = 1;
    t.facets = &far;
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, from(&t));
}

/* Four sights of a plane d = 40 + a x + b y over a square of 16 px. */
static int plane_of_slopes(int32_t a_q16, int32_t b_q16, stad_plane *plane)
{
    sheet_sight sight[4];
    for (int i = 0; i < 4; i++) {
        const int32_t x = i % 2 * 16, y = i / 2 * 16;
        sight[i].p.x_q8 = x * 256;
        sight[i].p.y_q8 = y * 256;
        sight[i].d_q16 = 40 * 65536 + a_q16 * x + b_q16 * y;
    }
    return stad_plane_through(sight, plane);
}

static void test_truth_plane_through_sights_too_steep_either_way_is_none(void)
{
    stad_plane plane;
    TEST_ASSERT_TRUE(plane_of_slopes(32768, -16384, &plane));
    TEST_ASSERT_INT_WITHIN(64, 32768, plane.a_q16);
    TEST_ASSERT_INT_WITHIN(64, -16384, plane.b_q16);
    TEST_ASSERT_FALSE(plane_of_slopes(80000, 0, &plane));
    TEST_ASSERT_FALSE(plane_of_slopes(-80000, 0, &plane));
    TEST_ASSERT_FALSE(plane_of_slopes(0, 80000, &plane));
    TEST_ASSERT_FALSE(plane_of_slopes(0, -80000, &plane));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_truth_point_in_front_is_seen_where_it_is);
    RUN_TEST(test_truth_point_out_of_sight_is_not_seen);
    RUN_TEST(test_truth_sheet_without_extent_has_no_pose);
    RUN_TEST(test_truth_facet_behind_the_camera_is_told);
    RUN_TEST(test_truth_facet_beyond_the_last_layer_is_told);
    RUN_TEST(test_truth_outline_of_too_many_corners_is_told);
    RUN_TEST(test_truth_outline_out_of_sight_is_told);
    RUN_TEST(test_truth_hull_of_too_many_corners_is_none);
    RUN_TEST(test_truth_corners_anywhere_are_refused);
    RUN_TEST(test_truth_left_of_the_searched_columns_has_no_box);
    RUN_TEST(test_truth_beyond_the_right_border_is_hidden);
    RUN_TEST(test_truth_that_no_column_can_score_has_no_pixels);
    RUN_TEST(test_truth_of_the_relief_ignores_marks_of_no_target);
    RUN_TEST(test_truth_of_too_many_parts_is_refused);
    RUN_TEST(test_truth_part_without_facets_is_told);
    RUN_TEST(test_truth_part_out_of_sight_is_told);
    RUN_TEST(test_truth_plane_through_sights_too_steep_either_way_is_none);
    return UNITY_END();
}
