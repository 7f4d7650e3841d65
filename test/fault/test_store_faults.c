/* SPDX-License-Identifier: MIT
 * test_store_faults.c - the promise of the store under power cuts, torn writes, flipped bits and stuck sectors.
 *
 * Exhaustive: every flash history below x every program granule x every kind of tear x a cut at every byte that a
 * save touches, and after each of these a second save with a cut at every byte again. After each cut a load must find
 * the old set or the new. */
#include "support/flash_sim.h"
#include "unity.h"

#include <stdio.h>

static flash_sim sim;
static const uint32_t granules[] = {1, 8, 64};

void setUp(void)
{
}

void tearDown(void)
{
}

/* A valid setup that differs in several fields for every number. */
static stad_setup setup_of(int number)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = 320;
    s.height = 240;
    s.channels = 1;
    s.origin = STAD_ORIGIN_TUNED;
    s.corrected = 1;
    stad_params_sample(&s.params, 64, 3 + 2 * (number % 4), 1);
    s.params.uniqueness_ratio = (int16_t)(number % 40);
    s.params.p1 = (int16_t)(10 + number % 60);
    stad_rig_identity(&s.rig, 320, 240);
    s.rig.a_q16 = 1000 * number - 70000;
    s.rig.b_q24 = -31 * number;
    s.rig.c_q24 = 17 * number + 1;
    return s;
}

static int number_of(const stad_setup *s)
{
    return (s->rig.a_q16 + 70000) / 1000;
}

static int same(const stad_setup *a, const stad_setup *b)
{
    uint8_t x[STAD_SETUP_BYTES], y[STAD_SETUP_BYTES];
    stad_setup_pack(a, 0, x);
    stad_setup_pack(b, 0, y);
    return memcmp(x, y, sizeof x) == 0;
}

/* What a load finds: the number of the setup, -1 for nothing, -2 for a setup that nobody ever saved. */
static int loaded(flash_sim *s)
{
    stad_setup found;
    stad_flash f = sim_flash(s);
    if (stad_store_load(&f, &found) < 0)
        return -1;
    stad_setup meant = setup_of(number_of(&found));
    return same(&found, &meant) ? number_of(&found) : -2;
}

static int save(flash_sim *s, int number)
{
    stad_flash f = sim_flash(s);
    stad_setup setup = setup_of(number);
    return stad_store_save(&f, &setup);
}

/* -- histories: what the flash went through before the save under test ------------------------------------------- */

enum history { BLANK, JUNK, FACTORY_ONLY, ONE_SAVE, TWO_SAVES, THREE_SAVES, OLDER_ROTTEN, NEWER_ROTTEN, NUMBERS_WRAP, HISTORIES };

static void put_record(flash_sim *s, int slot, int number, uint32_t sequence)
{
    stad_setup setup = setup_of(number);
    memset(s->bytes[slot], 0xff, SIM_SECTOR);
    stad_setup_pack(&setup, sequence, s->bytes[slot]);
}

static void prepare(flash_sim *s, enum history h, uint32_t granule, uint32_t seed)
{
    sim_init(s, granule, seed);
    if (h == JUNK)
        for (int i = 0; i < 2 * SIM_SECTOR; i++)
            s->bytes[i / SIM_SECTOR][i % SIM_SECTOR] = (uint8_t)sim_random(s);
    if (h >= FACTORY_ONLY)
        put_record(s, STAD_SLOT_FACTORY, 90, 0);
    for (int i = ONE_SAVE; i <= (int)h && h <= THREE_SAVES; i++)
        save(s, i);
    if (h == OLDER_ROTTEN || h == NEWER_ROTTEN) {
        put_record(s, STAD_SLOT_A, 1, 7);
        put_record(s, STAD_SLOT_B, 2, 8);
        s->bytes[h == NEWER_ROTTEN][20] ^= 4;
    }
    if (h == NUMBERS_WRAP) {
        put_record(s, STAD_SLOT_A, 2, 0);
        put_record(s, STAD_SLOT_B, 1, 0xffffffffu);
    }
    s->touched = 0;
}

