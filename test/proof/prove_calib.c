/* SPDX-License-Identifier: MIT
 * proof/prove_calib.c - the calibration loop: any config refused or taken; then in every phase, from any state that its invariants allow,
 * any call with any arguments: counters, frames present or missing, costs, saves, cancels. Each keeps the invariants: in holds(), so
 * they hold after any calls in any order.
 * SOURCES: calib/calib.c calib/collect.c calib/trial.c calib/points.c calib/presets.c calib/rule.c truth/target.c
 * PRECISION: 1
 * OPTIONS: -eva-min-loop-unroll 9 -eva-plevel 600 -eva-slevel 20 -eva-slevel-function copy_pairs:0,string_up:0,any_pairs:0,any_setup:0,any_point:0,any_state:0,bytes_equal:0,stad_rig_straighten:0 -cpp-extra-args=-Dmemcpy=copy_pairs
 * What other modules answer is taken at its widest, whatever was asked: marks, pairs, fits, truths, boxes, the tuner's points. That a run
 * stays within its budget is the tuner's; that a frame's pairs are read where they were written, the sanitizers'. */
#include "calib/calib_parts.h"

#include "proof/prove.h"

enum { WIDTH = 16, HEIGHT = 16, REACH = 2048 * 256 };

/* The loop copies nothing but pairs. */
void *copy_pairs(void *to, const void *from, size_t bytes)
{
    stad_pair *out = to;
    const stad_pair *in = from;
    //@ assert bytes % sizeof(stad_pair) == 0;
    for (size_t i = 0; i < bytes / sizeof *out; i++)
        out[i] = in[i];
    return to;
}

/* -- the other modules ------------------------------------------------------------------------------------------- */

static stad_corner any_corner(void)
{
    const stad_corner c = {any(-REACH / 8, REACH + REACH / 8), any(-REACH / 8, REACH + REACH / 8)};
    return c;
}

/* Of parameters, which are below 2^15. */
int32_t stad_log2_q16(uint32_t v)
{
    return any(0, 15 << 16);
}

uint32_t stad_isqrt(uint64_t v)
{
    return (uint32_t)any64(0, UINT32_MAX);
}

size_t stad_mark_bytes(int32_t width, int32_t height)
{
    return STAD_MARK_BYTES(width, height);
}

void stad_mark_config_default(stad_mark_config *c)
{
    c->ids = 0xFFFFFFFFu;
    c->max_hamming = 2;
    c->min_contrast = 20;
}

int stad_mark_find(const stad_image *img, const stad_mark_config *config, stad_mark *out, int max, void *work, size_t work_bytes)
{
    uint8_t *first = work, *last = first + work_bytes - 1;
    //@ assert work_bytes >= 1;
    //@ assert \valid(first) && \valid(last);
    //@ assert \valid(out + (0 .. max - 1));
    return any(-8, max);
}

static void any_pairs(stad_pair *out, int n)
{
    for (int i = 0; i < n; i++) {
        out[i].id = (int16_t)any(-32768, 32767);
        for (int k = 0; k < 4; k++) {
            out[i].left[k] = any_corner();
            out[i].right[k] = any_corner();
        }
    }
}

int stad_mark_pair(const stad_mark *left, int left_count, const stad_mark *right, int right_count, stad_pair *out, int max)
{
    any_pairs(out, max);
    return any(0, max);
}

void stad_rig_identity(stad_rig *r, int width, int height)
{
    r->a_q16 = r->b_q24 = r->c_q24 = 0;
    r->width = (int16_t)width;
    r->height = (int16_t)height;
}

int stad_calib_views_fault(const stad_calib *c, stad_calib_view *view, const stad_image *left, const stad_image *right)
{
    return !left || !right ? STAD_FAULT_LATE : any(STAD_FAULT_NONE, STAD_FAULT_SAME);
}

int stad_calib_rig_verdict(const stad_rig *rig, const stad_pair *pairs, int count, stad_pair *room, stad_rig_report *report)
{
    //@ assert 0 <= count <= 40 && (count == 0 || \valid(room + (0 .. count - 1)));
    stad_rig fit;
    stad_rig_fit(&fit, report, pairs, count, WIDTH, HEIGHT);
    return report->verdict;
}

int stad_calib_is_another_pose(const stad_calib *c, const stad_pair *pairs, int count)
{
    return any(0, 1);
}

static int is_still;

int stad_calib_is_still(const stad_calib *c, const stad_pair *pairs, int count)
{
    return is_still;
}

