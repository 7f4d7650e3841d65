/* SPDX-License-Identifier: MIT
 * test_calib_cuts.c - the loop when the board is reset or the power goes within a save: the old set or the new one. */
#include "support/calib_bench.h"

#include <stdio.h>
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

void test_calib_reset_at_any_turn_leaves_old_or_adopted(void)
{
    fresh_flash();
    power_on();
    stad_calib_start(&calib);
    int turns = run_to_the_end();
    stad_setup adopted = *stad_calib_setup(&calib);
    TEST_ASSERT_EQUAL(STAD_CALIB_ADOPTED, stad_calib_report_of(&calib)->outcome);
    printf("calib: a run of %d turns, reset at each\n", turns);
    for (int at = 0; at < turns; at++) {
        fresh_flash();
        power_on();
        stad_calib_start(&calib);
        for (int i = 0; i < at; i++)
            turn();
        memset(&calib, 0x5a, sizeof calib);
        power_on();
        const stad_setup *s = stad_calib_setup(&calib);
        TEST_ASSERT_TRUE(memcmp(s, &setup, sizeof setup) == 0 || memcmp(s, &adopted, sizeof adopted) == 0);
        TEST_ASSERT_EQUAL(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase);
    }
}

/* -- power cuts while the pump saves ----------------------------------------------------------------------------- */

/* A pump about to save, its flash, and what may be found after a cut. */
typedef struct saving {
    stad_calib calib;
    flash_sim sim;
    stad_setup old;
    long bytes; /* that the save touches */
} saving;

/* Turns until a save is wanted that is not the first `skip` of them. */
static void turn_to_save(int skip)
{
    stad_request r;
    for (int i = 0; i < 500; i++) {
        if (stad_calib_want(&calib, &r) == STAD_WANT_SAVE && skip-- == 0)
            return;
        turn();
    }
    TEST_FAIL_MESSAGE("no save was asked for");
}

/* `saves` sets in the flash beside the factory's, then a run up to its save: of what is adopted, or of the way back. */
static void bring_to_save(saving *s, int saves, int back)
{
    stad_flash flash = sim_flash(&sim);
    stad_setup other = setup;
    fresh_flash();
    made_up_turns = 0;
    for (int i = 0; i < saves; i++) {
        other.params.p1 = (int16_t)(60 + i);
        TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_save(&flash, &other));
    }
    config.probation_frames = back ? 3 : 0;
    power_on();
    stad_calib_start(&calib);
    turn_to_save(0);
    if (back) {
        turn();
        made_up_turns = 1; /* what was adopted turns out worse */
        turn_to_save(0);
    }
    s->calib = calib;
    s->sim = sim;
    TEST_ASSERT_GREATER_OR_EQUAL(0, stad_store_load(&flash, &s->old));
    sim.touched = 0;
    turn();
    s->bytes = sim.touched;
    made_up_turns = 0;
}

static int is_same(const stad_setup *a, const stad_setup *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

/* The power goes at one byte of the save. With its state kept the pump asks for the save again and ends the run; without it starts
 * over from the old set or the new one, and a fresh run ends well. Counts in found[] which of the two it was. */
static void cut_save(const saving *s, long at, enum sim_tear tear, int kept, int found[2])
{
    stad_request r;
    stad_setup stored;
    stad_flash flash = sim_flash(&sim);
    const stad_setup *new = &s->calib.active;
    char where[96];
    snprintf(where, sizeof where, "cut at byte %ld, tear %d, state %s", at, (int)tear, kept ? "kept" : "lost");
    calib = s->calib;
    sim = s->sim;
    sim_restart(&sim);
    sim.tear = tear;
    sim.cut_at = at;
    sim.random += (uint32_t)at;
    stad_store_save(&flash, stad_calib_setup(&calib)); /* the answer is never told: the board is off */
    TEST_ASSERT_EQUAL_MESSAGE(1, sim.dead, where);
    sim_restart(&sim);
    TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, stad_store_load(&flash, &stored), where);
    TEST_ASSERT_TRUE_MESSAGE(is_same(&stored, &s->old) || is_same(&stored, new), where);
    found[is_same(&stored, new)]++;
    if (!kept) {
        memset(&calib, 0x5a, sizeof calib);
        power_on();
        TEST_ASSERT_TRUE_MESSAGE(is_same(stad_calib_setup(&calib), &stored), where);
        TEST_ASSERT_EQUAL_MESSAGE(STAD_CALIB_IDLE, stad_calib_report_of(&calib)->phase, where);
        if (at % 4 == 0) /* a whole run takes its time */
            stad_calib_start(&calib);
    } else {
        TEST_ASSERT_EQUAL_MESSAGE(STAD_WANT_SAVE, stad_calib_want(&calib, &r), where);
    }
    run_to_the_end();
    TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, stad_store_load(&flash, &stored), where);
    TEST_ASSERT_TRUE_MESSAGE(is_same(&stored, stad_calib_setup(&calib)), where);
    TEST_ASSERT_EQUAL_MESSAGE(0, sim.violations, where);
}

void test_calib_power_cut_in_any_byte_of_a_save_leaves_old_or_new(void)
{
    static saving s;
    int cuts = 0, found[2] = {0, 0};
    for (int back = 0; back < 2; back++)
        for (int saves = 0; saves < 3; saves++) {
            bring_to_save(&s, saves, back);
            for (int tear = 0; tear < TEAR_KINDS; tear++)
                for (long at = 0; at < (tear ? SIM_SECTOR : s.bytes); at++, cuts += 2) /* only an erase tears */
                    for (int kept = 0; kept < 2; kept++)
                        cut_save(&s, at, (enum sim_tear)tear, kept, found);
        }
    printf("calib: %d cuts in its saves, the old set %d times, the new one %d\n", cuts, found[0], found[1]);
    TEST_ASSERT_GREATER_THAN(1000, found[0]);
}

int main(void)
{
    render_all();
    UNITY_BEGIN();
    RUN_TEST(test_calib_reset_at_any_turn_leaves_old_or_adopted);
    RUN_TEST(test_calib_power_cut_in_any_byte_of_a_save_leaves_old_or_new);
    return UNITY_END();
}
