/* SPDX-License-Identifier: MIT
 * monitor -> [CALIB] -> store        calib/calib.c - the pump: what is wanted next, and how runs begin and end
 *
 *   IDLE -> LOOK -> OTHER -> (CONFIRM) -> PICK -> JUDGE -> TUNE -> JUDGE -> SAVE -> PROBATION -> RECHECK -> COMPARE -> IDLE
 *
 * collect.c moves the phases that take frames, trial.c those that take costs. Every phase ends after a bounded number
 * of calls: frames by patience, costs by the budget. */
#include "stad/calib.h"
#include "calib/calib_parts.h"

#include <string.h>

#include "base/bytes.h"
#include "base/arith.h"
#include "truth/target_use.h"

void stad_calib_config_default(stad_calib_config *c, const stad_geometry *geometry, const stad_target *target,
                               const stad_camera *camera)
{
    memset(c, 0, sizeof *c);
    c->geometry = *geometry;
    c->target = target;
    c->camera = *camera;
    stad_monitor_defaults(&c->monitor);
    c->ids = stad_target_ids(target);
    c->margin_px = 1;
    c->pose_px = 6;
    c->patience = 60;
    c->probation_frames = 64;
    c->budget = 70;
    c->min_block_size = 3;
    c->threshold_q16 = 65536;
    c->penalty_q16 = 655;
    c->gain_q20 = 2 * STAD_COST_ONE / 100;
    c->cost = STAD_SCORE_BAD;
    c->rule = STAD_RULE_DEFAULT;
    c->preset_mask = (1u << STAD_PRESETS) - 1u;
    c->tunes = 1;
}

static int in(int32_t v, int32_t low, int32_t high)
{
    return v >= low && v <= high;
}

/* Frames in which marks can be looked for, a target that can be used, and a pair of its marks to find. */
static int marks_fit(const stad_calib_config *c)
{
    if (stad_geometry_check(&c->geometry, NULL) != STAD_OK || !stad_calib_frame_bytes(c->geometry.width, c->geometry.height))
        return 0;
    if (!c->target || !stad_target_fits(c->target, &c->camera))
        return 0;
    const uint32_t ids = stad_target_ids(c->target) & c->ids;
    return (ids & (ids - 1u)) != 0;
}

static int config_fits(const stad_calib_config *c)
{
    if (!marks_fit(c))
        return 0;
    if (!in(c->margin_px, 0, 16) || !in(c->pose_px, 0, 1000) || !in(c->patience, 1, INT16_MAX))
        return 0;
    if (!in(c->probation_frames, 0, INT16_MAX) || !in(c->budget, 4, STAD_TUNE_LOG))
        return 0;
    if (!in(c->min_block_size, 1, c->geometry.max_block_size) || c->min_block_size % 2 == 0)
        return 0;
    if (c->threshold_q16 < 0 || !in(c->penalty_q16, 0, 65536) || !in(c->gain_q20, 0, STAD_COST_ONE))
        return 0;
    return c->cost <= STAD_SCORE_CHOW && c->rule <= STAD_RULE_NONE;
}

static int setup_fits(const stad_calib_config *c, const stad_setup *s)
{
    const stad_geometry *g = &c->geometry;
    if (stad_setup_check(s) != STAD_OK || !stad_calib_fits(g, &s->params))
        return 0;
    return s->width == g->width && s->height == g->height && s->mode == g->mode && s->channels == g->channels;
}

/* -- beginning and ending ---------------------------------------------------------------------------------------- */

void stad_calib_enter(stad_calib *c, int phase)
{
    STAD_ASSERT(phase >= STAD_CALIB_IDLE && phase <= STAD_CALIB_COMPARE);
    c->report.phase = (uint8_t)phase;
    c->step = 0;
    c->vain = 0;
    c->trial_frames = 0;
}

