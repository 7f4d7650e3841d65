/* SPDX-License-Identifier: MIT
 * stad/rig.h - pairs -> [RIG] -> truth: is the rectification sound, and if not, the correction that makes it so.
 *
 * Stereo matching trusts that a point has the same row in both images. A knock or heat breaks that: half a pixel costs more
 * than tuning can win back, and no statistic of the matcher tells. The corners of marks tell: their dy = y_right - y_left is
 * fitted by
 *
 *     dy(x, y) = a + b (x - cx) + c (y - cy),    cx = width / 2, cy = height / 2 (integer division)
 *
 * a shift, a turn b and a scale c of the right camera, to which belongs dx(x, y) = c (x - cx) - b (y - cy). The corrected
 * right image is out(x, y) = right(x + dx, y + dy). What cannot be seen this way: a constant error in x. It moves all
 * disparities alike; nothing in two views of one mark tells it from a mark at another distance. It needs a known distance.
 *
 * A corrected rig is checked and fitted again on the RAW right image, never on the corrected one; stad_rig_straighten() moves
 * marks found in the raw image to where they are in the corrected one. */
#ifndef STAD_RIG_H
#define STAD_RIG_H

#include <stddef.h>
#include <stdint.h>

#include "stad/image.h"
#include "stad/mark.h"
#include "stad/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A correction. Plain integers without padding: copy it, store it, send it. All zeros but the size: no correction. */
typedef struct stad_rig {
    int32_t a_q16;         /* px at the centre */
    int32_t b_q24, c_q24;  /* px per px */
    int16_t width, height; /* of the images it was fitted for */
} stad_rig;

/* By the model's worst |dy| over the four corners of the image. Larger is worse. */
enum stad_rig_verdict {
    STAD_RIG_GOOD = 0,    /* < 0.25 px: leave it */
    STAD_RIG_WATCH = 1,   /* 0.25 .. 0.5 px: correct it if the marks span enough, else look again */
    STAD_RIG_CORRECT = 2, /* 0.5 .. 8 px: correct it before anything is tuned */
    STAD_RIG_FAIL = 3     /* > 8 px, or residual above 0.3 px, or fewer than 8 corners: needs a full calibration */
};

/* The numbers behind a verdict, Q8 px. */
typedef struct stad_rig_report {
    int32_t rms_before_q8; /* of dy over the corners, as seen */
    int32_t rms_after_q8;  /* of what the model leaves */
    int32_t worst_q8;      /* model's largest |dy| over the image's corners */
    int32_t span_q8;       /* extent in x of the corners */
    int16_t corners;       /* 4 a pair */
    uint8_t verdict;       /* enum stad_rig_verdict */
    uint8_t advised;       /* 1: apply this correction (CORRECT, or WATCH with the corners spanning a third of the width) */
} stad_rig_report;

/* The correction that does nothing, for images of that size. */
void stad_rig_identity(stad_rig *r, int width, int height);

/* Fits the model to all corners of `n` pairs, found in raw frames of `width` x `height`; pairs of several frames may be
 * strung together. Returns the verdict (>= 0), with the numbers in *report. STAD_RIG_FAIL with report->corners < 8 means
 * that nothing can be said; the rig is then the identity. Marks that span little of the image leave b or c badly known, which
 * is why `advised` asks for a span: use pairs of several poses. STAD_E_PARAM: width or height outside 16 .. 2048, or n
 * outside 0 .. 1024.
 * When not to call it: on corners of one small mark only. */
int stad_rig_fit(stad_rig *r, stad_rig_report *report, const stad_pair *pairs, int n, int width, int height);

/* Where in the raw right image the pixel (x, y) of the corrected one lies. In and out Q8 px. For boards that remap anyway:
 * fold this into the table. */
stad_corner stad_rig_apply(const stad_rig *r, stad_corner corrected);

/* The inverse: moves the right corners of pairs found in raw frames into the corrected image. */
void stad_rig_straighten(const stad_rig *r, stad_pair *pairs, int n);

/* Rows of the raw image that row y of the corrected one needs: first .. last, clipped to the image. Not checked: y must be a row
 * of the image, and the correction one that stad_rig_row() takes. */
void stad_rig_rows(const stad_rig *r, int y, int *first, int *last);

/* Writes row y of the corrected right image: width * channels bytes. 4 taps each way at 16 phases (cubic), pixels outside
 * repeat the border. STAD_E_SIZE: the image is not the rig's size, or y is outside; STAD_E_PARAM: a shift above 64 px or a
 * slope above 1/16. */
int stad_rig_row(const stad_rig *r, const stad_image *right, int y, uint8_t *out_row);

/* -- the same as a stream, for boards that see rows and no frame -------------------------------------------------------- */

/* Rows in the ring for corrections up to max_dy px, and the workspace in bytes. */
#define STAD_RIG_RING(max_dy) (2 * (max_dy) + 6)
/* The bytes of the ring. */
#define STAD_RIG_BYTES(width, channels, max_dy) ((size_t)(width) * (size_t)(channels) * (size_t)STAD_RIG_RING(max_dy))

/* A frame under way. Private but for being declared. */
typedef struct stad_rig_stream {
    stad_rig rig;                                /* the correction */
    uint8_t *ring;                               /* the workspace */
    int16_t channels, ring_rows, pushed, pulled; /* shape of the ring, rows so far */
} stad_rig_stream;

/* Starts a frame. `work`: STAD_RIG_BYTES(width, channels, max_dy) bytes, the caller's, used until the frame is out.
 * STAD_E_LIMIT: the correction moves some row by more than max_dy px; STAD_E_SIZE: workspace; STAD_E_PARAM: channels not
 * 1 or 3, max_dy outside 0 .. 16, or as above. */
int stad_rig_begin(stad_rig_stream *s, const stad_rig *r, int channels, int max_dy, void *work, size_t work_bytes);

/* Hands in the next raw row, copied. STAD_AGAIN: pull first, not taken; STAD_E_STATE: all rows are in. */
int stad_rig_push(stad_rig_stream *s, const uint8_t *raw_row);

/* Takes the next corrected row and returns its number. STAD_AGAIN: push first; STAD_E_STATE: all rows are out. */
int stad_rig_pull(stad_rig_stream *s, uint8_t *out_row);

#ifdef __cplusplus
}
#endif

#endif
