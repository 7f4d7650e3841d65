/* SPDX-License-Identifier: MIT
 * stad/simulate.h - what `stad simulate` is asked for, the board it plays, and what came of it. */
#ifndef STAD_SIMULATE_H
#define STAD_SIMULATE_H

#include "../common/calib_names.h"
#include "../common/engine.h"
#include "degrade.h"
#include "match_options.h"
#include "recording.h"
#include "report.h"
#include "simulate_ahead.h"
#include "stad/calib.h"
#include "stad/store.h"

/* Flash of three small sectors, in memory. */
#define SIM_SECTOR 128
typedef struct sim_flash {
    uint8_t bytes[3 * SIM_SECTOR];
    stad_flash flash;
} sim_flash;

/* A frame in the log. */
typedef struct sim_row {
    int frame, state, phase, fault, skipped;
    int live;     /* enum stad_calib_fault of the frame as the matcher saw it */
    double share; /* of considered pixels that are firm; what the monitor watches */
    stad_match_counts counts;
    stad_params params; /* it was matched with */
} sim_row;

/* A calibration run that ended. */
typedef struct sim_run {
    int frame;
    stad_calib_report report;
    stad_setup setup; /* in use since */
} sim_run;

typedef struct simulation {
    /* asked for */
    match_options options;
    const char *where, *csv, *json, *report;
    char *command;
    report_rig rig;
    double cx, cy; /* principal point, px; not a number = the middle */
    degrade bad;
    int side_by_side, raw_width, raw_height, keep_going, color;
    long calibrate_at, evaluations_per_frame, learn_frames, probation_frames, budget, limit, jobs;
    int cost;
    unsigned long long given; /* options, as TOOL_BIT */
    /* the board */
    recording frames;
    int end; /* the frame after the last that is to be played */
    stad_geometry geometry;
    ahead ahead;
    stad_calib calib;
    stad_evaluator evaluator;
    void *work;
    size_t work_bytes;
    picture held[2][2];
    stad_setup initial;
    sim_flash flash;
    /* what came of it */
    sim_row *rows;
    sim_run *runs;
    int row_count, skipped, alarms, run_count, run_room, last_outcome;
    stad_setup stored;
    int stored_slot; /* enum stad_slot, or negative: nothing was stored */
    double seconds;
    char stopped[600]; /* why the recording was not played to its end; "" when it was */
} simulation;

/* The whole recording. On failure, and at a signal (status 128 + its number), what was done so far is in the rows, and can be
 * written. */
int simulate_run(simulation *s, tool_fail *f);
void simulate_free(simulation *s);

/* 0 for a cost that was not measured, or whose match failed. */
int simulate_is_measured(int32_t cost_q20);

/* The next row from i on that begins a spell of one live fault, row_count when there is none; *last: the row that ends it. */
int simulate_spell(const simulation *s, int i, int *last);

/* 1 if the monitor was learning still at the last frame: nothing was watched. */
int simulate_learning(const simulation *s);

/* A correction as one says it. */
typedef struct sim_correction {
    double dy_px, roll_degrees, scale_percent;
} sim_correction;
sim_correction simulate_correction(const stad_rig *rig);

void simulate_print(const simulation *s);
int simulate_write_csv(const simulation *s, tool_fail *f);
int simulate_write_json(const simulation *s, tool_fail *f);
int simulate_write_report(simulation *s, tool_fail *f);

#endif
