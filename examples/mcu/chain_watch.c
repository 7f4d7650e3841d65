/* SPDX-License-Identifier: MIT
 * examples/mcu/chain_watch.c - match -> [WATCH] -> marks -> tune -> store
 *
 * The monitor learns what is usual from the counters of a few frames, then the light fails: noise grows, fewer pixels are
 * firm, and it asks for a recalibration. */
#include "chain.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "scene.h"
#include "stad/monitor.h"
#include "stad/stad.h"

enum { WIDTH = 96, HEIGHT = 64, DISPARITIES = 16, LEARN = 6, USUAL = 8, FRAMES = 14 };

static stad_match matcher;

static int match(int16_t noise, uint32_t seed)
{
    static uint8_t left[WIDTH], right[WIDTH];
    static int16_t disp_q4[WIDTH];
    const scene view = {WIDTH, HEIGHT, DISPARITIES, noise, seed};
    stad_params p;
    int y;
    stad_params_sample(&p, DISPARITIES, 5, 1);
    if (stad_match_begin(&matcher, &p) != STAD_OK)
        return 0;
    for (y = 0; y < HEIGHT; y++) {
        scene_row(&view, y, left, right, NULL);
        if (stad_match_push(&matcher, left, right) != STAD_OK)
            return 0;
        while (stad_match_pull(&matcher, disp_q4) >= 0) {
        }
    }
    return 1;
}

int chain_watch(void)
{
    static const stad_geometry g = {WIDTH, HEIGHT, 1, DISPARITIES, 5, 800, 63, STAD_MODE_SGBM, STAD_MEMORY_SMALL};
    stad_monitor_config config;
    stad_monitor monitor;
    uint32_t hash = HASH_START;
    int frame, alarm = 0;
    stad_monitor_defaults(&config);
    config.learn_frames = LEARN;
    if (stad_monitor_init(&monitor, &config) != STAD_OK || stad_match_init(&matcher, &g, work, work_bytes) != STAD_OK)
        return chain_agrees("watch", 0, EXPECT_WATCH);
    for (frame = 0; frame < FRAMES && alarm == 0; frame++) {
        if (!match(frame < USUAL ? 3 : 60, 100u + (uint32_t)frame))
            break;
        if (stad_monitor_frame(&monitor, stad_match_counts_of(&matcher)) == STAD_MONITOR_DEGRADED)
            alarm = frame;
        hash = hash_add(hash, (uint32_t)monitor.share_q16, 4);
        hash = hash_add(hash, (uint32_t)monitor.sum_q8, 4);
    }
    say("watch: noise from frame ");
    say_dec(USUAL);
    say(", alarm at frame ");
    say_dec(alarm);
    say("\n");
    return chain_agrees("watch", hash_add(hash, (uint32_t)alarm, 4), EXPECT_WATCH) && alarm >= USUAL;
}
