/* SPDX-License-Identifier: MIT
 * stad/calib.h - the loop: frames with marks -> rig -> truth -> preset, tune -> better on another pose? -> adopt,
 * store, watch.
 *
 * The application drives. stad_calib_want() says what is needed next; the application does it when it has the time, and reports; no call
 * blocks, calls back or does more than one frame's work:
 *
 *     fault = stad_calib_live(&c, &left, &right);                      every live frame, to be told at once
 *     stad_calib_counts(&c, stad_match_counts_of(&m));                 every live frame
 *     switch (stad_calib_want(&c, &r)) {
 *     case STAD_WANT_NOTHING: break;
 *     case STAD_WANT_FRAME:   if (stad_calib_frame(&c, &left, &right, work, bytes) == 1)
 *                                 keep both frames in buffer r.hold until the run is over; break;
 *     case STAD_WANT_MATCH:   cost = stad_calib_evaluate(&c, &r, &evaluator, &held_left[r.hold], &held_right[r.hold], work, bytes);
 *                             stad_calib_cost(&c, cost); break;
 *     case STAD_WANT_SAVE:    stad_calib_saved(&c, stad_store_save(&flash, stad_calib_setup(&c))); break;
 *     }
 *
 * A run:   look for marks (alarm, schedule or stad_calib_start) -> tuning frame -> a frame of another pose to judge
 * by -> correction confirmed on fresh frames, if the rig needs one -> the target picks a preset -> the judge drops it
 * if it is worse there -> a descent (STAD_TUNE_DESCENT) from what is left -> the judge decides -> save -> probation:
 * live frames, then both sets on one more frame with marks -> done, or rolled back.
 *
 * Nothing is adopted that did not hold on a frame it was not made from. The set in use (stad_calib_setup) changes at
 * two points only: when the decision is made, just before SAVE is asked for, and when it is rolled back.
 *
 * All is measured by the set in use. If its cost is not to be had where a run needs it (STAD_COST_FAILED: mostly a
 * workspace or images that do not fit), the run ends as STAD_CALIB_FAULT with STAD_FAULT_MATCH. Any other set that
 * fails is left out.
 *
 * Memory: one struct of less than 10 KB, the workspace of the caller, and two held frame pairs (at least the crop
 * r.box of them). After a reset call stad_calib_init() with the setup that stad_store_load() found: a run that was
 * under way starts over. A struct that survived the reset in retained memory together with the held frames goes on
 * where it was: it holds no pointer but config.target, a constant table.
 *
 * Why each step is as it is: docs/CALIBRATION.md. Not re-entrant on one struct. */
#ifndef STAD_CALIB_H
#define STAD_CALIB_H

#include <stddef.h>
#include <stdint.h>

#include "stad/image.h"
#include "stad/mark.h"
#include "stad/match.h"
#include "stad/monitor.h"
#include "stad/params.h"
#include "stad/rig.h"
#include "stad/score.h"
#include "stad/store.h"
#include "stad/truth.h"
#include "stad/tune.h"