int stad_rig_fit(stad_rig *r, stad_rig_report *report, const stad_pair *pairs, int n, int width, int height)
{
    //@ assert 0 <= n <= 40;
    const stad_rig fit = {any(-(1 << 30), 1 << 30), any(-(1 << 22), 1 << 22), any(-(1 << 22), 1 << 22), WIDTH, HEIGHT};
    *r = fit;
    report->rms_before_q8 = any(0, INT32_MAX);
    report->rms_after_q8 = any(0, INT32_MAX);
    report->worst_q8 = any(0, INT32_MAX);
    report->span_q8 = any(0, REACH * 2);
    report->corners = (int16_t)any(0, 160);
    report->verdict = (uint8_t)any(0, 3);
    report->advised = (uint8_t)any(0, 1);
    return any(0, 1) ? report->verdict : STAD_E_PARAM;
}

void stad_rig_straighten(const stad_rig *r, stad_pair *pairs, int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 4; k++) {
            pairs[i].right[k].x_q8 = any(-2 * REACH, 2 * REACH);
            pairs[i].right[k].y_q8 = any(-2 * REACH, 2 * REACH);
        }
}

int stad_truth_init(stad_truth *t, int width, int height, int min_disparity, int num_disparities, int margin)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int stad_truth_from_target(stad_truth *t, const stad_target *target, const stad_pair *pairs, int n, const stad_camera *camera)
{
    return any(-8, 14);
}

stad_box stad_truth_box(const stad_truth *t)
{
    const stad_box box = {(int16_t)any(0, WIDTH), (int16_t)any(0, HEIGHT), (int16_t)any(0, WIDTH), (int16_t)any(0, HEIGHT)};
    return box;
}

int stad_truth_crop(stad_truth *t, const stad_box *box)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int32_t stad_truth_pixels(const stad_truth *t)
{
    return any(0, 2048 * 2048);
}

static stad_point any_point(void)
{
    stad_point x;
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        x.v[i] = (int16_t)any(0, 32767);
    x.v[STAD_TUNE_UNIQUENESS_RATIO] = (int16_t)any(0, 99);
    return x;
}

void stad_tune_config_stereo(stad_tune_config *c, int purpose)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        c->axis[i].lo = (int16_t)any(0, 32767);
        c->axis[i].hi = (int16_t)any(0, 32767);
    }
}

int stad_tune_descent_init(stad_tune *t, const stad_tune_config *c, const stad_point *start)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int stad_tune_ask(const stad_tune *t, stad_point *x)
{
    *x = any_point();
    return any(0, 1);
}

int stad_tune_descent_tell(stad_tune *t, int32_t cost_q20)
{
    return any(0, 1) ? STAD_OK : STAD_E_STATE;
}

int stad_tune_best(const stad_tune *t, stad_point *x, int32_t *cost_q20)
{
    *x = any_point();
    *cost_q20 = any(0, INT32_MAX);
    return any(0, 1) ? STAD_OK : STAD_E_STATE;
}

void stad_monitor_defaults(stad_monitor_config *config)
{
    config->learn_frames = 30;
}

int stad_monitor_init(stad_monitor *m, const stad_monitor_config *config)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int stad_monitor_frame(stad_monitor *m, const stad_match_counts *counts)
{
    return any(-8, 2);
}

int stad_monitor_look_due(const stad_monitor *m)
{
    return any(0, 1);
}

void stad_monitor_looked(stad_monitor *m)
{
}

void stad_monitor_restart(stad_monitor *m)
{
}

void stad_monitor_remind(stad_monitor *m, int on)
{
}

int stad_geometry_check(const stad_geometry *g, const char **culprit)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int stad_params_check(const stad_params *p, int mode, int width, const char **culprit)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

int stad_setup_check(const stad_setup *s)
{
    return any(0, 1) ? STAD_OK : STAD_E_PARAM;
}

/* -- the caller -------------------------------------------------------------------------------------------------- */

static stad_calib c;
static union {
    uint8_t bytes[STAD_CALIB_FRAME_BYTES(WIDTH, HEIGHT)];
    struct {
        stad_mark left[16], right[16];
        stad_pair pairs[STAD_CALIB_PAIRS + 5 * STAD_CALIB_PAIRS];
    } scratch;
} work;
static uint8_t left_pix[WIDTH * HEIGHT], right_pix[WIDTH * HEIGHT];

