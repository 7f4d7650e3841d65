/* SPDX-License-Identifier: MIT
 * unit/test_rig.c - drifts that are known, found from marks, judged, undone in positions and in pixels. */
#include "unity.h"

#include "mark_case.h"

static char message[200];

void setUp(void)
{
}

void tearDown(void)
{
}

/* Pairs on a grid over a w x h image whose right corners are displaced by the model exactly. */
static int ideal_pairs(stad_pair *pairs, int w, int h, double a, double b, double c)
{
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 4; k++) {
            const double x = w * (0.2 + 0.3 * (i % 3)) + 20 * (k % 2), y = h * (0.2 + 0.5 * (i / 3)) + 20 * (k / 2);
            const double xr = x - 12, dx = xr - w / 2, dy = y - h / 2;
            pairs[i].id = (int16_t)i;
            pairs[i].left[k].x_q8 = (int32_t)lround(x * 256);
            pairs[i].left[k].y_q8 = (int32_t)lround(y * 256);
            pairs[i].right[k].x_q8 = (int32_t)lround((xr + c * dx - b * dy) * 256);
            pairs[i].right[k].y_q8 = (int32_t)lround((y + a + b * dx + c * dy) * 256);
        }
    return 6;
}

static void test_rig_ideal_drift_recovered(void)
{
    static const double drifts[][3] = {{0, 0, 0},     {0.5, 0, 0},   {-4, 0, 0},        {0, 0.0175, 0},       {0, -0.005, 0},
                                       {0, 0, 0.004}, {0, 0, -0.01}, {2, 0.01, -0.004}, {-1.5, -0.008, 0.006}};
    for (unsigned i = 0; i < sizeof drifts / sizeof drifts[0]; i++) {
        stad_pair pairs[8];
        stad_rig rig;
        stad_rig_report report;
        const int n = ideal_pairs(pairs, 640, 480, drifts[i][0], drifts[i][1], drifts[i][2]);
        TEST_ASSERT_TRUE(stad_rig_fit(&rig, &report, pairs, n, 640, 480) >= 0);
        snprintf(message, sizeof message, "case %u: %.4f %.5f %.5f", i, rig.a_q16 / 65536.0, rig.b_q24 / 16777216.0,
                 rig.c_q24 / 16777216.0);
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.a_q16 / 65536.0 - drifts[i][0]) < 0.01, message);
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.b_q24 / 16777216.0 - drifts[i][1]) < 0.00005, message);
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.c_q24 / 16777216.0 - drifts[i][2]) < 0.00005, message);
        TEST_ASSERT_TRUE_MESSAGE(report.rms_after_q8 <= 2, message);
        stad_rig_straighten(&rig, pairs, n);
        for (int k = 0; k < 4 * n; k++) {
            TEST_ASSERT_INT_WITHIN(3, pairs[k / 4].left[k % 4].y_q8, pairs[k / 4].right[k % 4].y_q8);
            TEST_ASSERT_INT_WITHIN(4, pairs[k / 4].left[k % 4].x_q8 - 12 * 256, pairs[k / 4].right[k % 4].x_q8);
        }
    }
}

static void test_rig_apply_and_straighten_are_inverse(void)
{
    stad_rig rig;
    stad_rig_identity(&rig, 752, 480);
    rig.a_q16 = 3 << 16;
    rig.b_q24 = 300000;
    rig.c_q24 = -120000;
    for (int32_t y = 0; y < 480; y += 37)
        for (int32_t x = 0; x < 752; x += 41) {
            const stad_corner p = {x * 256 + 13, y * 256 + 200};
            stad_pair pair;
            memset(&pair, 0, sizeof pair);
            pair.right[0] = stad_rig_apply(&rig, p);
            stad_rig_straighten(&rig, &pair, 1);
            TEST_ASSERT_INT_WITHIN(1, p.x_q8, pair.right[0].x_q8);
            TEST_ASSERT_INT_WITHIN(1, p.y_q8, pair.right[0].y_q8);
        }
}

static int verdict_of(double a, double b, double c, stad_rig_report *report)
{
    stad_pair pairs[8];
    stad_rig rig;
    const int n = ideal_pairs(pairs, 320, 240, a, b, c);
    return stad_rig_fit(&rig, report, pairs, n, 320, 240);
}

