/* SPDX-License-Identifier: MIT
 * test_calib_faults.c - the loop when cameras, frames, marks, flash or power fail: the state is told, nothing bad is
 * adopted, it ends.
 *
 * Frames are rendered once: the target in two poses before a room, with sound and with drifted cameras. Costs are
 * made up where only the pump is at stake. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "flash_sim.h"
#include "scene/target_scene.h"
#include "stad/calib.h"
#include "unity.h"

#define W      320
#define H      240
#define PIXELS ((size_t)W * H)

enum shot { NEAR_POSE, FAR_POSE, THIRD_POSE, NO_TARGET, DRIFTED, DRIFTED_OTHER, SHOTS };

static uint8_t shots[SHOTS][2][PIXELS];
static uint8_t left_pix[PIXELS], right_pix[PIXELS];
static uint8_t work[STAD_CALIB_FRAME_BYTES(W, H)] STAD_ALIGNED;
static stad_calib calib;
static stad_calib_config config;
static stad_setup setup;
static flash_sim sim;
static uint32_t noise_state;

static uint32_t dice(void)
{
    noise_state = noise_state * 1664525u + 1013904223u;
    return noise_state >> 8;
}

static target_camera camera_of(int drifted)
{
    target_camera c;
    target_camera_default(&c, W, H);
    c.f = 200;
    c.supersample = 2;
    if (drifted) {
        c.drift_dy = 1.5;
        c.drift_roll = 0.005;
    }
    return c;
}

static void render(enum shot which, const target_pose *pose, int drifted)
{
    static target_scene scene;
    static float grey[PIXELS];
    target_camera camera = camera_of(drifted);
    target_scene_clear(&scene);
    target_scene_add_room(&scene, &camera, 500, 2000, 8, 3);
    if (pose)
        target_scene_add(&scene, stad_target_relief(), pose);
    for (int view = 0; view < 2; view++) {
        target_render(&scene, &camera, view, NULL, grey, NULL);
        target_quantise(grey, (int)PIXELS, shots[which][view]);
    }
}

static void render_all(void)
{
    const target_pose poses[3] = {{{40, 8, 400}, 0.45, 0.10, 0.02},
                                  {{10, -14, 390}, 0.40, -0.14, -0.04},
                                  {{50, 0, 410}, 0.5, 0.0, 0.03}};
    render(NEAR_POSE, &poses[0], 0);
    render(FAR_POSE, &poses[1], 0);
    render(THIRD_POSE, &poses[2], 0);
    render(NO_TARGET, NULL, 0);
    render(DRIFTED, &poses[0], 1);
    render(DRIFTED_OTHER, &poses[1], 1);
}

static void start(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_start(&calib));
}

void setUp(void)
{
    const stad_geometry g = {W, H, 1, 64, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    target_camera camera = camera_of(0);
    stad_camera fixed = target_camera_fixed(&camera);
    noise_state = 7;
    stad_calib_config_default(&config, &g, stad_target_relief(), &fixed);
    config.patience = 5;
    memset(&setup, 0, sizeof setup);
    setup.width = W;
    setup.height = H;
    setup.channels = 1;
    stad_params_sample(&setup.params, 64, 3, 1);
    stad_rig_identity(&setup.rig, W, H);
    start();
}

void tearDown(void)
{
}

/* -- frames ------------------------------------------------------------------------------------------------------ */

/* A shot with noise of its own: two frames are never identical. */
static void expose(enum shot which)
{
    for (size_t i = 0; i < PIXELS; i++) {
        int a = shots[which][0][i] + (int)(dice() % 3) - 1, b = shots[which][1][i] + (int)(dice() % 3) - 1;
        left_pix[i] = (uint8_t)(a < 0 ? 0 : a > 255 ? 255 : a);
        right_pix[i] = (uint8_t)(b < 0 ? 0 : b > 255 ? 255 : b);
    }
}

static int give(void)
{
    stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    return stad_calib_frame(&calib, &left, &right, work, sizeof work);
}

static void fill(uint8_t *pix, int low, unsigned span)
{
    for (size_t i = 0; i < PIXELS; i++)
        pix[i] = (uint8_t)(low + (int)(dice() % span));
}

