/* SPDX-License-Identifier: MIT
 * stad/match.h - Semi-Global Matching of rectified frames, row in, row out, bit for bit cv::StereoSGBM.
 *
 * Life of a matcher:   stad_match_init once; for every frame stad_match_begin, then push and pull rows until all are out.
 *
 *     for (y = 0; y < height; y++) {
 *         stad_match_push(&m, left_row(y), right_row(y));
 *         while ((row = stad_match_pull(&m, disp)) >= 0) use(row, disp);
 *     }
 *
 * (after the last push the loop drains what is left). Memory: the caller owns everything. `stad_match` is a struct to
 * declare anywhere; all that grows with the image lives in one workspace of STAD_MATCH_BYTES(...) bytes, aligned to
 * STAD_ALIGN, that belongs to the matcher until the next stad_match_init. Nothing is freed: drop both and it is gone.
 * Re-entrant: matchers with their own workspaces share nothing.
 *
 * The geometry fixes the memory; parameters may change on every frame within it. docs/SPEC.md says what is computed,
 * docs/MEMORY.md what the bytes are for. */
#ifndef STAD_MATCH_H
#define STAD_MATCH_H

#include <stddef.h>
#include <stdint.h>

#include "stad/config.h"
#include "stad/image.h"
#include "stad/match_bytes.h"
#include "stad/params.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Memory plans: the same bits, different bytes and time. */
enum stad_memory {
    STAD_MEMORY_FAST = 0, /* keeps every intermediate that saves time */
    STAD_MEMORY_SMALL = 1 /* recomputes what can be recomputed exactly */
};

/* What fixes the memory. */
typedef struct stad_geometry {
    int16_t width, height;      /* px of both frames */
    int16_t channels;           /* 1 or 3 */
    int16_t max_disparities;    /* largest num_disparities, a multiple of 8 */
    int16_t max_block_size;     /* largest block_size, odd */
    int16_t max_p2;             /* largest p2; <= 255 lets STAD_MEMORY_SMALL keep path state in bytes */
    int16_t max_pre_filter_cap; /* largest pre_filter_cap */
    uint8_t mode;               /* enum stad_mode */
    uint8_t memory;             /* enum stad_memory */
} stad_geometry;

/* What came of the pixels of a frame; complete when its last row has been pulled. */
typedef struct stad_match_counts {
    int32_t considered;          /* pixels in columns that can have a disparity */
    int32_t firm;                /* of these: best cost beats every rival outside +-1 by 25 percent */
    int32_t rejected_uniqueness; /* failed uniqueness_ratio */
    int32_t rejected_check;      /* failed the left-right check */
    int32_t valid;               /* left with a disparity, before median and speckle filter */
    int32_t rejected_speckle;    /* removed by the speckle filter (stad_match_frame only) */
} stad_match_counts;

/* Beyond OpenCV, all off by default so that the bits stay. */
enum stad_match_option {
    STAD_MATCH_NO_MEDIAN = 1, /* leave out the final 3x3 median */
    STAD_MATCH_CONFIDENCE = 2 /* compute the confidence rows that stad_match_pull_all() hands out */
};

/* A matcher. Declare it where you like; the field is private. */
typedef struct stad_match {
    uint64_t opaque[STAD_MATCH_WORDS]; /* private */
} stad_match;

/* Bytes of workspace for a geometry: the number that STAD_MATCH_BYTES() gives at compile time; 0 if the geometry is
 * invalid. For the parts of it see stad_match_part(). */
size_t stad_match_bytes(const stad_geometry *g);

/* The i-th part of the workspace: its bytes, and its name in *name; 0 and NULL past the last one. */
size_t stad_match_part(const stad_geometry *g, int i, const char **name);

/* Checks a geometry. STAD_OK, or STAD_E_PARAM with the offending field's name in *culprit (may be NULL); "height" also when
 * the workspace might not fit a 32-bit size_t. */
int stad_geometry_check(const stad_geometry *g, const char **culprit);

/* Binds a matcher to its workspace. STAD_E_PARAM: bad geometry; STAD_E_SIZE: `work` is NULL, misaligned or too small. The
 * workspace need not be cleared. */
int stad_match_init(stad_match *m, const stad_geometry *g, void *work, size_t work_bytes);

/* Options, a sum of enum stad_match_option, from now on: of a frame under way they act on the rows not yet pulled. Set them before
 * stad_match_begin(); stad_match_init() clears them. STAD_E_PARAM: unknown bits. */
int stad_match_options(stad_match *m, unsigned options);

/* Starts a frame; whatever was left of the one before is dropped. STAD_E_PARAM: outside the domain; STAD_E_LIMIT: valid, but
 * above the geometry; stad_match_culprit() names the field. */
int stad_match_begin(stad_match *m, const stad_params *p);

/* The field that the last stad_match_init() or stad_match_begin() objected to, or NULL. */
const char *stad_match_culprit(const stad_match *m);

/* Hands in the next row of both frames: width * channels bytes each, copied before the call returns. STAD_AGAIN: pull
 * first, the row was not taken; STAD_E_STATE: no frame begun, or all rows are in. */
int stad_match_push(stad_match *m, const uint8_t *left_row, const uint8_t *right_row);

/* Takes the next finished row: writes `width` disparities (int16, disparity * 16; (min_disparity - 1) * 16 = none) and
 * returns its row number. Rows come top down in STAD_MODE_SGBM and 3WAY, bottom up in HH and HH4, which need the whole
 * frame first. STAD_AGAIN: push first; STAD_E_STATE: no frame begun, or all rows are out. */
int stad_match_pull(stad_match *m, int16_t *disp_q4_row);

/* The same with the extras; each may be NULL. `confidence`: width bytes, 0..255, the uniqueness margin of the row's pixels
 * (docs/SPEC.md; needs STAD_MATCH_CONFIDENCE, else zeros). `right_q4`: width disparities of the right view, as the
 * left-right check sees them. Neither is touched by median or speckle filter. */
int stad_match_pull_all(stad_match *m, int16_t *disp_q4_row, uint8_t *confidence, int16_t *right_q4);

/* A whole frame through the loop above, then the speckle filter if the parameters ask for it. `disp_stride` counts int16
 * elements. `speckle_work`: STAD_SPECKLE_BYTES(width, height) aligned for int32_t, or NULL when speckle_window_size is 0.
 * STAD_E_SIZE: an image or the speckle workspace does not fit the geometry; nothing is written. */
int stad_match_frame(stad_match *m, const stad_params *p, const stad_image *left, const stad_image *right, int16_t *disp_q4,
                     ptrdiff_t disp_stride, void *speckle_work, size_t speckle_bytes);

/* Counters of the frame. The pointer lives as long as the matcher. */
const stad_match_counts *stad_match_counts_of(const stad_match *m);

/* cv::filterSpeckles: components of 4-connected pixels other than `none_q4`, joined where they differ by at most max_diff_q4,
 * become `none_q4` when they have at most max_size pixels. Returns the number of pixels removed, or STAD_E_SIZE. */
int32_t stad_speckle_filter(int16_t *disp_q4, ptrdiff_t disp_stride, int32_t width, int32_t height, int16_t none_q4,
                            int32_t max_size, int32_t max_diff_q4, void *work, size_t work_bytes);

#ifdef __cplusplus
}
#endif

#endif