static void test_rig_verdict_follows_the_worst_dy(void)
{
    stad_rig_report report;
    TEST_ASSERT_EQUAL_INT(STAD_RIG_GOOD, verdict_of(0.23, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(0, report.advised);
    TEST_ASSERT_EQUAL_INT(STAD_RIG_WATCH, verdict_of(0.27, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(1, report.advised);
    TEST_ASSERT_EQUAL_INT(STAD_RIG_WATCH, verdict_of(0.48, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(STAD_RIG_CORRECT, verdict_of(0.52, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(STAD_RIG_CORRECT, verdict_of(0, 0.004, 0, &report)); /* 0.64 px at the edge */
    TEST_ASSERT_EQUAL_INT(STAD_RIG_CORRECT, verdict_of(7.9, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(STAD_RIG_FAIL, verdict_of(8.1, 0, 0, &report));
    TEST_ASSERT_EQUAL_INT(0, report.advised);
}

static void test_rig_watch_with_narrow_span_not_advised(void)
{
    stad_pair pairs[8];
    stad_rig rig;
    stad_rig_report report;
    const int n = ideal_pairs(pairs, 320, 240, 0.3, 0, 0);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 4; k++) {
            pairs[i].left[k].x_q8 = pairs[i].left[k].x_q8 / 4 + 80 * 256;
            pairs[i].right[k].x_q8 = pairs[i].right[k].x_q8 / 4 + 80 * 256;
        }
    TEST_ASSERT_EQUAL_INT(STAD_RIG_WATCH, stad_rig_fit(&rig, &report, pairs, n, 320, 240));
    TEST_ASSERT_EQUAL_INT(0, report.advised);
}

static void test_rig_scattered_or_scarce_corners_fail(void)
{
    stad_pair pairs[8];
    stad_rig rig;
    stad_rig_report report;
    int n = ideal_pairs(pairs, 320, 240, 0.3, 0, 0);
    TEST_ASSERT_EQUAL_INT(STAD_RIG_FAIL, stad_rig_fit(&rig, &report, pairs, 1, 320, 240));
    TEST_ASSERT_TRUE(report.corners < 8 && rig.a_q16 == 0 && rig.b_q24 == 0 && rig.c_q24 == 0);
    TEST_ASSERT_EQUAL_INT(STAD_RIG_FAIL, stad_rig_fit(&rig, &report, pairs, 0, 320, 240));
    for (int i = 0; i < n; i++)
        pairs[i].right[i % 4].y_q8 += i % 2 ? 400 : -400;
    TEST_ASSERT_EQUAL_INT(STAD_RIG_FAIL, stad_rig_fit(&rig, &report, pairs, n, 320, 240));
    TEST_ASSERT_TRUE(report.rms_after_q8 > 77);
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_rig_fit(&rig, &report, pairs, n, 15, 240));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_rig_fit(&rig, &report, pairs, -1, 320, 240));
    for (int k = 0; k < 8; k++) /* all corners on one line say nothing of turn and scale */
        pairs[k / 4].right[k % 4].x_q8 = pairs[k / 4].left[k % 4].x_q8 = pairs[k / 4].left[k % 4].y_q8;
    TEST_ASSERT_EQUAL_INT(STAD_RIG_FAIL, stad_rig_fit(&rig, &report, pairs, 2, 320, 240));
}

/* From pixels: two poses through the detector. */
static void test_rig_rendered_drift_measured(void)
{
    static const double drifts[][3] = {{0, 0, 0}, {1.5, 0, 0}, {0, 0.0087, 0}, {-0.8, -0.004, 0.003}};
    for (unsigned i = 0; i < 4; i++) {
        stad_pair pairs[16];
        stad_rig rig;
        stad_rig_report report;
        int n = 0;
        for (unsigned seed = 1; seed <= 2; seed++) {
            mark_case c = case_of(10 * i + seed);
            c.camera.drift_dy = drifts[i][0];
            c.camera.drift_roll = drifts[i][1];
            c.camera.drift_scale = drifts[i][2];
            case_render(&c);
            n += case_pairs(pairs + n, 8);
        }
        const int verdict = stad_rig_fit(&rig, &report, pairs, n, CASE_WIDTH, CASE_HEIGHT);
        snprintf(message, sizeof message, "drift %u: verdict %d a %.3f b %.5f c %.5f after %.3f", i, verdict, rig.a_q16 / 65536.0,
                 rig.b_q24 / 16777216.0, rig.c_q24 / 16777216.0, report.rms_after_q8 / 256.0);
        TEST_ASSERT_EQUAL_INT_MESSAGE(i == 0 ? STAD_RIG_GOOD : STAD_RIG_CORRECT, verdict, message);
        /* The renderer turns about (w - 1) / 2, the model about w / 2. */
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.a_q16 / 65536.0 - drifts[i][0]) < 0.05, message);
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.b_q24 / 16777216.0 - drifts[i][1]) < 0.0006, message);
        TEST_ASSERT_TRUE_MESSAGE(fabs(rig.c_q24 / 16777216.0 - drifts[i][2]) < 0.0008, message);
    }
}

static void test_rig_identity_rows_are_copies(void)
{
    uint8_t row[CASE_WIDTH * 3];
    stad_rig rig;
    stad_rig_identity(&rig, CASE_WIDTH, 80);
    const stad_image image = stad_image_packed(case_left, CASE_WIDTH, 80, 3);
    for (int i = 0; i < CASE_PIXELS; i++)
        case_left[i] = (uint8_t)(i * 7 + i / 911);
    for (int y = 0; y < 80; y++) {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_row(&rig, &image, y, row));
        TEST_ASSERT_EQUAL_MEMORY(case_left + y * CASE_WIDTH * 3, row, sizeof row);
    }
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_rig_row(&rig, &image, 80, row));
}

/* A smooth image shifted, turned and scaled comes back within 4 grey levels, in x and y. */
static void test_rig_row_undoes_a_drift(void)
{
    uint8_t row[CASE_WIDTH];
    stad_rig rig;
    stad_rig_identity(&rig, CASE_WIDTH, CASE_HEIGHT);
    rig.a_q16 = 70000;
    rig.b_q24 = 146000;
    rig.c_q24 = -50000;
    const double a = rig.a_q16 / 65536.0, b = rig.b_q24 / 16777216.0, c = rig.c_q24 / 16777216.0;
    const double det = (1 + c) * (1 + c) + b * b;
    for (int y = 0; y < CASE_HEIGHT; y++)
        for (int x = 0; x < CASE_WIDTH; x++) {
            /* raw position -> ideal position: the inverse of (1 + c, -b; b, 1 + c) */
            const double rx = x - 160, ry = y - 120 - a;
            const double ix = ((1 + c) * rx + b * ry) / det, iy = (-b * rx + (1 + c) * ry) / det;
            case_right[y * CASE_WIDTH + x] = (uint8_t)lround(128 + 60 * sin(ix / 5) + 50 * cos(iy / 6));
        }
    const stad_image image = stad_image_packed(case_right, CASE_WIDTH, CASE_HEIGHT, 1);
    for (int y = 10; y < CASE_HEIGHT - 10; y++) {
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_row(&rig, &image, y, row));
        for (int x = 10; x < CASE_WIDTH - 10; x++) {
            const double expected = 128 + 60 * sin((x - 160) / 5.0) + 50 * cos((y - 120) / 6.0);
            snprintf(message, sizeof message, "x %d y %d: %d, not %.1f", x, y, row[x], expected);
            TEST_ASSERT_TRUE_MESSAGE(fabs(row[x] - expected) <= 4, message);
        }
    }
}

