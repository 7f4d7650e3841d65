/* SPDX-License-Identifier: MIT
 * print, scene -> [scene/target_render.c] -> frames, truth - casts rays at flat quadrilaterals.
 *
 * In the image of a pinhole camera the inverse depth of a plane, and texture coordinates over depth, are linear in (x, y), and
 * the edges of a quadrilateral are lines. So each quad becomes a handful of linear functions a view, and a ray is a few
 * products. Rays on a fine grid are gathered by a Gaussian point spread. */
#include "scene/target_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* a x + b y + c over the image. */
typedef struct linear {
    double a, b, c;
} linear;

typedef struct shape {
    linear edge[4], inverse_z, u, v; /* u and v over z */
    int edges;
    double left, right, top, bottom;
    const target_quad *quad;
} shape;

static double at(linear f, double x, double y)
{
    return f.a * x + f.b * y + f.c;
}

void target_camera_default(target_camera *c, int width, int height)
{
    memset(c, 0, sizeof *c);
    c->width = width;
    c->height = height;
    c->f = width * 1.1;
    c->cx = (width - 1) / 2.0;
    c->cy = (height - 1) / 2.0;
    c->baseline = 60;
    c->psf = 0.8;
    c->supersample = 4;
}

stad_camera target_camera_fixed(const target_camera *c)
{
    const stad_camera fixed = {(int32_t)lround(c->f * 256), (int32_t)lround(c->cx * 256), (int32_t)lround(c->cy * 256)};
    return fixed;
}

void target_drift(const target_camera *c, double *x, double *y)
{
    const double dx = *x - c->cx, dy = *y - c->cy, s = 1 + c->drift_scale;
    *x = c->cx + s * (cos(c->drift_roll) * dx - sin(c->drift_roll) * dy);
    *y = c->cy + s * (sin(c->drift_roll) * dx + cos(c->drift_roll) * dy) + c->drift_dy;
}

/* The ideal position that shows at (x, y) of the drifted image. */
static void undrift(const target_camera *c, double *x, double *y)
{
    const double dx = *x - c->cx, dy = *y - c->cy - c->drift_dy, s = 1 + c->drift_scale;
    *x = c->cx + (cos(c->drift_roll) * dx + sin(c->drift_roll) * dy) / s;
    *y = c->cy + (-sin(c->drift_roll) * dx + cos(c->drift_roll) * dy) / s;
}

/* The linear function that has values f0..f2 at three points of the image. */
static linear through(const double *x, const double *y, const double *f)
{
    const double det = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    linear l;
    l.a = ((f[1] - f[0]) * (y[2] - y[0]) - (f[2] - f[0]) * (y[1] - y[0])) / det;
    l.b = ((x[1] - x[0]) * (f[2] - f[0]) - (x[2] - x[0]) * (f[1] - f[0])) / det;
    l.c = f[0] - l.a * x[0] - l.b * y[0];
    return l;
}

/* The three of four corners that span the largest triangle. */
static void pick_three(const double *x, const double *y, int *pick)
{
    double best = -1;
    for (int skip = 0; skip < 4; skip++) {
        int k[3], n = 0;
        for (int i = 0; i < 4; i++)
            if (i != skip)
                k[n++] = i;
        const double area = fabs((x[k[1]] - x[k[0]]) * (y[k[2]] - y[k[0]]) - (x[k[2]] - x[k[0]]) * (y[k[1]] - y[k[0]]));
        if (area > best) {
            best = area;
            memcpy(pick, k, sizeof k);
        }
    }
}

