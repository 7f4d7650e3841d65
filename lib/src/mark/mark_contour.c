/* SPDX-License-Identifier: MIT
 * components -> [mark/mark_contour.c] -> quad - the outer contour of a component, along the cracks between pixels.
 *
 * The walk keeps the component on its right, so it goes clockwise on the screen; where dark pixels touch by a corner only it
 * turns right and keeps them apart. A component off the image's border is walked without a bounds check: the walk looks at
 * pixels at most one beside it. */
#include "mark/mark_work.h"

static int is_dark(const mark_work *w, int32_t x, int32_t y)
{
    return w->dark[y * w->dark_stride + x / 8] >> (x % 8) & 1;
}

/* The four directions clockwise from east, and where the pixels ahead lie from a crack's end: on the left, on the right. */
static const int8_t step_x[4] = {1, 0, -1, 0}, step_y[4] = {0, 1, 0, -1};
static const int8_t left_x[4] = {0, 0, -1, -1}, left_y[4] = {-1, 0, 0, -1};
static const int8_t right_x[4] = {0, -1, -1, 0}, right_y[4] = {0, 0, -1, -1};

int stad_mark_contour(mark_work *w, const mark_component *c, int32_t *area2)
{
    const int32_t box_w = c->right - c->left + 1, box_h = c->bottom - c->top + 1;
    const int32_t longest = 3 * (box_w + box_h);
    int32_t x = c->start_x, y = c->top, count = 0, area = 0;
    unsigned direction = 0;
    do {
        if (count == longest)
            return 0;
        w->contour[count].x = (int16_t)x;
        w->contour[count++].y = (int16_t)y;
        area += (x - c->left) * step_y[direction] - (y - c->top) * step_x[direction];
        x += step_x[direction];
        y += step_y[direction];
        if (!is_dark(w, x + right_x[direction], y + right_y[direction]))
            direction = (direction + 1) % 4;
        else if (is_dark(w, x + left_x[direction], y + left_y[direction]))
            direction = (direction + 3) % 4;
    } while (x != c->start_x || y != c->top); /* reached upwards along the first pixel alone, and left to the east */
    w->contour_count = count;
    *area2 = area;
    return area * 3 >= 2 * box_w * box_h;
}