/* The stream gives the rows of the frame, for every order of pushing and pulling, in a ring of its own size and no larger. */
static void test_rig_stream_equals_frame(void)
{
    enum { W = 61, H = 47, DY = 5 };
    static uint8_t work[STAD_RIG_BYTES(W, 3, DY) + 16], pix[W * H * 3];
    target_random r;
    target_random_seed(&r, 3);
    for (unsigned i = 0; i < sizeof pix; i++)
        pix[i] = (uint8_t)(255 * target_random_uniform(&r));
    static const int32_t drifts[][3] = {{0, 0, 0}, {70000, 900000, 0}, {-300000, 0, 300000}, {0, -1048576, 800000}};
    for (unsigned i = 0; i < 4; i++)
        for (int eager = 0; eager < 2; eager++) {
            uint8_t expected[W * 3], got[W * 3];
            stad_rig rig;
            stad_rig_stream s;
            stad_rig_identity(&rig, W, H);
            rig.a_q16 = drifts[i][0];
            rig.b_q24 = drifts[i][1];
            rig.c_q24 = drifts[i][2];
            memset(work, 0xC3, sizeof work);
            const stad_image image = stad_image_packed(pix, W, H, 3);
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_begin(&s, &rig, 3, DY, work, STAD_RIG_BYTES(W, 3, DY)));
            int pushed = 0, pulled = 0;
            while (pulled < H) {
                int progress = 0;
                while (pushed < H && stad_rig_push(&s, pix + pushed * W * 3) == STAD_OK) {
                    pushed++;
                    progress = 1;
                    if (!eager)
                        break;
                }
                for (int y = stad_rig_pull(&s, got); y >= 0; y = stad_rig_pull(&s, got)) {
                    TEST_ASSERT_EQUAL_INT(pulled++, y);
                    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_row(&rig, &image, y, expected));
                    snprintf(message, sizeof message, "drift %u eager %d row %d", i, eager, y);
                    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected, got, sizeof got, message);
                    progress = 1;
                    if (eager)
                        break;
                }
                TEST_ASSERT_TRUE_MESSAGE(progress, "stuck");
            }
            TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_rig_pull(&s, got));
            TEST_ASSERT_EACH_EQUAL_HEX8(0xC3, work + STAD_RIG_BYTES(W, 3, DY), 16);
        }
}

