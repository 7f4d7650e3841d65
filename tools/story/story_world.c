/* SPDX-License-Identifier: MIT
 * target, room -> [story/story_world.c] -> frames - what the cameras of the story look at. */
#include "story.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

target_camera story_camera(int disturbed)
{
    target_camera c;
    target_camera_default(&c, STORY_WIDTH, STORY_HEIGHT);
    c.f = 300;
    c.baseline = 56;
    c.psf = 0.7;
    c.supersample = 2;
    if (disturbed) {
        c.drift_dy = 1.1;
        c.drift_roll = 0.45 * 3.14159265358979 / 180;
        c.drift_scale = 0.002;
    }
    return c;
}

/* Where somebody holds the target: in the middle, aside, nearer, leaning more. */
static target_pose pose_of(int which)
{
    static const target_pose poses[STORY_POSES] = {
        {{40, 8, 410}, 0.50, 0.10, 0.02},
        {{12, -14, 400}, 0.42, -0.14, -0.04},
        {{66, 14, 420}, 0.55, 0.16, 0.03},
        {{30, -4, 395}, 0.46, -0.06, 0.05},
    };
    return poses[which];
}

/* `px`, `which`: room for a picture each. */
static void make_truth(const target_scene *scene, const target_camera *camera, int32_t *q16, uint8_t *rest, float *px,
                       uint8_t *which)
{
    const int n = STORY_WIDTH * STORY_HEIGHT;
    target_truth(scene, camera, px, rest, which);
    for (int i = 0; i < n; i++) {
        if (isnan(px[i]) || which[i] == 1)
            rest[i] = STAD_LABEL_IGNORED;
        q16[i] = rest[i] == STAD_LABEL_IGNORED ? 0 : (int32_t)lround(px[i] * 65536.0);
    }
}

static int take_memory(story_world *w, int poses, tool_fail *f)
{
    const size_t n = (size_t)STORY_WIDTH * STORY_HEIGHT;
    int good = 1;
    for (int view = 0; view < 2; view++)
        good &= (w->copy[view] = malloc(sizeof(float) * n)) != NULL;
    for (int i = 0; i < poses; i++) {
        for (int view = 0; view < 2; view++)
            good &= (w->view[i][view] = malloc(sizeof(float) * n)) != NULL;
        good &= (w->truth_q16[i] = malloc(sizeof(int32_t) * n)) != NULL;
        good &= (w->rest[i] = malloc(n)) != NULL;
    }
    return good ? TOOL_OK : tool_fail_set(f, TOOL_FILE, "not enough memory for the world");
}

int story_world_make(story_world *w, int disturbed, int poses, unsigned seed, tool_fail *f)
{
    static target_scene scene;
    static uint8_t which[STORY_WIDTH * STORY_HEIGHT];
    if (take_memory(w, poses, f) != TOOL_OK)
        return f->status;
    target_camera camera = story_camera(disturbed);
    w->disturbed = disturbed;
    target_random_seed(&w->random, seed);
    for (int i = 0; i < poses; i++) {
        target_pose pose = pose_of(i);
        target_scene_clear(&scene);
        target_scene_add_room(&scene, &camera, 450, 2400, 24, 5);
        target_scene_add(&scene, stad_target_relief(), &pose);
        for (int view = 0; view < 2; view++)
            target_render(&scene, &camera, view, NULL, w->view[i][view], NULL);
        make_truth(&scene, &camera, w->truth_q16[i], w->rest[i], w->copy[0], which);
    }
    return TOOL_OK;
}

void story_world_free(story_world *w)
{
    free(w->copy[0]);
    free(w->copy[1]);
    for (int i = 0; i < STORY_POSES; i++) {
        free(w->view[i][0]);
        free(w->view[i][1]);
        free(w->truth_q16[i]);
        free(w->rest[i]);
    }
}

void story_expose(story_world *w, int pose, story_frame *frame)
{
    const int n = STORY_WIDTH * STORY_HEIGHT;
    float *const *copy = w->copy;
    for (int view = 0; view < 2; view++)
        memcpy(copy[view], w->view[pose][view], sizeof(float) * (size_t)n);
    if (w->disturbed)
        target_degrade(copy[0], copy[1], STORY_WIDTH, STORY_HEIGHT, TARGET_LOW_LIGHT, &w->random);
    for (int view = 0; view < 2; view++) {
        target_add_noise(copy[view], n, 2, &w->random);
        target_quantise(copy[view], n, view ? frame->right.pix : frame->left.pix);
    }
    frame->pose = pose;
}
