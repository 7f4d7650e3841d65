/* SPDX-License-Identifier: MIT
 * unit/test_mark.c - the detector on rendered marks: who they are, where they are, and what is no mark. */
#include "unity.h"

#include "mark_case.h"

#include "mark/mark_line.h"

static char message[200];

void setUp(void)
{
}

void tearDown(void)
{
}

static void test_mark_bytes_function_equals_macro(void)
{
    static const int sizes[][2] = {{16, 16}, {17, 31}, {320, 240}, {321, 243}, {640, 480}, {2048, 2048}};
    for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        TEST_ASSERT_TRUE(STAD_MARK_BYTES(sizes[i][0], sizes[i][1]) == stad_mark_bytes(sizes[i][0], sizes[i][1]));
    TEST_ASSERT_TRUE(STAD_MARK_BYTES(320, 240) <= 28000);
    TEST_ASSERT_TRUE(STAD_MARK_BYTES(640, 480) <= 75000);
    TEST_ASSERT_TRUE(stad_mark_bytes(15, 16) == 0 && stad_mark_bytes(16, 2049) == 0);
}

/* Every mark of the scene, its corners in printed order within a quarter of a pixel, in both views. */
static void test_mark_rendered_target_found_with_corners(void)
{
    for (unsigned seed = 1; seed <= 6; seed++) {
        const mark_case c = case_of(seed);
        stad_pair pairs[32];
        case_render(&c);
        const int n = case_pairs(pairs, 32);
        snprintf(message, sizeof message, "seed %u", seed);
        TEST_ASSERT_EQUAL_INT_MESSAGE(4, n, message);
        for (int i = 0; i < n; i++)
            for (int k = 0; k < 8; k++) {
                double x, y;
                const stad_corner p = k < 4 ? pairs[i].left[k] : pairs[i].right[k - 4];
                case_corner(&c, pairs[i].id, k % 4, k / 4, &x, &y);
                snprintf(message, sizeof message, "seed %u mark %d corner %d: %.2f %.2f, not %.2f %.2f", seed, pairs[i].id, k,
                         p.x_q8 / 256.0, p.y_q8 / 256.0, x, y);
                TEST_ASSERT_TRUE_MESSAGE(fabs(p.x_q8 / 256.0 - x) < 0.25 && fabs(p.y_q8 / 256.0 - y) < 0.25, message);
            }
    }
}

/* Draws mark `id`, turned by quarters, with its surround, cells of `cell` px, at (x0, y0). */
static void draw_mark(uint8_t *pix, int id, int turn, int cell, int x0, int y0, uint64_t flip)
{
    for (int y = 0; y < 10 * cell; y++)
        for (int x = 0; x < 10 * cell; x++) {
            int row = y / cell - 1, column = x / cell - 1;
            for (int i = 0; i < turn; i++) {
                const int old = row;
                row = 7 - column;
                column = old;
            }
            int white = stad_mark_cell(id, row, column);
            if (row >= 1 && row <= 6 && column >= 1 && column <= 6)
                white ^= (int)(flip >> ((row - 1) * 6 + column - 1) & 1u);
            pix[(y0 + y) * CASE_WIDTH + x0 + x] = white ? 220 : 30;
        }
}

static void test_mark_every_identity_and_turn_decoded(void)
{
    for (int id = 0; id < STAD_MARK_IDS; id++) {
        memset(case_left, 128, sizeof case_left);
        for (int turn = 0; turn < 4; turn++)
            draw_mark(case_left, id, turn, 5, 10 + 70 * turn, 20 + 30 * turn, 0);
        stad_mark marks[8];
        TEST_ASSERT_EQUAL_INT(4, case_find(case_left, marks, 8));
        for (int i = 0; i < 4; i++) {
            TEST_ASSERT_EQUAL_INT(id, marks[i].id);
            TEST_ASSERT_EQUAL_INT(0, marks[i].hamming);
            /* Turned clockwise by `turn` quarters, the printed top left corner is `turn` corners on. */
            const int turn = (marks[i].corner[0].x_q8 / 256 - 10) / 70, at = (4 - turn) % 4;
            const int x = 10 + 70 * turn + 5, y = 20 + 30 * turn + 5;
            TEST_ASSERT_INT_WITHIN(100, x * 256 - 128, marks[i].corner[at].x_q8);
            TEST_ASSERT_INT_WITHIN(100, y * 256 - 128, marks[i].corner[at].y_q8);
        }
    }
}

