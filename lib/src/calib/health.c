/* SPDX-License-Identifier: MIT
 * frame -> [HEALTH] -> marks        calib/health.c - black, white, blank, frozen or equal views are not looked at further
 *
 * Every fourth pixel of every fourth row: 4,800 samples at 320 x 240. A live sensor never gives the same samples
 * twice; one that hands out buffers in turns gives them again after a few frames. */
#include "calib/calib_parts.h"

#include "base/arith.h"

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

/* Among the last pictures; and remembers this one, first. */
static int is_known(stad_calib_view *view, uint32_t hash)
{
    int known = 0;
    uint32_t moved = hash;
    for (int i = 0; i < STAD_CALIB_SEEN; i++) {
        uint32_t was = view->hash[i];
        known |= was == hash;
        view->hash[i] = moved;
        moved = was;
    }
    return known;
}

static int view_fault(const stad_calib *c, stad_calib_view *view, const stad_image *image)
{
    samples s = take(image);
    int frozen = is_known(view, s.hash) && !c->config.still;
    if (s.high < DARK)
        return STAD_FAULT_BLACK;
    if (s.high - s.low < CONTRAST)
        return s.low >= WHITE ? STAD_FAULT_SATURATED : STAD_FAULT_FLAT;
    if (2 * s.white > s.count)
        return STAD_FAULT_SATURATED;
    return frozen ? STAD_FAULT_FROZEN : STAD_FAULT_NONE;
}

int stad_calib_size_fits(const stad_calib *c, const stad_image *image)
{
    const stad_geometry *g = &c->config.geometry;
    return image->width == g->width && image->height == g->height && image->channels == g->channels;
}

/* Both views are hashed even if the first is at fault, so that the next frame is compared with this one. */
int stad_calib_views_fault(const stad_calib *c, stad_calib_view *view, const stad_image *left, const stad_image *right)
{
    if (!left || !right)
        return STAD_FAULT_LATE;
    if (!stad_calib_size_fits(c, left) || !stad_calib_size_fits(c, right))
        return STAD_FAULT_SIZE;
    int fault = view_fault(c, &view[0], left), second = view_fault(c, &view[1], right);
    if (fault == STAD_FAULT_NONE)
        fault = second;
    return fault == STAD_FAULT_NONE && view[0].hash[0] == view[1].hash[0] ? STAD_FAULT_SAME : fault;
}

int stad_calib_live(stad_calib *c, const stad_image *left, const stad_image *right)
{
    STAD_ASSERT(c && c->config.target); /* initialised */
    return stad_calib_views_fault(c, c->live, left, right);
}