static void make_black(void)
{
    fill(left_pix, 0, 6);
    fill(right_pix, 0, 6);
}
static void make_left_black(void)
{
    expose(NEAR_POSE);
    fill(left_pix, 0, 6);
}
static void make_saturated(void)
{
    fill(left_pix, 250, 6);
    fill(right_pix, 250, 6);
}
static void make_half_saturated(void)
{
    expose(NEAR_POSE);
    memset(right_pix, 255, PIXELS * 6 / 10);
}
static void make_right_dead(void)
{
    expose(NEAR_POSE);
    fill(right_pix, 120, 9);
}
static void make_frozen(void)
{
    memcpy(left_pix, shots[NO_TARGET][0], PIXELS);
    memcpy(right_pix, shots[NO_TARGET][1], PIXELS);
}
static void make_left_frozen(void)
{
    expose(NEAR_POSE);
    memcpy(left_pix, shots[NEAR_POSE][0], PIXELS);
}
static void make_swapped(void)
{
    static uint8_t keep[PIXELS];
    expose(NEAR_POSE);
    memcpy(keep, left_pix, PIXELS);
    memcpy(left_pix, right_pix, PIXELS);
    memcpy(right_pix, keep, PIXELS);
}
static void make_rows_shifted(void)
{
    expose(NEAR_POSE);
    memmove(right_pix + 12 * W, right_pix, PIXELS - 12 * W);
}
/* The upper half of the right view is a frame older, when the target was elsewhere. */
static void make_torn(void)
{
    static uint8_t keep[PIXELS];
    expose(FAR_POSE);
    memcpy(keep, right_pix, PIXELS);
    expose(NEAR_POSE);
    memcpy(right_pix, keep, PIXELS / 2);
}
static void make_with_target(void)
{
    expose(NEAR_POSE);
}
static void make_without_target(void)
{
    expose(NO_TARGET);
}

/* -- camera faults ----------------------------------------------------------------------------------------------- */

static void expect_fault(void (*make)(void), int fault, int outcome)
{
    start();
    for (int i = 0; i < config.patience; i++) {
        TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, stad_calib_report_of(&calib)->phase);
        make();
        int status = give();
        TEST_ASSERT_LESS_THAN(0, status);
    }
    TEST_ASSERT_EQUAL(fault, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL(outcome, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_black_cameras_are_told(void)
{
    expect_fault(make_black, STAD_FAULT_BLACK, STAD_CALIB_FAULT);
    expect_fault(make_left_black, STAD_FAULT_BLACK, STAD_CALIB_FAULT);
}

void test_calib_saturated_cameras_are_told(void)
{
    expect_fault(make_saturated, STAD_FAULT_SATURATED, STAD_CALIB_FAULT);
    expect_fault(make_half_saturated, STAD_FAULT_SATURATED, STAD_CALIB_FAULT);
}

void test_calib_dead_camera_is_told(void)
{
    expect_fault(make_right_dead, STAD_FAULT_FLAT, STAD_CALIB_FAULT);
}

void test_calib_frozen_cameras_are_told(void)
{
    expect_fault(make_frozen, STAD_FAULT_FROZEN, STAD_CALIB_FAULT);
    make_left_frozen();
    stad_calib_init(&calib, &config, &setup);
    stad_calib_start(&calib);
    TEST_ASSERT_EQUAL(1, give()); /* the first of them cannot be known */
    make_left_frozen();
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_FROZEN, stad_calib_report_of(&calib)->fault);
}

void test_calib_still_recordings_are_allowed_when_asked_for(void)
{
    config.still = 1;
    start();
    make_frozen();
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    make_frozen();
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_MARKS, stad_calib_report_of(&calib)->fault);
}

void test_calib_swapped_cameras_are_told(void)
{
    expect_fault(make_swapped, STAD_FAULT_SWAPPED, STAD_CALIB_FAULT);
}

void test_calib_shifted_rows_are_told(void)
{
    expect_fault(make_rows_shifted, STAD_FAULT_RIG, STAD_CALIB_RIG_FAILED);
    TEST_ASSERT_EQUAL(STAD_RIG_FAIL, stad_calib_report_of(&calib)->verdict_before);
}

void test_calib_torn_frame_is_refused(void)
{
    start();
    make_torn();
    TEST_ASSERT_LESS_THAN(0, give());
    TEST_ASSERT_TRUE(stad_calib_report_of(&calib)->fault == STAD_FAULT_RIG ||
                     stad_calib_report_of(&calib)->fault == STAD_FAULT_MARKS);
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give()); /* the next good one is taken */
}

