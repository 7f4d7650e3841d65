/* SPDX-License-Identifier: MIT
 * tools/study/marks/shim.c - the library, the renderer and libapriltag behind plain calls, for figures.py.
 *
 * Built by figures.py into a shared library; libapriltag is a part of this study only. */
#include "scene/target_scene.h"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static uint8_t work[STAD_MARK_BYTES(2048, 2048)] STAD_ALIGNED;
static apriltag_detector_t *detector;

static void reference_open(void)
{
    if (detector)
        return;
    detector = apriltag_detector_create();
    apriltag_detector_add_family_bits(detector, tag36h11_create(), 2);
    detector->nthreads = 1;
    detector->quad_decimate = 1;
}

/* Whether libapriltag refines its corners in the grey image, as it does by default; by how much it reduces the picture to look for
 * quads, which widens the refinement too; and the blur in which it looks. */
void study_reference_settings(int refines, double decimate, double sigma)
{
    reference_open();
    detector->refine_edges = refines;
    detector->quad_decimate = (float)decimate;
    detector->quad_sigma = (float)sigma;
}

int study_bytes(int width, int height)
{
    return (int)stad_mark_bytes(width, height);
}

/* Marks as rows of id, hamming, then x, y of four corners in px from the centre of the first pixel. */
int study_find(const uint8_t *pix, int width, int height, double *rows, int max)
{
    stad_mark marks[64];
    const stad_image image = stad_image_packed(pix, width, height, 1);
    const int count = stad_mark_find(&image, NULL, marks, max < 64 ? max : 64, work, sizeof work);
    for (int i = 0; i < count; i++) {
        rows[i * 10] = marks[i].id;
        rows[i * 10 + 1] = marks[i].hamming;
        for (int k = 0; k < 4; k++) {
            rows[i * 10 + 2 + 2 * k] = marks[i].corner[k].x_q8 / 256.0;
            rows[i * 10 + 3 + 2 * k] = marks[i].corner[k].y_q8 / 256.0;
        }
    }
    return count;
}

/* The same from libapriltag (no decimation, one thread), identities 0..31 only. Its corners run bottom left, bottom right, top
 * right, top left, and its pixels have their centres at one half. */