/* Projects a quad into a view. 0 when it is edge on or behind the camera. */
static int project(const target_quad *q, const target_camera *c, int view, shape *s)
{
    double x[4], y[4], area = 0;
    s->quad = q;
    s->left = s->top = 1e9;
    s->right = s->bottom = -1e9;
    for (int i = 0; i < 4; i++) {
        if (q->p[i].z < 1)
            return 0;
        x[i] = c->cx + c->f * (q->p[i].x - (view ? c->baseline : 0)) / q->p[i].z;
        y[i] = c->cy + c->f * q->p[i].y / q->p[i].z;
        s->left = fmin(s->left, x[i]);
        s->right = fmax(s->right, x[i]);
        s->top = fmin(s->top, y[i]);
        s->bottom = fmax(s->bottom, y[i]);
    }
    for (int i = 0; i < 4; i++)
        area += x[i] * y[(i + 1) % 4] - x[(i + 1) % 4] * y[i];
    if (fabs(area) < 0.02)
        return 0;
    int k[3];
    double px[3], py[3], f[3][3];
    pick_three(x, y, k);
    for (int i = 0; i < 3; i++) {
        const double z = q->p[k[i]].z;
        px[i] = x[k[i]];
        py[i] = y[k[i]];
        f[0][i] = 1 / z;
        f[1][i] = q->u[k[i]] / z;
        f[2][i] = q->v[k[i]] / z;
    }
    s->inverse_z = through(px, py, f[0]);
    s->u = through(px, py, f[1]);
    s->v = through(px, py, f[2]);
    s->edges = 0;
    for (int i = 0; i < 4; i++) {
        const double dx = x[(i + 1) % 4] - x[i], dy = y[(i + 1) % 4] - y[i], sign = area > 0 ? 1 : -1;
        if (dx * dx + dy * dy < 1e-12)
            continue;
        const linear edge = {-sign * dy, sign * dx, sign * (dy * x[i] - dx * y[i])};
        s->edge[s->edges++] = edge;
    }
    return 1;
}

static int inside(const shape *s, double x, double y)
{
    if (x < s->left || x > s->right || y < s->top || y > s->bottom)
        return 0;
    for (int i = 0; i < s->edges; i++)
        if (at(s->edge[i], x, y) < 0)
            return 0;
    return 1;
}

static int project_all(const target_scene *s, const target_camera *c, int view, shape *shapes)
{
    int count = 0;
    for (int i = 0; i < s->count; i++)
        count += project(&s->quad[i], c, view, &shapes[count]);
    return count;
}

static const shape *nearest(const shape *shapes, int count, double x, double y)
{
    const shape *best = NULL;
    double best_z = 0;
    for (int i = 0; i < count; i++) {
        if (!inside(&shapes[i], x, y))
            continue;
        const double inverse_z = at(shapes[i].inverse_z, x, y);
        if (inverse_z > best_z) {
            best_z = inverse_z;
            best = &shapes[i];
        }
    }
    return best;
}

static double shade(const shape *s, double x, double y)
{
    const target_quad *q = s->quad;
    const double z = 1 / at(s->inverse_z, x, y);
    const int u_um = (int)floor(at(s->u, x, y) * z * 1000), v_um = (int)floor(at(s->v, x, y) * z * 1000);
    switch (q->kind) {
    case TARGET_SHEET:
        return target_print(q->target, u_um, v_um);
    case TARGET_PART:
        return target_print_part((int)q->seed, u_um, v_um);
    case TARGET_WALL:
        return 110 + (int)(q->seed % 8) * 5;
    default:
        return 60 + (int)(q->seed * 37 % 130) + target_noise(u_um, v_um, 3000, q->seed) * 0.6;
    }
}

/* One fine row: grey and coverage (0 or 1) of width * supersample rays. */
static void cast_row(const shape *shapes, int count, const target_camera *c, int view, double y, float *grey, float *cover)
{
    const int rays = c->width * c->supersample;
    for (int i = 0; i < rays; i++) {
        double px = (i + 0.5) / c->supersample - 0.5, py = y;
        if (view)
            undrift(c, &px, &py);
        const shape *hit = nearest(shapes, count, px, py);
        cover[i] = hit ? 1 : 0;
        grey[i] = hit ? (float)shade(hit, px, py) : 0;
    }
}

