/* SPDX-License-Identifier: MIT
 * test_monitor.c - the CUSUM on made-up counters: what alarms, what does not, and when. */
#include "stad/monitor.h"
#include "unity.h"

static stad_monitor monitor;

void setUp(void)
{
    stad_monitor_init(&monitor, NULL);
}

void tearDown(void)
{
}

/* One frame in which `per_mille` of 80000 pixels are firm. */
static int frame(int per_mille)
{
    stad_match_counts counts = {0};
    counts.considered = 80000;
    counts.firm = per_mille * 80;
    return stad_monitor_frame(&monitor, &counts);
}

static void learn(int per_mille)
{
    for (int i = 0; i < 30; i++)
        TEST_ASSERT_EQUAL(STAD_MONITOR_LEARNING, frame(per_mille));
}

/* Frames until the alarm, 0 when none came within `limit`. */
static int frames_to_alarm(int per_mille, int limit)
{
    for (int i = 1; i <= limit; i++)
        if (frame(per_mille) == STAD_MONITOR_DEGRADED)
            return i;
    return 0;
}

void test_monitor_steady_never_alarms(void)
{
    learn(700);
    TEST_ASSERT_EQUAL(0, frames_to_alarm(700, 5000));
}

void test_monitor_rise_never_alarms(void)
{
    learn(400);
    TEST_ASSERT_EQUAL(0, frames_to_alarm(900, 200));
}

void test_monitor_deep_fall_alarms_on_second_frame(void)
{
    learn(700);
    TEST_ASSERT_EQUAL(2, frames_to_alarm(300, 10));
}

void test_monitor_fall_within_slack_stays_quiet(void)
{
    learn(700); /* sigma is at its floor of 10 per mille: slack forgives 20 */
    TEST_ASSERT_EQUAL(0, frames_to_alarm(681, 500));
}

void test_monitor_sum_reaches_threshold_alarms_only_above(void)
{
    learn(700);
    monitor.sum_q8 = 0;
    frame(700 - 60); /* 6 deviations - 2 of slack = 4 */
    TEST_ASSERT_INT_WITHIN(24, 4 * 256, monitor.sum_q8);
    TEST_ASSERT_EQUAL(0, monitor.cooldown);
}

void test_monitor_one_frame_is_clipped(void)
{
    learn(900);
    TEST_ASSERT_EQUAL(STAD_MONITOR_OK, frame(0)); /* 90 deviations count as 8: 6 after slack */
    TEST_ASSERT_EQUAL(6 * 256, monitor.sum_q8);
}

void test_monitor_noisy_learning_widens_sigma(void)
{
    for (int i = 0; i < 30; i++)
        frame(i % 2 ? 650 : 750);
    TEST_ASSERT_INT_WITHIN(66, 3333, monitor.sigma_q16); /* sd of +-50 over 30: 50.9 per mille */
    TEST_ASSERT_EQUAL(0, frames_to_alarm(620, 100));
}

void test_monitor_cooldown_holds_alarms_back(void)
{
    learn(900);
    TEST_ASSERT_EQUAL(2, frames_to_alarm(500, 10));
    for (int i = 0; i < 64; i++)
        TEST_ASSERT_EQUAL(STAD_MONITOR_OK, frame(0));
}

void test_monitor_second_fall_after_cooldown_alarms(void)
{
    learn(900);
    frames_to_alarm(600, 10);
    TEST_ASSERT_EQUAL(0, frames_to_alarm(600, 200)); /* the mean has followed */
    TEST_ASSERT_NOT_EQUAL(0, frames_to_alarm(300, 5));
}

void test_monitor_restart_learns_anew(void)
{
    learn(900);
    stad_monitor_restart(&monitor);
    learn(300);
    TEST_ASSERT_EQUAL(0, frames_to_alarm(300, 200));
}

void test_monitor_impossible_counts_are_refused(void)
{
    stad_match_counts counts = {0};
    learn(500);
    stad_monitor before = monitor;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_monitor_frame(&monitor, &counts));
    counts.considered = 10;
    counts.firm = 11;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_monitor_frame(&monitor, &counts));
    counts.firm = -1;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_monitor_frame(&monitor, &counts));
    TEST_ASSERT_EQUAL(before.mean_q16, monitor.mean_q16);
    TEST_ASSERT_EQUAL(before.since_look + 3, monitor.since_look);
}

