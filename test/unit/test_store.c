/* SPDX-License-Identifier: MIT
 * test_store.c - the record's bytes, what is refused, and the three slots on sound flash. */
#include "support/flash_sim.h"
#include "store/crc32.h"
#include "unity.h"

static flash_sim sim;
static stad_flash flash;
static stad_setup setup;

void setUp(void)
{
    sim_init(&sim, 8, 1);
    flash = sim_flash(&sim);
    memset(&setup, 0, sizeof setup);
    setup.width = 320;
    setup.height = 240;
    setup.channels = 1;
    stad_params_sample(&setup.params, 64, 3, 1);
    stad_rig_identity(&setup.rig, 320, 240);
}

void tearDown(void)
{
}

void test_store_crc32_of_check_string_is_the_published_one(void)
{
    TEST_ASSERT_EQUAL_HEX32(0xcbf43926u, stad_crc32((const uint8_t *)"123456789", 9));
    TEST_ASSERT_EQUAL_HEX32(0, stad_crc32(NULL, 0));
}

void test_store_record_bytes_are_pinned(void)
{
    static const uint8_t head[] = {'S', 'T', 'A', 'D', 1, 0, 60, 0, 4, 3, 2, 1, 0x40, 1, 0xf0, 0, 0, 1, 2, 1};
    static const uint8_t fields[] = {0xfe, 0xff, 64, 0, 3, 0, 72, 0, 0x20, 1, 1, 0, 63, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    static const uint8_t rig[] = {0xff, 0xff, 0xff, 0xff, 0, 0, 8, 0, 0, 0, 0xf0, 0xff};
    uint8_t bytes[STAD_SETUP_BYTES];
    setup.origin = STAD_ORIGIN_TUNED;
    setup.corrected = 1;
    setup.params.min_disparity = -2;
    setup.rig.a_q16 = -1;
    setup.rig.b_q24 = 1 << 19;
    setup.rig.c_q24 = -(1 << 20);
    stad_setup_pack(&setup, 0x01020304u, bytes);
    TEST_ASSERT_EQUAL_MEMORY(head, bytes, sizeof head);
    TEST_ASSERT_EQUAL_MEMORY(fields, bytes + 20, sizeof fields);
    TEST_ASSERT_EQUAL_MEMORY(rig, bytes + 44, sizeof rig);
}

void test_store_unpack_returns_what_was_packed(void)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    stad_setup found;
    uint32_t sequence = 0;
    setup.params.min_disparity = -17;
    setup.corrected = 1;
    setup.rig.a_q16 = INT16_MIN;
    stad_setup_pack(&setup, 0xfffffffeu, bytes);
    TEST_ASSERT_EQUAL(STAD_OK, stad_setup_unpack(bytes, sizeof bytes, &found, &sequence));
    TEST_ASSERT_EQUAL_MEMORY(&setup, &found, sizeof setup);
    TEST_ASSERT_EQUAL_HEX32(0xfffffffeu, sequence);
}

/* A record with a right CRC around one wrong byte must still be refused. */
static int unpack_with(size_t at, uint8_t value)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    stad_setup found;
    uint32_t sequence;
    stad_setup_pack(&setup, 1, bytes);
    bytes[at] = value;
    uint32_t crc = stad_crc32(bytes, STAD_SETUP_BYTES - 4);
    for (int i = 0; i < 4; i++)
        bytes[STAD_SETUP_BYTES - 4 + i] = (uint8_t)(crc >> (8 * i));
    return stad_setup_unpack(bytes, sizeof bytes, &found, &sequence);
}

void test_store_foreign_fields_are_refused(void)
{
    TEST_ASSERT_EQUAL(STAD_OK, unpack_with(0, 'S'));
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(0, 's'));   /* magic */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(4, 2));     /* version */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(6, 64));    /* length */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(13, 0x80)); /* width < 0 */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(15, 0x80)); /* height < 0 */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(16, 4));    /* mode */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(17, 2));    /* channels */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(18, 3));    /* origin */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(19, 2));    /* corrected */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(24, 4));    /* block even */
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, unpack_with(44, 1));    /* a correction without the flag */
}

void test_store_wild_correction_is_refused(void)
{
    const int32_t beyond[] = {16 * 65536 + 1, -16 * 65536 - 1, INT32_MAX, INT32_MIN};
    setup.corrected = 1;
    for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
        setup.rig.a_q16 = beyond[i];
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&setup));
        setup.rig.a_q16 = 0;
        setup.rig.b_q24 = beyond[i];
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&setup));
        setup.rig.b_q24 = 0;
        setup.rig.c_q24 = beyond[i];
        TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&setup));
        setup.rig.c_q24 = 0;
    }
    setup.rig.width = 319;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_setup_check(&setup));
}

