/* SPDX-License-Identifier: MIT
 * proof/prove_monitor.c - the monitor: any config, then any frame (several numbers of pixels, any of firm ones)
 * from any state that its invariants allow.
 * SOURCES: monitor/monitor.c base/log.c
 *
 * Invariants: 0 <= share, mean <= 65536; 1 <= sigma; 0 <= sum <= 32767; learn_sum <= 1000 * 2^16, learn_sq <= 1000 * 2^32;
 * frames <= learn_frames. Learning and watching keep them: a mean moved by a fraction towards a share stays between both. */
#include "proof/prove.h"
#include "stad/monitor.h"

static stad_monitor_config any_config(void)
{
    stad_monitor_config c;
    c.learn_frames = (int16_t)any(-32768, 32767);
    c.cooldown_frames = (int16_t)any(-32768, 32767);
    c.slack_q8 = (int16_t)any(-32768, 32767);
    c.threshold_q8 = (int16_t)any(-32768, 32767);
    c.clip_q8 = (int16_t)any(-32768, 32767);
    c.follow_shift = (int16_t)any(-32768, 32767);
    c.floor_q16 = any(INT32_MIN, INT32_MAX);
    c.mark_every = any(INT32_MIN, INT32_MAX);
    return c;
}

static void prove_with(int32_t considered)
{
    stad_monitor m;
    stad_match_counts counts = {considered, any(INT32_MIN, INT32_MAX), 0, 0, 0, 0};
    stad_monitor_config c = any_config();
    if (stad_monitor_init(&m, &c) != STAD_OK || stad_monitor_init(&m, any(0, 1) ? &c : 0) != STAD_OK)
        return;
    stad_monitor_frame(&m, &counts);
    m.mean_q16 = any(0, 65536);
    m.share_q16 = any(0, 65536);
    m.sigma_q16 = any(1, INT32_MAX);
    m.sum_q8 = any(0, 32767);
    m.learn_sum = any64(0, 1000ll << 16);
    m.learn_sq = any64(0, 1000ll << 32);
    m.frames = any(0, 1000);
    m.cooldown = any(0, 32767);
    m.remind = any(0, 1);
    m.since_look = any(0, INT32_MAX);
    stad_monitor_frame(&m, &counts);
    //@ assert 0 <= m.sum_q8 <= 32767 && 1 <= m.sigma_q16 && 0 <= m.share_q16 <= 65536;
    stad_monitor_look_due(&m);
    stad_monitor_looked(&m);
    stad_monitor_remind(&m, any(INT32_MIN, INT32_MAX));
    stad_monitor_restart(&m);
}

int main(void)
{
    prove_with(INT32_MIN);
    prove_with(0);
    prove_with(1);
    prove_with(77);
    prove_with(320 * 240);
    prove_with(INT32_MAX);
    return 0;
}
