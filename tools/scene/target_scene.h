/* SPDX-License-Identifier: MIT
 * scene/target_scene.h - renders stereo frames of calibration targets with exact disparity and visibility.
 *
 * A scene is a list of flat textured quadrilaterals in front of a rectified pair of cameras; targets and a cluttered room are
 * added to it. Everything is a function of its arguments and a seed. Host code: floats and malloc.
 *
 * Millimetres; camera frame of the left view, x right, y down, z forward. Grey levels 0..255 as float until quantised. */
#ifndef TARGET_SCENE_H
#define TARGET_SCENE_H

#include <stdint.h>

#include "stad/stad.h"

#ifdef __cplusplus
extern "C" {
#endif

/* -- print ---------------------------------------------------------------------------------------------------------------- */

/* 1/f noise about 0, standard deviation near 64, cells from finest_um to 64 times that. */
int target_noise(int x_um, int y_um, int finest_um, unsigned seed);

/* Grey 0..255 of the base sheet at a point: marks with their surround at full contrast, else noise at a quarter of it. */
int target_print(const stad_target *target, int x_um, int y_um);

/* The same of a raised part (part 0: the base), in coordinates on its facet. */
int target_print_part(int part, int x_um, int y_um);

/* -- scene ---------------------------------------------------------------------------------------------------------------- */

typedef struct target_vector {
    double x, y, z;
} target_vector;

/* The pose of a target: where its sheet's centre is, and turns about x (top edge away for positive), y (right edge away) and
 * the view direction (clockwise), radians, applied in the order roll, yaw, pitch. */
typedef struct target_pose {
    target_vector centre;
    double pitch, yaw, roll;
} target_pose;

/* A pair of cameras. The drift turns the RIGHT image about its centre, scales and shifts it, after projection. */
typedef struct target_camera {
    int width, height;
    double f, cx, cy;   /* px */
    double baseline;    /* mm */
    double psf;         /* px, standard deviation of the Gaussian point spread */
    int supersample;    /* rays a pixel and direction; 4 is plenty */
    double drift_dy;    /* px */
    double drift_roll;  /* radians */
    double drift_scale; /* 0.004 = 0.4 percent larger */
} target_camera;

typedef struct target_quad {
    target_vector p[4];        /* flat, convex, in order; two may coincide */
    double u[4], v[4];         /* texture coordinates of the corners, mm */
    const stad_target *target; /* SHEET: whose base; also set for its facets and walls */
    int kind;                  /* enum target_texture */
    unsigned seed;
} target_quad;

enum target_texture { TARGET_SHEET, TARGET_PART, TARGET_WALL, TARGET_ROOM };

#define TARGET_MAX_QUADS 256
typedef struct target_scene {
    int count;
    target_quad quad[TARGET_MAX_QUADS];
} target_scene;

void target_camera_default(target_camera *c, int width, int height);
stad_camera target_camera_fixed(const target_camera *c);
void target_scene_clear(target_scene *s);
void target_scene_add(target_scene *s, const stad_target *target, const target_pose *pose);

/* A room: a leaning back wall at `far_mm` and `count` textured quadrilaterals at random between near and far. */
void target_scene_add_room(target_scene *s, const target_camera *c, double near_mm, double far_mm, int count, unsigned seed);

/* Renders a view (0 left, 1 right) to width x height floats. `behind`: an image shown where the scene is empty, or NULL for
 * mid grey. `coverage`: share of each pixel that the scene covers, or NULL. */
void target_render(const target_scene *s, const target_camera *c, int view, const float *behind, float *grey, float *coverage);

/* Exact truth at pixel centres of the undrifted left view: disparity in px (NaN: nothing there), label as enum stad_label,
 * and which = 1 target, 0 room. `which` may be NULL. */
void target_truth(const target_scene *s, const target_camera *c, float *disparity, uint8_t *label, uint8_t *which);

/* Where in the drifted right image a point of the ideal one is. */
void target_drift(const target_camera *c, double *x, double *y);

/* A point of a target (mm on the sheet, height) in the camera frame. */
target_vector target_point(const stad_target *target, const target_pose *pose, double x_mm, double y_mm, double h_mm);

/* -- what goes wrong with images (fiducials: the eight kinds) --------------------------------------------------------------- */

typedef struct target_random {
    uint64_t state;
} target_random;

void target_random_seed(target_random *r, uint64_t seed);
double target_random_uniform(target_random *r); /* [0, 1) */
double target_random_normal(target_random *r);

enum target_kind {
    TARGET_CLEAN,
    TARGET_NOISE_5,
    TARGET_NOISE_10,
    TARGET_NOISE_20,
    TARGET_GAIN,
    TARGET_VIGNETTE,
    TARGET_LOW_LIGHT,
    TARGET_BLUR,
    TARGET_KINDS
};
const char *target_kind_name(int kind);

/* Degrades a pair of grey images in place, still float. */
void target_degrade(float *left, float *right, int width, int height, int kind, target_random *r);

void target_add_noise(float *grey, int count, double sd, target_random *r);
void target_blur(float *grey, int width, int height, double sd);

/* Rounds and clips to 8 bits. */
void target_quantise(const float *grey, int count, uint8_t *pix);

/* Grey of black ink and of paper: compresses 0..255 to black..white, in place. */
void target_expose(float *grey, int count, double black, double white);

#ifdef __cplusplus
}
#endif

#endif