void test_store_short_record_is_refused(void)
{
    uint8_t bytes[STAD_SETUP_BYTES];
    stad_setup found;
    uint32_t sequence;
    stad_setup_pack(&setup, 1, bytes);
    for (size_t n = 0; n < sizeof bytes; n++)
        TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_setup_unpack(bytes, n, &found, &sequence));
}

void test_store_blank_flash_holds_nothing(void)
{
    stad_setup found = setup;
    found.params.p1 = 4711;
    TEST_ASSERT_EQUAL(STAD_E_CORRUPT, stad_store_load(&flash, &found));
    TEST_ASSERT_EQUAL(4711, found.params.p1);
}

void test_store_saves_alternate_and_newest_wins(void)
{
    stad_setup found;
    for (int i = 0; i < 5; i++) {
        setup.params.p1 = (int16_t)(50 + i);
        TEST_ASSERT_EQUAL(i % 2, stad_store_save(&flash, &setup));
        TEST_ASSERT_EQUAL(i % 2, stad_store_load(&flash, &found));
        TEST_ASSERT_EQUAL(50 + i, found.params.p1);
    }
    TEST_ASSERT_EQUAL(STAD_SLOT_B, stad_store_load_slot(&flash, STAD_SLOT_B, &found));
    TEST_ASSERT_EQUAL(53, found.params.p1);
}

void test_store_factory_is_written_once_and_last_resort(void)
{
    stad_setup found;
    TEST_ASSERT_EQUAL(STAD_SLOT_FACTORY, stad_store_save_factory(&flash, &setup));
    TEST_ASSERT_EQUAL(STAD_E_STATE, stad_store_save_factory(&flash, &setup));
    TEST_ASSERT_EQUAL(STAD_SLOT_FACTORY, stad_store_load(&flash, &found));
    TEST_ASSERT_EQUAL(STAD_SLOT_A, stad_store_save(&flash, &setup));
    TEST_ASSERT_EQUAL(STAD_SLOT_A, stad_store_load(&flash, &found));
}

void test_store_bad_setup_is_not_saved(void)
{
    setup.params.block_size = 4;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_save(&flash, &setup));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_save_factory(&flash, &setup));
    TEST_ASSERT_EQUAL(0, sim.touched);
}

static void expect_refused(const stad_flash *f)
{
    stad_setup found;
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_load(f, &found));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_load_slot(f, 0, &found));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_save(f, &setup));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_save_factory(f, &setup));
}

void test_store_misdescribed_flash_is_refused(void)
{
    const uint32_t granules[] = {0, 3, 128};
    for (size_t i = 0; i < 3; i++) {
        stad_flash f = flash;
        f.program_bytes = granules[i];
        expect_refused(&f);
    }
    for (int i = 0; i < 3; i++) {
        stad_flash f = flash;
        f.slot_offset[i] = f.slot_offset[(i + 1) % 3];
        expect_refused(&f);
    }
    stad_flash f = flash;
    f.sector_bytes = 63;
    expect_refused(&f);
    f = flash;
    f.read = NULL;
    expect_refused(&f);
    f = flash;
    f.program = NULL;
    expect_refused(&f);
    f = flash;
    f.erase = NULL;
    expect_refused(&f);
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_load_slot(&flash, 3, &setup));
    TEST_ASSERT_EQUAL(STAD_E_PARAM, stad_store_load_slot(&flash, -1, &setup));
}

int main(void)
{
    UNITY_BEGIN();
    RUN_TEST(test_store_crc32_of_check_string_is_the_published_one);
    RUN_TEST(test_store_record_bytes_are_pinned);
    RUN_TEST(test_store_unpack_returns_what_was_packed);
    RUN_TEST(test_store_foreign_fields_are_refused);
    RUN_TEST(test_store_wild_correction_is_refused);
    RUN_TEST(test_store_short_record_is_refused);
    RUN_TEST(test_store_blank_flash_holds_nothing);
    RUN_TEST(test_store_saves_alternate_and_newest_wins);
    RUN_TEST(test_store_factory_is_written_once_and_last_resort);
    RUN_TEST(test_store_bad_setup_is_not_saved);
    RUN_TEST(test_store_misdescribed_flash_is_refused);
    return UNITY_END();
}
