/* SPDX-License-Identifier: MIT
 * story/story.h - a board's life in one program: healthy, disturbed, alarmed, corrected, tuned, reset, restored.
 *
 * The world is rendered, the cameras drift and the light fails; what the board does about it is the library's own code, asked
 * in the way a firmware asks it. */
#ifndef STORY_H
#define STORY_H

#include "../common/engine.h"
#include "../scene/target_scene.h"
#include "stad/stad.h"

#define STORY_WIDTH       480
#define STORY_HEIGHT      360
#define STORY_DISPARITIES 64

/* -- world: a room with the target in one of four poses; the views are rendered once, every frame has noise of its own  */

enum story_pose { STORY_POSES = 4 };

typedef struct story_world {
    float *view[STORY_POSES][2]; /* as the lens makes them, left and right */
    int32_t *truth_q16[STORY_POSES];
    uint8_t *rest[STORY_POSES]; /* labels outside the target */
    float *copy[2];             /* a frame while it is exposed */
    int disturbed;              /* 1: right camera turned and shifted, dim and noisy light */
    target_random random;
} story_world;

typedef struct story_frame {
    picture left, right;
    int pose;
} story_frame;

target_camera story_camera(int disturbed);
/* Renders the first `poses` of them. `w` is all zeros before. */
int story_world_make(story_world *w, int disturbed, int poses, unsigned seed, tool_fail *f);
void story_world_free(story_world *w);

/* A frame as the sensors give it: frame->left and ->right are written, which the caller has allocated. */
void story_expose(story_world *w, int pose, story_frame *frame);

/* -- board: matcher, calibration loop, flash --------------------------------------------------------------------- */

#define STORY_SECTOR 4096u

typedef struct story_board {
    uint8_t flash_bytes[3][STORY_SECTOR];
    stad_flash flash;
    engine engine;
    stad_geometry geometry;
    stad_calib calib;
    stad_evaluator evaluator;
    void *work;
    size_t work_bytes;
    story_frame held[2], fresh; /* what the calibration keeps; what it looks at once */
    picture corrected;
    int matches, frames, saves;
} story_board;

int story_board_start(story_board *b, tool_fail *f); /* power on, with a factory setup in flash */
int story_board_reset(story_board *b);               /* RAM is lost; flash is read. Returns the slot. */
void story_board_free(story_board *b);

/* The right view through a correction, into `out` (allocated). */
void story_correct(const stad_rig *rig, const picture *right, picture *out);

/* One live frame: matched with the setup in use, its counters told. */
int story_board_live(story_board *b, const story_frame *frame, tool_fail *f);

/* One turn of the pump: does what is wanted, with frames of the world. Returns what was wanted. */
int story_board_turn(story_board *b, story_world *w);

/* -- cameras that fail --------------------------------------------------------------------------------------------- */

#define STORY_FAULTS 7

typedef struct story_fault {
    const char *name; /* what is wrong */
    int live, fault;  /* enum stad_calib_fault: of live frames at once, NONE where it takes marks; of the run's frames */
    int outcome;      /* enum stad_calib_outcome: of the run */
    int adopted;      /* 1: the setup in use has changed */
} story_fault;

/* The board from reset, and a run in front of cameras with fault `kind` to its end. A negative status: no setup. */
int story_fault_of(story_board *b, story_world *w, int kind, story_frame *frame, story_fault *told);

/* Bad share outside the target, percent, of a setup on a frame, added to *bad; the disparities go to *d. */
int story_add_bad(story_board *b, const story_world *w, const story_frame *frame, const stad_setup *setup, disparity *d,
                  double *bad, tool_fail *f);

#endif
