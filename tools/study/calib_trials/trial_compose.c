/* SPDX-License-Identifier: MIT
 * open scene + target -> [trial_compose.c] -> frames, labels of the rest */
#include "trial.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "stad/score.h"

int trial_read(trial_scene *s, const char *left, const char *right, const char *truth, const char *mask, int disparities,
               tool_fail *f)
{
    if (engine_read_pair(&s->left, &s->right, left, right, 0, f) != TOOL_OK)
        return f->status;
    if (truth_read(&s->truth, truth, 0, 0, f) != TOOL_OK || (mask && truth_mask(&s->truth, mask, f) != TOOL_OK))
        return f->status;
    s->width = s->left.width;
    s->height = s->left.height;
    s->disparities = disparities;
    if (s->truth.width != s->width || s->truth.height != s->height)
        return tool_fail_set(f, TOOL_FILE, "%s: not the size of the pictures", truth);
    return TOOL_OK;
}

/* A wide lens, as boards have; the baseline puts the target at a bit more than half of the range that is searched. */
target_camera trial_camera(const trial_scene *s)
{
    target_camera c;
    target_camera_default(&c, s->width, s->height);
    c.f = 0.6 * s->width;
    c.psf = 0.7;
    return c;
}

static double spread(target_random *r, double by)
{
    return by * (2 * target_random_uniform(r) - 1);
}

/* Pose 0 tunes, pose 1 judges: the sheet 0.42 of the image wide, leaning back, right of the columns that are not searched. */
static target_pose place(const trial_scene *s, target_camera *c, int which, unsigned seed)
{
    target_random r;
    target_random_seed(&r, seed * 16u + (unsigned)which);
    const stad_target *t = stad_target_relief();
    const double share = 0.42 + spread(&r, 0.03), z = c->f * t->width_mm / (share * s->width);
    const double px = s->width * (0.62 + (which ? -0.04 : 0.02)) + spread(&r, 0.03 * s->width);
    const double py = s->height * (which ? 0.46 : 0.52) + spread(&r, 0.03 * s->height);
    target_pose p;
    c->baseline = 0.52 * s->disparities * z / c->f;
    p.centre.z = z;
    p.centre.x = (px - c->cx) * z / c->f;
    p.centre.y = (py - c->cy) * z / c->f;
    p.pitch = 0.5 + spread(&r, 0.1);
    p.yaw = (which ? -0.12 : 0.12) + spread(&r, 0.08);
    p.roll = spread(&r, 0.06);
    return p;
}

/* Labels of the scene, without what the target touches in either view (4 px of margin: half a block and the blur). */
static uint8_t *rest_labels(const trial_scene *s, const float *cover_left, const float *cover_right)
{
    const int w = s->width, h = s->height, margin = 4;
    uint8_t *label = malloc((size_t)w * (size_t)h);
    memcpy(label, s->truth.label, (size_t)w * (size_t)h);
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            const int k = y * w + x;
            const int d = s->truth.label[k] ? (int)(s->truth.q16[k] / 65536) : 0;
            int touched = 0;
            for (int v = -margin; v <= margin && !touched; v++)
                for (int u = -margin; u <= margin && !touched; u++) {
                    const int yy = y + v, xl = x + u, xr = x + u - d;
                    if (yy < 0 || yy >= h)
                        continue;
                    touched |= xl >= 0 && xl < w && cover_left[yy * w + xl] > 0.01f;
                    touched |= xr >= 0 && xr < w && cover_right[yy * w + xr] > 0.01f;
                }
            if (touched)
                label[k] = STAD_LABEL_IGNORED;
        }
    return label;
}

static float *floats_of(const picture *p)
{
    const int n = p->width * p->height;
    float *out = malloc(sizeof *out * (size_t)n);
    for (int i = 0; i < n; i++)
        out[i] = p->pix[i];
    return out;
}

void trial_compose(trial_frame *out, const trial_scene *s, int which, int kind, unsigned seed)
{
    static target_scene scene;
    tool_fail f;
    const size_t n = (size_t)s->width * (size_t)s->height;
    float *behind[2] = {floats_of(&s->left), floats_of(&s->right)};
    float *view[2], *cover[2];
    target_camera camera = trial_camera(s);
    target_pose pose = place(s, &camera, which, seed);
    target_random r;
    target_scene_clear(&scene);
    if (which != TRIAL_WITHOUT_TARGET)
        target_scene_add(&scene, stad_target_relief(), &pose);
    for (int i = 0; i < 2; i++) {
        view[i] = malloc(sizeof(float) * n);
        cover[i] = malloc(sizeof(float) * n);
        target_render(&scene, &camera, i, behind[i], view[i], cover[i]);
    }
    out->rest = rest_labels(s, cover[0], cover[1]);
    target_random_seed(&r, 1000003u * seed + 31u * (unsigned)kind + (unsigned)which);
    target_degrade(view[0], view[1], s->width, s->height, kind, &r);
    picture_alloc(&out->left, s->width, s->height, 1, &f);
    picture_alloc(&out->right, s->width, s->height, 1, &f);
    target_quantise(view[0], (int)n, out->left.pix);
    target_quantise(view[1], (int)n, out->right.pix);
    for (int i = 0; i < 2; i++) {
        free(behind[i]);
        free(view[i]);
        free(cover[i]);
    }
}

double trial_bad(engine *e, const trial_scene *s, const trial_frame *frame, const stad_params *p, int32_t *cost)
{
    tool_fail f = {0, ""};
    disparity d;
    stad_score score;
    stad_score_config config;
    memset(&d, 0, sizeof d);
    if (engine_run(e, p, &frame->left, &frame->right, &d, NULL, &f) != TOOL_OK)
        return -1;
    stad_score_config_init(&config, STAD_SCORE_BAD, p->min_disparity, p->num_disparities);
    stad_score_begin(&score, &config);
    for (int y = 0; y < s->height; y++)
        stad_score_row(&score, y, d.q4 + (ptrdiff_t)y * s->width, s->truth.q16 + (ptrdiff_t)y * s->width,
                       frame->rest + (ptrdiff_t)y * s->width, s->width);
    disparity_free(&d);
    const int32_t q20 = stad_score_end(&score);
    if (cost)
        *cost = q20;
    return 100.0 * q20 / STAD_COST_ONE;
}
