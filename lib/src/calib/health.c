/* SPDX-License-Identifier: MIT
 * frame -> [HEALTH] -> marks        calib/health.c - black, white, blank or frozen views are not looked at further
 *
 * Every fourth pixel of every fourth row: 1,200 samples at 320 x 240 / 16. A live sensor never gives the same samples
 * twice; one that hands out buffers in turns gives them again after a few frames. */
#include "calib/calib_parts.h"

#define GRID     4
#define DARK     24 /* nothing brighter: a mark needs 20 grey levels of contrast to be found */
#define CONTRAST 24
#define WHITE    250

typedef struct samples {
    int32_t count, white;
    uint8_t low, high;
    uint32_t hash; /* FNV-1a, 32 bit */
} samples;

static samples take(const stad_image *image)
{
    samples s = {0, 0, 255, 0, 2166136261u};
    ptrdiff_t step = (ptrdiff_t)GRID * image->pixel_stride;
    for (int32_t y = 0; y < image->height; y += GRID) {
        const uint8_t *p = image->pix + y * image->row_stride + (image->channels == 3 ? 1 : 0);
        for (int32_t x = 0; x < image->width; x += GRID, p += step) {
            s.low = *p < s.low ? *p : s.low;
            s.high = *p > s.high ? *p : s.high;
            s.white += *p >= WHITE;
            s.hash = (s.hash ^ *p) * 16777619u;
            s.count++;
        }
    }
    return s;
}

/* Among the last pictures; and remembers this one. */
static int is_known(stad_calib_view *view, uint32_t hash)
{
    int known = 0, most = view->seen < STAD_CALIB_SEEN ? view->seen : STAD_CALIB_SEEN;
    for (int i = 0; i < most; i++)
        known |= view->hash[i] == hash;
    view->hash[view->next] = hash;
    view->next = (view->next + 1) % STAD_CALIB_SEEN;
    view->seen = most < STAD_CALIB_SEEN ? most + 1 : most;
    return known;
}

int stad_calib_view_fault(stad_calib_view *view, const stad_image *image, int may_be_still)
{
    samples s = take(image);
    int frozen = is_known(view, s.hash) && !may_be_still;
    if (s.high < DARK)
        return STAD_FAULT_BLACK;
    if (s.high - s.low < CONTRAST)
        return s.low >= WHITE ? STAD_FAULT_SATURATED : STAD_FAULT_FLAT;
    if (2 * s.white > s.count)
        return STAD_FAULT_SATURATED;
    return frozen ? STAD_FAULT_FROZEN : STAD_FAULT_NONE;
}