static stad_setup any_setup(void)
{
    stad_setup s;
    s.width = (int16_t)any(-32768, 32767);
    s.height = (int16_t)any(-32768, 32767);
    s.mode = (uint8_t)any(0, 255);
    s.channels = (uint8_t)any(0, 255);
    s.origin = (uint8_t)any(0, 255);
    s.corrected = (uint8_t)any(0, 255);
    s.params.min_disparity = (int16_t)any(-2047, 2047);
    s.params.num_disparities = (int16_t)any(16, 4088);
    s.params.block_size = (int16_t)any(1, 255);
    s.params.p1 = (int16_t)any(0, 32767);
    s.params.p2 = (int16_t)any(0, 32767);
    s.params.disp12_max_diff = (int16_t)any(-32768, 32767);
    s.params.pre_filter_cap = (int16_t)any(0, 32767);
    s.params.uniqueness_ratio = (int16_t)any(0, 99);
    s.params.speckle_window_size = any(INT32_MIN, INT32_MAX);
    s.params.speckle_range = any(INT32_MIN, INT32_MAX);
    s.rig.a_q16 = any(-(64 << 16), 64 << 16);
    s.rig.b_q24 = any(-(1 << 20), 1 << 20);
    s.rig.c_q24 = any(-(1 << 20), 1 << 20);
    s.rig.width = s.width;
    s.rig.height = s.height;
    return s;
}

/* Any config; then those alone whose numbers init lets pass: the analysis learns nothing from a function that compares. */
static int begin(void)
{
    const stad_geometry g = {WIDTH, HEIGHT, 1, 16, 11, 8192, 127, 0, 0};
    stad_calib_config config;
    const stad_camera camera = {any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX)};
    const stad_setup setup = any_setup();
    stad_calib_config_default(&config, &g, stad_target_relief(), &camera);
    config.ids = (uint32_t)any64(0, UINT32_MAX);
    config.margin_px = (int16_t)any(-32768, 32767);
    config.pose_px = (int16_t)any(-32768, 32767);
    config.patience = (int16_t)any(-32768, 32767);
    config.probation_frames = (int16_t)any(-32768, 32767);
    config.budget = (int16_t)any(-32768, 32767);
    config.min_block_size = (int16_t)any(-32768, 32767);
    config.threshold_q16 = any(INT32_MIN, INT32_MAX);
    config.penalty_q16 = any(INT32_MIN, INT32_MAX);
    config.gain_q20 = any(INT32_MIN, INT32_MAX);
    config.cost = (uint8_t)any(0, 255);
    config.rule = (uint8_t)any(0, 255);
    config.preset_mask = (uint8_t)any(0, 255);
    config.tunes = (uint8_t)any(0, 255);
    config.still = (uint8_t)any(0, 255);
    stad_calib_init(&c, &config, &setup);
    config.margin_px = (int16_t)any(0, 16);
    config.pose_px = (int16_t)any(0, 1000);
    config.patience = (int16_t)any(1, 32767);
    config.probation_frames = (int16_t)any(0, 32767);
    config.budget = (int16_t)any(4, STAD_TUNE_LOG);
    config.min_block_size = (int16_t)any(1, 11);
    config.threshold_q16 = any(0, INT32_MAX);
    config.penalty_q16 = any(0, 65536);
    config.gain_q20 = any(0, STAD_COST_ONE);
    config.cost = (uint8_t)any(STAD_SCORE_BAD, STAD_SCORE_CHOW);
    config.rule = (uint8_t)any(STAD_RULE_DEFAULT, STAD_RULE_NONE);
    return stad_calib_init(&c, &config, &setup) == STAD_OK;
}

/* -- invariants -------------------------------------------------------------------------------------------------- */

enum { MOST_EVALUATIONS = STAD_TUNE_LOG + 11 };

static const int16_t last_step[] = {0, 0, 0, 1, STAD_PRESETS, 0, 2, 1, 0, 0, 1};

