/* SPDX-License-Identifier: MIT
 * support/calib_bench.c - frames rendered once, what cameras do wrong, turns of the loop. */
#include "support/calib_bench.h"

#include <string.h>

#include "scene/target_scene.h"
#include "unity.h"

uint8_t shots[SHOTS][2][PIXELS];
uint8_t left_pix[PIXELS], right_pix[PIXELS];
uint8_t work[STAD_CALIB_FRAME_BYTES(W, H)] STAD_ALIGNED;
stad_calib calib;
stad_calib_config config;
stad_setup setup;
flash_sim sim;
int made_up_turns;
static uint32_t noise_state;

uint32_t dice(void)
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

void render_all(void)
{
    const target_pose poses[3] = {
        {{40, 8, 400}, 0.45, 0.10, 0.02}, {{10, -14, 390}, 0.40, -0.14, -0.04}, {{50, 0, 410}, 0.5, 0.0, 0.03}};
    render(NEAR_POSE, &poses[0], 0);
    render(FAR_POSE, &poses[1], 0);
    render(THIRD_POSE, &poses[2], 0);
    render(NO_TARGET, NULL, 0);
    render(DRIFTED, &poses[0], 1);
    render(DRIFTED_OTHER, &poses[1], 1);
}

void start(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &setup));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_start(&calib));
}

void bench_reset(void)
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
}

/* -- frames ------------------------------------------------------------------------------------------------------ */

void expose(enum shot which)
{
    for (size_t i = 0; i < PIXELS; i++) {
        int a = shots[which][0][i] + (int)(dice() % 3) - 1, b = shots[which][1][i] + (int)(dice() % 3) - 1;
        left_pix[i] = (uint8_t)(a < 0 ? 0 : a > 255 ? 255 : a);
        right_pix[i] = (uint8_t)(b < 0 ? 0 : b > 255 ? 255 : b);
    }
}

int give(void)
{
    stad_image left = stad_image_packed(left_pix, W, H, 1), right = stad_image_packed(right_pix, W, H, 1);
    return stad_calib_frame(&calib, &left, &right, work, sizeof work);
}

static void fill(uint8_t *pix, int low, unsigned span)
{
    for (size_t i = 0; i < PIXELS; i++)
        pix[i] = (uint8_t)(low + (int)(dice() % span));
}

void make_black(void)
{
    fill(left_pix, 0, 6);
    fill(right_pix, 0, 6);
}
void make_left_black(void)
{
    expose(NEAR_POSE);
    fill(left_pix, 0, 6);
}
void make_saturated(void)
{
    fill(left_pix, 250, 6);
    fill(right_pix, 250, 6);
}
void make_half_saturated(void)
{
    expose(NEAR_POSE);
    memset(right_pix, 255, PIXELS * 6 / 10);
}
void make_right_dead(void)
{
    expose(NEAR_POSE);
    fill(right_pix, 120, 9);
}
void make_frozen(void)
{
    memcpy(left_pix, shots[NO_TARGET][0], PIXELS);
    memcpy(right_pix, shots[NO_TARGET][1], PIXELS);
}
void make_left_frozen(void)
{
    expose(NEAR_POSE);
    memcpy(left_pix, shots[NEAR_POSE][0], PIXELS);
}
void make_swapped(void)
{
    static uint8_t keep[PIXELS];
    expose(NEAR_POSE);
    memcpy(keep, left_pix, PIXELS);
    memcpy(left_pix, right_pix, PIXELS);
    memcpy(right_pix, keep, PIXELS);
}
void make_same(void)
{
    expose(NEAR_POSE);
    memcpy(right_pix, left_pix, PIXELS);
}
void make_rows_shifted(void)
{
    expose(NEAR_POSE);
    memmove(right_pix + 12 * W, right_pix, PIXELS - 12 * W);
}
/* The upper half of the right view is a frame older, when the target was elsewhere. */
void make_torn(void)
{
    static uint8_t keep[PIXELS];
    expose(FAR_POSE);
    memcpy(keep, right_pix, PIXELS);
    expose(NEAR_POSE);
    memcpy(right_pix, keep, PIXELS / 2);
}
void make_with_target(void)
{
    expose(NEAR_POSE);
}
void make_without_target(void)
{
    expose(NO_TARGET);
}

/* -- turns ------------------------------------------------------------------------------------------------------- */

int32_t made_up(const stad_request *r)
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

int live(int per_mille)
{
    stad_match_counts counts = {70000, 70 * per_mille, 0, 0, 0, 0};
    return stad_calib_counts(&calib, &counts);
}

int turn(void)
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

void power_on(void)
{
    stad_setup found;
    stad_flash flash = sim_flash(&sim);
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_load(&flash, &found));
    TEST_ASSERT_EQUAL(STAD_OK, stad_calib_init(&calib, &config, &found));
}

int run_to_the_end(void)
{
    int turns = 0;
    while (stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE && turns < 500) {
        turn();
        turns++;
    }
    TEST_ASSERT_EQUAL_MESSAGE(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase, "the run did not end");
    return turns;
}

void fresh_flash(void)
{
    sim_init(&sim, 8, 5);
    stad_flash flash = sim_flash(&sim);
    TEST_ASSERT_EQUAL(STAD_SLOT_FACTORY, stad_store_save_factory(&flash, &setup));
}