static void test_mark_wrong_bits_corrected_up_to_the_limit(void)
{
    static const uint64_t flips[] = {0, 1u << 7, 1u << 7 | 1u << 28, 1u << 7 | 1u << 28 | 1u << 14};
    for (int wrong = 0; wrong < 4; wrong++)
        for (uint8_t limit = 0; limit <= 2; limit++) {
            stad_mark marks[4];
            stad_mark_config config;
            stad_mark_config_default(&config);
            config.max_hamming = limit;
            memset(case_left, 128, sizeof case_left);
            draw_mark(case_left, 9, 0, 6, 50, 50, flips[wrong]);
            const stad_image image = stad_image_packed(case_left, CASE_WIDTH, CASE_HEIGHT, 1);
            const int found = stad_mark_find(&image, &config, marks, 4, case_work, sizeof case_work);
            TEST_ASSERT_EQUAL_INT(wrong <= limit, found);
            if (found)
                TEST_ASSERT_EQUAL_INT(wrong, marks[0].hamming);
        }
}

static void test_mark_unwanted_identity_left_out(void)
{
    stad_mark marks[4];
    stad_mark_config config;
    stad_mark_config_default(&config);
    memset(case_left, 128, sizeof case_left);
    draw_mark(case_left, 3, 0, 5, 20, 20, 0);
    draw_mark(case_left, 4, 0, 5, 120, 20, 0);
    config.ids = 1u << 4;
    const stad_image image = stad_image_packed(case_left, CASE_WIDTH, CASE_HEIGHT, 1);
    TEST_ASSERT_EQUAL_INT(1, stad_mark_find(&image, &config, marks, 4, case_work, sizeof case_work));
    TEST_ASSERT_EQUAL_INT(4, marks[0].id);
}

static void test_mark_strides_and_channels_give_the_same(void)
{
    static uint8_t colour[CASE_PIXELS * 3 + 64];
    const mark_case c = case_of(3);
    stad_mark plain[32], strided[32];
    case_render(&c);
    const int n = case_find(case_left, plain, 32);
    memset(colour, 77, sizeof colour);
    for (int y = 0; y < CASE_HEIGHT; y++) /* bottom up, luma in the middle */
        for (int x = 0; x < CASE_WIDTH; x++)
            colour[((CASE_HEIGHT - 1 - y) * CASE_WIDTH + x) * 3 + 1] = case_left[y * CASE_WIDTH + x];
    const stad_image image = {colour + (CASE_HEIGHT - 1) * CASE_WIDTH * 3, CASE_WIDTH, CASE_HEIGHT, 3, 3, -3 * CASE_WIDTH};
    TEST_ASSERT_TRUE(n > 0);
    TEST_ASSERT_EQUAL_INT(n, stad_mark_find(&image, NULL, strided, 32, case_work, sizeof case_work));
    TEST_ASSERT_EQUAL_MEMORY(plain, strided, sizeof plain[0] * (size_t)n);
}

