/* SPDX-License-Identifier: MIT
 * proof/test_mark_maps.c - components and contours of every dark map of 6 x 4 px within a white border, against a flood. */
#include <string.h>

#include "mark/mark_work.h"
#include "unity.h"

enum { COLUMNS = 6, ROWS = 4, WIDTH = COLUMNS + 2, HEIGHT = ROWS + 2, MAPS = 1 << COLUMNS * ROWS };

static uint8_t dark[HEIGHT], left[HEIGHT]; /* a byte a row; what no component has been found for yet */
static mark_run runs[2 * (WIDTH / 2 + 2)];
static mark_component components[WIDTH + 8];
static int16_t free_slots[WIDTH + 8];
static mark_point contour[3 * (WIDTH + HEIGHT)];
static unsigned map;

void setUp(void)
{
}

void tearDown(void)
{
}

static int32_t count_bits(const uint8_t *rows)
{
    int32_t n = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (unsigned bits = rows[y]; bits; bits &= bits - 1)
            n++;
    return n;
}

/* Takes the pixels connected with (x, y) out of `left`; returns how many, and leaves them in `part`. */
static int32_t flood(int x, int y, uint8_t *part)
{
    memset(part, 0, HEIGHT);
    part[y] = (uint8_t)(1 << x);
    for (int grown = 1; grown;) {
        grown = 0;
        for (int row = 1; row < HEIGHT - 1; row++) {
            const unsigned near = part[row] | (unsigned)part[row] << 1 | (unsigned)part[row] >> 1 | part[row - 1] | part[row + 1];
            const uint8_t next = (uint8_t)(near & left[row]);
            grown |= next != part[row];
            part[row] = next;
        }
    }
    for (int row = 0; row < HEIGHT; row++)
        left[row] = (uint8_t)(left[row] & ~part[row]);
    return count_bits(part);
}

/* In the place of the detector's: each component is one that the flood finds, once, in its box. */
void stad_mark_examine(mark_work *w, const mark_component *c)
{
    uint8_t part[HEIGHT];
    unsigned columns = 0, first = 0;
    int32_t area2 = 0, top = HEIGHT, bottom = 0;
    TEST_ASSERT_EQUAL_UINT_MESSAGE(1, left[c->top] >> c->start_x & 1, "found already");
    TEST_ASSERT_EQUAL_INT32(flood(c->start_x, c->top, part), c->area);
    for (int y = 0; y < HEIGHT; y++) {
        columns |= part[y];
        top = part[y] && y < top ? y : top;
        bottom = part[y] ? y : bottom;
    }
    while (!(columns >> first & 1u))
        first++;
    TEST_ASSERT_EQUAL_INT(first, c->left);
    TEST_ASSERT_EQUAL_UINT(1, columns >> c->right);
    TEST_ASSERT_EQUAL_INT(top, c->top);
    TEST_ASSERT_EQUAL_INT(bottom, c->bottom);
    if (stad_mark_contour(w, c, &area2)) /* what it encloses: the component, and holes in it */
        TEST_ASSERT_TRUE(area2 >= 2 * c->area && area2 <= 2 * (c->right - c->left + 1) * (c->bottom - c->top + 1));
}

static void test_mark_components_of_every_small_map_are_those_of_a_flood(void)
{
    for (map = 0; map < MAPS; map++) {
        mark_work w;
        memset(&w, 0, sizeof w);
        w.width = WIDTH;
        w.height = HEIGHT;
        w.dark = dark;
        w.dark_stride = 1;
        w.runs[0] = runs;
        w.runs[1] = runs + WIDTH / 2 + 2;
        w.components = components;
        w.free_slots = free_slots;
        w.contour = contour;
        for (int y = 1; y <= ROWS; y++)
            dark[y] = left[y] = (uint8_t)((map >> (y - 1) * COLUMNS & 63u) << 1);
        stad_mark_runs_first(&w);
        for (int y = 0; y < HEIGHT; y++)
            stad_mark_runs_row(&w, y);
        TEST_ASSERT_EQUAL_INT_MESSAGE(WIDTH + 8, w.free_count, "a slot was not given back");
        TEST_ASSERT_EQUAL_INT_MESSAGE(0, count_bits(left), "a component was not found");
    }
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_mark_components_of_every_small_map_are_those_of_a_flood);
    return UNITY_END();
}
