/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_calib.c - the pump with any config, frames, counters and answers, in any order of calls: what it asks for always fits
 * the matcher, what is in use is always a setup of the domain, and a run that is served ends.
 *
 * Frames are four rendered shots of the target, damaged as the bytes say. */
#include <string.h>

#include "fuzz/fuzz.h"
#include "scene/target_scene.h"
#include "stad/calib.h"
#include "support/subject.h"

enum { W = 320, H = 240, PIXELS = W * H, SHOTS = 4, FRAMES = 40, TURNS = 600 };

static uint8_t shots[SHOTS][2][PIXELS], left[PIXELS], right[PIXELS];
static stad_camera camera;
static uint32_t dice = 1;

static void render(int which, const target_pose *pose, int drifted)
{
    static target_scene quads;
    static float grey[PIXELS];
    target_camera c;
    target_camera_default(&c, W, H);
    c.f = 200;
    c.supersample = 2;
    c.drift_dy = drifted ? 1.5 : 0;
    camera = target_camera_fixed(&c);
    target_scene_clear(&quads);
    target_scene_add(&quads, stad_target_relief(), pose);
    for (int view = 0; view < 2; view++) {
        target_render(&quads, &c, view, NULL, grey, NULL);
        target_quantise(grey, PIXELS, shots[which][view]);
    }
}

static void render_all(void)
{
    const target_pose poses[2] = {{{40, 8, 400}, 0.45, 0.10, 0.02}, {{10, -14, 390}, 0.40, -0.14, -0.04}};
    for (int i = 0; i < SHOTS; i++) {
        render(i, &poses[i % 2], i / 2);
    }
}

static void expose(bytes *b)
{
    int how = next(b), shot = how % SHOTS;
    memcpy(left, shots[shot][how >> 2 & 1 & (how >> 3)], PIXELS);
    memcpy(right, shots[shot][1], PIXELS);
    for (int i = 0; i < 64; i++) { /* so that it is not frozen */
        dice = dice * 1664525u + 1013904223u;
        left[dice >> 8 & 0xFFFF] ^= 1;
        right[dice >> 12 & 0xFFFF] ^= 1;
    }
    for (size_t i = 0; i < PIXELS; i += 4 * 31) {
        left[i] ^= (uint8_t)(dice >> 20 & 1);
        right[i] ^= (uint8_t)(dice >> 21 & 1);
    }
    if (how > 200) {
        uint8_t *view = how & 1 ? left : right;
        size_t at = (size_t)next(b) * 300, run = (size_t)next(b) * 300;
        memset(view + at, next(b), at + run > PIXELS ? PIXELS - at : run);
    }
    if (how > 240) {
        fill(how & 1 ? left : right, PIXELS, b, (size_t)how);
    }
}

static int frame(stad_calib *c, bytes *b)
{
    int how = next(b);
    size_t bytes_needed = STAD_CALIB_FRAME_BYTES(W, H);
    uint8_t *work = subject_alloc(bytes_needed, 0, 3);
    stad_image l = stad_image_packed(left, W, H, 1), r = stad_image_packed(right, W, H, 1);
    expose(b);
    if (how > 250) {
        l.width -= 8;
    }
    int live = stad_calib_live(c, how == 7 ? NULL : &l, how == 8 ? NULL : &r);
    expect(live >= STAD_FAULT_NONE && live <= STAD_FAULT_SAME);
    int status = stad_calib_frame(c, how == 7 ? NULL : &l, how == 8 ? NULL : &r, work, bytes_needed - (how == 9));
    expect(status <= 1 && status >= STAD_E_RIG && subject_guards_stand(work));
    subject_free(work);
    return status;
}

static void match(stad_calib *c, const stad_request *r, const stad_geometry *g, bytes *b)
{
    int how = next(b);
    expect(stad_params_check(&r->params, g->mode, W, NULL) == STAD_OK);
    expect(r->params.num_disparities <= g->max_disparities && r->params.block_size <= g->max_block_size);
    expect(r->params.p2 <= g->max_p2 && r->params.pre_filter_cap <= g->max_pre_filter_cap);
    expect(r->hold < 2 && r->box.x >= 0 && r->box.y >= 0 && r->box.width > 0 && r->box.height > 0);
    expect(r->box.x + r->box.width <= W && r->box.y + r->box.height <= H);
    int32_t *truth = subject_alloc((size_t)r->box.width * 4, 0, 1);
    uint8_t *label = subject_alloc((size_t)r->box.width, 0, 2);
    int status = stad_calib_truth_row(c, r, next(b) % (r->box.height + 1), truth, label);
    expect((status == STAD_OK || status == STAD_E_SIZE) && subject_guards_stand(truth) && subject_guards_stand(label));
    subject_free(truth), subject_free(label);
    int32_t cost = how == 0 ? STAD_COST_FAILED : how == 1 ? next_i32(b) : (how % 64) * 12000 + next(b) * 100;
    status = stad_calib_cost(c, cost);
    expect(status == (cost < 0 ? STAD_E_PARAM : STAD_OK));
}

static void counters(stad_calib *c, bytes *b)
{
    stad_match_counts counts = {70000, next(b) * 274, 0, 0, 0, 0};
    if (counts.firm > 69000) {
        counts.considered = next_i32(b);
        counts.firm = next_i32(b);
    }
    int status = stad_calib_counts(c, &counts);
    expect(status == STAD_E_PARAM || (status >= 0 && status <= STAD_MONITOR_DEGRADED));
}