/* The workspace is not trusted, and nothing is written beside it. */
static void test_mark_dirty_workspace_same_marks_nothing_beside(void)
{
    enum { BYTES = STAD_MARK_BYTES(CASE_WIDTH, CASE_HEIGHT), GUARD = 64 };
    static uint8_t guarded[BYTES + 2 * GUARD] STAD_ALIGNED;
    const mark_case c = case_of(4);
    const stad_image image = stad_image_packed(case_left, CASE_WIDTH, CASE_HEIGHT, 1);
    stad_mark plain[32], dirty[32];
    case_render(&c);
    const int n = case_find(case_left, plain, 32);
    memset(guarded, 0xA5, sizeof guarded);
    TEST_ASSERT_EQUAL_INT(n, stad_mark_find(&image, NULL, dirty, 32, guarded + GUARD, BYTES));
    TEST_ASSERT_EQUAL_MEMORY(plain, dirty, sizeof plain[0] * (size_t)n);
    TEST_ASSERT_EACH_EQUAL_HEX8(0xA5, guarded, GUARD);
    TEST_ASSERT_EACH_EQUAL_HEX8(0xA5, guarded + GUARD + BYTES, GUARD);
}

/* White noise makes the most runs and components there can be; odd sizes have tiles cut at two edges. */
static void test_mark_noise_of_odd_sizes_finds_nothing(void)
{
    static uint8_t noise[131 * 97];
    target_random r;
    target_random_seed(&r, 5);
    for (int width = 16; width <= 131; width += 23)
        for (int height = 16; height <= 97; height += 27)
            for (int kind = 0; kind < 3; kind++) {
                for (int i = 0; i < width * height; i++)
                    noise[i] = (uint8_t)(255 * (kind == 0   ? target_random_uniform(&r)
                                                : kind == 1 ? (i % width + i / width) % 2
                                                            : i % width % 2));
                const stad_image image = stad_image_packed(noise, width, height, 1);
                stad_mark marks[4];
                snprintf(message, sizeof message, "%d x %d kind %d", width, height, kind);
                TEST_ASSERT_EQUAL_INT_MESSAGE(
                    0, stad_mark_find(&image, NULL, marks, 4, case_work, stad_mark_bytes(width, height)), message);
            }
}

static void test_mark_flat_and_clutter_find_nothing(void)
{
    stad_mark marks[4];
    memset(case_left, 90, sizeof case_left);
    TEST_ASSERT_EQUAL_INT(0, case_find(case_left, marks, 4));
    for (unsigned seed = 1; seed <= 5; seed++) {
        mark_case c = case_of(seed);
        c.target = NULL;
        c.room = 40;
        case_render(&c);
        TEST_ASSERT_EQUAL_INT(0, case_find(case_left, marks, 4));
    }
}

static void test_mark_bad_arguments_refused(void)
{
    stad_mark marks[4];
    stad_mark_config config;
    stad_mark_config_default(&config);
    stad_image image = stad_image_packed(case_left, CASE_WIDTH, CASE_HEIGHT, 1);
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_mark_find(&image, NULL, marks, 4, case_work, sizeof case_work - 1));
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_mark_find(&image, NULL, marks, 4, case_work + 1, sizeof case_work));
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_mark_find(&image, NULL, marks, 4, NULL, sizeof case_work));
    config.max_hamming = 3;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_mark_find(&image, &config, marks, 4, case_work, sizeof case_work));
    image.channels = 2;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_mark_find(&image, NULL, marks, 4, case_work, sizeof case_work));
    image.channels = 1;
    image.width = 15;
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_mark_find(&image, NULL, marks, 4, case_work, sizeof case_work));
}

static void test_mark_room_for_one_writes_one(void)
{
    stad_mark marks[2];
    memset(case_left, 128, sizeof case_left);
    memset(marks, 0x5A, sizeof marks);
    draw_mark(case_left, 3, 0, 5, 20, 20, 0);
    draw_mark(case_left, 4, 0, 5, 120, 90, 0);
    TEST_ASSERT_EQUAL_INT(1, case_find(case_left, marks, 1));
    TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &marks[1], sizeof marks[1]);
}

