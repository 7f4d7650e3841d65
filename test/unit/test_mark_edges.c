/* SPDX-License-Identifier: MIT
 * unit/test_mark_edges.c - lines and edges of marks where there is little to hold on to: each step refuses by itself. */
#include <string.h>

#include "mark/mark_work.h"
#include "stad/config.h"
#include "unity.h"

enum { WIDTH = 240, HEIGHT = 240 };

static uint8_t pix[WIDTH * HEIGHT];
static uint8_t memory[STAD_MARK_BYTES(WIDTH, HEIGHT)] STAD_ALIGNED;
static mark_work work;

void setUp(void)
{
    memset(&work, 0, sizeof work);
    memset(pix, 200, sizeof pix);
    work.pix = pix;
    work.row_stride = WIDTH;
    work.pixel_stride = 1;
    work.width = WIDTH;
    work.height = HEIGHT;
}

void tearDown(void)
{
}

static stad_corner at(int x, int y)
{
    const stad_corner p = {x * 256, y * 256};
    return p;
}

/* Dark from row y on. */
static void darken_below(int y)
{
    memset(pix + (size_t)y * WIDTH, 40, sizeof pix - (size_t)y * WIDTH);
}

static void test_mark_unit_of_long_vectors_has_length_one(void)
{
    const int64_t far = (int64_t)1 << 40;
    const int64_t x[4] = {far, -far, 0, 0}, y[4] = {0, 0, far, -far};
    for (int i = 0; i < 4; i++) {
        int32_t ux, uy;
        TEST_ASSERT_EQUAL(INT32_MAX, stad_mark_unit_q14(x[i], y[i], &ux, &uy));
        TEST_ASSERT_EQUAL(x[i] > 0 ? 16384 : x[i] < 0 ? -16384 : 0, ux);
        TEST_ASSERT_EQUAL(y[i] > 0 ? 16384 : y[i] < 0 ? -16384 : 0, uy);
    }
}

static void test_mark_line_through_two_points_is_none(void)
{
    mark_moments m;
    mark_line line;
    stad_mark_moments_first(&m, at(0, 0));
    stad_mark_moments_add(&m, 0, 0);
    stad_mark_moments_add(&m, 256, 0);
    TEST_ASSERT_EQUAL(0, stad_mark_line_fit(&m, &line));
    stad_mark_moments_add(&m, 512, 0);
    TEST_ASSERT_EQUAL(1, stad_mark_line_fit(&m, &line));
    TEST_ASSERT_EQUAL(0, stad_mark_line_distance_q8(&line, 9999, 0));
}

static void test_mark_side_of_two_cracks_is_none(void)
{
    mark_point contour[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mark_line line;
    work.contour = contour;
    work.contour_count = 4;
    TEST_ASSERT_EQUAL(0, stad_mark_side(&work, 0, 2, &line));
}

static void test_mark_edge_of_a_flat_image_is_lost(void)
{
    mark_line line;
    TEST_ASSERT_EQUAL(0, stad_mark_edge_line(&work, at(40, 80), at(120, 80), MARK_MAX_REACH, &line));
}

static void test_mark_edge_along_less_than_half_of_the_side_is_lost(void)
{
    mark_line line;
    darken_below(80);
    TEST_ASSERT_EQUAL(1, stad_mark_edge_line(&work, at(40, 80), at(120, 80), MARK_MAX_REACH, &line));
    TEST_ASSERT_INT_WITHIN(64, 80 * 256 - 128, line.p.y_q8); /* between the rows 79 and 80 */
    for (int y = 80; y < HEIGHT; y++)
        memset(pix + y * WIDTH + 70, 200, 90);
    TEST_ASSERT_EQUAL(0, stad_mark_edge_line(&work, at(40, 80), at(120, 80), MARK_MAX_REACH, &line));
}

/* Normals an edge apart by nothing meet it in one point. */
static void test_mark_edge_without_extent_is_none(void)
{
    const stad_corner a = at(100, 80), b = {a.x_q8 + 1, a.y_q8};
    mark_line line;
    darken_below(80);
    TEST_ASSERT_EQUAL(0, stad_mark_edge_line(&work, a, b, MARK_MAX_REACH, &line));
}

static void test_mark_refine_without_edges_refuses(void)
{
    mark_quad quad = {{at(40, 40), at(120, 40), at(120, 120), at(40, 120)}};
    TEST_ASSERT_EQUAL(0, stad_mark_refine(&work, &quad));
}

/* A triangle with a point halfway along one side taken for a corner: both lines there are one. */
static void test_mark_refine_of_sides_in_one_line_refuses(void)
{
    mark_quad quad = {{at(40, 60), at(110, 60), at(180, 60), at(110, 200)}};
    for (int y = 60; y < 200; y++) {
        const int half = (200 - y) / 2;
        memset(pix + y * WIDTH + 110 - half, 40, (size_t)(2 * half));
    }
    TEST_ASSERT_EQUAL(0, stad_mark_refine(&work, &quad));
}

/* -- a mark drawn in cells of 18 px, its contrast and its blur to be chosen ------------------------------------------------ */

static void draw_mark(int id, int black, int white)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int row = y / 18 - 2, column = x / 18 - 2;
            pix[y * WIDTH + x] = (uint8_t)(stad_mark_cell(id, row, column) ? white : black);
        }
}

