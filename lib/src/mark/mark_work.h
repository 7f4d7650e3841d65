/* SPDX-License-Identifier: MIT
 * mark/mark_work.h - what the steps of the detector share: the carved workspace and each step's contract.
 *
 *     image -> tiles -> dark map -> runs -> components -> contour -> quad -> cells -> word -> refine -> mark
 *
 * Sizes: width, height <= STAD_MARK_MAX_SIZE = 2^11, so a position in Q8 is below 2^19 and a difference below 2^20. */
#ifndef STAD_MARK_WORK_H
#define STAD_MARK_WORK_H

#include <stddef.h>
#include <stdint.h>

#include "mark/mark_line.h"
#include "stad/mark.h"

/* A run of dark pixels first..last of one row, and the component it belongs to. */
typedef struct mark_run {
    int16_t first, last, component;
} mark_run;

/* A 4-connected component of dark pixels. Slots live while a run of the last two rows refers to them, which bounds their
 * number by the runs of two rows: width + 2. */
typedef struct mark_component {
    int32_t area;
    int16_t left, right, top, bottom; /* bounding box, inclusive */
    int16_t start_x;                  /* its first pixel in row `top` */
    int16_t parent;                   /* own index: a root */
} mark_component;

typedef struct mark_point {
    int16_t x, y;
} mark_point;

/* A view of the image's one channel, and the parts of the workspace. */
typedef struct mark_work {
    const uint8_t *pix;
    ptrdiff_t row_stride;
    int32_t pixel_stride, width, height;
    const stad_mark_config *config;
    uint8_t *dark; /* 1 bit a pixel, lowest first; dark_stride bytes a row */
    int32_t dark_stride;
    uint8_t *tiles; /* 4 rows of (minimum, maximum) of each column of tiles; the last row is scratch */
    int32_t tile_columns;
    mark_run *runs[2]; /* of the row above and of this one */
    int32_t run_count[2];
    mark_component *components;
    int16_t *free_slots;
    int32_t free_count;
    mark_point *contour; /* corners between pixels: (x, y) is the top left corner of pixel (x, y) */
    int32_t contour_count, contour_max;
    uint8_t *cells; /* 12 x 12 */
    stad_mark *out;
    int32_t found, max;
} mark_work;

typedef struct mark_quad {
    stad_corner p[4]; /* clockwise on the screen */
} mark_quad;

extern const uint64_t stad_mark_codes[STAD_MARK_IDS];

/* Thresholds the whole image into w->dark. A pixel is dark below the middle of the extremes of the 3 x 3 tiles (4 x 4 px each)
 * round it; where they differ by less than min_contrast nothing is. */
void stad_mark_tiles_first(mark_work *w);
void stad_mark_tiles_row(mark_work *w, int32_t tile_y);

/* Takes in row y of the dark map; components that end with the row above are examined and their slots given back. */
void stad_mark_runs_first(mark_work *w);
void stad_mark_runs_row(mark_work *w, int32_t y);

/* Examines a finished component; a mark found is appended to w->out. */
void stad_mark_examine(mark_work *w, const mark_component *c);

/* Follows the outer contour of a component into w->contour. 1, or 0 when it is too long or encloses too little. *area2
 * becomes twice the enclosed area. */
int stad_mark_contour(mark_work *w, const mark_component *c, int32_t *area2);

/* The line along the contour from point i to point k > i (which may be past the last), Q4 px. 1, or 0 when it is crooked. */
int stad_mark_side(const mark_work *w, int32_t i, int32_t k, mark_line *line);

/* The quadrilateral of w->contour. 1, or 0 when it has none. */
int stad_mark_quad(const mark_work *w, int32_t area2, mark_quad *quad);

/* Reads the cells of a quadrilateral: identity and number of wrong bits, and the corner of `quad` that is the printed top
 * left. 1, or 0 when it is no mark. */
int stad_mark_decode(const mark_work *w, const mark_quad *quad, stad_mark *mark, int *first_corner);

/* Moves the corners onto the edges of the grey image. 1, or 0 when an edge is lost. */
int stad_mark_refine(const mark_work *w, mark_quad *quad);

/* Half pixels on each side of an edge that are looked at, at most. */
enum { MARK_MAX_REACH = 5 };

/* The line along the edge near the side from a to b, dark on its right, within `reach` half pixels. 1, or 0 when fewer than half
 * of the normals meet one. */
int stad_mark_edge_line(const mark_work *w, stad_corner a, stad_corner b, int32_t reach, mark_line *line);

/* The image at (x, y), bilinear, grey levels in Q8; outside it the border repeats. */
int32_t stad_mark_sample_q8(const mark_work *w, int32_t x_q8, int32_t y_q8);

#endif
