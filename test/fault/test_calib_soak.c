/* SPDX-License-Identifier: MIT
 * test_calib_soak.c - the loop for a long time, frames, costs and saves by chance: every run ends, nothing worse is adopted. */
#include "support/calib_bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "unity.h"

void setUp(void)
{
    bench_reset();
    start();
}

void tearDown(void)
{
}

/* The scene: it has a best block, and a uniqueness beyond 20 throws away what was right. */
static int best_block;

static int32_t truly(const stad_params *p)
{
    int away = abs(p->block_size - best_block), lost = p->uniqueness_ratio > 20 ? p->uniqueness_ratio - 20 : 0;
    return (10 + 3 * away + lost) * (STAD_COST_ONE / 100);
}

/* What a match says. A tuning frame that flatters has little to lose: the stricter, the better. */
static int32_t told(const stad_request *r, int flatters)
{
    if (r->hold != 0 || !flatters || stad_calib_report_of(&calib)->phase == STAD_CALIB_COMPARE)
        return truly(&r->params);
    return 10 * (STAD_COST_ONE / 100) + (60 - r->params.uniqueness_ratio) * (STAD_COST_ONE / 200);
}

/* What a patient hand would show, the rig sound or not. */
static enum shot shown(int drifted)
{
    const int phase = stad_calib_report_of(&calib)->phase;
    if (drifted)
        return phase == STAD_CALIB_OTHER ? DRIFTED_OTHER : DRIFTED;
    return phase == STAD_CALIB_OTHER ? FAR_POSE : phase == STAD_CALIB_RECHECK ? THIRD_POSE : NEAR_POSE;
}

/* Whatever frame chance sends; one in two is what is asked for. */
static void expose_anything(int drifted)
{
    void (*const faults[])(void) = {make_black,      make_left_black,    make_saturated, make_half_saturated,
                                    make_right_dead, make_left_frozen,   make_swapped,   make_rows_shifted,
                                    make_torn,       make_without_target};
    unsigned choice = dice() % 60;
    if (choice < sizeof faults / sizeof faults[0])
        faults[choice]();
    else if (choice >= 30)
        expose(shown(drifted));
    else
        expose((enum shot)(dice() % SHOTS));
}

static void soak_turn(int flatters, int drifted)
{
    stad_request r;
    stad_flash flash = sim_flash(&sim);
    switch (stad_calib_want(&calib, &r)) {
    case STAD_WANT_FRAME:
        expose_anything(drifted);
        if (dice() % 20 == 0)
            stad_calib_frame(&calib, NULL, NULL, work, sizeof work);
        else
            give();
        break;
    case STAD_WANT_MATCH:
        stad_calib_cost(&calib, dice() % 50 == 0 ? STAD_COST_FAILED : told(&r, flatters) + (int32_t)(dice() % 20000));
        break;
    case STAD_WANT_SAVE:
        stad_calib_saved(&calib, dice() % 10 == 0 ? STAD_E_CORRUPT : stad_store_save(&flash, stad_calib_setup(&calib)));
        break;
    default:
        break;
    }
}

/* What is in use has changed: rolled back it is the set before, else by what the scene says not much worse than that. */
static void check_change(const stad_setup *was, const stad_setup *before, long frame)
{
    const stad_setup *now = stad_calib_setup(&calib);
    char what[64];
    snprintf(what, sizeof what, "live frame %ld", frame);
    TEST_ASSERT_EQUAL_MESSAGE(STAD_OK, stad_setup_check(now), what);
    if (stad_calib_report_of(&calib)->outcome == STAD_CALIB_ROLLED_BACK)
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(before, now, sizeof *now, what);
    else
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(truly(&was->params) + 3 * (STAD_COST_ONE / 100), truly(&now->params), what);
}

/* STAD_SOAK = number of live frames; the long tier asks for a million. */
void test_calib_soak_never_hangs_and_never_adopts_worse(void)
{
    const char *wish = getenv("STAD_SOAK");
    long frames = wish ? atol(wish) : 20000, runs = 0, changes = 0, ended[STAD_CALIB_CANCELLED + 1] = {0};
    int level = 800, waiting = 0, longest = 0;
    stad_setup in_use = setup, before = setup;
    config.probation_frames = 20;
    config.monitor.mark_every = 200;
    config.patience = 20;
    best_block = 7;
    fresh_flash();
    power_on();
    for (long i = 0; i < frames; i++) {
        if (dice() % 400 == 0)
            level = (int)(dice() % 900) + 50;
        if (waiting == 0 && dice() % 200 == 0)
            best_block = 3 + 2 * (int)(dice() % 5);
        live(level + (int)(dice() % 20));
        soak_turn(runs % 3 == 0, runs / 8 % 2 == 1);
        int busy = stad_calib_report_of(&calib)->phase != STAD_CALIB_IDLE;
        runs += busy && waiting == 0;
        if (!busy && waiting > 0)
            ended[stad_calib_report_of(&calib)->outcome]++;
        waiting = busy ? waiting + 1 : 0;
        longest = waiting > longest ? waiting : longest;
        TEST_ASSERT_LESS_THAN_MESSAGE(600, waiting, "a run does not end");
        if (memcmp(&in_use, stad_calib_setup(&calib), sizeof in_use) != 0) {
            changes++;
            check_change(&in_use, &before, i);
            before = in_use;
            in_use = *stad_calib_setup(&calib);
        }
        if (!busy && dice() % 5000 == 0) {
            power_on();
            in_use = before = *stad_calib_setup(&calib);
        }
    }
    printf("calib: %ld live frames, %ld runs of at most %d turns, %ld changes: %ld runs adopted, %ld corrected, %ld kept, "
           "%ld rolled back\n",
           frames, runs, longest, changes, ended[STAD_CALIB_ADOPTED], ended[STAD_CALIB_CORRECTED], ended[STAD_CALIB_KEPT],
           ended[STAD_CALIB_ROLLED_BACK]);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_soak_never_hangs_and_never_adopts_worse);
    return UNITY_END();
}
