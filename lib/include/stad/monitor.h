/* SPDX-License-Identifier: MIT
 * stad/monitor.h - has the depth map got worse? Two counters a frame, a few words of state.
 *
 * The statistic is the share of considered pixels whose best cost beats every rival by 25 percent ("firm"): the
 * selection kernel counts it anyway (stad_match_counts). A one-sided CUSUM watches it fall. Density, left-right
 * failures and texture were tried in its place: weaker, or alarmed falsely.
 *
 * What no match statistic can see: a small row offset, a small roll, a constant shift in x. Hence the second half:
 * every mark_every-th frame stad_monitor_look_due() says that marks should be looked for, whatever the statistic
 * says.
 *
 * DEGRADED asks for a recalibration and does nothing else. Source: docs/LOOP.md, "Trigger". */
#ifndef STAD_MONITOR_H
#define STAD_MONITOR_H

#include <stdint.h>

#include "stad/match.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What stad_monitor_frame() answers. */
enum stad_monitor_state {
    STAD_MONITOR_LEARNING = 0, /* not enough frames yet to know what is usual */
    STAD_MONITOR_OK = 1,
    STAD_MONITOR_DEGRADED = 2 /* this frame raised the alarm; the next answers are OK until the cool-down is over */
};

/* How soon it alarms. Start from stad_monitor_defaults(). */
typedef struct stad_monitor_config {
    int16_t learn_frames;    /* 2..1000: frames that teach mean and deviation; default 30 */
    int16_t cooldown_frames; /* 0..32767: frames after an alarm without another; default 64 */
    int16_t slack_q8;        /* > 0: deviations a frame that are forgiven (k); default 2.0 */
    int16_t threshold_q8;    /* > 0: sum of deviations that alarms (h); default 8.0 */
    int16_t clip_q8;         /* > 0: largest deviation one frame can contribute; default 8.0 */
    int16_t follow_shift;    /* 1..15: the mean follows by 1 / 2^shift a frame; default 4 */
    int32_t floor_q16;       /* 1..65536: smallest standard deviation believed, as a share; default 1 percent */
    int32_t mark_every;      /* look for marks every so many frames; 0 = never; default 300 */
} stad_monitor_config;

/* State: no pointers, copy it freely. */
typedef struct stad_monitor {
    stad_monitor_config config; /* as given */
    int32_t share_q16;          /* firm / considered of the last frame */
    int32_t mean_q16;           /* what is usual */
    int32_t sigma_q16;          /* and how much it varies */
    int32_t sum_q8;             /* the CUSUM */
    int64_t learn_sum;          /* sum of shares while learning, <= 1000 * 2^16 */
    int64_t learn_sq;           /* sum of squares, <= 1000 * 2^32 */
    int32_t frames;             /* frames since the start of learning, saturating */
    int32_t cooldown;           /* frames left */
    int32_t since_look;         /* frames since marks were last looked for */
    int32_t remind;             /* 1: alarm once more when the cool-down is over */
} stad_monitor;

/* The defaults above. */
void stad_monitor_defaults(stad_monitor_config *config);

/* Starts learning. `config` NULL: the defaults. STAD_E_PARAM: a field out of range; the monitor is unchanged. */
int stad_monitor_init(stad_monitor *m, const stad_monitor_config *config);

/* Forgets what is usual and learns again: call it when parameters, correction or the scene's kind have changed. */
void stad_monitor_restart(stad_monitor *m);

/* One frame's counters. Returns enum stad_monitor_state, or STAD_E_PARAM when the counters are impossible (none
 * considered, more firm than considered): such a frame teaches nothing, but still counts for the schedule of marks. */
int stad_monitor_frame(stad_monitor *m, const stad_match_counts *counts);

/* 1: what raised the alarm is still there; the cool-down begins anew, and at its end the alarm is raised again, for
 * by then the fall has become usual. 0: no longer. */
void stad_monitor_remind(stad_monitor *m, int on);

/* 1 when it is time to look for marks; stad_monitor_looked() starts the wait anew. */
int stad_monitor_look_due(const stad_monitor *m);

/* Marks have been looked for. */
void stad_monitor_looked(stad_monitor *m);

#ifdef __cplusplus
}
#endif

#endif