static void test_mark_pair_ambiguous_identity_left_out(void)
{
    stad_mark left[3], right[3];
    stad_pair pairs[3];
    memset(left, 0, sizeof left);
    memset(right, 0, sizeof right);
    left[0].id = 5, left[1].id = 6, left[2].id = 7;
    right[0].id = 7, right[1].id = 6, right[2].id = 6;
    right[0].corner[2].x_q8 = 99;
    TEST_ASSERT_EQUAL_INT(1, stad_mark_pair(left, 3, right, 3, pairs, 3));
    TEST_ASSERT_EQUAL_INT(7, pairs[0].id);
    TEST_ASSERT_EQUAL_INT(99, pairs[0].right[2].x_q8);
    TEST_ASSERT_EQUAL_INT(0, stad_mark_pair(left, 3, right, 3, pairs, 0));
    TEST_ASSERT_EQUAL_INT(0, stad_mark_pair(left, 0, right, 3, pairs, 3));
}

static void test_mark_line_through_points_met_and_missed(void)
{
    mark_moments m;
    mark_line across, down, parallel;
    stad_corner p;
    const stad_corner origin = {0, 0};
    const int32_t reach = STAD_MARK_MAX_SIZE * 256;
    stad_mark_moments_first(&m, origin);
    for (int i = 0; i < 10; i++)
        stad_mark_moments_add(&m, i * 256, 512 + i * 64);
    TEST_ASSERT_TRUE(stad_mark_line_fit(&m, &across));
    stad_mark_moments_first(&m, origin);
    for (int i = 0; i < 10; i++)
        stad_mark_moments_add(&m, 1024, i * 256);
    TEST_ASSERT_TRUE(stad_mark_line_fit(&m, &down));
    TEST_ASSERT_TRUE(stad_mark_line_meet(&across, &down, reach, &p));
    TEST_ASSERT_INT_WITHIN(1, 1024, p.x_q8);
    TEST_ASSERT_INT_WITHIN(1, 768, p.y_q8);
    down.p.x_q8 += 2 * reach;
    TEST_ASSERT_FALSE(stad_mark_line_meet(&across, &down, reach, &p));
    down.p.x_q8 -= 4 * reach;
    TEST_ASSERT_FALSE(stad_mark_line_meet(&across, &down, reach, &p));
    down.p.x_q8 += 2 * reach;
    across.p.y_q8 += 2 * reach;
    TEST_ASSERT_FALSE(stad_mark_line_meet(&across, &down, reach, &p));
    across.p.y_q8 -= 4 * reach;
    TEST_ASSERT_FALSE(stad_mark_line_meet(&across, &down, reach, &p));
    parallel = across;
    parallel.p.y_q8 += 256;
    TEST_ASSERT_FALSE(stad_mark_line_meet(&across, &parallel, reach, &p));
    stad_mark_moments_first(&m, origin);
    for (int i = 0; i < 10; i++)
        stad_mark_moments_add(&m, 5, 5);
    TEST_ASSERT_FALSE(stad_mark_line_fit(&m, &across));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_mark_bytes_function_equals_macro);
    RUN_TEST(test_mark_rendered_target_found_with_corners);
    RUN_TEST(test_mark_every_identity_and_turn_decoded);
    RUN_TEST(test_mark_wrong_bits_corrected_up_to_the_limit);
    RUN_TEST(test_mark_unwanted_identity_left_out);
    RUN_TEST(test_mark_strides_and_channels_give_the_same);
    RUN_TEST(test_mark_dirty_workspace_same_marks_nothing_beside);
    RUN_TEST(test_mark_noise_of_odd_sizes_finds_nothing);
    RUN_TEST(test_mark_flat_and_clutter_find_nothing);
    RUN_TEST(test_mark_bad_arguments_refused);
    RUN_TEST(test_mark_room_for_one_writes_one);
    RUN_TEST(test_mark_pair_ambiguous_identity_left_out);
    RUN_TEST(test_mark_line_through_points_met_and_missed);
    return UNITY_END();
}