/* Point spread on the fine grid: pixel box and Gaussian. Returns its reach. */
static int spread(const target_camera *c, float *kernel)
{
    const double sd = c->psf * c->supersample;
    const int half = c->supersample / 2, reach = half + (int)ceil(3 * sd);
    double sum = 0;
    for (int i = -reach; i < reach; i++) {
        double value = 0;
        for (int k = -half; k < half; k++)
            value += sd > 0 ? exp(-0.5 * (i - k) * (i - k) / (sd * sd)) : i == k;
        kernel[i + reach] = (float)value;
        sum += value;
    }
    for (int i = 0; i < 2 * reach; i++)
        kernel[i] = (float)(kernel[i] / sum);
    return reach;
}

/* Gathers a fine row into pixels. */
static void gather_row(const float *fine, const target_camera *c, const float *kernel, int reach, float *out)
{
    const int rays = c->width * c->supersample;
    for (int x = 0; x < c->width; x++) {
        const int from = x * c->supersample + c->supersample / 2 - reach;
        float sum = 0;
        for (int i = 0; i < 2 * reach; i++) {
            const int k = from + i < 0 ? 0 : from + i >= rays ? rays - 1 : from + i;
            sum += kernel[i] * fine[k];
        }
        out[x] = sum;
    }
}

void target_render(const target_scene *s, const target_camera *c, int view, const float *behind, float *grey, float *coverage)
{
    const int w = c->width, rows = c->height * c->supersample;
    shape *shapes = malloc(sizeof *shapes * TARGET_MAX_QUADS);
    float *fine = malloc(sizeof *fine * 2 * (size_t)(w * c->supersample));
    float *thin = malloc(sizeof *thin * 2 * (size_t)w * (size_t)rows);
    float kernel[256];
    const int count = project_all(s, c, view, shapes), reach = spread(c, kernel);
    for (int r = 0; r < rows; r++) {
        float *cover = fine + w * c->supersample;
        cast_row(shapes, count, c, view, (r + 0.5) / c->supersample - 0.5, fine, cover);
        gather_row(fine, c, kernel, reach, thin + (size_t)r * 2 * (size_t)w);
        gather_row(cover, c, kernel, reach, thin + ((size_t)r * 2 + 1) * (size_t)w);
    }
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < w; x++) {
            float sum = 0, cover = 0;
            for (int i = 0; i < 2 * reach; i++) {
                const int from = y * c->supersample + c->supersample / 2 - reach + i;
                const float *row = thin + (size_t)(from < 0 ? 0 : from >= rows ? rows - 1 : from) * 2 * (size_t)w;
                sum += kernel[i] * row[x];
                cover += kernel[i] * row[w + x];
            }
            const size_t k = (size_t)y * (size_t)w + (size_t)x;
            grey[k] = sum + (1 - cover) * (behind ? behind[k] : 128.0f);
            if (coverage)
                coverage[k] = cover;
        }
    free(thin);
    free(fine);
    free(shapes);
}

void target_truth(const target_scene *s, const target_camera *c, float *disparity, uint8_t *label, uint8_t *which)
{
    shape *left = malloc(sizeof *left * TARGET_MAX_QUADS), *right = malloc(sizeof *right * TARGET_MAX_QUADS);
    const int left_count = project_all(s, c, 0, left), right_count = project_all(s, c, 1, right);
    for (int y = 0; y < c->height; y++)
        for (int x = 0; x < c->width; x++) {
            const size_t k = (size_t)y * (size_t)c->width + (size_t)x;
            const shape *hit = nearest(left, left_count, x, y);
            disparity[k] = NAN;
            label[k] = STAD_LABEL_IGNORED;
            if (which)
                which[k] = (uint8_t)(hit && hit->quad->target);
            if (!hit)
                continue;
            const double inverse_z = at(hit->inverse_z, x, y), d = c->f * c->baseline * inverse_z, xr = x - d;
            const shape *other = nearest(right, right_count, xr, y);
            const int hidden = xr < 0 || (other && at(other->inverse_z, xr, y) > inverse_z * 1.002);
            disparity[k] = (float)d;
            label[k] = hidden ? STAD_LABEL_OCCLUDED : STAD_LABEL_VISIBLE;
        }
    free(left);
    free(right);
}