static void test_rig_begin_refuses_what_does_not_fit(void)
{
    static uint8_t work[STAD_RIG_BYTES(320, 1, 4)];
    stad_rig rig;
    stad_rig_stream s;
    stad_rig_identity(&rig, 320, 240);
    TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_begin(&s, &rig, 1, 4, work, sizeof work));
    TEST_ASSERT_EQUAL_INT(STAD_E_SIZE, stad_rig_begin(&s, &rig, 1, 4, work, sizeof work - 1));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_rig_begin(&s, &rig, 2, 4, work, sizeof work));
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_rig_begin(&s, &rig, 1, 17, work, sizeof work));
    rig.a_q16 = 4 * 65536 + 1000;
    TEST_ASSERT_EQUAL_INT(STAD_E_LIMIT, stad_rig_begin(&s, &rig, 1, 4, work, sizeof work));
    rig.a_q16 = 65 << 16;
    TEST_ASSERT_EQUAL_INT(STAD_E_PARAM, stad_rig_begin(&s, &rig, 1, 4, work, sizeof work));
}

/* A rig shifted by three rows does not need the last row of all: the result is whole before it comes. */
static void test_rig_stream_takes_rows_after_the_last_pull(void)
{
    static uint8_t work[STAD_RIG_BYTES(16, 1, 4)];
    uint8_t row[16] = {0}, out[16];
    stad_rig rig;
    stad_rig_stream s;
    int pulled = 0;
    for (int side = -1; side <= 1; side += 2) {
        stad_rig_identity(&rig, 16, 16);
        rig.a_q16 = side * 3 * 65536;
        TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_begin(&s, &rig, 1, 4, work, sizeof work));
        int before_the_end = 0;
        for (int y = 0; y < 16; y++) {
            TEST_ASSERT_EQUAL_INT(STAD_OK, stad_rig_push(&s, row));
            for (pulled = stad_rig_pull(&s, out); pulled >= 0; pulled = stad_rig_pull(&s, out))
                before_the_end = y;
        }
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, stad_rig_push(&s, row));
        TEST_ASSERT_EQUAL_INT(STAD_E_STATE, pulled);
        TEST_ASSERT_EQUAL_INT(side < 0 ? 14 : 15, before_the_end);
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_rig_ideal_drift_recovered);
    RUN_TEST(test_rig_apply_and_straighten_are_inverse);
    RUN_TEST(test_rig_verdict_follows_the_worst_dy);
    RUN_TEST(test_rig_watch_with_narrow_span_not_advised);
    RUN_TEST(test_rig_scattered_or_scarce_corners_fail);
    RUN_TEST(test_rig_rendered_drift_measured);
    RUN_TEST(test_rig_identity_rows_are_copies);
    RUN_TEST(test_rig_row_undoes_a_drift);
    RUN_TEST(test_rig_stream_equals_frame);
    RUN_TEST(test_rig_begin_refuses_what_does_not_fit);
    RUN_TEST(test_rig_stream_takes_rows_after_the_last_pull);
    return UNITY_END();
}