void test_calib_no_target_is_told(void)
{
    expect_fault(make_without_target, STAD_FAULT_MARKS, STAD_CALIB_NO_MARKS);
}

void test_calib_target_out_of_range_is_told(void)
{
    config.geometry.max_disparities = 16;
    setup.params.num_disparities = 16;
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(STAD_E_NO_MARK, give());
    TEST_ASSERT_EQUAL(STAD_FAULT_RANGE, stad_calib_report_of(&calib)->fault);
}

void test_calib_wrong_focal_length_is_told(void)
{
    config.camera.f_q8 *= 2;
    expect_fault(make_with_target, STAD_FAULT_CAMERA, STAD_CALIB_FAULT);
}

void test_calib_wrong_size_is_told(void)
{
    stad_image small = stad_image_packed(left_pix, W - 1, H, 1),
               right = stad_image_packed(right_pix, W, H, 1);
    start();
    TEST_ASSERT_EQUAL(STAD_E_SIZE, stad_calib_frame(&calib, &small, &right, work, sizeof work));
    TEST_ASSERT_EQUAL(STAD_FAULT_SIZE, stad_calib_report_of(&calib)->fault);
    TEST_ASSERT_EQUAL(STAD_CALIB_LOOK, stad_calib_report_of(&calib)->phase);
}

/* -- poses and the rig ------------------------------------------------------------------------------------------- */

void test_calib_same_pose_does_not_judge(void)
{
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    for (int i = 0; i < config.patience; i++) {
        TEST_ASSERT_EQUAL(STAD_CALIB_OTHER, stad_calib_report_of(&calib)->phase);
        expose(NEAR_POSE);
        TEST_ASSERT_EQUAL(0, give());
    }
    TEST_ASSERT_EQUAL(STAD_CALIB_NO_POSE, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_two_poses_of_a_sound_rig_begin_the_trial(void)
{
    stad_request r;
    start();
    expose(NEAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    make_black();
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, give());
    expose(FAR_POSE);
    TEST_ASSERT_EQUAL(1, give());
    TEST_ASSERT_EQUAL(STAD_RIG_GOOD, stad_calib_report_of(&calib)->verdict_before);
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
    TEST_ASSERT_EQUAL(0, r.rig.a_q16);
    TEST_ASSERT_GREATER_THAN(64 + 60, r.box.width);
}

static int give_until_idle(enum shot first, enum shot then, int most)
{
    int given = 0;
    for (; given < most && stad_calib_report_of(&calib)->phase <= STAD_CALIB_CONFIRM &&
           stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE;
         given++) {
        expose(given == 0 ? first : then);
        give();
    }
    return given;
}

void test_calib_drifted_rig_is_corrected_without_another_pose(void)
{
    start();
    give_until_idle(DRIFTED, DRIFTED, 40);
    TEST_ASSERT_EQUAL(STAD_CALIB_SAVE, stad_calib_report_of(&calib)->phase);
    stad_calib_saved(&calib, 0);
    const stad_calib_report *r = stad_calib_report_of(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_CORRECTED, r->outcome);
    TEST_ASSERT_EQUAL(STAD_RIG_CORRECT, r->verdict_before);
    TEST_ASSERT_EQUAL(STAD_RIG_GOOD, r->verdict_after);
    TEST_ASSERT_EQUAL(1, stad_calib_setup(&calib)->corrected);
    TEST_ASSERT_EQUAL_MEMORY(&setup.params, &stad_calib_setup(&calib)->params, sizeof setup.params);
    TEST_ASSERT_INT_WITHIN(65536 / 8, 3 * 65536 / 2, stad_calib_setup(&calib)->rig.a_q16);
}

void test_calib_drifted_rig_is_tuned_only_through_its_correction(void)
{
    stad_request r;
    start();
    give_until_idle(DRIFTED, DRIFTED_OTHER, 40);
    TEST_ASSERT_EQUAL(STAD_WANT_MATCH, stad_calib_want(&calib, &r));
    TEST_ASSERT_NOT_EQUAL(0, r.rig.a_q16);
    TEST_ASSERT_EQUAL(0, stad_calib_setup(&calib)->corrected); /* nothing adopted yet */
}

void test_calib_correction_that_fresh_frames_deny_is_refused(void)
{
    start();
    expose(DRIFTED);
    TEST_ASSERT_EQUAL(1, give());
    expose(DRIFTED_OTHER);
    TEST_ASSERT_EQUAL(1, give());
    TEST_ASSERT_EQUAL(STAD_CALIB_CONFIRM, stad_calib_report_of(&calib)->phase);
    for (int i = 0; i < 20 && stad_calib_report_of(&calib)->phase == STAD_CALIB_CONFIRM; i++) {
        expose(i < 4 ? NEAR_POSE : DRIFTED); /* the camera comes loose, and back */
        give();
    }
    TEST_ASSERT_NOT_EQUAL(STAD_CALIB_CONFIRM, stad_calib_report_of(&calib)->phase);
    TEST_ASSERT_EQUAL_MEMORY(&setup, stad_calib_setup(&calib), sizeof setup);
}

void test_calib_correction_is_dropped_when_the_rig_is_sound_again(void)
{
    setup.corrected = 1;
    setup.rig.a_q16 = 2 * 65536;
    start();
    give_until_idle(NEAR_POSE, NEAR_POSE, 40);
    stad_calib_saved(&calib, 0);
    TEST_ASSERT_EQUAL(STAD_CALIB_CORRECTED, stad_calib_report_of(&calib)->outcome);
    TEST_ASSERT_EQUAL(0, stad_calib_setup(&calib)->corrected);
}

/* -- resets, soak ------------------------------------------------------------------------------------------------ */

static int made_up_turns; /* 1: in which it does harm */

/* Costs as of a scene in which block 7 and more helps, for any point. */
static int32_t made_up(const stad_request *r)
{
    if (made_up_turns)
        return (10 + 5 * r->params.block_size) * (STAD_COST_ONE / 100);
    int block = r->params.block_size < 7 ? 7 - r->params.block_size : 0;
    return (int32_t)((10 + 5 * block + (r->params.p1 < 200 ? 6 : 0)) * (STAD_COST_ONE / 100));
}

static enum shot shot_for(int phase)
{
    return phase == STAD_CALIB_OTHER ? FAR_POSE : phase == STAD_CALIB_RECHECK ? THIRD_POSE : NEAR_POSE;
}

static void live(int per_mille)
{
    stad_match_counts counts = {70000, 70 * per_mille, 0, 0, 0, 0};
    stad_calib_counts(&calib, &counts);
}

/* One turn; a save goes to the simulated flash. Returns what was wanted. */
static int turn(void)
{
    stad_request r;
    stad_flash flash = sim_flash(&sim);
    int want = stad_calib_want(&calib, &r);
    if (want == STAD_WANT_FRAME) {
        expose(shot_for(stad_calib_report_of(&calib)->phase));
        give();
    } else if (want == STAD_WANT_MATCH) {
        stad_calib_cost(&calib, made_up(&r));
    } else if (want == STAD_WANT_SAVE) {
        stad_calib_saved(&calib, stad_store_save(&flash, stad_calib_setup(&calib)));
    } else {
        live(800);
    }
    return want;
}

static void power_on(void)
{
    stad_setup found;
    stad_flash flash = sim_flash(&sim);
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_load(&flash, &found));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &found));
}