void stad_calib_finish(stad_calib *c, int outcome)
{
    int well = outcome == STAD_CALIB_ADOPTED || outcome == STAD_CALIB_CORRECTED || outcome == STAD_CALIB_KEPT;
    int rig_moved = outcome == STAD_CALIB_RIG_FAILED || (outcome == STAD_CALIB_ROLLED_BACK && c->report.fault == STAD_FAULT_RIG);
    int one_look = c->scheduled && c->report.phase == STAD_CALIB_LOOK; /* a single frame proves nothing */
    stad_calib_enter(c, STAD_CALIB_IDLE);
    c->report.outcome = (uint8_t)outcome;
    if (well && !c->alarm_stands)
        c->report.alarmed = 0;
    if (rig_moved && !one_look)
        c->report.alarmed = 1;
    if (well || rig_moved)
        stad_monitor_remind(&c->monitor, c->report.alarmed);
    stad_monitor_looked(&c->monitor);
}

/* A run, none of whose costs is measured yet. */
static void begin(stad_calib *c, int scheduled)
{
    stad_calib_report *r = &c->report;
    uint8_t alarmed = r->alarmed;
    memset(r, 0, sizeof *r);
    r->alarmed = alarmed;
    r->preset = -1;
    r->tune_before_q20 = r->tune_after_q20 = -1;
    r->judge_before_q20 = r->judge_after_q20 = -1;
    c->candidate = c->active;
    c->alarm_stands = 0;
    c->scheduled = (uint8_t)scheduled;
    stad_calib_enter(c, STAD_CALIB_LOOK);
}

int stad_calib_init(stad_calib *c, const stad_calib_config *config, const stad_setup *setup)
{
    STAD_ASSERT(c && config && setup);
    if (!config_fits(config) || !setup_fits(config, setup) || stad_monitor_init(&c->monitor, &config->monitor) != STAD_OK)
        return STAD_E_PARAM;
    memset(c, 0, sizeof *c);
    stad_monitor_init(&c->monitor, &config->monitor);
    c->config = *config;
    c->active = *setup;
    begin(c, 0); /* and not gone on with: the report of no run */
    stad_calib_enter(c, STAD_CALIB_IDLE);
    return STAD_OK;
}

int stad_calib_start(stad_calib *c)
{
    if (c->report.phase != STAD_CALIB_IDLE)
        return STAD_E_STATE;
    begin(c, 0);
    return STAD_OK;
}

/* Up to the decision nothing has changed; after it the set in use has been judged already. */
void stad_calib_cancel(stad_calib *c)
{
    if (c->report.phase != STAD_CALIB_IDLE)
        stad_calib_finish(c, STAD_CALIB_CANCELLED);
}

/* How a run ends that lasts: by what differs from the set before it. */
static int change_outcome(const stad_calib *c)
{
    if (!bytes_equal(&c->active.params, &c->previous.params, sizeof c->active.params))
        return STAD_CALIB_ADOPTED;
    return bytes_equal(&c->active.rig, &c->previous.rig, sizeof c->active.rig) ? STAD_CALIB_KEPT : STAD_CALIB_CORRECTED;
}

void stad_calib_adopt(stad_calib *c)
{
    c->previous = c->active;
    c->active = c->candidate;
    if (change_outcome(c) == STAD_CALIB_KEPT) {
        c->active = c->previous;
        stad_calib_finish(c, STAD_CALIB_KEPT);
        return;
    }
    stad_monitor_restart(&c->monitor);
    c->report.outcome = STAD_CALIB_NONE;
    stad_calib_enter(c, STAD_CALIB_SAVE);
}

void stad_calib_roll_back(stad_calib *c)
{
    c->active = c->previous;
    stad_monitor_restart(&c->monitor);
    c->report.outcome = STAD_CALIB_ROLLED_BACK;
    stad_calib_enter(c, STAD_CALIB_SAVE);
}