/* Does what is wanted. Returns whether a frame was spent. */
static int serve(stad_calib *c, const stad_geometry *g, bytes *b)
{
    stad_request r;
    switch (stad_calib_want(c, &r)) {
    case STAD_WANT_FRAME:
        frame(c, b);
        return 1;
    case STAD_WANT_MATCH:
        match(c, &r, g, b);
        break;
    case STAD_WANT_SAVE:
        expect(stad_calib_saved(c, next(b) % 4 ? 0 : STAD_E_CORRUPT) == STAD_OK);
        break;
    default:
        counters(c, b);
    }
    return 0;
}

/* A call that may not fit the moment. */
static void meddle(stad_calib *c, bytes *b)
{
    stad_request r;
    int op = next(b) % 8, want = stad_calib_want(c, &r), status;
    switch (op) {
    case 0:
        status = stad_calib_start(c);
        expect(status == STAD_OK || status == STAD_E_STATE);
        break;
    case 1:
        stad_calib_cancel(c);
        break;
    case 2:
        expect(want == STAD_WANT_MATCH || stad_calib_cost(c, 5) == STAD_E_STATE);
        break;
    case 3:
        expect(want == STAD_WANT_SAVE || stad_calib_saved(c, 0) == STAD_E_STATE);
        break;
    case 4:
        expect(want == STAD_WANT_FRAME || stad_calib_frame(c, NULL, NULL, NULL, 0) == STAD_E_STATE);
        break;
    default:
        counters(c, b);
    }
}

static void some_config(stad_calib_config *c, bytes *b)
{
    int how = next(b);
    c->patience = 6;
    c->probation_frames = 3;
    c->monitor.learn_frames = 4;
    c->monitor.mark_every = 9;
    if (how & 1) {
        c->margin_px = number(b, 17);
        c->pose_px = number(b, 20);
        c->patience = number(b, 9);
        c->probation_frames = number(b, 9);
    }
    if (how & 2) {
        c->budget = number(b, 240);
        c->min_block_size = number(b, 12);
        c->rule = (uint8_t)(next(b) % 4);
        c->cost = (uint8_t)(next(b) % 3);
    }
    if (how & 4) {
        c->threshold_q16 = next_i32(b);
        c->penalty_q16 = next_i32(b) >> (next(b) % 32);
        c->gain_q20 = next_i32(b) >> (next(b) % 32);
    }
    if (how & 8) {
        c->preset_mask = (uint8_t)next(b);
        c->tunes = (uint8_t)(next(b) % 2);
        c->still = (uint8_t)(next(b) % 2);
        c->ids = (uint32_t)next(b);
    }
    if (how & 16) {
        c->camera.f_q8 = next_i32(b) >> (next(b) % 32);
        c->camera.cx_q8 = next_i32(b) >> (next(b) % 32);
        c->camera.cy_q8 = next_i32(b) >> (next(b) % 32);
    }
    if (how & 32) {
        c->geometry.max_p2 = number(b, 240);
        c->geometry.max_pre_filter_cap = number(b, 127);
        c->geometry.max_block_size = number(b, 14);
    }
    if (how & 64) {
        c->monitor.slack_q8 = (int16_t)next_i16(b);
        c->monitor.threshold_q8 = (int16_t)next_i16(b);
        c->monitor.clip_q8 = (int16_t)next_i16(b);
        c->monitor.follow_shift = number(b, 17);
        c->monitor.floor_q16 = next_i32(b) >> (next(b) % 32);
        c->monitor.mark_every = next_i32(b) >> (next(b) % 32);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static stad_calib c;
    static int ready;
    const stad_geometry g = {W, H, 1, 64, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    bytes b = {data, size};
    stad_calib_config config;
    stad_setup setup;
    int frames = 0, busy = 0;
    if (!ready) {
        render_all();
        ready = 1;
    }
    dice = 1;
    stad_calib_config_default(&config, &g, stad_target_relief(), &camera);
    some_config(&config, &b);
    memset(&setup, 0, sizeof setup);
    setup.width = W;
    setup.height = H;
    setup.channels = 1;
    stad_params_sample(&setup.params, 64, next(&b) % 4 ? 3 : number(&b, 14), 1);
    setup.params.p1 = (int16_t)(next(&b) % 4 ? setup.params.p1 : number(&b, 200));
    setup.params.min_disparity = (int16_t)(next(&b) % 4 ? 0 : number(&b, 40));
    stad_rig_identity(&setup.rig, W, H);
    if (stad_calib_init(&c, &config, &setup) != STAD_OK) {
        return 0;
    }
    for (int i = 0; i < TURNS && frames < FRAMES && b.left; i++) {
        if (next(&b) > 230) {
            meddle(&c, &b);
        } else {
            frames += serve(&c, &config.geometry, &b);
        }
        const stad_calib_report *r = stad_calib_report_of(&c);
        expect(stad_setup_check(stad_calib_setup(&c)) == STAD_OK);
        expect(r->phase <= STAD_CALIB_COMPARE && r->evaluations <= config.budget + STAD_PRESETS + 4);
    }
    for (int i = 0; frames < FRAMES && config.patience < 9 && config.probation_frames < 9 && i < TURNS;
         i++) { /* served to its end */
        frames += serve(&c, &config.geometry, &b);
        busy = stad_calib_report_of(&c)->phase != STAD_CALIB_IDLE;
        if (!busy) {
            break;
        }
    }
    expect(!busy || frames == FRAMES);
    return 0;
}