static int run_to_the_end(void)
{
    int turns = 0;
    while (stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE && turns < 500) {
        turn();
        turns++;
    }
    TEST_ASSERT_EQUAL_MESSAGE(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase, "the run did not end");
    return turns;
}

static void fresh_flash(void)
{
    sim_init(&sim, 8, 5);
    stad_flash flash = sim_flash(&sim);
    TEST_ASSERT_EQUAL(STAD_SLOT_FACTORY, stad_store_save_factory(&flash, &setup));
}

void test_calib_reset_at_any_turn_leaves_old_or_adopted(void)
{
    fresh_flash();
    power_on();
    stad_calib_start(&calib);
    int turns = run_to_the_end();
    stad_setup adopted = *stad_calib_setup(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
    printf("calib: a run of %d turns, reset at each\n", turns);
    for (int at = 0; at < turns; at++) {
        fresh_flash();
        power_on();
        stad_calib_start(&calib);
        for (int i = 0; i < at; i++)
            turn();
        memset(&calib, 0x5a, sizeof calib);
        power_on();
        const stad_setup *s = stad_calib_setup(&calib);
        TEST_ASSERT_TRUE(memcmp(s, &setup, sizeof setup) == 0 || memcmp(s, &adopted, sizeof adopted) == 0);
        TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    }
}

/* -- power cuts while the pump saves ----------------------------------------------------------------------------- */

/* A pump about to save, its flash, and what may be found after a cut. */
typedef struct saving {
    stad_calib calib;
    flash_sim sim;
    stad_setup old;
    long bytes; /* that the save touches */
} saving;

/* Turns until a save is wanted that is not the first `skip` of them. */
static void turn_to_save(int skip)
{
    stad_request r;
    for (int i = 0; i < 500; i++) {
        if (stad_calib_want(&calib, &r) == STAD_WANT_SAVE && skip-- == 0)
            return;
        turn();
    }
    TEST_FAIL_MESSAGE("no save was asked for");
}

/* `saves` sets in the flash beside the factory's, then a run up to its save: of what is adopted, or of the way back. */
static void bring_to_save(saving *s, int saves, int back)
{
    stad_flash flash = sim_flash(&sim);
    stad_setup other = setup;
    fresh_flash();
    made_up_turns = 0;
    for (int i = 0; i < saves; i++) {
        other.params.p1 = (int16_t)(60 + i);
        TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_save(&flash, &other));
    }
    config.probation_frames = back ? 3 : 0;
    power_on();
    stad_calib_start(&calib);
    turn_to_save(0);
    if (back) {
        turn();
        made_up_turns = 1; /* what was adopted turns out worse */
        turn_to_save(0);
    }
    s->calib = calib;
    s->sim = sim;
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_load(&flash, &s->old));
    sim.touched = 0;
    turn();
    s->bytes = sim.touched;
    made_up_turns = 0;
}