static char why[160];

static void expect_old_or_new(flash_sim *s, int before, int after, const char *when)
{
    int now = loaded(s);
    if (now == before || now == after)
        return;
    snprintf(why + strlen(why), sizeof why - strlen(why), " %s: %d, wanted %d or %d", when, now, before, after);
    TEST_FAIL_MESSAGE(why);
}

/* Cuts a second save at every byte, starting from the state a first cut left. Returns the number of cut points. */
static long cut_second_save(const flash_sim *after_cut)
{
    long cuts = 0;
    for (long cut = 0;; cut++) {
        flash_sim s = *after_cut;
        sim_restart(&s);
        int before = loaded(&s);
        s.cut_at = cut;
        int status = save(&s, 52);
        int finished = !s.dead;
        sim_restart(&s);
        expect_old_or_new(&s, before, 52, "second save");
        TEST_ASSERT_EQUAL_MESSAGE(0, s.violations, why);
        if (finished) {
            TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, status, why);
            return cuts;
        }
        cuts++;
    }
}

static long cut_everywhere(enum history h, uint32_t granule, enum sim_tear tear)
{
    long cuts = 0;
    for (long cut = 0;; cut++) {
        snprintf(why, sizeof why, "history %d granule %u tear %d cut %ld", (int)h, (unsigned)granule, (int)tear, cut);
        prepare(&sim, h, granule, (uint32_t)(977 * cut + 13 * (long)h + 1));
        sim.tear = tear;
        int before = loaded(&sim);
        sim.cut_at = cut;
        int status = save(&sim, 51);
        if (!sim.dead) {
            TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, status, why);
            TEST_ASSERT_EQUAL_MESSAGE(51, loaded(&sim), why);
            return cuts;
        }
        flash_sim after_cut = sim;
        sim_restart(&sim);
        expect_old_or_new(&sim, before, 51, "first save");
        TEST_ASSERT_EQUAL_MESSAGE(0, sim.violations, why);
        cuts += 1 + cut_second_save(&after_cut);
    }
}

void test_store_cut_at_every_byte_leaves_old_or_new(void)
{
    long cuts = 0;
    for (int h = 0; h < HISTORIES; h++)
        for (size_t g = 0; g < sizeof granules / sizeof granules[0]; g++)
            for (int tear = 0; tear < TEAR_KINDS; tear++)
                cuts += cut_everywhere((enum history)h, granules[g], (enum sim_tear)tear);
    printf("store: %ld cut points\n", cuts);
    TEST_ASSERT_GREATER_THAN(1000, cuts);
}

/* Saves with a cut at every byte while some reads fail. Done is what loads, whichever fail; what loads after a cut is the old set
 * or the new one unless a slot failed twice running. Returns the number of cut points. */
static long cut_while_reads_slip(enum history h, enum sim_tear tear, uint32_t slips)
{
    const int twice = (slips & slips >> 1) != 0;
    for (long cut = 0;; cut++) {
        snprintf(why, sizeof why, "history %d tear %d slips %#x cut %ld", (int)h, (int)tear, (unsigned)slips, cut);
        prepare(&sim, h, 8, (uint32_t)(977 * cut + 13 * (long)h + 1));
        sim.tear = tear;
        int before = loaded(&sim);
        sim.cut_at = cut;
        sim.slips = slips;
        int status = save(&sim, 51), finished = !sim.dead;
        sim_restart(&sim);
        if (status >= 0)
            TEST_ASSERT_EQUAL_MESSAGE(51, loaded(&sim), why);
        else if (!twice)
            expect_old_or_new(&sim, before, 51, "save");
        TEST_ASSERT_EQUAL_MESSAGE(0, sim.violations, why);
        if (finished)
            return cut;
    }
}

void test_store_cut_while_reads_fail_leaves_old_or_new(void)
{
    long cuts = 0;
    for (int h = 0; h < HISTORIES; h++)
        for (int tear = 0; tear < TEAR_KINDS; tear++)
            for (uint32_t slips = 1; slips < 64; slips++) /* a save reads six times at most */
                cuts += cut_while_reads_slip((enum history)h, (enum sim_tear)tear, slips);
    printf("store: %ld cut points with failing reads\n", cuts);
}

