/* SPDX-License-Identifier: MIT
 * nets, print -> [sheet/sheet_pages.c] -> pen - what is on which page. */
#include "sheet.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../scene/target_scene.h"

#define MARGIN_MM 7.0 /* what printers leave white */
#define GAP_MM    4.0
#define PX_PER_MM 4 /* of the print: its finest grain is 1 mm */

static const sheet_paper papers[] = {{"a4", 297.0, 210.0}, {"letter", 279.4, 215.9}};

/* The same, in any case? */
static int is_named(const char *name, const char *text)
{
    while (*name && tolower((unsigned char)*text) == *name) {
        name++;
        text++;
    }
    return *name == *text;
}

const sheet_paper *sheet_paper_named(const char *name)
{
    for (size_t i = 0; i < sizeof papers / sizeof papers[0]; i++)
        if (is_named(papers[i].name, name))
            return &papers[i];
    return NULL;
}

static sheet_point at(double x, double y)
{
    sheet_point p = {x, y};
    return p;
}

static void box(const sheet_pen *pen, double x, double y, double w, double h, int kind)
{
    sheet_point p[4] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    for (int i = 0; i < 4; i++)
        pen->line(pen->to, p[i], p[(i + 1) % 4], kind);
}

static void fill_box(const sheet_pen *pen, double x, double y, double w, double h, int grey)
{
    sheet_point p[4] = {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
    pen->fill(pen->to, p, 4, grey);
}

/* -- print ------------------------------------------------------------------------------------------------------- */

typedef int print_at(const void *what, int x_um, int y_um);

static int base_print(const void *what, int x_um, int y_um)
{
    return target_print((const stad_target *)what, x_um, y_um);
}

static int part_print(const void *what, int x_um, int y_um)
{
    return target_print_part(*(const int *)what, x_um, y_um);
}

/* A patch of print whose corner is at `origin`, spanned by unit vectors u and v. */
static int print_patch(const sheet_pen *pen, print_at *print, const void *what, double w_mm, double h_mm,
                       const sheet_point span[3])
{
    sheet_raster r;
    r.width = (int)ceil(w_mm * PX_PER_MM - 1e-6);
    r.height = (int)ceil(h_mm * PX_PER_MM - 1e-6);
    unsigned char *grey = malloc((size_t)r.width * (size_t)r.height);
    if (!grey)
        return 0;
    for (int y = 0; y < r.height; y++)
        for (int x = 0; x < r.width; x++)
            grey[(size_t)y * (size_t)r.width + (size_t)x] =
                (unsigned char)print(what, (2 * x + 1) * 500 / PX_PER_MM, (2 * y + 1) * 500 / PX_PER_MM);
    r.grey = grey;
    r.origin = span[0];
    r.u = at(span[1].x * w_mm / r.width, span[1].y * w_mm / r.width);
    r.v = at(span[2].x * h_mm / r.height, span[2].y * h_mm / r.height);
    pen->raster(pen->to, &r);
    free(grey);
    return 1;
}

/* -- page 1 ------------------------------------------------------------------------------------------------------ */

/* Marks as filled squares over the print, so that their edges are as sharp as the printer can. */
static void draw_tag(const sheet_pen *pen, const stad_target *t, const stad_target_tag *tag, sheet_point o)
{
    double cell = t->tag_mm / 8.0, x0 = o.x + tag->x_mm, y0 = o.y + tag->y_mm;
    fill_box(pen, x0 - cell, y0 - cell, 10 * cell, 10 * cell, 255);
    fill_box(pen, x0, y0, 8 * cell, 8 * cell, 0);
    for (int row = 1; row < 7; row++)
        for (int column = 1; column < 7; column++) {
            int x_um = tag->x_mm * 1000 + (2 * column + 1) * t->tag_mm * 1000 / 16;
            int y_um = tag->y_mm * 1000 + (2 * row + 1) * t->tag_mm * 1000 / 16;
            if (target_print(t, x_um, y_um) > 127)
                fill_box(pen, x0 + column * cell, y0 + row * cell, cell, cell, 255);
        }
}

static void draw_footprints(const sheet_pen *pen, const stad_target *t, sheet_point o)
{
    for (int i = 0; i < t->facet_count; i++) {
        const stad_target_facet *f = &t->facets[i];
        for (int k = 0; k < 4; k++) {
            int n = (k + 1) % 4;
            pen->line(pen->to, at(o.x + f->x_mm[k], o.y + f->y_mm[k]), at(o.x + f->x_mm[n], o.y + f->y_mm[n]), SHEET_THIN);
        }
        if (i == 0 || t->facets[i - 1].part != f->part)
            pen->text(pen->to, at(o.x + f->x_mm[0] + 1, o.y + f->y_mm[0] + 4), 2.5, t->parts[f->part]);
    }
}

/* 100 mm, upright, beside the base. */
static void draw_ruler(const sheet_pen *pen, double x, double y)
{
    pen->line(pen->to, at(x, y), at(x, y + 100), SHEET_CUT);
    for (int mm = 0; mm <= 100; mm++)
        pen->line(pen->to, at(x, y + mm), at(x + (mm % 10 == 0 ? 3 : mm % 5 == 0 ? 2 : 1), y + mm), SHEET_CUT);
    pen->text(pen->to, at(x - 2, y - 2), 3, "0");
    pen->text(pen->to, at(x - 4, y + 104), 3, "100 mm");
}

static int draw_base(const stad_target *t, const sheet_paper *paper, const sheet_pen *pen)
{
    sheet_point o = at((paper->width_mm - t->width_mm) / 2, (paper->height_mm - t->height_mm) / 2);
    const sheet_point span[3] = {o, {1, 0}, {0, 1}};
    if (!print_patch(pen, base_print, t, t->width_mm, t->height_mm, span))
        return 0;
    for (int i = 0; i < t->tag_count; i++)
        draw_tag(pen, t, &t->tags[i], o);
    draw_footprints(pen, t, o);
    box(pen, o.x, o.y, t->width_mm, t->height_mm, SHEET_CUT);
    draw_ruler(pen, o.x + t->width_mm + 2, paper->height_mm / 2 - 50);
    pen->text(pen->to, at(o.x, o.y - 3), 3, "base: print at 100 %, check the ruler, cut along the outline, glue to a flat board");
    return 1;
}

/* -- nets -------------------------------------------------------------------------------------------------------- */

static int draw_piece(const stad_target *t, const sheet_pen *pen, const sheet_piece *piece, sheet_point shift)
{
    sheet_point p[4];
    for (int i = 0; i < piece->count; i++)
        p[i] = at(piece->p[i].x + shift.x, piece->p[i].y + shift.y);
    if (piece->kind == SHEET_TOP) {
        const stad_target_facet *f = &t->facets[piece->facet];
        double w = sheet_edge_mm(f, 0), h = sheet_edge_mm(f, 3);
        int part = f->part + 1;
        const sheet_point span[3] = {
            p[0], {(p[1].x - p[0].x) / w, (p[1].y - p[0].y) / w}, {(p[3].x - p[0].x) / h, (p[3].y - p[0].y) / h}};
        if (!print_patch(pen, part_print, &part, w, h, span))
            return 0;
    } else if (piece->kind == SHEET_WALL) {
        pen->fill(pen->to, p, piece->count, 128);
    }
    for (int i = 0; i < piece->count; i++)
        pen->line(pen->to, p[i], p[(i + 1) % piece->count], piece->folds >> i & 1 ? SHEET_FOLD : SHEET_CUT);
    return 1;
}

/* Where each part's net goes: rows of nets, as many pages as it takes. */
typedef struct place {
    int page;
    sheet_point shift;
} place;

#define PARTS 32

static int arrange(const stad_target *t, const sheet_paper *paper, place *places)
{
    static sheet_net net;
    double x = MARGIN_MM, y = MARGIN_MM, row = 0;
    int page = 0;
    for (int part = 0; part < t->part_count; part++) {
        sheet_unfold(t, part, &net);
        double w = net.high.x - net.low.x, h = net.high.y - net.low.y + 5;
        if (w > paper->width_mm - 2 * MARGIN_MM || h > paper->height_mm - 2 * MARGIN_MM)
            return -1;
        if (x + w > paper->width_mm - MARGIN_MM) {
            x = MARGIN_MM;
            y += row + GAP_MM;
            row = 0;
        }
        if (y + h > paper->height_mm - MARGIN_MM) {
            page++;
            x = y = MARGIN_MM;
            row = 0;
        }
        places[part].page = page;
        places[part].shift = at(x - net.low.x, y + 5 - net.low.y);
        x += w + GAP_MM;
        row = fmax(row, h);
    }
    return t->part_count > 0 ? page + 1 : 0;
}

static int draw_nets(const stad_target *t, const sheet_pen *pen, const place *places, int page)
{
    static sheet_net net;
    for (int part = 0; part < t->part_count; part++) {
        if (places[part].page != page)
            continue;
        sheet_unfold(t, part, &net);
        sheet_point shift = places[part].shift;
        for (int i = 0; i < net.count; i++)
            if (!draw_piece(t, pen, &net.piece[i], shift))
                return 0;
        pen->text(pen->to, at(net.low.x + shift.x, net.low.y + shift.y - 1), 3, t->parts[part]);
    }
    return 1;
}

/* -- last page --------------------------------------------------------------------------------------------------- */

static const char *const guide[] = {
    "1. Print every page at 100 % (no 'fit to page') on matt paper; the parts on card of 160 to 250 g/m2. "
    "Gloss shines and spoils both views.",
    "2. Lay a steel rule on the printed ruler of page 1: 100 mm must be 100 mm within 0.5 mm. If not, print "
    "again at the right scale.",
    "3. Cut out the base along its outline and glue it to something flat and stiff (glass, aluminium "
    "composite, plywood of 6 mm).",
    "4. Cut the parts along the solid lines. Score the dashed lines with a blunt knife and fold them away "
    "from you, printed side out.",
    "5. Glue the side flaps first, so that each part becomes a box open below. Then fold the foot flaps "
    "inwards, and glue the part onto the",
    "   outline of its name on the base. The sketch and the table give the heights: keep them within 0.5 mm. "
    "Do not press the tops hollow.",
    "6. Mount it upright or lying, with all four marks in sight of both cameras, at the distance where the "
    "marks are 24 to 48 pixels wide in",
    "   the image and the whole sheet covers 10 to 20 % of it. Leaning it back by 10 to 30 degrees is good. "
    "Even light, no shadow edges.",
    "7. For judging, the loop needs the target in a second pose: a move by a tenth of its width or a turn by "
    "ten degrees is enough.",
    "8. Tell the library the focal length (px) and the principal point of the rectified pair: they bend the "
    "truth of the raised parts when the sheet leans.",
};

static void draw_table(const stad_target *t, const sheet_pen *pen, double x, double y)
{
    char line[160];
    for (int i = 0; i < t->facet_count; i++) {
        const stad_target_facet *f = &t->facets[i];
        snprintf(line, sizeof line, "%-8s corners (x y h) mm: (%d %d %d)  (%d %d %d)  (%d %d %d)  (%d %d %d)", t->parts[f->part],
                 f->x_mm[0], f->y_mm[0], f->h_mm[0], f->x_mm[1], f->y_mm[1], f->h_mm[1], f->x_mm[2], f->y_mm[2], f->h_mm[2],
                 f->x_mm[3], f->y_mm[3], f->h_mm[3]);
        pen->text(pen->to, at(x, y + 5 * i), 3.2, line);
    }
}

#define LOWER_ROW_MM 36 /* the second row of parts below the first, on paper */

/* The finished target from the side: x to the right, height up, half scale, walls and tops of every facet. */
static void draw_side_view(const stad_target *t, const sheet_pen *pen, double x, double y)
{
    const double scale = 0.5;
    pen->line(pen->to, at(x, y), at(x + scale * t->width_mm, y), SHEET_CUT);
    for (int i = 0; i < t->facet_count; i++) {
        const stad_target_facet *f = &t->facets[i];
        double left = x + scale * f->x_mm[0], right = x + scale * f->x_mm[1];
        double low = y - scale * f->h_mm[0], high = y - scale * f->h_mm[1];
        double row = f->y_mm[0] < t->height_mm / 2 ? 0 : LOWER_ROW_MM;
        pen->line(pen->to, at(left, low + row), at(right, high + row), SHEET_CUT);
        pen->line(pen->to, at(left, low + row), at(left, y + row), SHEET_THIN);
        pen->line(pen->to, at(right, high + row), at(right, y + row), SHEET_THIN);
        if (i == 0 || t->facets[i - 1].part != f->part)
            pen->text(pen->to, at(left, y + row + 4), 2.8, t->parts[f->part]);
    }
    pen->line(pen->to, at(x, y + LOWER_ROW_MM), at(x + scale * t->width_mm, y + LOWER_ROW_MM), SHEET_CUT);
    pen->text(pen->to, at(x + scale * t->width_mm + 3, y), 2.8, "seen from below, half size: upper row of parts");
    pen->text(pen->to, at(x + scale * t->width_mm + 3, y + LOWER_ROW_MM), 2.8, "lower row of parts");
}

static void draw_guide(const stad_target *t, const sheet_pen *pen)
{
    double x = 12, y = 16;
    char title[96];
    snprintf(title, sizeof title, "Target \"%s\": base %d x %d mm, marks of %d mm. How to build and mount it", t->name,
             t->width_mm, t->height_mm, t->tag_mm);
    pen->text(pen->to, at(x, y), 5, title);
    for (size_t i = 0; i < sizeof guide / sizeof guide[0]; i++)
        pen->text(pen->to, at(x, y + 9 + 6 * (double)i), 3.4, guide[i]);
    if (t->facet_count > 0) {
        draw_table(t, pen, x, y + 76);
        draw_side_view(t, pen, x, y + 144);
    }
    pen->line(pen->to, at(230, 185), at(250, 185), SHEET_CUT);
    pen->text(pen->to, at(253, 186), 3, "cut");
    pen->line(pen->to, at(230, 190), at(250, 190), SHEET_FOLD);
    pen->text(pen->to, at(253, 191), 3, "fold");
}

int sheet_draw(const stad_target *target, const sheet_paper *paper, const sheet_pen *pen)
{
    static place places[PARTS];
    if (target->part_count > PARTS)
        return 0;
    int net_pages = arrange(target, paper, places), pages = 2 + net_pages;
    if (net_pages < 0)
        return 0;
    int ok = pen->begin(pen->to, paper->width_mm, paper->height_mm, 1, pages) && draw_base(target, paper, pen);
    for (int page = 0; ok && page < net_pages; page++)
        ok = pen->begin(pen->to, paper->width_mm, paper->height_mm, 2 + page, pages) && draw_nets(target, pen, places, page);
    if (ok && pen->begin(pen->to, paper->width_mm, paper->height_mm, pages, pages))
        draw_guide(target, pen);
    else
        ok = 0;
    return pen->end(pen->to) && ok ? pages : 0;
}