static int is_same(const stad_setup *a, const stad_setup *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* The power goes at one byte of the save. With its state kept the pump asks for the save again and ends the run; without it starts
 * over from the old set or the new one, and a fresh run ends well. Counts in found[] which of the two it was. */
static void cut_save(const saving *s, long at, enum sim_tear tear, int kept, int found[2])
{
    stad_request r;
    stad_setup stored;
    stad_flash flash = sim_flash(&sim);
    const stad_setup *new = &s->calib.active;
    char where[96];
    snprintf(where, sizeof where, "cut at byte %ld, tear %d, state %s", at, (int)tear,
             kept ? "kept" : "lost");
    calib = s->calib;
    sim = s->sim;
    sim_restart(&sim);
    sim.tear = tear;
    sim.cut_at = at;
    sim.random += (uint32_t)at;
    stad_store_save(&flash, stad_calib_setup(&calib)); /* the answer is never told: the board is off */
    TEST_ASSERT_EQUAL_MESSAGE(1, sim.dead, where);
    sim_restart(&sim);
    TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, stad_store_load(&flash, &stored), where);
    TEST_ASSERT_TRUE_MESSAGE(is_same(&stored, &s->old) || is_same(&stored, new), where);
    found[is_same(&stored, new)]++;
    if (!kept) {
        memset(&calib, 0x5a, sizeof calib);
        power_on();
        TEST_ASSERT_TRUE_MESSAGE(is_same(stad_calib_setup(&calib), &stored), where);
        TEST_ASSERT_EQUAL_MESSAGE(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase, where);
        if (at % 4 == 0) /* a whole run takes its time */
            stad_calib_start(&calib);
    } else {
        TEST_ASSERT_EQUAL_MESSAGE(STAD_WANT_SAVE, stad_calib_want(&calib, &r), where);
    }
    run_to_the_end();
    TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, stad_store_load(&flash, &stored), where);
    TEST_ASSERT_TRUE_MESSAGE(is_same(&stored, stad_calib_setup(&calib)), where);
    TEST_ASSERT_EQUAL_MESSAGE(0, sim.violations, where);
}

void test_calib_power_cut_in_any_byte_of_a_save_leaves_old_or_new(void)
{
    static saving s;
    int cuts = 0, found[2] = {0, 0};
    for (int back = 0; back < 2; back++)
        for (int saves = 0; saves < 3; saves++) {
            bring_to_save(&s, saves, back);
            for (int tear = 0; tear < TEAR_KINDS; tear++)
                for (long at = 0; at < (tear ? SIM_SECTOR : s.bytes);
                     at++, cuts += 2) /* only an erase tears */
                    for (int kept = 0; kept < 2; kept++)
                        cut_save(&s, at, (enum sim_tear)tear, kept, found);
        }
    printf("calib: %d cuts in its saves, the old set %d times, the new one %d\n", cuts, found[0], found[1]);
    TEST_ASSERT_GREATER_THAN(1000, found[0]);
}

