/* SPDX-License-Identifier: MIT
 * frames -> marks -> rig -> [COLLECT] -> truth -> trial        calib/collect.c - what a raw frame is good for, by
 * phase
 *
 * Pairs are kept as found in the raw frames: a correction is always fitted on raw corners, and truth always made from
 * straightened ones. */
#include "calib/calib_parts.h"

#include <string.h>

#include "base/bytes.h"
#include "base/arith.h"

#define MARKS 16
#define LAG   2 /* frames by which one view may be later than the other, unseen */

/* What a frame's marks need while they are looked at; lies at the front of the caller's workspace. */
typedef struct scratch {
    stad_mark left[MARKS], right[MARKS];
    stad_pair pairs[STAD_CALIB_PAIRS];    /* of this frame */
    stad_pair room[5 * STAD_CALIB_PAIRS]; /* for copies to straighten or string together */
    int32_t count;
} scratch;

typedef char scratch_fits[sizeof(scratch) <= STAD_CALIB_SCRATCH && STAD_CALIB_SCRATCH % STAD_ALIGN == 0 ? 1 : -1];

size_t stad_calib_frame_bytes(int32_t width, int32_t height)
{
    size_t marks = stad_mark_bytes(width, height);
    return marks > 0 ? marks + STAD_CALIB_SCRATCH : 0;
}

/* -- seeing: from pixels to pairs -------------------------------------------------------------------------------- */

/* Marks lie in front of both cameras: behind where even a search that begins below 0 looks, the views are exchanged. */
static int pairs_are_swapped(const stad_pair *pairs, int count, int min_disparity)
{
    int behind = 0;
    for (int i = 0; i < count; i++)
        behind += pairs[i].left[0].x_q8 - pairs[i].right[0].x_q8 < 256 * (min_i32(min_disparity, 0) - 1);
    return 2 * behind > count;
}

static int find_pairs(stad_calib *c, const stad_image *left, const stad_image *right, scratch *s, size_t work_bytes)
{
    uint8_t *work = (uint8_t *)s + STAD_CALIB_SCRATCH;
    size_t bytes = work_bytes - STAD_CALIB_SCRATCH;
    stad_mark_config config;
    stad_mark_config_default(&config);
    config.ids = c->config.ids;
    int nl = stad_mark_find(left, &config, s->left, MARKS, work, bytes);
    int nr = stad_mark_find(right, &config, s->right, MARKS, work, bytes);
    if (nl < 0 || nr < 0)
        return STAD_FAULT_SIZE;
    s->count = stad_mark_pair(s->left, nl, s->right, nr, s->pairs, STAD_CALIB_PAIRS);
    if (s->count < 2)
        return STAD_FAULT_MARKS;
    if (pairs_are_swapped(s->pairs, s->count, c->active.params.min_disparity))
        return STAD_FAULT_SWAPPED;
    return STAD_FAULT_NONE;
}

static int see(stad_calib *c, const stad_image *left, const stad_image *right, scratch *s, size_t work_bytes)
{
    int fault = stad_calib_views_fault(c, c->view, left, right);
    return fault != STAD_FAULT_NONE ? fault : find_pairs(c, left, right, s, work_bytes);
}

/* -- the rig ----------------------------------------------------------------------------------------------------- */

static void set_rig(stad_calib *c, const stad_rig *rig)
{
    c->candidate.rig = *rig;
    c->candidate.corrected = rig->a_q16 != 0 || rig->b_q24 != 0 || rig->c_q24 != 0;
}

/* A sound rig is left alone; else the candidate gets what a fit on the raw pairs of the frames so far advises. */
static int choose_correction(stad_calib *c, const stad_pair *pairs, int count)
{
    stad_rig rig;
    const stad_geometry *g = &c->config.geometry;
    c->candidate.rig = c->active.rig;
    c->candidate.corrected = c->active.corrected;
    if (c->report.verdict_before == STAD_RIG_GOOD)
        return STAD_FAULT_NONE;
    int verdict = stad_rig_fit(&rig, &c->report.rig, pairs, count, g->width, g->height);
    if (verdict < 0 || verdict == STAD_RIG_FAIL)
        return STAD_FAULT_RIG;
    int better_none = !c->report.rig.advised && c->report.verdict_before > STAD_RIG_WATCH;
    if (verdict == STAD_RIG_GOOD || better_none)
        stad_rig_identity(&rig, g->width, g->height);
    if (verdict == STAD_RIG_GOOD || better_none || c->report.rig.advised)
        set_rig(c, &rig);
    return STAD_FAULT_NONE;
}

