/* SPDX-License-Identifier: MIT
 * support/calib_bench.h - a loop before a target: frames rendered once, cameras that fail, made-up costs, a flash.
 *
 * One target in three poses before a room, with sound and with drifted cameras. Each frame gets noise of its own. */
#ifndef TEST_CALIB_BENCH_H
#define TEST_CALIB_BENCH_H

#include <stddef.h>
#include <stdint.h>

#include "support/flash_sim.h"
#include "stad/calib.h"

#define W      320
#define H      240
#define PIXELS ((size_t)W * H)

enum shot { NEAR_POSE, FAR_POSE, THIRD_POSE, NO_TARGET, DRIFTED, DRIFTED_OTHER, SHOTS };

extern uint8_t shots[SHOTS][2][PIXELS];
extern uint8_t left_pix[PIXELS], right_pix[PIXELS]; /* the frame at hand */
extern uint8_t work[STAD_CALIB_FRAME_BYTES(W, H)];
extern stad_calib calib;
extern stad_calib_config config;
extern stad_setup setup;
extern flash_sim sim;

/* Renders the shots; once. */
void render_all(void);

/* Config, setup and dice as at the beginning; patience 5, no run. */
void bench_reset(void);

/* Begins a run with config and setup. */
void start(void);
uint32_t dice(void);

/* -- frames */

/* A shot with noise of its own: two frames are never identical. */
void expose(enum shot which);

/* The frame at hand to the loop; its answer. */
int give(void);

void make_black(void);
void make_left_black(void);
void make_saturated(void);
void make_half_saturated(void);
void make_right_dead(void);
void make_frozen(void);
void make_left_frozen(void);
void make_swapped(void);
void make_same(void);
void make_rows_shifted(void);
void make_torn(void);
void make_with_target(void);
void make_without_target(void);

/* -- turns */

/* 0: costs as of a scene in which block 7 and more helps, for any point; 1: in which it does harm. */
extern int made_up_turns;
int32_t made_up(const stad_request *r);

/* A live frame of which so many are firm. Returns the monitor's answer. */
int live(int per_mille);

/* One turn; a save goes to the simulated flash. Returns what was wanted. */
int turn(void);

/* Turns until the run is over; fails after 500. Returns their number. */
int run_to_the_end(void);

/* A flash that holds `setup` as the factory's. */
void fresh_flash(void);

/* A board that starts: the loop from what the flash holds. */
void power_on(void);

#endif
