/* SPDX-License-Identifier: MIT
 * calib_trials/trial.h - the target composited into an open scene, degraded, and the library's own loop run on it. */
#ifndef CALIB_TRIAL_H
#define CALIB_TRIAL_H

#include "../../common/engine.h"
#include "../../common/truth_file.h"
#include "../../scene/target_scene.h"
#include "stad/stad.h"

typedef struct trial_scene {
    picture left, right;
    truth_map truth;
    int width, height, disparities;
} trial_scene;

/* One frame pair as the cameras give it. `rest`: labels of the scene outside the target, from truth that the loop never sees. */
typedef struct trial_frame {
    picture left, right;
    uint8_t *rest;
} trial_frame;

int trial_read(trial_scene *s, const char *left, const char *right, const char *truth, const char *mask, int disparities,
               tool_fail *f);

#define TRIAL_WITHOUT_TARGET 2

/* Pose `which` (0, 1) of the target before the scene, or the scene alone; every number by chance comes from the seed. */
void trial_compose(trial_frame *out, const trial_scene *s, int which, int kind, unsigned seed);
target_camera trial_camera(const trial_scene *s);

/* Bad share of the rest, percent; the cost in Q20 through *cost. */
double trial_bad(engine *e, const trial_scene *s, const trial_frame *frame, const stad_params *p, int32_t *cost);

#endif