#ifdef __cplusplus
extern "C" {
#endif

/* -- what is asked for ------------------------------------------------------------------------------------------- */

/* What stad_calib_want() answers. */
enum stad_want {
    STAD_WANT_NOTHING = 0,
    STAD_WANT_FRAME = 1, /* a fresh raw pair -> stad_calib_frame() */
    STAD_WANT_MATCH = 2, /* the cost of `params` on the crop `box` of held pair `hold` -> stad_calib_cost() */
    STAD_WANT_SAVE = 3   /* stad_calib_setup() to be stored -> stad_calib_saved() */
};

/* A wish of the calibration. */
typedef struct stad_request {
    uint8_t want;       /* enum stad_want */
    uint8_t hold;       /* FRAME: the buffer (0, 1) that the pair goes to if it is kept; MATCH: the buffer to match */
    stad_box box;       /* MATCH: the same box of the left and of the corrected right frame */
    stad_params params; /* MATCH */
    stad_rig rig;       /* MATCH: the correction to apply to the right frame first; the identity = none */
} stad_request;

/* -- what it is told to do --------------------------------------------------------------------------------------- */

/* When a set that was tuned is adopted. */
enum stad_rule {
    STAD_RULE_DEFAULT = 0, /* tuned: better on the other pose by the margin; a preset: not worse there */
    STAD_RULE_STRICT = 1,  /* the whole change, preset included, better on the other pose by the margin */
    STAD_RULE_NONE = 2     /* whatever was best on the tuning frame: for studies */
};

#define STAD_PRESETS 7 /* points a run can start from: stad_calib_preset() */

/* What a calibration is told. Start from stad_calib_config_default(). */
typedef struct stad_calib_config {
    stad_geometry geometry;      /* of the live matcher: no set is asked for that would not fit it; 16 .. 2048 px a side */
    const stad_target *target;   /* stad_target_relief(), or a constant table of your own */
    stad_camera camera;          /* both views'; as stad_truth_from_target() takes it */
    stad_monitor_config monitor; /* when to ask for a run */
    uint32_t ids;                /* bit i: mark i may be used, two of the target's at least; default all of them */
    int16_t margin_px;           /* stad_truth_init()'s; default 1 */
    int16_t pose_px;             /* mean move of the corners that makes another pose; default 6 */
    int16_t patience;            /* frames in vain before a run is given up; default 60 */
    int16_t probation_frames;    /* live frames after adoption before the second look; default 64; 0 = none */
    int16_t budget;              /* evaluations a run, picks and judgements included; 4..240, default 70 */
    int16_t min_block_size;      /* smallest block that is tried; default 3 */
    int32_t threshold_q16;       /* error that counts as wrong; default 1 px */
    int32_t penalty_q16;         /* lambda: per squared octave from the start; default .01 */
    int32_t gain_q20;            /* smallest gain the judge must see; default 2 points of 100 */
    uint8_t cost;                /* enum stad_score_cost: STAD_SCORE_BAD (default) or STAD_SCORE_CHOW */
    uint8_t rule;                /* enum stad_rule */
    uint8_t preset_mask;         /* bit i: preset i may be picked; default all */
    uint8_t tunes;               /* 0: only pick among the presets; default 1 */
    uint8_t still;               /* 1: identical frames are no fault (recordings without noise); default 0 */
} stad_calib_config;

/* -- what it says ------------------------------------------------------------------------------------------------ */

/* Where a run stands. */
enum stad_calib_phase {
    STAD_CALIB_IDLE = 0,
    STAD_CALIB_LOOK = 1,    /* for marks: the tuning frame */
    STAD_CALIB_OTHER = 2,   /* for the target in another pose */
    STAD_CALIB_CONFIRM = 3, /* the correction, on a few fresh frames */
    STAD_CALIB_PICK = 4,    /* presets on the tuning frame */
    STAD_CALIB_TUNE = 5,
    STAD_CALIB_JUDGE = 6, /* on the other pose */
    STAD_CALIB_SAVE = 7,
    STAD_CALIB_PROBATION = 8, /* live frames */
    STAD_CALIB_RECHECK = 9,   /* a frame with marks to compare new and old */
    STAD_CALIB_COMPARE = 10
};

/* How the last run ended. */
enum stad_calib_outcome {
    STAD_CALIB_NONE = 0,        /* no run yet, or one is under way */
    STAD_CALIB_SOUND = 1,       /* a scheduled look found the rig good: nothing to do */
    STAD_CALIB_ADOPTED = 2,     /* parameters, and the correction if there was one */
    STAD_CALIB_CORRECTED = 3,   /* the correction only */
    STAD_CALIB_KEPT = 4,        /* nothing held on the other pose: what was in use stays */
    STAD_CALIB_ROLLED_BACK = 5, /* adopted, then worse on probation */
    STAD_CALIB_NO_MARKS = 6,    /* patience ran out looking for marks */
    STAD_CALIB_NO_POSE = 7,     /* patience ran out looking for another pose */
    STAD_CALIB_RIG_FAILED = 8,  /* the rig needs a full calibration, moved during the run, or its correction was not
                                 * confirmed; an alarm is raised again after the monitor's cool-down */
    STAD_CALIB_FAULT = 9,       /* patience ran out on camera faults, or STAD_FAULT_MATCH */
    STAD_CALIB_CANCELLED = 10
};

/* What was wrong with the last frame, or with its matches. */
enum stad_calib_fault {
    STAD_FAULT_NONE = 0,
    STAD_FAULT_LATE = 1,      /* no frame came */
    STAD_FAULT_BLACK = 2,     /* a view without light */
    STAD_FAULT_SATURATED = 3, /* a view more than half white */
    STAD_FAULT_FLAT = 4,      /* a view without content: a dead camera */
    STAD_FAULT_FROZEN = 5,    /* a view identical to one of the four before */
    STAD_FAULT_SWAPPED = 6,   /* the marks are on the wrong side: left and right exchanged */
    STAD_FAULT_MARKS = 7,     /* too few marks, or marks that do not fit one sheet (a torn frame, a bent sheet) */
    STAD_FAULT_RANGE = 8,     /* the target is nearer or farther than the matcher searches */
    STAD_FAULT_RIG = 9,       /* rows do not agree and no small correction makes them, or not as at the run's start */
    STAD_FAULT_SIZE = 10,     /* not the geometry's size or channels */
    STAD_FAULT_CAMERA = 11,   /* the marks make no rectangular sheet in space: a wrong focal length or principal point */
    STAD_FAULT_MOVING = 12,   /* CONFIRM: hold the target still; a moving one tells of views that come late, not of the rig */
    STAD_FAULT_SAME = 13,     /* left and right are the same picture: one camera feeds both */
    STAD_FAULT_MATCH = 14     /* the cost of the set in use could not be had: a firmware's workspace or images do not fit */
};

/* What the calibration says of itself. Costs are Q20, and measured: never STAD_COST_FAILED. */
typedef struct stad_calib_report {
    uint8_t phase;          /* enum stad_calib_phase */
    uint8_t outcome;        /* enum stad_calib_outcome */
    uint8_t fault;          /* enum stad_calib_fault */
    uint8_t alarmed;        /* 1: the monitor has asked, or a run found the rig moved, and no run has ended well since */
    uint8_t verdict_before; /* enum stad_rig_verdict with the correction in use when the run began */
    uint8_t verdict_after;  /* with the correction of this run, on fresh frames */
    int8_t preset;          /* picked by the target, -1 = none */
    int8_t tuned;           /* 1: the chosen set came from tuning, 0: from the ladder or it is the old one */
    int8_t save_status;     /* of the last save */
    int16_t evaluations;    /* of this run */
    int32_t tune_before_q20, tune_after_q20;   /* cost on the tuning frame: set in use, set chosen; -1 = not measured */
    int32_t judge_before_q20, judge_after_q20; /* cost on the other pose; -1 = not measured */
    stad_rig_report rig;                       /* of the last fit */
} stad_calib_report;

/* -- state ------------------------------------------------------------------------------------------------------- */

#define STAD_CALIB_PAIRS 8  /* of a frame */
#define STAD_CALIB_SEEN  4  /* pictures of a view that the next is compared with */
#define STAD_CALIB_POOL  16 /* of the fresh, still frames that confirm a correction: four frames with four marks */

/* A frame that is held by the application, as far as calib remembers it. */
typedef struct stad_calib_pose {
    stad_pair pairs[STAD_CALIB_PAIRS]; /* raw */
    int32_t count;                     /* of them */
    stad_truth truth;                  /* of the crop, after correction */
    stad_box box;                      /* the crop */
} stad_calib_pose;

/* What the health check remembers of a view. */
typedef struct stad_calib_view {
    uint32_t hash[STAD_CALIB_SEEN]; /* of the last pictures, the latest first; 0 = none yet */
} stad_calib_view;

/* Private; read it through the calls. */
typedef struct stad_calib {
    stad_calib_config config;                           /* as given */
    stad_monitor monitor;                               /* of the live frames */
    stad_setup active, previous, candidate;             /* setups: in use, to roll back to, on trial */
    stad_calib_pose pose[2];                            /* the held pairs */
    stad_calib_view view[2];                            /* left, right: of frames that were wanted */
    stad_calib_view live[2];                            /* of those that stad_calib_live() was shown */
    stad_pair pool[STAD_CALIB_POOL + STAD_CALIB_PAIRS]; /* raw */
    stad_calib_report report;                           /* stad_calib_report_of() */
    stad_tune tune;                                     /* the search */
    stad_point pick, tuned;                             /* the picked preset (or the set in use), the tuner's best */
    int32_t pick_q20, tuned_q20;                        /* their costs on the tuning frame */
    int32_t pick_score_q20;                             /* the same with the preset's handicap */
    int32_t judged_q20[3];                              /* on the other pose: the set in use, the pick, the tuned one */
    int32_t compared_q20;                               /* on probation: the new set's cost */
    int16_t step;                                       /* within a phase */
    int16_t vain;                                       /* frames without use */
    int16_t pooled;                                     /* pairs in the pool */
    int16_t still;                                      /* frames in a row in which the target was where it was before */
    int16_t trial_frames;                               /* live frames of the probation */
    uint8_t scheduled;                                  /* the run was begun by the schedule: one frame, then leave it */
    uint8_t alarmed_on_trial;                           /* 1: the monitor asked during the probation */
    uint8_t alarm_stands; /* 1: ... or after the last frame of the run, whose end is no answer then */
} stad_calib;

/* Defaults for a matcher of that geometry and a target; the camera is the caller's to give. */
void stad_calib_config_default(stad_calib_config *c, const stad_geometry *geometry, const stad_target *target,
                               const stad_camera *camera);

/* Starts with `setup`, what stad_store_load() found, in use. STAD_E_PARAM: config or setup out of range, or not of
 * one geometry, frames in which marks cannot be looked for (stad_calib_frame_bytes() is 0), or a target that is missing
 * or cannot be used with camera and ids; *c is unchanged then. The setup's own min_disparity, num_disparities and
 * speckle parameters are never changed. */
int stad_calib_init(stad_calib *c, const stad_calib_config *config, const stad_setup *setup);

/* One live frame's counters, matched with the setup in use. Returns the monitor's answer: enum stad_monitor_state, or
 * STAD_E_PARAM when the counters are impossible; such a frame is one of the schedule's and of the probation's still. */
int stad_calib_counts(stad_calib *c, const stad_match_counts *counts);

/* What is wrong with a live frame, told at once: enum stad_calib_fault, one of NONE, LATE (a view is NULL), SIZE, BLACK,
 * SATURATED, FLAT, FROZEN, SAME. Looks at 1 pixel in 16 of both raw views, far less than a match takes. It tells and no
 * more: whether such a frame is matched and counted is the application's choice. What takes marks to see (SWAPPED,
 * RANGE, RIG) is told by runs and scheduled looks, which check their frames by themselves. */
int stad_calib_live(stad_calib *c, const stad_image *left, const stad_image *right);

/* Begins a run now, whatever the monitor says. STAD_E_STATE: one is under way. */
int stad_calib_start(stad_calib *c);

/* Ends a run; what is in use stays. Called while a SAVE is asked for, flash keeps the set before: store stad_calib_setup() then. */
void stad_calib_cancel(stad_calib *c);

/* What is wanted next: enum stad_want, also in r->want. Asking twice is harmless. */
int stad_calib_want(const stad_calib *c, stad_request *r);

/* Workspace of stad_calib_frame(). */
#define STAD_CALIB_FRAME_BYTES(width, height) (STAD_MARK_BYTES(width, height) + STAD_CALIB_SCRATCH)
#define STAD_CALIB_SCRATCH                    4608u /* marks and pairs of a frame, and copies of the pairs of several */
/* The same at run time; 0 for a size in which marks cannot be looked for. */
size_t stad_calib_frame_bytes(int32_t width, int32_t height);

/* A fresh raw pair. `left` or `right` NULL: it did not come in time. Returns 1: hold the pair in buffer r.hold; 0:
 * used up or not needed, go on; a negative status: of no use, report.fault says why, and a frame of patience is gone.
 * STAD_E_STATE: no frame was wanted; STAD_E_SIZE: the workspace. */
int stad_calib_frame(stad_calib *c, const stad_image *left, const stad_image *right, void *work, size_t work_bytes);

/* One row of truth and labels of the crop that a MATCH request is about, for a firmware that matches and scores by
 * itself. y counts from the top of the crop; arrays of box.width. */
int stad_calib_truth_row(const stad_calib *c, const stad_request *r, int y, int32_t *truth_q16_row, uint8_t *label_row);

/* The score config to go with it. */
void stad_calib_score_config(const stad_calib *c, const stad_request *r, stad_score_config *s);

/* The cost that MATCH asked for; STAD_COST_FAILED when it could not be had. STAD_E_STATE: none was asked for;
 * STAD_E_PARAM: a cost below 0, and it is still asked for. */
int stad_calib_cost(stad_calib *c, int32_t cost_q20);

/* How the save ended: a status; negative means that it will be asked for once more, then given up (the set stays in
 * use). */
int stad_calib_saved(stad_calib *c, int status);

/* What to run the live matcher with, and what to store. Valid until the next call that changes *c. */
const stad_setup *stad_calib_setup(const stad_calib *c);

/* Where it stands. */
const stad_calib_report *stad_calib_report_of(const stad_calib *c);

/* -- presets: where a run starts, by the regime the camera is in ------------------------------------------------- */

/* Preset i, 0..STAD_PRESETS - 1, as a tuner's point for images of that many channels, and its name. STAD_E_PARAM past
 * the end, or channels not 1 or 3. */
int stad_calib_preset(int i, int channels, stad_point *point, const char **name);

/* -- the one evaluation, done for you ---------------------------------------------------------------------------- */

/* What an evaluation works with. */
typedef struct stad_evaluator {
    stad_match match; /* of the crop */
    stad_score score; /* against its truth */
} stad_evaluator;

/* Workspace: the live matcher's (its geometry), and STAD_CALIB_ROWS_BYTES() for five rows. Aligned to STAD_ALIGN. */
#define STAD_CALIB_ROWS_BYTES(width, channels) \
    (((size_t)(width) * (7u + 2u * (size_t)(channels)) + STAD_ALIGN - 1u) / STAD_ALIGN * STAD_ALIGN)
/* The bytes of both; all arguments as of STAD_MATCH_BYTES(). */
#define STAD_CALIB_EVALUATE_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory) \
    (STAD_MATCH_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory) +           \
     STAD_CALIB_ROWS_BYTES(width, channels))
/* The same at run time; 0 for an invalid geometry. */
size_t stad_calib_evaluate_bytes(const stad_geometry *geometry);

/* One workspace for stad_calib_frame() and stad_calib_evaluate() in turn: the larger of both. */
#define STAD_CALIB_WORK_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory) \
    STAD_BYTES_MAX(STAD_CALIB_FRAME_BYTES(width, height),                                                  \
                   STAD_CALIB_EVALUATE_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory))

/* Matches the crop of a MATCH request on a held raw pair and scores it against the truth: the cost, or
 * STAD_COST_FAILED, also when images or workspace do not fit. */
int32_t stad_calib_evaluate(const stad_calib *c, const stad_request *r, stad_evaluator *e, const stad_image *left,
                            const stad_image *right, void *work, size_t work_bytes);

#ifdef __cplusplus
}
#endif

#endif