void test_monitor_look_is_due_every_nth_frame(void)
{
    for (int i = 0; i < 299; i++) {
        frame(500);
        TEST_ASSERT_EQUAL(0, stad_monitor_look_due(&monitor));
    }
    frame(500);
    TEST_ASSERT_EQUAL(1, stad_monitor_look_due(&monitor));
    stad_monitor_looked(&monitor);
    TEST_ASSERT_EQUAL(0, stad_monitor_look_due(&monitor));
}

void test_monitor_zero_schedule_is_never_due(void)
{
    stad_monitor_config config;
    stad_monitor_defaults(&config);
    config.mark_every = 0;
    TEST_ASSERT_EQUAL(STAD_OK, stad_monitor_init(&monitor, &config));
    for (int i = 0; i < 1000; i++)
        frame(500);
    TEST_ASSERT_EQUAL(0, stad_monitor_look_due(&monitor));
}

static int refused(void (*spoil)(stad_monitor_config *))
{
    stad_monitor_config config;
    stad_monitor_defaults(&config);
    spoil(&config);
    return stad_monitor_init(&monitor, &config) == STAD_E_PARAM;
}

static void one_learn_frame(stad_monitor_config *c)
{
    c->learn_frames = 1;
}
static void long_learning(stad_monitor_config *c)
{
    c->learn_frames = 1001;
}
static void negative_cooldown(stad_monitor_config *c)
{
    c->cooldown_frames = -1;
}
static void zero_slack(stad_monitor_config *c)
{
    c->slack_q8 = 0;
}
static void zero_threshold(stad_monitor_config *c)
{
    c->threshold_q8 = 0;
}
static void zero_clip(stad_monitor_config *c)
{
    c->clip_q8 = 0;
}
static void no_follow(stad_monitor_config *c)
{
    c->follow_shift = 0;
}
static void far_follow(stad_monitor_config *c)
{
    c->follow_shift = 16;
}
static void zero_floor(stad_monitor_config *c)
{
    c->floor_q16 = 0;
}
static void high_floor(stad_monitor_config *c)
{
    c->floor_q16 = 65537;
}
static void negative_schedule(stad_monitor_config *c)
{
    c->mark_every = -1;
}

void test_monitor_config_out_of_range_is_refused(void)
{
    void (*const spoils[])(stad_monitor_config *) = {one_learn_frame, long_learning, negative_cooldown, zero_slack,
                                                     zero_threshold,  zero_clip,     no_follow,         far_follow,
                                                     zero_floor,      high_floor,    negative_schedule};
    for (size_t i = 0; i < sizeof spoils / sizeof spoils[0]; i++)
        TEST_ASSERT_TRUE_MESSAGE(refused(spoils[i]), "config accepted");
}

void test_monitor_remind_without_cooldown_alarms_on_the_next_frame(void)
{
    stad_monitor_config config;
    stad_monitor_defaults(&config);
    config.cooldown_frames = 0;
    TEST_ASSERT_EQUAL(STAD_OK, stad_monitor_init(&monitor, &config));
    learn(700);
    stad_monitor_remind(&monitor, 1);
    TEST_ASSERT_EQUAL(1, frames_to_alarm(700, 3));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_monitor_steady_never_alarms);
    RUN_TEST(test_monitor_rise_never_alarms);
    RUN_TEST(test_monitor_deep_fall_alarms_on_second_frame);
    RUN_TEST(test_monitor_fall_within_slack_stays_quiet);
    RUN_TEST(test_monitor_sum_reaches_threshold_alarms_only_above);
    RUN_TEST(test_monitor_one_frame_is_clipped);
    RUN_TEST(test_monitor_noisy_learning_widens_sigma);
    RUN_TEST(test_monitor_cooldown_holds_alarms_back);
    RUN_TEST(test_monitor_second_fall_after_cooldown_alarms);
    RUN_TEST(test_monitor_restart_learns_anew);
    RUN_TEST(test_monitor_impossible_counts_are_refused);
    RUN_TEST(test_monitor_look_is_due_every_nth_frame);
    RUN_TEST(test_monitor_zero_schedule_is_never_due);
    RUN_TEST(test_monitor_config_out_of_range_is_refused);
    RUN_TEST(test_monitor_remind_without_cooldown_alarms_on_the_next_frame);
    return UNITY_END();
}