static void any_state(int phase, int still)
{
    c.report.phase = (uint8_t)phase;
    c.report.outcome = (uint8_t)any(STAD_CALIB_NONE, STAD_CALIB_CANCELLED);
    c.report.fault = (uint8_t)any(STAD_FAULT_NONE, STAD_FAULT_MATCH);
    c.report.alarmed = (uint8_t)any(0, 1);
    c.report.verdict_before = (uint8_t)any(0, 3);
    c.report.preset = (int8_t)any(-1, STAD_PRESETS - 1);
    c.report.evaluations = (int16_t)any(0, MOST_EVALUATIONS);
    c.report.rig.advised = (uint8_t)any(0, 1);
    c.report.tune_before_q20 = any(-1, INT32_MAX);
    c.active = any_setup();
    c.previous = any_setup();
    c.candidate = any_setup();
    c.pose[0].count = any(0, STAD_CALIB_PAIRS);
    c.pose[1].count = any(0, STAD_CALIB_PAIRS);
    any_pairs(c.pose[0].pairs, STAD_CALIB_PAIRS);
    any_pairs(c.pose[1].pairs, STAD_CALIB_PAIRS);
    any_pairs(c.pool, STAD_CALIB_POOL + STAD_CALIB_PAIRS);
    c.pick = any_point();
    c.tuned = any_point();
    c.pick_q20 = any(-1, INT32_MAX);
    c.tuned_q20 = any(-1, INT32_MAX);
    c.pick_score_q20 = any(-1, INT32_MAX);
    for (int i = 0; i < 3; i++)
        c.judged_q20[i] = any(-1, INT32_MAX);
    c.compared_q20 = any(0, INT32_MAX);
    c.step = (int16_t)any(0, last_step[phase]);
    c.vain = (int16_t)any(-1, 32766);
    c.pooled = (int16_t)any(0, STAD_CALIB_POOL - 1);
    c.still = (int16_t)still;
    c.trial_frames = (int16_t)any(0, 32766);
    c.scheduled = (uint8_t)any(0, 1);
    c.alarmed_on_trial = (uint8_t)any(0, 1);
    c.alarm_stands = (uint8_t)any(0, 1);
}

/* Of JUDGE and COMPARE, whose steps are the fewest, by the phase before: from PICK alone a judgement begins that has had more steps,
 * and stad_calib_enter() clears them. */
static void holds(int before)
{
    const int most = before == STAD_CALIB_PICK ? STAD_PRESETS : before == STAD_CALIB_JUDGE || before == STAD_CALIB_TUNE ? 2 : 1;
    //@ assert c.report.phase <= STAD_CALIB_COMPARE;
    //@ assert 0 <= c.step <= most;
    //@ assert -1 <= c.vain <= 32766;
    //@ assert 0 <= c.pooled < STAD_CALIB_POOL;
    //@ assert 0 <= c.still <= 3;
    //@ assert 0 <= c.trial_frames <= 32766;
    //@ assert 0 <= c.pose[0].count <= STAD_CALIB_PAIRS && 0 <= c.pose[1].count <= STAD_CALIB_PAIRS;
    //@ assert -1 <= c.report.preset < STAD_PRESETS;
}

static void one_call(int call)
{
    const stad_match_counts counts = {any(INT32_MIN, INT32_MAX), any(INT32_MIN, INT32_MAX), 0, 0, 0, 0};
    const stad_image left = stad_image_packed(left_pix, WIDTH, HEIGHT, 1), right = stad_image_packed(right_pix, WIDTH, HEIGHT, 1);
    stad_request request;
    switch (call) {
    case 0:
        stad_calib_counts(&c, &counts);
        break;
    case 1:
        stad_calib_start(&c);
        break;
    case 2:
        stad_calib_cancel(&c);
        break;
    case 3:
        stad_calib_want(&c, &request);
        break;
    case 4:
        stad_calib_frame(&c, any(0, 1) ? &left : 0, any(0, 1) ? &right : 0, &work, sizeof work);
        break;
    case 5:
        stad_calib_cost(&c, any(INT32_MIN, INT32_MAX));
        break;
    default:
        stad_calib_saved(&c, any(-8, 8));
        break;
    }
}

int main(void)
{
    any_pairs(work.scratch.pairs, 6 * STAD_CALIB_PAIRS);
    if (!begin())
        return 1;
    //@ loop unroll 11;
    for (int phase = STAD_CALIB_IDLE; phase <= STAD_CALIB_COMPARE; phase++)
        //@ loop unroll 7;
        for (int call = 0; call < 7; call++) {
            if (phase == STAD_CALIB_CONFIRM && call == 4)
                continue;
            any_state(phase, any(0, 3));
            is_still = any(0, 1);
            one_call(call);
            holds(phase);
        }
    //@ loop unroll 16;
    for (int i = 0; i < 16; i++) { /* frames that confirm, by what each does to the pool */
        any_state(STAD_CALIB_CONFIRM, i % 4);
        is_still = i / 4 % 2;
        c.pooled = (int16_t)(i / 8 ? any(1, STAD_CALIB_POOL - 1) : 0);
        one_call(4);
        holds(STAD_CALIB_CONFIRM);
    }
    return 0;
}
