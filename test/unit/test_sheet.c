/* SPDX-License-Identifier: MIT
 * test_sheet.c - the nets of the target's parts fold up to the heights and footprints of the table, and fit the
 * paper. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sheet/sheet.h"
#include "unity.h"

static sheet_net net;
static char why[100];

void setUp(void)
{
}

void tearDown(void)
{
}

static double length(const sheet_piece *p, int edge)
{
    sheet_point a = p->p[edge], b = p->p[(edge + 1) % p->count];
    return hypot(b.x - a.x, b.y - a.y);
}

static double space_mm(const stad_target_facet *f, int i, int k)
{
    double x = f->x_mm[i] - f->x_mm[k], y = f->y_mm[i] - f->y_mm[k], h = f->h_mm[i] - f->h_mm[k];
    return sqrt(x * x + y * y + h * h);
}

/* Every facet has its true shape: sides and diagonals. */
static void expect_facet(const sheet_piece *piece, const stad_target_facet *f)
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < i; k++) {
            double mm = hypot(piece->p[i].x - piece->p[k].x, piece->p[i].y - piece->p[k].y);
            TEST_ASSERT_TRUE_MESSAGE(fabs(mm - space_mm(f, i, k)) < 1e-6, why);
        }
}

/* A wall's upright sides are as high as the table says, its foot as long as the footprint. */
static void expect_wall(const sheet_piece *wall, const stad_target_facet *f, int edge)
{
    int k = (edge + 1) & 3, foot = f->h_mm[k] > 0 ? 2 : 1;
    double foot_mm = hypot(f->x_mm[k] - f->x_mm[edge], f->y_mm[k] - f->y_mm[edge]);
    TEST_ASSERT_TRUE_MESSAGE(fabs(length(wall, foot) - foot_mm) < 1e-6, why);
    if (f->h_mm[k] > 0)
        TEST_ASSERT_TRUE_MESSAGE(fabs(length(wall, 1) - f->h_mm[k]) < 1e-6, why);
    if (f->h_mm[edge] > 0)
        TEST_ASSERT_TRUE_MESSAGE(fabs(length(wall, wall->count - 1) - f->h_mm[edge]) < 1e-6, why);
}

/* The edge of the facet that the wall hangs on. */
static int edge_of(const sheet_piece *wall, const sheet_piece *top)
{
    for (int i = 0; i < 4; i++)
        if (memcmp(&wall->p[0], &top->p[i], sizeof wall->p[0]) == 0 &&
            memcmp(&wall->p[1], &top->p[(i + 1) & 3], sizeof wall->p[1]) == 0)
            return i;
    return -1;
}

static const sheet_piece *top_of(int facet)
{
    for (int i = 0; i < net.count; i++)
        if (net.piece[i].kind == SHEET_TOP && net.piece[i].facet == facet)
            return &net.piece[i];
    return NULL;
}

void test_sheet_nets_fold_to_the_table(void)
{
    const stad_target *t = stad_target_relief();
    for (int part = 0; part < t->part_count; part++) {
        sheet_unfold(t, part, &net);
        TEST_ASSERT_LESS_THAN(SHEET_PIECES, net.count);
        for (int i = 0; i < net.count; i++) {
            const sheet_piece *piece = &net.piece[i];
            const stad_target_facet *f = &t->facets[piece->facet];
            snprintf(why, sizeof why, "part %s piece %d", t->parts[part], i);
            TEST_ASSERT_EQUAL(part, f->part);
            if (piece->kind == SHEET_TOP)
                expect_facet(piece, f);
            else if (piece->kind == SHEET_WALL)
                expect_wall(piece, f, edge_of(piece, top_of(piece->facet)));
        }
    }
}

static int count_kind(int kind)
{
    int n = 0;
    for (int i = 0; i < net.count; i++)
        n += net.piece[i].kind == kind;
    return n;
}

void test_sheet_parts_have_their_pieces(void)
{
    const stad_target *t = stad_target_relief();
    sheet_unfold(t, 0, &net); /* plate: a box without its floor, a foot flap and a side flap at each wall */
    TEST_ASSERT_EQUAL(1, count_kind(SHEET_TOP));
    TEST_ASSERT_EQUAL(4, count_kind(SHEET_WALL));
    TEST_ASSERT_EQUAL(8, count_kind(SHEET_FLAP));
    sheet_unfold(t, 2, &net); /* tent: two slopes side by side, two gables each */
    TEST_ASSERT_EQUAL(2, count_kind(SHEET_TOP));
    TEST_ASSERT_EQUAL(4, count_kind(SHEET_WALL));
    sheet_unfold(t, t->part_count, &net);
    TEST_ASSERT_EQUAL(0, net.count);
}

/* -- a pen that only measures ------------------------------------------------------------------------------------ */

typedef struct gauge {
    double width, height;
    int pages, outside, rasters;
} gauge;

static void look_at(gauge *g, sheet_point p)
{
    g->outside += p.x < 5 || p.y < 5 || p.x > g->width - 5 || p.y > g->height - 5;
}

static int gauge_begin(void *to, double width_mm, double height_mm, int page, int pages)
{
    gauge *g = to;
    g->width = width_mm;
    g->height = height_mm;
    g->pages = pages;
    return page <= pages;
}

static void gauge_line(void *to, sheet_point a, sheet_point b, int kind)
{
    (void)kind;
    look_at(to, a);
    look_at(to, b);
}

static void gauge_fill(void *to, const sheet_point *p, int count, int grey)
{
    (void)grey;
    for (int i = 0; i < count; i++)
        look_at(to, p[i]);
}

static void gauge_raster(void *to, const sheet_raster *r)
{
    ((gauge *)to)->rasters++;
    look_at(to, r->origin);
}

static void gauge_text(void *to, sheet_point at, double size_mm, const char *text)
{
    (void)size_mm;
    for (const char *c = text; *c; c++)
        TEST_ASSERT_TRUE_MESSAGE(*c >= 32 && *c < 127, text);
    look_at(to, at);
}

static int gauge_end(void *to)
{
    (void)to;
    return 1;
}

static void expect_fits(const stad_target *target, const char *paper, int rasters)
{
    gauge g = {0, 0, 0, 0, 0};
    const sheet_pen pen = {&g, gauge_begin, gauge_line, gauge_fill, gauge_raster, gauge_text, gauge_end};
    int pages = sheet_draw(target, sheet_paper_named(paper), &pen);
    TEST_ASSERT_GREATER_THAN(1, pages);
    TEST_ASSERT_EQUAL(pages, g.pages);
    TEST_ASSERT_EQUAL(rasters, g.rasters);
    TEST_ASSERT_EQUAL_MESSAGE(0, g.outside, paper);
}

void test_sheet_everything_lies_within_the_printable_page(void)
{
    const stad_target *t = stad_target_relief();
    expect_fits(t, "a4", 1 + t->facet_count);
    expect_fits(t, "letter", 1 + t->facet_count);
    expect_fits(stad_target_card(), "a4", 1);
    TEST_ASSERT_NULL(sheet_paper_named("a5"));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_sheet_nets_fold_to_the_table);
    RUN_TEST(test_sheet_parts_have_their_pieces);
    RUN_TEST(test_sheet_everything_lies_within_the_printable_page);
    return UNITY_END();
}