/* The rows of a single frame still agree. WATCH is let pass: blur and noise of one frame bring that about. */
static int rig_holds(const stad_rig *rig, const stad_pair *pairs, int count, stad_pair *room)
{
    stad_rig_report rest;
    return stad_calib_rig_verdict(rig, pairs, count, room, &rest) <= STAD_RIG_WATCH;
}

static int rig_is_new(const stad_calib *c)
{
    return !bytes_equal(&c->candidate.rig, &c->active.rig, sizeof c->active.rig);
}

/* -- truth ------------------------------------------------------------------------------------------------------- */

/* Marks beyond what the matcher searches, the corners of every pair. */
static int out_of_range(const stad_params *p, const stad_pair *pairs, int count)
{
    int32_t low = 256 * p->min_disparity, high = 256 * (p->min_disparity + p->num_disparities - 1);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 4; k++) {
            int32_t d = pairs[i].left[k].x_q8 - pairs[i].right[k].x_q8;
            if (d < low || d > high)
                return 1;
        }
    return 0;
}

static int make_truth(const stad_calib *c, stad_calib_pose *pose, const stad_rig *rig, stad_pair *straight)
{
    const stad_params *p = &c->active.params;
    const stad_geometry *g = &c->config.geometry;
    memcpy(straight, pose->pairs, (size_t)pose->count * sizeof *straight);
    stad_rig_straighten(rig, straight, pose->count);
    if (out_of_range(p, straight, pose->count))
        return STAD_FAULT_RANGE;
    if (stad_truth_init(&pose->truth, g->width, g->height, p->min_disparity, p->num_disparities, c->config.margin_px) != STAD_OK)
        return STAD_FAULT_MARKS;
    int status = stad_truth_from_target(&pose->truth, c->config.target, straight, pose->count, &c->config.camera);
    if (status < 0)
        return status == STAD_E_RIG ? STAD_FAULT_CAMERA : STAD_FAULT_MARKS;
    pose->box = stad_truth_box(&pose->truth);
    if (pose->box.width <= 0 || stad_truth_crop(&pose->truth, &pose->box) != STAD_OK)
        return STAD_FAULT_MARKS;
    return STAD_FAULT_NONE;
}

static int keep_pose(stad_calib *c, const stad_rig *rig, scratch *s)
{
    stad_calib_pose *pose = &c->pose[0];
    memcpy(pose->pairs, s->pairs, (size_t)s->count * sizeof *s->pairs);
    pose->count = s->count;
    return make_truth(c, pose, rig, s->room);
}

/* -- the phases -------------------------------------------------------------------------------------------------- */

static int look(stad_calib *c, scratch *s)
{
    stad_rig_report rest;
    c->report.verdict_before = (uint8_t)stad_calib_rig_verdict(&c->active.rig, s->pairs, s->count, s->room, &rest);
    c->report.verdict_after = c->report.verdict_before;
    c->report.rig = rest;
    if (c->report.verdict_before == STAD_RIG_GOOD && c->scheduled && !c->report.alarmed) {
        if (out_of_range(&c->active.params, s->room, s->count)) /* straightened for the verdict */
            return STAD_FAULT_RANGE;
        stad_calib_finish(c, STAD_CALIB_SOUND);
        return STAD_FAULT_NONE;
    }
    int fault = choose_correction(c, s->pairs, s->count);
    if (fault == STAD_FAULT_NONE)
        fault = keep_pose(c, &c->candidate.rig, s);
    c->pose[1].count = 0;
    c->pooled = 0;
    if (fault == STAD_FAULT_NONE)
        stad_calib_enter(c, STAD_CALIB_OTHER);
    return fault;
}

static int string_up(stad_pair *out, int n, const stad_pair *more, int count)
{
    memcpy(out + n, more, (size_t)count * sizeof *out);
    return n + count;
}

