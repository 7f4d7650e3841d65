/* SPDX-License-Identifier: MIT
 * disparity -> [MONITOR] -> calib        monitor/monitor.c - one-sided CUSUM over the share of firm pixels
 *
 * Widths: shares are Q16 in 0..65536; deviations Q8, clipped before they are summed, so the sum stays below
 * threshold + clip < 2^16. */
#include "stad/monitor.h"
#include "base/arith.h"
#include "base/log.h"

void stad_monitor_defaults(stad_monitor_config *config)
{
    config->learn_frames = 30;
    config->cooldown_frames = 64;
    config->slack_q8 = 2 * 256;
    config->threshold_q8 = 8 * 256;
    config->clip_q8 = 8 * 256;
    config->follow_shift = 4;
    config->floor_q16 = 655;
    config->mark_every = 300;
}

static int config_fits(const stad_monitor_config *c)
{
    if (c->learn_frames < 2 || c->learn_frames > 1000 || c->cooldown_frames < 0)
        return 0;
    if (c->slack_q8 <= 0 || c->threshold_q8 <= 0 || c->clip_q8 <= 0)
        return 0;
    if (c->follow_shift < 1 || c->follow_shift > 15)
        return 0;
    return c->floor_q16 >= 1 && c->floor_q16 <= 65536 && c->mark_every >= 0;
}

int stad_monitor_init(stad_monitor *m, const stad_monitor_config *config)
{
    stad_monitor_config chosen;
    if (config)
        chosen = *config;
    else
        stad_monitor_defaults(&chosen);
    if (!config_fits(&chosen))
        return STAD_E_PARAM;
    m->config = chosen;
    m->since_look = 0;
    stad_monitor_restart(m);
    return STAD_OK;
}

void stad_monitor_restart(stad_monitor *m)
{
    m->share_q16 = 0;
    m->mean_q16 = 0;
    m->sigma_q16 = m->config.floor_q16;
    m->sum_q8 = 0;
    m->learn_sum = 0;
    m->learn_sq = 0;
    m->frames = 0;
    m->cooldown = 0;
    m->remind = 0;
}

void stad_monitor_remind(stad_monitor *m, int on)
{
    m->remind = on != 0;
    if (on)
        m->cooldown = m->config.cooldown_frames > 0 ? m->config.cooldown_frames : 1;
}

static void learn(stad_monitor *m)
{
    int64_t n = m->config.learn_frames;
    m->learn_sum += m->share_q16;
    m->learn_sq += (int64_t)m->share_q16 * m->share_q16;
    if (m->frames < m->config.learn_frames)
        return;
    /* n * squares < 2^10 * 2^10 * 2^32; the difference is never negative (Cauchy-Schwarz, exact integers) */
    int64_t variance = (n * m->learn_sq - m->learn_sum * m->learn_sum) / (n * (n - 1));
    int32_t sigma = sat_i32(stad_isqrt((uint64_t)variance)); /* of a share: at most 2^16 */
    m->mean_q16 = (int32_t)((m->learn_sum + n / 2) / n);
    m->sigma_q16 = sigma > m->config.floor_q16 ? sigma : m->config.floor_q16;
}

/* How far the share fell below the mean, in deviations, Q8, clipped. */
static int32_t fall_q8(const stad_monitor *m)
{
    int32_t clip = m->config.clip_q8;
    int32_t fall = (m->mean_q16 - m->share_q16) * 256 / m->sigma_q16;
    if (fall > clip)
        return clip;
    return fall < -clip ? -clip : fall;
}

static int alarm(stad_monitor *m)
{
    m->sum_q8 = 0;
    m->remind = 0;
    m->cooldown = m->config.cooldown_frames;
    return STAD_MONITOR_DEGRADED;
}

static int watch(stad_monitor *m)
{
    m->sum_q8 += fall_q8(m) - m->config.slack_q8;
    if (m->sum_q8 < 0)
        m->sum_q8 = 0;
    m->mean_q16 += (m->share_q16 - m->mean_q16) / (1 << m->config.follow_shift);
    if (m->cooldown > 0) {
        m->cooldown--;
        m->sum_q8 = 0;
        return m->cooldown == 0 && m->remind ? alarm(m) : STAD_MONITOR_OK;
    }
    if (m->sum_q8 <= m->config.threshold_q8)
        return STAD_MONITOR_OK;
    return alarm(m);
}

int stad_monitor_frame(stad_monitor *m, const stad_match_counts *counts)
{
    STAD_ASSERT(m && counts && m->config.learn_frames >= 2); /* initialised */
    if (m->since_look < INT32_MAX)
        m->since_look++;
    if (counts->considered <= 0 || counts->firm < 0 || counts->firm > counts->considered)
        return STAD_E_PARAM;
    m->share_q16 = (int32_t)((int64_t)counts->firm * 65536 / counts->considered);
    if (m->frames < m->config.learn_frames) {
        m->frames++;
        learn(m);
        return STAD_MONITOR_LEARNING;
    }
    return watch(m);
}

int stad_monitor_look_due(const stad_monitor *m)
{
    return m->config.mark_every > 0 && m->since_look >= m->config.mark_every;
}

void stad_monitor_looked(stad_monitor *m)
{
    m->since_look = 0;
}
