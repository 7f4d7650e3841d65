/* SPDX-License-Identifier: MIT
 * scene/scene_plates.c - a scene by chance: a slanted background, and plates in front of it. */
#include "scene_random.h"

#include <string.h>

/* lo..hi, both included. */
static int draw(uint32_t *state, int lo, int hi)
{
    *state = scene_hash(*state + 0x9e3779b9u);
    return lo + (int)(*state % (uint32_t)(hi - lo + 1));
}

/* Most paints are rich; one in four is faint and one in five repeats, which is where parameters matter. */
static void draw_paint(scene *s, int i, uint32_t *state)
{
    scene_noise *n = &s->noise[i];
    n->seed = scene_hash(*state ^ 0xa5a5u);
    n->grey = draw(state, 90, 165);
    n->contrast = draw(state, 0, 3) == 0 ? draw(state, 6, 14) : draw(state, 40, 85);
    n->finest = draw(state, 1, 2);
    n->coarsest = draw(state, 3, 6);
    n->stripes = draw(state, 0, 4) == 0 ? draw(state, 9, 23) : 0;
    s->surface[i].paint = scene_paint_noise;
    s->surface[i].what = n;
}

/* Slopes such that the disparity over the surface's own extent stays within +-reach of its middle value. */
static void draw_slopes(scene_surface *f, uint32_t *state, int32_t reach_q16, int wide, int high)
{
    f->a_q16 = draw(state, -100, 100) * (reach_q16 / 200) / (wide / 2 + 1);
    f->b_q16 = draw(state, -100, 100) * (reach_q16 / 200) / (high / 2 + 1);
}

static void draw_plate(scene *s, int i, uint32_t *state, int32_t near_q16, int32_t reach_q16)
{
    scene_surface *f = &s->surface[i];
    int w = s->width, h = s->height;
    int wide = draw(state, w / 10 + 1, w / 3 + 1), high = draw(state, h / 8 + 1, h / 2 + 1);
    f->x0 = draw(state, -wide / 4, w - 3 * wide / 4);
    f->y0 = draw(state, -high / 4, h - 3 * high / 4);
    f->x1 = f->x0 + wide;
    f->y1 = f->y0 + high;
    f->shape = draw(state, 0, 1) ? SCENE_BOX : SCENE_DISC;
    draw_slopes(f, state, reach_q16, wide, high);
    /* near_q16 is the disparity in the plate's own middle; c is that of the plane in the image's middle */
    int64_t off_x = (f->x0 + f->x1) / 2 - w / 2, off_y = (f->y0 + f->y1) / 2 - h / 2;
    f->c_q16 = (int32_t)(near_q16 - off_x * f->a_q16 - off_y * f->b_q16);
    draw_paint(s, i, state);
}

void scene_random(scene *s, int width, int height, int min_disparity, int num_disparities, int plates, uint32_t seed)
{
    uint32_t state = scene_hash(seed + 1);
    memset(s, 0, sizeof *s);
    s->width = width;
    s->height = height;
    s->seed = scene_hash(seed ^ 0x5eedu);
    s->right_gain_q8 = 256;
    s->count = plates + 1;
    /* the background keeps to the lowest quarter of the range, the plates to what is above */
    int32_t step_q16 = (num_disparities - 2) * 65536 / 64;
    int32_t base_q16 = min_disparity * 65536;
    s->surface[0].shape = SCENE_EVERYWHERE;
    s->surface[0].c_q16 = base_q16 + 9 * step_q16;
    draw_slopes(&s->surface[0], &state, 7 * step_q16, width, height);
    draw_paint(s, 0, &state);
    s->noise[0].contrast = 70; /* half of the image: rich, or the scene is about nothing else */
    s->noise[0].stripes = 0;
    for (int i = 1; i <= plates; i++)
        draw_plate(s, i, &state, base_q16 + draw(&state, 22, 58) * step_q16, 4 * step_q16);
}