/* The correction from the corners of both poses and the pool of fresh frames, and the truths with it. */
static int refit(stad_calib *c, scratch *s)
{
    int n = string_up(s->room, 0, c->pool, c->pooled);
    n = string_up(s->room, n, c->pose[0].pairs, c->pose[0].count);
    n = string_up(s->room, n, c->pose[1].pairs, c->pose[1].count);
    int fault = choose_correction(c, s->room, n);
    for (int i = 0; i < 2 && fault == STAD_FAULT_NONE; i++)
        if (c->pose[i].count > 0)
            fault = make_truth(c, &c->pose[i], &c->candidate.rig, s->room);
    return fault;
}

static int other(stad_calib *c, scratch *s)
{
    memcpy(c->pose[1].pairs, s->pairs, (size_t)s->count * sizeof *s->pairs);
    c->pose[1].count = s->count;
    int fault = refit(c, s);
    if (fault != STAD_FAULT_NONE) {
        c->pose[1].count = 0;
        return fault;
    }
    if (rig_is_new(c))
        stad_calib_enter(c, STAD_CALIB_CONFIRM);
    else
        stad_calib_trial_begin(c);
    return fault;
}

static int rig_fails(stad_calib *c)
{
    stad_calib_finish(c, STAD_CALIB_RIG_FAILED);
    return STAD_FAULT_RIG;
}

/* The corners of the fresh frames agree, by the verdict, with the correction. If those of the held frames do not, the
 * rig moved since they were taken. */
static int confirmed(stad_calib *c, int verdict, stad_pair *room)
{
    for (int i = 0; i < 2 && c->pose[1].count > 0; i++)
        if (!rig_holds(&c->candidate.rig, c->pose[i].pairs, c->pose[i].count, room))
            return rig_fails(c);
    c->report.verdict_after = (uint8_t)verdict;
    if (c->pose[1].count > 0) {
        stad_calib_trial_begin(c);
        return STAD_FAULT_NONE;
    }
    c->candidate.params = c->active.params; /* no other pose to judge parameters by */
    stad_calib_adopt(c);
    return STAD_FAULT_NONE;
}

/* Pools a fresh frame if the target was still in it and the two before. A view that comes late shows a moving target
 * in rows that do not agree, in every frame alike; a still one it shows as it is. */
static int pool(stad_calib *c, const scratch *s)
{
    int known = c->pooled > 0, still = known && stad_calib_is_still(c, s->pairs, s->count);
    c->still = (int16_t)(still ? min_i32(c->still + 1, LAG + 1) : 0);
    if (c->still <= LAG)
        c->pooled = 0;
    c->pooled = (int16_t)string_up(c->pool, c->pooled, s->pairs, s->count);
    if (c->still >= LAG)
        c->vain = -1; /* this frame is of use */
    return known && !still ? STAD_FAULT_MOVING : STAD_FAULT_NONE;
}

/* Fresh frames are pooled until they are as many as the noise of corners asks for. Not GOOD at first: fit once more
 * with them, and ask fresh ones again. */
static int confirm(stad_calib *c, scratch *s)
{
    stad_rig_report rest;
    int moving = pool(c, s);
    if (moving != STAD_FAULT_NONE || c->still < LAG || c->pooled < STAD_CALIB_POOL)
        return moving;
    int verdict = stad_calib_rig_verdict(&c->candidate.rig, c->pool, c->pooled, s->room, &rest);
    int fault = STAD_FAULT_NONE;
    if (verdict == STAD_RIG_GOOD || (c->step > 0 && verdict == STAD_RIG_WATCH && verdict < c->report.verdict_before))
        fault = confirmed(c, verdict, s->room);
    else if (c->step == 0)
        fault = refit(c, s);
    else
        fault = rig_fails(c);
    c->step = c->report.phase == STAD_CALIB_CONFIRM ? 1 : c->step;
    c->pooled = 0;
    return fault;
}

static int recheck(stad_calib *c, scratch *s)
{
    stad_rig_report now, was;
    int with_new = stad_calib_rig_verdict(&c->active.rig, s->pairs, s->count, s->room, &now);
    int with_old = stad_calib_rig_verdict(&c->previous.rig, s->pairs, s->count, s->room, &was);
    if (with_new > with_old) {
        stad_calib_roll_back(c);
        return STAD_FAULT_RIG;
    }
    if (with_new > STAD_RIG_WATCH)
        return STAD_FAULT_RIG;
    int fault = keep_pose(c, &c->active.rig, s);
    if (fault == STAD_FAULT_NONE) {
        c->alarm_stands = 0; /* whatever raised it, the rig is sound */
        stad_calib_enter(c, STAD_CALIB_COMPARE);
    }
    return fault;
}