/* The mean of `width` pixels along rows, then along columns. */
static void blur(int width)
{
    static uint8_t was[WIDTH * HEIGHT];
    for (int pass = 0; pass < 2; pass++) {
        const int step = pass == 0 ? 1 : WIDTH;
        memcpy(was, pix, sizeof was);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int place = pass == 0 ? x : y, end = pass == 0 ? WIDTH : HEIGHT;
                int sum = 0;
                for (int k = place - width / 2; k <= place + width / 2; k++)
                    sum += was[y * WIDTH + x + ((k < 0 ? 0 : k >= end ? end - 1 : k) - place) * step];
                pix[y * WIDTH + x] = (uint8_t)(sum / width);
            }
    }
}

static int find(stad_mark *mark, int least_contrast)
{
    const stad_image image = stad_image_packed(pix, WIDTH, HEIGHT, 1);
    stad_mark_config config;
    stad_mark_config_default(&config);
    config.min_contrast = (uint8_t)least_contrast;
    return stad_mark_find(&image, &config, mark, 1, memory, sizeof memory);
}

static void test_mark_in_cells_is_found_where_it_was_drawn(void)
{
    stad_mark mark;
    draw_mark(5, 30, 210);
    TEST_ASSERT_EQUAL(1, find(&mark, 20));
    TEST_ASSERT_EQUAL(5, mark.id);
    TEST_ASSERT_INT_WITHIN(32, 36 * 256 - 128, mark.corner[0].x_q8);
    TEST_ASSERT_INT_WITHIN(32, 180 * 256 - 128, mark.corner[2].y_q8);
}

/* It reads, but its edges rise by less than a grey level a pixel: no corner to rely on. */
static void test_mark_that_reads_but_has_no_edge_is_not_told(void)
{
    stad_mark mark;
    draw_mark(5, 100, 160);
    blur(17);
    TEST_ASSERT_EQUAL(1, find(&mark, 8));
    draw_mark(5, 100, 118);
    blur(17);
    TEST_ASSERT_EQUAL(0, find(&mark, 8));
}

/* A blot on the middle of cells of the white ring, which leaves the black one's edge alone. */
static void blot(int cells)
{
    for (int k = 0; k < cells; k++)
        for (int y = 3; y < 15; y++)
            memset(pix + (18 + y) * WIDTH + 36 + 36 * k + 3, 30, 12);
}

static void test_mark_with_five_blots_around_it_is_none(void)
{
    stad_mark mark;
    for (int cells = 0; cells <= 5; cells++) {
        draw_mark(5, 30, 210);
        blot(cells < 5 ? cells : 4);
        if (cells == 5)
            for (int y = 3; y < 15; y++)
                memset(pix + (180 + y) * WIDTH + 36 + 3, 30, 12);
        TEST_ASSERT_EQUAL(cells <= 4, find(&mark, 20));
    }
}

/* The border of the image cuts it off; so does the last row, where a component never ends. */
static void test_mark_at_the_border_is_not_told(void)
{
    stad_mark mark;
    static uint8_t whole[WIDTH * HEIGHT];
    draw_mark(5, 30, 210);
    memcpy(whole, pix, sizeof whole);
    const int shift[4][2] = {{36, 0}, {-60, 0}, {0, 36}, {0, -60}};
    for (int i = 0; i < 4; i++) {
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int from_x = x + shift[i][0], from_y = y + shift[i][1];
                const int inside = from_x >= 0 && from_x < WIDTH && from_y >= 0 && from_y < HEIGHT;
                pix[y * WIDTH + x] = inside ? whole[from_y * WIDTH + from_x] : 210;
            }
        TEST_ASSERT_EQUAL(0, find(&mark, 20));
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_mark_unit_of_long_vectors_has_length_one);
    RUN_TEST(test_mark_line_through_two_points_is_none);
    RUN_TEST(test_mark_side_of_two_cracks_is_none);
    RUN_TEST(test_mark_edge_of_a_flat_image_is_lost);
    RUN_TEST(test_mark_edge_along_less_than_half_of_the_side_is_lost);
    RUN_TEST(test_mark_edge_without_extent_is_none);
    RUN_TEST(test_mark_refine_without_edges_refuses);
    RUN_TEST(test_mark_refine_of_sides_in_one_line_refuses);
    RUN_TEST(test_mark_in_cells_is_found_where_it_was_drawn);
    RUN_TEST(test_mark_that_reads_but_has_no_edge_is_not_told);
    RUN_TEST(test_mark_with_five_blots_around_it_is_none);
    RUN_TEST(test_mark_at_the_border_is_not_told);
    return UNITY_END();
}
