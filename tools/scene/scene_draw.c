/* SPDX-License-Identifier: MIT
 * scene/scene_draw.c - draws a scene: for every pixel of either view the surface in front, its paint, its disparity. */
#include "scene_draw.h"

#include <stdlib.h>
#include <string.h>

#include "scene_random.h"

/* Disparity at x (px * 65536) and row y. */
static int64_t disparity_at(const scene *s, const scene_surface *f, int64_t x_q16, int y)
{
    int64_t off = x_q16 - (int64_t)s->width * 32768;
    return f->c_q16 + off * f->a_q16 / 65536 + (int64_t)(2 * y - s->height) * f->b_q16 / 2;
}

/* The x on the surface that the right camera sees at xr: x - d(x) = xr, solved for x. */
static int64_t x_seen_from_right(const scene *s, const scene_surface *f, int64_t xr_q16, int y)
{
    int64_t at_zero = disparity_at(s, f, 0, y); /* d(x) = at_zero + a x */
    return (xr_q16 + at_zero) * 65536 / (65536 - f->a_q16);
}

/* A box's edges lie half a pixel before its first pixel and after its last, so a left pixel is in it or not, whole. */
static int covers(const scene_surface *f, int64_t x_q16, int y)
{
    if (f->shape == SCENE_EVERYWHERE)
        return 1;
    if (y < f->y0 || y >= f->y1 || x_q16 < (int64_t)f->x0 * 65536 - 32768 || x_q16 >= (int64_t)f->x1 * 65536 - 32768)
        return 0;
    if (f->shape == SCENE_BOX)
        return 1;
    /* both axes scaled to 1024 half axes: squares stay far below 2^63 */
    int64_t dx = (2 * x_q16 - (int64_t)(f->x0 + f->x1 - 1) * 65536) / 64 / (f->x1 - f->x0);
    int64_t dy = (int64_t)(2 * y - (f->y0 + f->y1 - 1)) * 1024 / (f->y1 - f->y0);
    return dx * dx + dy * dy <= 1024 * 1024;
}

/* A surface met by a ray: which, where on it, how near. */
typedef struct hit {
    int surface;
    int64_t x_q16, d_q16;
} hit;

static hit look_left(const scene *s, int x, int y)
{
    hit best = {-1, 0, 0};
    for (int i = 0; i < s->count; i++) {
        int64_t at = (int64_t)x * 65536, d = disparity_at(s, &s->surface[i], at, y);
        if (covers(&s->surface[i], at, y) && (best.surface < 0 || d > best.d_q16))
            best = (hit){i, at, d};
    }
    return best;
}

static hit look_right(const scene *s, int64_t xr_q16, int y)
{
    hit best = {-1, 0, 0};
    for (int i = 0; i < s->count; i++) {
        int64_t at = x_seen_from_right(s, &s->surface[i], xr_q16, y), d = at - xr_q16;
        if (covers(&s->surface[i], at, y) && (best.surface < 0 || d > best.d_q16))
            best = (hit){i, at, d};
    }
    return best;
}

static int grey_of(const scene *s, const hit *h, int y)
{
    const scene_surface *f = &s->surface[h->surface];
    return f->paint(f->what, (int32_t)(h->x_q16 / 256), y * 256);
}

/* What a camera makes of it: gain, and noise as the sum of four dice. */
static uint8_t expose(const scene *s, int grey, int right, int x, int y)
{
    uint32_t dice = scene_hash(s->seed + scene_hash((uint32_t)(right << 30 | y << 15 | x)));
    int sum = (int)(dice & 255) + (int)(dice >> 8 & 255) + (int)(dice >> 16 & 255) + (int)(dice >> 24) - 510;
    int v = (right ? grey * s->right_gain_q8 / 256 : grey) + sum * s->camera_noise / 510;
    return (uint8_t)(v < 0 ? 0 : v > 255 ? 255 : v);
}

/* Is the left pixel's point inside the right image, and in front there? 1/64 px of slack for the division's rounding. */
static int seen_from_right(const scene *s, const hit *h, int y)
{
    int64_t xr = h->x_q16 - h->d_q16;
    if (xr < -32768 || xr >= (int64_t)s->width * 65536 - 32768)
        return 0;
    hit front = look_right(s, xr, y);
    return front.surface == h->surface || front.d_q16 - h->d_q16 <= 1024;
}

static void render_row(const scene *s, int y, picture *left, picture *right, int32_t *truth_q16, picture *visible)
{
    size_t row = (size_t)y * (size_t)s->width;
    for (int x = 0; x < s->width; x++) {
        size_t at = row + (size_t)x;
        hit l = look_left(s, x, y), r = look_right(s, (int64_t)x * 65536, y);
        left->pix[at] = expose(s, grey_of(s, &l, y), 0, x, y);
        right->pix[at] = expose(s, grey_of(s, &r, y), 1, x, y);
        truth_q16[at] = (int32_t)l.d_q16;
        visible->pix[at] = seen_from_right(s, &l, y) ? 255 : 0;
    }
}

int scene_render(const scene *s, picture *left, picture *right, int32_t **truth_q16, picture *visible, tool_fail *f)
{
    memset(left, 0, sizeof *left);
    memset(right, 0, sizeof *right);
    memset(visible, 0, sizeof *visible);
    *truth_q16 = malloc((size_t)s->width * (size_t)s->height * sizeof **truth_q16);
    int status = *truth_q16 ? TOOL_OK : tool_fail_set(f, TOOL_FILE, "not enough memory for the scene");
    if (status == TOOL_OK)
        status = picture_alloc(left, s->width, s->height, 1, f);
    if (status == TOOL_OK)
        status = picture_alloc(right, s->width, s->height, 1, f);
    if (status == TOOL_OK)
        status = picture_alloc(visible, s->width, s->height, 1, f);
    for (int y = 0; status == TOOL_OK && y < s->height; y++)
        render_row(s, y, left, right, *truth_q16, visible);
    if (status) {
        picture_free(left);
        picture_free(right);
        picture_free(visible);
        free(*truth_q16);
        *truth_q16 = NULL;
    }
    return status;
}
