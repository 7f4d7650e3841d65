/* SPDX-License-Identifier: MIT
 * stad/truth.h - pairs -> [TRUTH] -> score: what the disparity must be, where a calibration target says so.
 *
 * On a plane the disparity of rectified images is affine in the left image's coordinates, d = a x + b y + c, without any
 * knowledge of the cameras. So the corners of two to four marks on a flat sheet give the truth of the whole sheet to about a
 * sixteenth of a pixel. A truth is a list of such planes, each valid within a convex polygon of the left image, and of masks.
 * stad_truth_row() renders one row of it at a time: where planes overlap the nearer wins, and pixels whose counterpart in the
 * right view is hidden by a nearer plane are labelled as occluded. Everything is integer arithmetic in a struct of fixed size;
 * no image is kept.
 *
 * Three ways to fill it, after stad_truth_init():
 *   stad_truth_from_target()  a printed target with relief, from its table; needs the cameras' focal length
 *   stad_plane_fit() + stad_truth_add_plane()  any flat thing that carries marks; no calibration needed
 *   stad_truth_add_plane()    corners from elsewhere, a chessboard for example
 * A flat target alone misleads the tuning of the matcher: see docs/CALIBRATION.md before using the last two for it. */
#ifndef STAD_TRUTH_H
#define STAD_TRUTH_H

#include <stdint.h>

#include "stad/mark.h"
#include "stad/status.h"
#include "stad/target.h"

#ifdef __cplusplus
extern "C" {
#endif

/* d = (a_q16 x + b_q16 y + c_q16) / 65536 px at left pixel (x, y). Within its polygon |d| < 2048 px, |a|, |b| < 1. */
typedef struct stad_plane {
    int32_t a_q16, b_q16, c_q16; /* px per px, px per px, px */
} stad_plane;

/* A convex polygon of the left image; its corners in order, either way round. */
#define STAD_POLYGON_MAX 8 /* corners at most */

/* The polygon. */
typedef struct stad_polygon {
    int32_t count;                   /* 3 .. STAD_POLYGON_MAX */
    stad_corner p[STAD_POLYGON_MAX]; /* the corners, Q8 px */
} stad_polygon;

/* A box of pixels. */
typedef struct stad_box {
    int16_t x, y, width, height; /* px; x, y: the top left one */
} stad_box;

/* Planes and masks that a truth can hold; the relief target takes 13. */
#define STAD_TRUTH_LAYERS 16

/* A plane or a mask. */
typedef struct stad_truth_layer {
    stad_plane plane;   /* of a mask: unused */
    stad_polygon where; /* left pixels */
    int32_t is_mask;    /* 1: nothing is scored here */
} stad_truth_layer;

/* A truth, 1.4 KB. Declare it anywhere, fill it by the calls below; the fields are private. */
typedef struct stad_truth {
    int16_t width, height, min_disparity, num_disparities, margin, count; /* as stad_truth_init() was told; layers */
    stad_truth_layer layer[STAD_TRUTH_LAYERS];                            /* in the order they were added */
} stad_truth;

/* An empty truth for frames of width x height (16 .. 2048) and the matcher's range of disparities: columns in which the
 * matcher cannot search the whole range are never scored. `margin`: px, 0 .. 16, left out along the rim of
 * every plane; 1 suits marks found by stad_mark_find(). STAD_E_PARAM: out of range. */
int stad_truth_init(stad_truth *t, int width, int height, int min_disparity, int num_disparities, int margin);

/* Adds a plane. STAD_E_LIMIT: STAD_TRUTH_LAYERS are in already; STAD_E_PARAM: fewer than 3 or more than STAD_POLYGON_MAX
 * corners, corners that turn both ways (that the sides do not cross is not checked: a pentagram passes), farther than 4096 px
 * outside, or a slope or a disparity of the plane out of range. */
int stad_truth_add_plane(stad_truth *t, const stad_plane *plane, const stad_polygon *where);

/* Adds a mask: inside it nothing is scored of what was added BEFORE it. Planes added later lie on top. A mask hides nothing from
 * the right camera, as its disparity is unknown: where that matters, let it reach farther to the left. Same errors. */
int stad_truth_add_mask(stad_truth *t, const stad_polygon *where);

/* Row y: `width` truths in px * 65536 and labels (enum stad_label of stad/score.h; what the right camera cannot see is
 * STAD_LABEL_OCCLUDED). Where the label is STAD_LABEL_IGNORED the truth means nothing. STAD_E_SIZE: width is not that of the truth, or y is
 * outside. */
int stad_truth_row(const stad_truth *t, int y, int width, int32_t *truth_q16_row, uint8_t *label_row);

/* The box of left pixels that may carry a label, widened to the left by the columns that the matcher needs to search its
 * range: matching this crop scores what matching the whole frame would. Empty (width 0): nothing to score. */
stad_box stad_truth_box(const stad_truth *t);

/* Moves a truth of the frame to a crop of it, the same box in both views. STAD_E_PARAM: the box is not within the frame. */
int stad_truth_crop(stad_truth *t, const stad_box *box);

/* Pixels between the first and the last covered one of each row: an upper bound of what can be scored. A frame with fewer
 * than 2,000 at 320 x 240 (in proportion elsewhere) is not worth tuning on. */
int32_t stad_truth_pixels(const stad_truth *t);

/* The numbers behind a fit. */
typedef struct stad_plane_report {
    int32_t rms_q8;  /* px, of the disparities of the corners used */
    int16_t corners; /* used */
    int16_t dropped; /* identity of the mark left out, or -1 */
} stad_plane_report;

/* Fits a plane to the corners of `n` pairs on one flat thing: at least 2 marks, 4 are better; one mark alone extrapolates ten
 * times worse. If the rms exceeds 0.25 px the mark that fits worst is left out, once, when 2 remain; if it still does, or
 * fewer than 2 marks are there, STAD_E_NO_MARK. STAD_E_RIG: a slope out of range. `report` may be NULL. The rig must have
 * been corrected first: pass straightened pairs. */
int stad_plane_fit(stad_plane *plane, stad_plane_report *report, const stad_pair *pairs, int n);

/* Adds all planes of a target to an initialised truth: the base from its marks in `pairs` (at least 2 of them; other
 * identities are ignored), each raised facet from the base plane, its height and the focal length, its walls masked.
 * A target without raised facets needs no cameras: pass NULL. Returns the number of planes added (facets seen from behind or
 * edge on are masked). STAD_E_NO_MARK: too few marks, marks that do not fit one plane, or fewer pixels than stad_truth_pixels()
 * asks for; STAD_E_PARAM: cameras missing or out of range; STAD_E_LIMIT: too many layers; STAD_E_RIG: with these cameras three
 * or more marks make no rectangular sheet in space, as focal length or principal point are wrong. After an error *t is undefined.
 * The focal length matters through the sheet's tilt alone: it bends facets, not the base; so only a sheet that leans gives it away,
 * by half a radian an error of about a quarter. */
int stad_truth_from_target(stad_truth *t, const stad_target *target, const stad_pair *pairs, int n, const stad_camera *camera);

#ifdef __cplusplus
}
#endif

#endif
