/* SPDX-License-Identifier: MIT
 * stad/scene_set.h - the pairs with truth that a search is scored on. */
#ifndef STAD_SCENE_SET_H
#define STAD_SCENE_SET_H

#include "../common/engine.h"
#include "../common/params_text.h"
#include "../common/truth_file.h"
#include "bad_bounds.h"
#include "measure.h"
#include "stad/target.h"

/* One pair: files, what was read of them, and a matcher. Strings are borrowed or owned by the set. */
typedef struct scored_scene {
    const char *left_path, *right_path, *truth_path, *mask_path;
    double truth_scale;
    int fiducials; /* 1: the truth is that of the target in the frames, found when the parameters are known */
    int min_disparity, num_disparities; /* INT_MAX and 0: not said for this scene */
    picture left, right;
    truth_map truth;
    stad_params base; /* what the search does not vary */
    engine engine;
    disparity disp;    /* of the last run */
    disparity best;    /* kept by scene_keep() */
    bad_bounds bounds; /* made when first used */
} scored_scene;

typedef struct scene_set {
    scored_scene *scene;
    int count;
    char **owned; /* strings read from a list */
    int owned_count;
} scene_set;

/* What every scene is scored with. */
typedef struct scoring {
    int mode, memory;
    int cost;         /* enum stad_score_cost */
    double threshold; /* px */
} scoring;

int scene_set_single(scene_set *s, tool_fail *f);

/* LIST.json: [{"left", "right", "truth", "mask", "truth_scale", "min_disparity", "num_disparities"}, ...], the last four as needed, paths
 * from the list's own folder. What would be passed over in silence is refused with list, scene (from 0) and key. */
int scene_set_list(scene_set *s, const char *path, tool_fail *f);

/* Reads all pictures and truths. */
int scene_set_read(scene_set *s, int color, tool_fail *f);
void scene_set_free(scene_set *s);

/* The truth of a scene with fiducials; base is set. */
int scene_find_truth(scored_scene *c, const stad_camera *camera, tool_fail *f);

/* Matches and scores one scene. TOOL_OK with the cost (Q20, STAD_COST_FAILED: parameters that the domain refuses, or no pixel that
 * can be scored). From call to call all may change but the scene, the range of disparities and `how`. */
int scene_cost(scored_scene *c, const stad_params *p, const scoring *how, int32_t *cost_q20, tool_fail *f);

/* Keeps the last run's disparity map in `best`; `disp` is then of no run. */
void scene_keep(scored_scene *c);

#endif
