/* SPDX-License-Identifier: MIT
 * stad/target.h - the calibration target as a table: one geometry for truth, renderer and printed sheet.
 *
 * A target is a flat base sheet with marks in its corners and, standing on it, raised parts made of flat facets: a plate, a
 * wedge, a tent, bars. Flat targets and fronto-parallel plates alone mislead the tuning; slopes are what makes it right.
 *
 *      0 ------------------------------ x
 *      | [0]      plate  wedge     [1]         heights h point from the base towards the camera;
 *      |                                       [i]: mark i, upright, with a white surround of one cell
 *      | [3]      tent   bars      [2]
 *      y
 *
 * Units: whole millimetres on the base sheet, origin at its top left corner. */
#ifndef STAD_TARGET_H
#define STAD_TARGET_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A mark on the base: the top left corner of its black square. */
typedef struct stad_target_tag {
    int16_t id, x_mm, y_mm; /* identity and place */
} stad_target_tag;

/* A flat quadrilateral at heights of its own; corners in order. Facets of one part stand on one common footprint: the
 * shadow of the facets on the base. Walls run straight down from the facets' edges. */
typedef struct stad_target_facet {
    int16_t part;                      /* index into the parts */
    int16_t x_mm[4], y_mm[4], h_mm[4]; /* of each corner: place on the base, height above it */
} stad_target_facet;

/* A target. */
typedef struct stad_target {
    const char *name;                           /* for messages */
    int16_t width_mm, height_mm;                /* of the base sheet */
    int16_t tag_mm;                             /* side of a mark's black square, a multiple of 8 */
    int16_t tag_count, part_count, facet_count; /* of the three tables */
    const stad_target_tag *tags;                /* marks on the base */
    const char *const *parts;                   /* names, such as "plate" */
    const stad_target_facet *facets;            /* what stands on it */
} stad_target;

/* The relief target that `stad sheet` prints: 256 x 184 mm, marks 0..3, plate, wedge, tent, three bars. Constant. */
const stad_target *stad_target_relief(void);

/* A flat card of 120 x 72 mm with marks 4 and 5, to be held in front. Constant. */
const stad_target *stad_target_card(void);

/* A rectified pair of cameras: same focal length and principal point in both views. The baseline is not needed: the marks'
 * distances in millimetres give the scale, so a sheet printed larger with parts cut by the same print does no harm. */
typedef struct stad_camera {
    int32_t f_q8;         /* focal length, px */
    int32_t cx_q8, cy_q8; /* principal point, px from the centre of the first pixel */
} stad_camera;

#ifdef __cplusplus
}
#endif

#endif