void test_store_slip_of_the_only_good_slot_does_not_outlast_the_save(void)
{
    prepare(&sim, ONE_SAVE, 8, 1);
    sim.slips = 3; /* both reads of slot A, the good one */
    TEST_ASSERT_EQUAL(STAD_SLOT_B, save(&sim, 51));
    TEST_ASSERT_EQUAL(51, loaded(&sim));
}

void test_store_slip_in_a_load_still_finds_the_newest(void)
{
    prepare(&sim, TWO_SAVES, 8, 1);
    for (int k = 0; k < 4; k++) {
        sim.slips = 1u << k;
        TEST_ASSERT_EQUAL(TWO_SAVES, loaded(&sim));
    }
}

void test_store_unreadable_slot_is_given_up_for_a_good_one(void)
{
    prepare(&sim, TWO_SAVES, 8, 1);
    sim.slips = 3; /* both reads of slot A, the older */
    TEST_ASSERT_EQUAL(STAD_SLOT_A, save(&sim, 51));
    TEST_ASSERT_EQUAL(51, loaded(&sim));
}

void test_store_overlapping_sectors_are_refused(void)
{
    prepare(&sim, BLANK, 8, 1);
    stad_setup setup = setup_of(1), found;
    stad_flash f = sim_flash(&sim);
    const uint32_t near[] = {0, 16, SIM_SECTOR - 1};
    for (int slot = 0; slot < 3; slot++)
        for (int other = 0; other < 3; other++)
            for (int k = 0; k < 3 && other != slot; k++) {
                f = sim_flash(&sim);
                f.slot_offset[slot] = f.slot_offset[other] + near[k];
                snprintf(why, sizeof why, "slot %d is %u after slot %d", slot, (unsigned)near[k], other);
                TEST_ASSERT_EQUAL_MESSAGE(STAD_E_PARAM, stad_store_save(&f, &setup), why);
                TEST_ASSERT_EQUAL_MESSAGE(STAD_E_PARAM, stad_store_load(&f, &found), why);
            }
    TEST_ASSERT_EQUAL(0, sim.wear[0] + sim.wear[1] + sim.wear[2]);
}

void test_store_random_bit_flips_are_never_accepted(void)
{
    uint8_t good[STAD_SETUP_BYTES], bad[STAD_SETUP_BYTES];
    sim_init(&sim, 4, 20240601u);
    for (int trial = 0; trial < 100000; trial++) {
        stad_setup setup = setup_of(trial % 97), found;
        uint32_t sequence, flips = 1 + sim_random(&sim) % 64;
        stad_setup_pack(&setup, sim_random(&sim), good);
        memcpy(bad, good, sizeof bad);
        for (uint32_t i = 0; i < flips; i++) {
            uint32_t bit = sim_random(&sim) % (8 * STAD_SETUP_BYTES);
            bad[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
        if (memcmp(good, bad, sizeof bad) == 0)
            continue;
        snprintf(why, sizeof why, "trial %d flips %u", trial, (unsigned)flips);
        TEST_ASSERT_EQUAL_MESSAGE(STAD_E_CORRUPT, stad_setup_unpack(bad, sizeof bad, &found, &sequence), why);
    }
}

void test_store_every_single_and_double_flip_is_refused(void)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    stad_setup setup = setup_of(5), found;
    uint32_t sequence;
    stad_setup_pack(&setup, 9, bytes);
    for (int i = 0; i < 8 * STAD_SETUP_BYTES; i++) {
        bytes[i / 8] ^= (uint8_t)(1 << i % 8);
        TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_setup_unpack(bytes, sizeof bytes, &found, &sequence));
        for (int j = 0; j < i; j++) {
            bytes[j / 8] ^= (uint8_t)(1 << j % 8);
            TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_setup_unpack(bytes, sizeof bytes, &found, &sequence));
            bytes[j / 8] ^= (uint8_t)(1 << j % 8);
        }
        bytes[i / 8] ^= (uint8_t)(1 << i % 8);
    }
}

