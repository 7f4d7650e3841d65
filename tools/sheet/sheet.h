/* SPDX-License-Identifier: MIT
 * sheet/sheet.h - the printable target: pages in true scale, drawn by a pen that writes PDF or SVG.
 *
 * Page 1 is the base with its marks, the next pages the fold-up parts as nets, the last one how to build and mount
 * it. Geometry and print come from the tables that truth and renderer use. The same job gives the same bytes
 * everywhere: no date, no random number, and numbers with three decimals. */
#ifndef SHEET_H
#define SHEET_H

#include <stdio.h>

#include "../common/fail.h"
#include "stad/target.h"

/* -- pen: millimetres, origin at the page's top left corner, y down ---------------------------------------------- */

typedef struct sheet_point {
    double x, y;
} sheet_point;

enum sheet_line { SHEET_CUT, SHEET_FOLD, SHEET_THIN };

/* Grey rows, top first; pixel (i, j) covers a parallelogram: origin + i u + j v .. + (i + 1) u + (j + 1) v. */
typedef struct sheet_raster {
    int width, height;
    const unsigned char *grey;
    sheet_point origin, u, v; /* u, v: of one pixel, mm */
} sheet_raster;

typedef struct sheet_pen {
    void *to;
    int (*begin)(void *to, double width_mm, double height_mm, int page, int pages); /* 0 = could not */
    void (*line)(void *to, sheet_point a, sheet_point b, int kind);
    void (*fill)(void *to, const sheet_point *p, int count, int grey);
    void (*raster)(void *to, const sheet_raster *r);
    void (*text)(void *to, sheet_point at, double size_mm, const char *text); /* ASCII */
    int (*end)(void *to);                                                     /* after the last page; 0 = could not */
} sheet_pen;

typedef struct sheet_paper {
    const char *name;
    double width_mm, height_mm; /* lying */
} sheet_paper;

const sheet_paper *sheet_paper_named(const char *name); /* a4, letter, in any case; NULL otherwise */

/* Draws all pages of a target. Returns how many, or 0 when the pen failed or a part does not fit the paper. */
int sheet_draw(const stad_target *target, const sheet_paper *paper, const sheet_pen *pen);

/* -- nets -------------------------------------------------------------------------------------------------------- */

enum sheet_piece_kind { SHEET_TOP, SHEET_WALL, SHEET_FLAP };

/* A polygon of a net; edge i runs from p[i] to p[i + 1]. */
typedef struct sheet_piece {
    int kind, count, facet;
    sheet_point p[4];
    int folds; /* bit i: edge i is folded, not cut */
} sheet_piece;

#define SHEET_PIECES 48
typedef struct sheet_net {
    int count;
    sheet_piece piece[SHEET_PIECES];
    sheet_point low, high; /* bounding box */
} sheet_net;

/* Unfolds a part of the target: its facets, walls, and flaps to glue. */
void sheet_unfold(const stad_target *target, int part, sheet_net *net);

/* Length of a facet's edge in space, mm. */
double sheet_edge_mm(const stad_target_facet *f, int edge);

/* -- files ------------------------------------------------------------------------------------------------------- */

/* One PDF of all pages, or one SVG a page (name-1.svg ...), by the suffix of `path`. */
int sheet_write(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f);

sheet_pen sheet_pdf_pen(FILE *out, void **state);
sheet_pen sheet_svg_pen(const char *path, void **state,
                        tool_fail *f); /* what goes wrong is told in *f, which stays the caller's */

#endif