int stad_calib_saved(stad_calib *c, int status)
{
    if (c->report.phase != STAD_CALIB_SAVE)
        return STAD_E_STATE;
    c->report.save_status = (int8_t)(status < 0 ? status : 0);
    if (status < 0 && c->step == 0) {
        c->step = 1;
        return STAD_OK;
    }
    if (c->report.outcome == STAD_CALIB_ROLLED_BACK)
        stad_calib_finish(c, STAD_CALIB_ROLLED_BACK);
    else if (change_outcome(c) == STAD_CALIB_CORRECTED || c->config.probation_frames == 0)
        stad_calib_finish(c, change_outcome(c));
    else {
        c->alarmed_on_trial = 0;
        stad_calib_enter(c, STAD_CALIB_PROBATION);
    }
    return STAD_OK;
}

/* -- live frames ------------------------------------------------------------------------------------------------- */

static void probation_frame(stad_calib *c, int state)
{
    c->trial_frames++;
    c->alarmed_on_trial = state == STAD_MONITOR_DEGRADED;
    if (c->alarmed_on_trial || c->trial_frames >= c->config.probation_frames)
        stad_calib_enter(c, STAD_CALIB_RECHECK);
}

/* What happens from here on to SAVE is seen in no frame of the run: an alarm is not answered by its end. */
static int took_its_last_frame(int phase)
{
    return phase == STAD_CALIB_PICK || phase == STAD_CALIB_TUNE || phase == STAD_CALIB_JUDGE;
}

int stad_calib_counts(stad_calib *c, const stad_match_counts *counts)
{
    int state = stad_monitor_frame(&c->monitor, counts);
    if (state == STAD_MONITOR_DEGRADED) {
        c->report.alarmed = 1;
        c->alarm_stands = (uint8_t)took_its_last_frame(c->report.phase);
    }
    if (c->report.phase == STAD_CALIB_PROBATION) {
        probation_frame(c, state);
    } else if (c->report.phase == STAD_CALIB_IDLE && state == STAD_MONITOR_DEGRADED) {
        begin(c, 0);
    } else if (c->report.phase == STAD_CALIB_IDLE && stad_monitor_look_due(&c->monitor)) {
        stad_monitor_looked(&c->monitor);
        begin(c, 1);
    }
    return state;
}

/* -- asking ------------------------------------------------------------------------------------------------------ */

static void want_match(const stad_calib *c, stad_request *r)
{
    stad_point point;
    stad_calib_trial_point(c, &point);
    r->hold = (uint8_t)stad_calib_trial_hold(c);
    r->box = c->pose[r->hold].box;
    r->params = stad_calib_params_at(&c->active.params, &point);
    r->rig = c->report.phase == STAD_CALIB_COMPARE ? c->active.rig : c->candidate.rig;
}

int stad_calib_want(const stad_calib *c, stad_request *r)
{
    STAD_ASSERT(c && r && c->config.target); /* initialised */
    memset(r, 0, sizeof *r);
    switch (c->report.phase) {
    case STAD_CALIB_LOOK:
    case STAD_CALIB_CONFIRM:
    case STAD_CALIB_RECHECK:
        r->want = STAD_WANT_FRAME;
        break;
    case STAD_CALIB_OTHER:
        r->want = STAD_WANT_FRAME;
        r->hold = 1;
        break;
    case STAD_CALIB_PICK:
    case STAD_CALIB_JUDGE:
    case STAD_CALIB_TUNE:
    case STAD_CALIB_COMPARE:
        r->want = STAD_WANT_MATCH;
        want_match(c, r);
        break;
    case STAD_CALIB_SAVE:
        r->want = STAD_WANT_SAVE;
        break;
    default:
        break;
    }
    return r->want;
}

int stad_calib_cost(stad_calib *c, int32_t cost_q20)
{
    stad_request r;
    if (stad_calib_want(c, &r) != STAD_WANT_MATCH)
        return STAD_E_STATE;
    if (cost_q20 < 0)
        return STAD_E_PARAM;
    stad_calib_trial_cost(c, cost_q20);
    return STAD_OK;
}

const stad_setup *stad_calib_setup(const stad_calib *c)
{
    return &c->active;
}

const stad_calib_report *stad_calib_report_of(const stad_calib *c)
{
    return &c->report;
}
