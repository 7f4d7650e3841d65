/* SPDX-License-Identifier: MIT
 * stad/mark.h - frames -> [MARK] -> pair -> rig, truth: fiducial marks of the family AprilTag 36h11.
 *
 * stad_mark_find() looks for marks in one image and gives their identity and their four corners to a few hundredths of a
 * pixel; stad_mark_pair() joins what the left and the right camera saw of the same mark. Both work in integers and in memory
 * that the caller owns: no image is copied, nothing is kept after the call, and one workspace serves left and right in turn.
 *
 * A mark is a black square of 8 x 8 cells (a border one cell wide round 6 x 6 cells of code) on a white surround at least one
 * cell wide. `Side` is the side of the black square. From 24 px a side it is found nearly always, from 32 px also in strong
 * noise; below 16 px not at all. Marks cut by the image's edge, and mirrored ones, are not found.
 *
 * Coordinates: pixels in Q8, (0, 0) is the CENTRE of the first pixel, x to the right, y down. A library that puts the centre
 * of the first pixel at (0.5, 0.5) reports the same corner larger by 128 in both. */
#ifndef STAD_MARK_H
#define STAD_MARK_H

#include <stddef.h>
#include <stdint.h>

#include "stad/image.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Identities in the table: 0 .. STAD_MARK_IDS - 1, the first words of the family. */
#define STAD_MARK_IDS 32

/* Largest width and height of an image that is searched; the smallest is 16. */
#define STAD_MARK_MAX_SIZE 2048

/* A point of an image, Q8 pixels. */
typedef struct stad_corner {
    int32_t x_q8, y_q8; /* px * 256 */
} stad_corner;

/* One mark in one image. The corners are those of the black square, in the order top left, top right, bottom right, bottom
 * left of the mark AS PRINTED, whatever its turn in the image: corner i of the left view and corner i of the right view are
 * the same point of the world. */
typedef struct stad_mark {
    int16_t id;            /* 0 .. STAD_MARK_IDS - 1 */
    int16_t hamming;       /* code bits that had to be corrected, 0 .. 2 */
    stad_corner corner[4]; /* Q8 px */
} stad_mark;

/* The same mark in both views. */
typedef struct stad_pair {
    int16_t id;                    /* of the mark */
    stad_corner left[4], right[4]; /* Q8 px, same order */
} stad_pair;

/* What to look for. stad_mark_config_default() gives: all identities, 2 bits, contrast 20. */
typedef struct stad_mark_config {
    uint32_t ids;         /* bit i set: identity i is wanted */
    uint8_t max_hamming;  /* 0 .. 2; words of the family differ in at least 11 bits */
    uint8_t min_contrast; /* grey levels, 8 .. 128: least difference of black and white within 12 x 12 pixels */
} stad_mark_config;

/* Fills in what is said above. */
void stad_mark_config_default(stad_mark_config *c);

/* Bytes of workspace for an image, an integer constant expression for constant arguments: 27.6 KB at 320 x 240, 74 KB at
 * 640 x 480. In order: the dark map (1 bit a pixel), extremes of four tile rows, two rows of runs, components, their free
 * list, one contour, the cells of one mark. stad_mark_bytes() gives the same number at run time, 0 for an invalid size. */
#define STAD_MARK_BYTES(width, height)                                                                                 \
    (STAD_MARK_PAD(((size_t)(width) + 7u) / 8u * (size_t)(height)) + STAD_MARK_PAD(((size_t)(width) + 3u) / 4u * 8u) + \
     STAD_MARK_PAD(12u * ((size_t)(width) / 2u + 2u)) + STAD_MARK_PAD(24u * ((size_t)(width) + 8u)) +                  \
     STAD_MARK_PAD(2u * ((size_t)(width) + 8u)) + STAD_MARK_PAD(12u * ((size_t)(width) + (size_t)(height))) + 160u)
#define STAD_MARK_PAD(bytes) (((size_t)(bytes) + 7u) / 8u * 8u) /* up to whole words */
/* The same at run time; 0 for an invalid size. */
size_t stad_mark_bytes(int32_t width, int32_t height);

/* A cell of the mark as printed: 1 white, 0 black. `row`, `column`: 0 .. 7 from the top left of the black square; the cells
 * round it (-1 and 8) are the white surround. For those who draw marks. */
int stad_mark_cell(int id, int row, int column);

/* Finds the marks of an image, top to bottom by the last row they touch, and writes at most `max` of them to `out`. Returns
 * how many were written (0 is no error; with `max` reached the rest is not looked for).
 *
 * `img`: 1 channel, or 3 of which the middle one (green) is used. `work`: stad_mark_bytes() bytes aligned to STAD_ALIGN, need
 * not be cleared, free for other use after the call. `config` NULL: the default. An identity that appears twice in the image
 * is returned twice; stad_mark_pair() then leaves it out.
 * STAD_E_PARAM: config or channels; STAD_E_SIZE: image or workspace. Time is bounded by the image's size alone: every loop
 * runs over pixels, runs, or the contour of a component, and each component is followed at most once. */
int stad_mark_find(const stad_image *img, const stad_mark_config *config, stad_mark *out, int max, void *work, size_t work_bytes);

/* Pairs the marks of two views by identity, in the order of `left`; an identity that is not exactly once in each view is left
 * out. Returns the number of pairs written, at most `max`. Nothing is assumed about the rectification, so a drifted rig pairs
 * as well as a sound one. */
int stad_mark_pair(const stad_mark *left, int left_count, const stad_mark *right, int right_count, stad_pair *out, int max);

#ifdef __cplusplus
}
#endif

#endif