/* 1: hold the frame; 0: not; the fault in *fault. */
static int use(stad_calib *c, scratch *s, int *fault)
{
    switch (c->report.phase) {
    case STAD_CALIB_LOOK:
        *fault = look(c, s);
        return *fault == STAD_FAULT_NONE && c->report.phase == STAD_CALIB_OTHER;
    case STAD_CALIB_OTHER:
        if (!rig_is_new(c) && !rig_holds(&c->active.rig, s->pairs, s->count, s->room)) {
            *fault = STAD_FAULT_RIG;
            return 0;
        }
        if (!stad_calib_is_another_pose(c, s->pairs, s->count))
            return 0;
        *fault = other(c, s);
        return *fault == STAD_FAULT_NONE;
    case STAD_CALIB_CONFIRM:
        *fault = confirm(c, s);
        return 0;
    default:
        *fault = recheck(c, s);
        return *fault == STAD_FAULT_NONE && c->report.phase == STAD_CALIB_COMPARE;
    }
}

static int give_up_outcome(const stad_calib *c)
{
    switch (c->report.fault) {
    case STAD_FAULT_MARKS:
    case STAD_FAULT_RANGE:
        return STAD_CALIB_NO_MARKS;
    case STAD_FAULT_RIG:
        return STAD_CALIB_RIG_FAILED;
    default:
        return STAD_CALIB_FAULT;
    }
}

void stad_calib_give_up(stad_calib *c)
{
    int phase = c->report.phase;
    if (phase == STAD_CALIB_OTHER && rig_is_new(c)) {
        stad_calib_enter(c, STAD_CALIB_CONFIRM);
    } else if (phase == STAD_CALIB_OTHER) {
        stad_calib_finish(c, c->report.fault == STAD_FAULT_RIG ? STAD_CALIB_RIG_FAILED : STAD_CALIB_NO_POSE);
    } else if (phase == STAD_CALIB_CONFIRM) {
        stad_calib_finish(c, STAD_CALIB_RIG_FAILED);
    } else if (phase >= STAD_CALIB_RECHECK && (c->alarmed_on_trial || c->report.fault == STAD_FAULT_RIG)) {
        stad_calib_roll_back(c);
    } else if (phase == STAD_CALIB_RECHECK) {
        stad_calib_finish(c, STAD_CALIB_ADOPTED);
    } else {
        stad_calib_finish(c, give_up_outcome(c));
    }
}

/* What a frame with that fault is answered: enum stad_calib_fault, from NONE to SAME. */
static const int8_t status_of[] = {
    STAD_OK,        STAD_AGAIN,     STAD_E_CORRUPT, STAD_E_CORRUPT, STAD_E_CORRUPT, STAD_E_CORRUPT, STAD_E_CORRUPT,
    STAD_E_NO_MARK, STAD_E_NO_MARK, STAD_E_RIG,     STAD_E_SIZE,    STAD_E_RIG,     STAD_AGAIN,     STAD_E_CORRUPT,
};

int stad_calib_frame(stad_calib *c, const stad_image *left, const stad_image *right, void *work, size_t work_bytes)
{
    STAD_ASSERT(c && c->config.target);
    stad_request wanted;
    size_t need = stad_calib_frame_bytes(c->config.geometry.width, c->config.geometry.height);
    if (stad_calib_want(c, &wanted) != STAD_WANT_FRAME)
        return STAD_E_STATE;
    if (!work || work_bytes < need || (uintptr_t)work % STAD_ALIGN != 0)
        return STAD_E_SIZE;
    scratch *s = (scratch *)work;
    int phase = c->report.phase, held = 0;
    int fault = see(c, left, right, s, work_bytes);
    if (fault == STAD_FAULT_NONE)
        held = use(c, s, &fault);
    c->report.fault = (uint8_t)fault;
    if (c->report.phase == phase) { /* no step forward: one frame of patience */
        c->vain++;
        if (c->vain >= (c->scheduled && phase == STAD_CALIB_LOOK ? 1 : c->config.patience))
            stad_calib_give_up(c);
    }
    return fault == STAD_FAULT_NONE ? held : status_of[fault];
}