/* Whatever frame chance sends. */
static void expose_anything(void)
{
    void (*const faults[])(void) = {make_black,      make_left_black,    make_saturated, make_half_saturated,
                                    make_right_dead, make_left_frozen,   make_swapped,   make_rows_shifted,
                                    make_torn,       make_without_target};
    unsigned choice = dice() % 40;
    if (choice < sizeof faults / sizeof faults[0])
        faults[choice]();
    else
        expose((enum shot)(dice() % SHOTS));
}

static void soak_turn(void)
{
    stad_request r;
    stad_flash flash = sim_flash(&sim);
    switch (stad_calib_want(&calib, &r)) {
    case STAD_WANT_FRAME:
        expose_anything();
        if (dice() % 20 == 0)
            stad_calib_frame(&calib, NULL, NULL, work, sizeof work);
        else
            give();
        break;
    case STAD_WANT_MATCH:
        stad_calib_cost(&calib,
                        dice() % 50 == 0 ? STAD_COST_FAILED : made_up(&r) + (int32_t)(dice() % 20000));
        break;
    case STAD_WANT_SAVE:
        stad_calib_saved(&calib, dice() % 10 == 0 ? STAD_E_CORRUPT
                                                  : stad_store_save(&flash, stad_calib_setup(&calib)));
        break;
    default:
        break;
    }
}

/* STAD_SOAK = number of live frames; the long tier asks for a million. */
void test_calib_soak_never_hangs_and_never_adopts_worse(void)
{
    const char *wish = getenv("STAD_SOAK");
    long frames = wish ? atol(wish) : 20000, runs = 0;
    int level = 800, waiting = 0;
    stad_request start_point;
    config.probation_frames = 20;
    config.monitor.mark_every = 200;
    config.patience = 20;
    fresh_flash();
    power_on();
    memset(&start_point, 0, sizeof start_point);
    start_point.params = setup.params;
    for (long i = 0; i < frames; i++) {
        if (dice() % 400 == 0)
            level = (int)(dice() % 900) + 50;
        live(level + (int)(dice() % 20));
        soak_turn();
        int busy = stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE;
        runs += busy && waiting == 0;
        waiting = busy ? waiting + 1 : 0;
        TEST_ASSERT_LESS_THAN_MESSAGE(600, waiting, "a run does not end");
        stad_request now = start_point;
        now.params = stad_calib_setup(&calib)->params;
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(made_up(&start_point) + 3 * (STAD_COST_ONE / 100), made_up(&now),
                                          "a worse set was adopted");
        TEST_ASSERT_EQUAL(STAD_OK, stad_setup_check(stad_calib_setup(&calib)));
        if (dice() % 5000 == 0)
            power_on();
    }
    printf("calib: %ld live frames, %ld runs\n", frames, runs);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_black_cameras_are_told);
    RUN_TEST(test_calib_saturated_cameras_are_told);
    RUN_TEST(test_calib_dead_camera_is_told);
    RUN_TEST(test_calib_frozen_cameras_are_told);
    RUN_TEST(test_calib_still_recordings_are_allowed_when_asked_for);
    RUN_TEST(test_calib_swapped_cameras_are_told);
    RUN_TEST(test_calib_shifted_rows_are_told);
    RUN_TEST(test_calib_torn_frame_is_refused);
    RUN_TEST(test_calib_no_target_is_told);
    RUN_TEST(test_calib_target_out_of_range_is_told);
    RUN_TEST(test_calib_wrong_focal_length_is_told);
    RUN_TEST(test_calib_wrong_size_is_told);
    RUN_TEST(test_calib_same_pose_does_not_judge);
    RUN_TEST(test_calib_two_poses_of_a_sound_rig_begin_the_trial);
    RUN_TEST(test_calib_drifted_rig_is_corrected_without_another_pose);
    RUN_TEST(test_calib_drifted_rig_is_tuned_only_through_its_correction);
    RUN_TEST(test_calib_correction_that_fresh_frames_deny_is_refused);
    RUN_TEST(test_calib_correction_is_dropped_when_the_rig_is_sound_again);
    RUN_TEST(test_calib_reset_at_any_turn_leaves_old_or_adopted);
    RUN_TEST(test_calib_power_cut_in_any_byte_of_a_save_leaves_old_or_new);
    RUN_TEST(test_calib_soak_never_hangs_and_never_adopts_worse);
    return UNITY_END();
}