int study_find_reference(const uint8_t *pix, int width, int height, double *rows, int max)
{
    reference_open();
    image_u8_t image = {width, height, width, (uint8_t *)(uintptr_t)pix};
    zarray_t *found = apriltag_detector_detect(detector, &image);
    int count = 0;
    for (int i = 0; i < zarray_size(found) && count < max; i++) {
        apriltag_detection_t *d;
        zarray_get(found, i, &d);
        if (d->id >= STAD_MARK_IDS)
            continue;
        rows[count * 10] = d->id;
        rows[count * 10 + 1] = d->hamming;
        for (int k = 0; k < 4; k++) {
            rows[count * 10 + 2 + 2 * k] = d->p[3 - k][0] - 0.5;
            rows[count * 10 + 3 + 2 * k] = d->p[3 - k][1] - 0.5;
        }
        count++;
    }
    apriltag_detections_destroy(found);
    return count;
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Processor time a frame of both detectors over the same frames in the same loop, turn by turn. */
void study_time(const uint8_t *frames, int count, int width, int height, int rounds, double *ours, double *reference)
{
    double rows[64 * 10];
    *ours = *reference = 0;
    for (int n = -1; n < rounds; n++)
        for (int i = 0; i < count; i++) {
            const uint8_t *frame = frames + (size_t)i * (size_t)(width * height);
            const double t0 = seconds();
            study_find(frame, width, height, rows, 64);
            const double t1 = seconds();
            study_find_reference(frame, width, height, rows, 64);
            const double t2 = seconds();
            if (n < 0)
                continue; /* warm up */
            *ours += (t1 - t0) / (count * rounds);
            *reference += (t2 - t1) / (count * rounds);
        }
}

static stad_target_tag board_tags[4];

/* A flat board of four marks of 48 mm in the corners of 256 x 184 mm, or the relief. */
static const stad_target *target_of(int relief)
{
    static stad_target board;
    if (relief)
        return stad_target_relief();
    board = *stad_target_relief();
    memcpy(board_tags, board.tags, sizeof board_tags);
    board.tags = board_tags;
    board.facet_count = board.part_count = 0;
    return &board;
}

typedef struct study_scene {
    int32_t width, height, relief, room, seed, supersample;
    double f, baseline, psf, dy, roll, scale, x, y, z, pitch, yaw, turn;
} study_scene;

static void open_scene(const study_scene *s, target_camera *c, target_scene *scene)
{
    target_camera_default(c, s->width, s->height);
    c->f = s->f;
    c->baseline = s->baseline;
    c->psf = s->psf;
    c->supersample = s->supersample;
    c->drift_dy = s->dy;
    c->drift_roll = s->roll;
    c->drift_scale = s->scale;
    const target_pose pose = {{s->x, s->y, s->z}, s->pitch, s->yaw, s->turn};
    target_scene_clear(scene);
    if (s->relief >= 0)
        target_scene_add(scene, target_of(s->relief), &pose);
    if (s->room > 0)
        target_scene_add_room(scene, c, s->z * 1.4, s->z * 4, s->room, (unsigned)s->seed);
}

/* Both views as floats, truth of the left one, and the true corners: 4 marks x 4 corners x (x left, y left, x right, y right),
 * the right ones drifted. behind: left and right image behind, or NULL. */
void study_render(const study_scene *s, const float *behind, float *left, float *right, float *disparity, uint8_t *label,
                  uint8_t *which, float *coverage, double *corners)
{
    static target_scene scene;
    target_camera c;
    open_scene(s, &c, &scene);
    const int pixels = s->width * s->height;
    target_render(&scene, &c, 0, behind, left, coverage);
    target_render(&scene, &c, 1, behind ? behind + pixels : NULL, right, coverage ? coverage + pixels : NULL);
    target_truth(&scene, &c, disparity, label, which);
    if (s->relief < 0)
        return;
    const stad_target *target = target_of(s->relief);
    const target_pose pose = {{s->x, s->y, s->z}, s->pitch, s->yaw, s->turn};
    for (int i = 0; i < 16; i++) {
        const stad_target_tag *tag = &target->tags[i / 4];
        const int k = i % 4;
        const target_vector p = target_point(target, &pose, tag->x_mm + (k == 1 || k == 2 ? target->tag_mm : 0),
                                             tag->y_mm + (k >= 2 ? target->tag_mm : 0), 0);
        corners[i * 4] = c.cx + c.f * p.x / p.z;
        corners[i * 4 + 1] = c.cy + c.f * p.y / p.z;
        corners[i * 4 + 2] = c.cx + c.f * (p.x - c.baseline) / p.z;
        corners[i * 4 + 3] = corners[i * 4 + 1];
        target_drift(&c, &corners[i * 4 + 2], &corners[i * 4 + 3]);
    }
}

void study_degrade(float *left, float *right, int width, int height, int kind, int seed)
{
    target_random r;
    target_random_seed(&r, (uint64_t)seed);
    target_degrade(left, right, width, height, kind, &r);
}

/* Exposes, adds noise, quantises. */
void study_expose(float *grey, int count, double black, double white, double noise, int seed, uint8_t *pix)
{
    target_random r;
    target_random_seed(&r, (uint64_t)seed);
    target_expose(grey, count, black, white);
    target_add_noise(grey, count, noise, &r);
    target_quantise(grey, count, pix);
}

/* Marks of both views, paired. */
static int pair_frames(const uint8_t *left, const uint8_t *right, int width, int height, stad_pair *pairs)
{
    stad_mark a[32], b[32];
    const stad_image l = stad_image_packed(left, width, height, 1), r = stad_image_packed(right, width, height, 1);
    const int na = stad_mark_find(&l, NULL, a, 32, work, sizeof work), nb = stad_mark_find(&r, NULL, b, 32, work, sizeof work);
    return stad_mark_pair(a, na, b, nb, pairs, 32);
}

/* Truth of the relief (relief != 0) or the flat board from a pair of frames, every row of it. Returns the status. */
int study_truth(const uint8_t *left, const uint8_t *right, const study_scene *s, int num_disparities, int margin, double *truth,
                uint8_t *label)
{
    stad_pair pairs[32];
    stad_truth t;
    target_camera c;
    static target_scene scene;
    open_scene(s, &c, &scene);
    const stad_camera fixed = target_camera_fixed(&c);
    const int n = pair_frames(left, right, s->width, s->height, pairs);
    int status = stad_truth_init(&t, s->width, s->height, 0, num_disparities, margin);
    if (status >= 0)
        status = stad_truth_from_target(&t, target_of(s->relief), pairs, n, &fixed);
    int32_t *row = malloc(sizeof *row * (size_t)s->width);
    for (int y = 0; y < s->height && status >= 0; y++) {
        stad_truth_row(&t, y, s->width, row, label + y * s->width);
        for (int x = 0; x < s->width; x++)
            truth[y * s->width + x] = row[x] / 65536.0;
    }
    free(row);
    return status;
}

/* Fits the rig to `frames` pairs of images; numbers: verdict, a, b, c, rms before, after, worst, advised. */
int study_rig(const uint8_t *left, const uint8_t *right, int frames, int width, int height, stad_rig *rig, double *numbers)
{
    stad_pair pairs[1024];
    stad_rig_report report;
    int n = 0;
    for (int i = 0; i < frames && n <= 992; i++)
        n += pair_frames(left + (size_t)i * (size_t)(width * height), right + (size_t)i * (size_t)(width * height), width, height,
                         pairs + n);
    const int verdict = stad_rig_fit(rig, &report, pairs, n, width, height);
    const double values[8] = {verdict,
                              rig->a_q16 / 65536.0,
                              rig->b_q24 / 16777216.0,
                              rig->c_q24 / 16777216.0,
                              report.rms_before_q8 / 256.0,
                              report.rms_after_q8 / 256.0,
                              report.worst_q8 / 256.0,
                              report.advised};
    memcpy(numbers, values, sizeof values);
    return n;
}

int study_correct(const stad_rig *rig, const uint8_t *right, int width, int height, uint8_t *out)
{
    const stad_image image = stad_image_packed(right, width, height, 1);
    int status = 0;
    for (int y = 0; y < height && status >= 0; y++)
        status = stad_rig_row(rig, &image, y, out + y * width);
    return status;
}

/* A chessboard: corners as rows of x left, y left, x right, y right in px, taken four at a time as if they were marks. numbers:
 * status of the plane, its rms, verdict of the rig, its worst dy, rms of dy before. Then the truth of the board's outline
 * (n corners of a convex polygon), every row. */
int study_board(const double *corners, int count, const double *outline, int n, int width, int height, int min_disparity,
                int disparities, double *numbers, double *truth, uint8_t *label)
{
    stad_pair pairs[32];
    stad_rig rig;
    stad_rig_report drift;
    stad_plane plane;
    stad_plane_report fit;
    stad_truth t;
    stad_polygon where = {n, {{0, 0}}};
    for (int i = 0; i < count / 4 * 4; i++) {
        stad_pair *p = &pairs[i / 4];
        p->id = (int16_t)(i / 4);
        p->left[i % 4].x_q8 = (int32_t)(corners[4 * i] * 256 + 0.5);
        p->left[i % 4].y_q8 = (int32_t)(corners[4 * i + 1] * 256 + 0.5);
        p->right[i % 4].x_q8 = (int32_t)(corners[4 * i + 2] * 256 + 0.5);
        p->right[i % 4].y_q8 = (int32_t)(corners[4 * i + 3] * 256 + 0.5);
    }
    for (int i = 0; i < n; i++) {
        where.p[i].x_q8 = (int32_t)(outline[2 * i] * 256);
        where.p[i].y_q8 = (int32_t)(outline[2 * i + 1] * 256);
    }
    numbers[2] = stad_rig_fit(&rig, &drift, pairs, count / 4, width, height);
    numbers[3] = drift.worst_q8 / 256.0;
    numbers[4] = drift.rms_before_q8 / 256.0;
    stad_rig_straighten(&rig, pairs, count / 4);
    numbers[0] = stad_plane_fit(&plane, &fit, pairs, count / 4);
    numbers[1] = fit.rms_q8 / 256.0;
    if (numbers[0] < 0 || stad_truth_init(&t, width, height, min_disparity, disparities, 1) < 0 ||
        stad_truth_add_plane(&t, &plane, &where) < 0)
        return 0;
    int32_t *row = malloc(sizeof *row * (size_t)width);
    for (int y = 0; y < height; y++) {
        stad_truth_row(&t, y, width, row, label + y * width);
        for (int x = 0; x < width; x++)
            truth[y * width + x] = row[x] / 65536.0;
    }
    free(row);
    return 1;
}