void test_store_flip_in_newest_falls_back_to_older(void)
{
    for (int bit = 0; bit < 8 * STAD_SETUP_BYTES; bit++) {
        prepare(&sim, TWO_SAVES, 4, 1);
        sim.bytes[STAD_SLOT_B][bit / 8] ^= (uint8_t)(1 << bit % 8);
        TEST_ASSERT_EQUAL(ONE_SAVE, loaded(&sim));
        sim.bytes[STAD_SLOT_A][bit / 8] ^= (uint8_t)(1 << bit % 8);
        TEST_ASSERT_EQUAL(90, loaded(&sim)); /* the factory's */
    }
}

void test_store_stuck_target_keeps_old_and_reports(void)
{
    prepare(&sim, TWO_SAVES, 8, 1);
    sim.stuck[STAD_SLOT_A] = 1;
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, save(&sim, 51));
    TEST_ASSERT_EQUAL(TWO_SAVES, loaded(&sim));
}

void test_store_stuck_sector_on_first_save_takes_the_other(void)
{
    prepare(&sim, JUNK, 8, 1);
    sim.stuck[STAD_SLOT_A] = 1;
    TEST_ASSERT_EQUAL(STAD_SLOT_B, save(&sim, 51));
    TEST_ASSERT_EQUAL(51, loaded(&sim));
}

void test_store_unreadable_slot_is_not_erased(void)
{
    prepare(&sim, TWO_SAVES, 8, 1);
    sim.unreadable[0] = sim.unreadable[1] = 1;
    int wear = sim.wear[0] + sim.wear[1];
    TEST_ASSERT_EQUAL(STAD_E_STATE, save(&sim, 51));
    TEST_ASSERT_EQUAL(wear, sim.wear[0] + sim.wear[1]);
    TEST_ASSERT_EQUAL(90, loaded(&sim));
}

void test_store_refusing_flash_keeps_old(void)
{
    prepare(&sim, TWO_SAVES, 8, 1);
    sim.refuses = 1;
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, save(&sim, 51));
    TEST_ASSERT_EQUAL(TWO_SAVES, loaded(&sim));
}

void test_store_many_saves_wear_both_slots_alike(void)
{
    prepare(&sim, BLANK, 4, 1);
    for (int i = 0; i < 1000; i++) {
        TEST_ASSERT_EQUAL(i % 2, save(&sim, i % 97));
        TEST_ASSERT_EQUAL(i % 97, loaded(&sim));
    }
    TEST_ASSERT_EQUAL(500, sim.wear[0]);
    TEST_ASSERT_EQUAL(500, sim.wear[1]);
    TEST_ASSERT_EQUAL(0, sim.wear[2]);
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_store_cut_at_every_byte_leaves_old_or_new);
    RUN_TEST(test_store_cut_while_reads_fail_leaves_old_or_new);
    RUN_TEST(test_store_slip_of_the_only_good_slot_does_not_outlast_the_save);
    RUN_TEST(test_store_slip_in_a_load_still_finds_the_newest);
    RUN_TEST(test_store_unreadable_slot_is_given_up_for_a_good_one);
    RUN_TEST(test_store_overlapping_sectors_are_refused);
    RUN_TEST(test_store_random_bit_flips_are_never_accepted);
    RUN_TEST(test_store_every_single_and_double_flip_is_refused);
    RUN_TEST(test_store_flip_in_newest_falls_back_to_older);
    RUN_TEST(test_store_stuck_target_keeps_old_and_reports);
    RUN_TEST(test_store_stuck_sector_on_first_save_takes_the_other);
    RUN_TEST(test_store_unreadable_slot_is_not_erased);
    RUN_TEST(test_store_refusing_flash_keeps_old);
    RUN_TEST(test_store_many_saves_wear_both_slots_alike);
    return UNITY_END();
}
