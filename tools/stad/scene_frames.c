/* SPDX-License-Identifier: MIT
 * stad/scene_frames.c - `stad scene --target`: a recording of a room in which someone holds up the target.
 *
 * The pose wanders along sines of different periods, so that neighbouring frames are alike and distant ones are other poses.
 * In the coordinates of the trials: a wide lens, the target at about half of the disparity range.
 * Now and then it is held still: a correction of the rig is only confirmed on a target that does not move. */
#include "scene_frames.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/grid.h"
#include "../scene/target_scene.h"
#include "tool.h"

typedef struct frame_memory {
    float *view[2], *truth;
    uint8_t *label;
    picture picture[2], visible;
} frame_memory;

static double place(const scene_frames *s, target_camera *c)
{
    target_camera_default(c, s->width, s->height);
    c->f = 0.6 * s->width;
    c->psf = 0.7;
    double z = c->f * stad_target_relief()->width_mm / (s->share / 100.0 * s->width);
    c->baseline = 0.5 * s->num_disparities * z / c->f;
    return z;
}

#define MOVES 28 /* frames, */
#define RESTS 12 /* then so many of the last pose */

/* Steps of the path up to frame i. */
static int steps_at(int i)
{
    int within = i % (MOVES + RESTS);
    return i / (MOVES + RESTS) * (MOVES - 1) + (within < MOVES ? within : MOVES - 1);
}

static target_pose pose_at(const scene_frames *s, const target_camera *c, double z, int i)
{
    double t = steps_at(i) + 17.0 * s->seed, px = s->width * (0.6 + 0.05 * sin(t / 5)),
           py = s->height * (0.5 + 0.05 * sin(t / 7 + 1));
    target_pose p;
    p.centre.z = z * (1 + 0.06 * sin(t / 9));
    p.centre.x = (px - c->cx) * p.centre.z / c->f;
    p.centre.y = (py - c->cy) * p.centre.z / c->f;
    p.pitch = 0.5 + 0.1 * sin(t / 6 + 2);
    p.yaw = 0.18 * sin(t / 8);
    p.roll = 0.06 * sin(t / 11 + 3);
    return p;
}

static int take_memory(frame_memory *m, const scene_frames *s, tool_fail *f)
{
    size_t n = (size_t)s->width * (size_t)s->height;
    memset(m, 0, sizeof *m);
    for (int v = 0; v < 2; v++)
        m->view[v] = malloc(n * sizeof *m->view[v]);
    m->truth = malloc(n * sizeof *m->truth);
    m->label = malloc(n);
    if (!m->view[0] || !m->view[1] || !m->truth || !m->label)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for a frame");
    int status = picture_alloc(&m->picture[0], s->width, s->height, 1, f);
    if (status == TOOL_OK)
        status = picture_alloc(&m->picture[1], s->width, s->height, 1, f);
    return status ? status : picture_alloc(&m->visible, s->width, s->height, 1, f);
}

static void drop_memory(frame_memory *m)
{
    for (int v = 0; v < 2; v++) {
        free(m->view[v]);
        picture_free(&m->picture[v]);
    }
    free(m->truth);
    free(m->label);
    picture_free(&m->visible);
}

static void draw(frame_memory *m, const scene_frames *s, const target_scene *scene, const target_camera *c, int i)
{
    int n = s->width * s->height;
    target_random random;
    for (int v = 0; v < 2; v++) {
        target_random_seed(&random, s->seed * 1000003u + 2u * (unsigned)i + (unsigned)v);
        target_render(scene, c, v, NULL, m->view[v], NULL);
        target_add_noise(m->view[v], n, s->noise / 3, &random);
        target_quantise(m->view[v], n, m->picture[v].pix);
    }
    target_truth(scene, c, m->truth, m->label, NULL);
    for (int k = 0; k < n; k++)
        m->visible.pix[k] = m->label[k] == STAD_LABEL_VISIBLE ? 255 : 0;
}

static int write_view(const picture *p, const scene_frames *s, int i, const char *name, tool_fail *f)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%03d_%s.%s", s->folder, i, name, s->pgm ? "pgm" : "png");
    return s->pgm ? picture_write_pgm(p, path, f) : picture_write_png(p, path, f);
}

static int write_frame(const frame_memory *m, const scene_frames *s, int i, tool_fail *f)
{
    char path[4096];
    int status = write_view(&m->picture[0], s, i, "left", f);
    if (status == TOOL_OK)
        status = write_view(&m->picture[1], s, i, "right", f);
    snprintf(path, sizeof path, "%s/%03d_nonocc.png", s->folder, i);
    if (status == TOOL_OK)
        status = picture_write_png(&m->visible, path, f);
    snprintf(path, sizeof path, "%s/%03d_disp.pfm", s->folder, i);
    return status ? status : pfm_write(m->truth, s->width, s->height, path, f);
}

int scene_frames_write(const scene_frames *s, tool_fail *f)
{
    static target_scene scene;
    target_camera camera;
    frame_memory m;
    double z = place(s, &camera);
    int status = take_memory(&m, s, f);
    for (int i = 0; i < s->frames && status == TOOL_OK; i++) {
        target_pose pose = pose_at(s, &camera, z, i);
        camera.drift_dy = i >= s->drift_from ? s->drift_dy : 0;
        target_scene_clear(&scene);
        target_scene_add_room(&scene, &camera, 1.5 * z, 4 * z, 24, s->seed);
        target_scene_add(&scene, stad_target_relief(), &pose);
        draw(&m, s, &scene, &camera, i);
        status = write_frame(&m, s, i, f);
        progress_line("%d / %d frames", i + 1, s->frames);
    }
    progress_end();
    if (status == TOOL_OK)
        printf("focal length %.1f px, baseline %.4f m, centre %.1f,%.1f\n", camera.f, camera.baseline / 1000, camera.cx,
               camera.cy);
    drop_memory(&m);
    return status;
}
