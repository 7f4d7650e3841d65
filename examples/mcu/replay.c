/* SPDX-License-Identifier: MIT
 * examples/mcu/replay.c - the firmware as it is meant to live, on frames that the host lends it
 *
 *     host's frame -> match by rows -> monitor -> marks -> tune -> better on another pose? -> flash -> reset -> restored
 *
 * Frames are recording/NNN_left.pgm and _right.pgm beneath the folder it is started in:
 *     stad scene -o recording --target --pgm --share 60 --frames 20 --width 160 --height 120 --num-disparities 32 --noise 8
 * Memory holds three pairs, the two that the calibration keeps and the fresh one, and one workspace that the live matcher,
 * the search for marks and the evaluations use in turn: it all fits the 192 KB of the smallest board. Ends with 0 when the
 * run ended in an adopted set, that set was found after the reset, and all is as on the host. */
#include <string.h>

#include "board.h"
#include "chip.h"
#include "expected.h"
#include "hash.h"
#include "say.h"
#include "stad/stad.h"

enum { WIDTH = 160, HEIGHT = 120, DISPARITIES = 32, BLOCK = 11, P2 = 8192, CAP = 63, FOCAL = 96, BUDGET = 12, FRAMES = 20 };
enum { WORK_BYTES = STAD_CALIB_WORK_BYTES(WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL) };

static const stad_geometry geometry = {WIDTH, HEIGHT, 1, DISPARITIES, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_SMALL};
static const char header[] = "P5\n160 120\n255\n";

typedef struct picture {
    uint8_t header[sizeof header - 1], pix[HEIGHT * WIDTH];
} picture;
typedef struct frame {
    picture left, right;
} frame;

/* The board's memory; only the flash chip outlives a reset. */
static STAD_ALIGNED uint8_t work[WORK_BYTES];
static frame fresh, held[2];
static stad_match live;
static stad_calib calib;
static stad_evaluator evaluator;

static int read_picture(int number, const char *side, picture *p)
{
    char path[40] = "recording/000_";
    char *to = path + 14;
    path[11] = (char)('0' + number / 10 % 10);
    path[12] = (char)('0' + number % 10);
    while ((*to++ = *side++) != '\0') {
    }
    return board_read_file(path, p, sizeof *p) == sizeof *p && memcmp(p->header, header, sizeof p->header) == 0;
}

static int read_frame(int number)
{
    return read_picture(number, "left.pgm", &fresh.left) && read_picture(number, "right.pgm", &fresh.right);
}

static stad_image image_of(const picture *p)
{
    return stad_image_packed(p->pix, WIDTH, HEIGHT, 1);
}

/* A live frame by rows with the set in use, its right view corrected on the way, and counted; the disparity's hash. */
static uint32_t match_live(const stad_setup *setup)
{
    const stad_image view = image_of(&fresh.right);
    static uint8_t straight[WIDTH];
    static int16_t disp_q4[WIDTH];
    uint32_t hash = HASH_START;
    int y;
    if (stad_match_init(&live, &geometry, work, sizeof work) != STAD_OK || stad_match_begin(&live, &setup->params) != STAD_OK)
        return 0;
    for (y = 0; y < HEIGHT; y++) {
        stad_rig_row(&setup->rig, &view, y, straight);
        stad_match_push(&live, fresh.left.pix + y * WIDTH, setup->corrected ? straight : fresh.right.pix + y * WIDTH);
        while (stad_match_pull(&live, disp_q4) >= 0)
            hash = hash_row(hash, disp_q4, WIDTH);
    }
    return hash;
}

/* Shows the fresh frame to the calibration and keeps it where that is wanted. */
static void show(const stad_request *wish)
{
    const stad_image left = image_of(&fresh.left), right = image_of(&fresh.right);
    if (stad_calib_frame(&calib, &left, &right, work, sizeof work) == 1)
        held[wish->hold] = fresh;
}

static int32_t evaluate(const stad_request *wish)
{
    const stad_image left = image_of(&held[wish->hold].left), right = image_of(&held[wish->hold].right);
    return stad_calib_evaluate(&calib, wish, &evaluator, &left, &right, work, sizeof work);
}

/* Does what the calibration wants until it wants another frame. */
static void serve(void)
{
    stad_request wish;
    int looked = 0;
    while (stad_calib_want(&calib, &wish) != STAD_WANT_NOTHING) {
        if (wish.want == STAD_WANT_FRAME) {
            if (looked++)
                return;
            show(&wish);
        } else if (wish.want == STAD_WANT_MATCH) {
            stad_calib_cost(&calib, evaluate(&wish));
        } else {
            stad_calib_saved(&calib, stad_store_save(&chip_flash, stad_calib_setup(&calib)));
        }
    }
}

/* From reset: with what flash holds (*restored), or the defaults. */
static int start(stad_setup *setup, int *restored)
{
    const stad_camera camera = {FOCAL * 256, (WIDTH - 1) * 128, (HEIGHT - 1) * 128};
    stad_calib_config config;
    *restored = stad_store_load(&chip_flash, setup) >= 0;
    if (!*restored) {
        memset(setup, 0, sizeof *setup);
        setup->width = WIDTH;
        setup->height = HEIGHT;
        setup->channels = 1;
        stad_params_sample(&setup->params, DISPARITIES, 3, 1);
        stad_rig_identity(&setup->rig, WIDTH, HEIGHT);
    }
    stad_calib_config_default(&config, &geometry, stad_target_relief(), &camera);
    config.budget = BUDGET;
    config.probation_frames = 0;
    say(*restored ? "flash holds a set: restored\n" : "flash is empty: defaults\n");
    return stad_calib_init(&calib, &config, setup) == STAD_OK;
}

/* Every frame through matcher, monitor and calibration; the hash of all disparities. */
static uint32_t live_frames(uint32_t hash)
{
    int number;
    for (number = 0; number < FRAMES && read_frame(number); number++) {
        if (number == 1)
            stad_calib_start(&calib);
        hash = hash_add(hash, match_live(stad_calib_setup(&calib)), 4);
        stad_calib_counts(&calib, stad_match_counts_of(&live));
        serve();
    }
    return number == FRAMES ? hash : 0;
}

static void reset(void)
{
    memset(work, 0, sizeof work);
    memset(&fresh, 0, sizeof fresh);
    memset(held, 0, sizeof held);
    memset(&live, 0, sizeof live);
    memset(&calib, 0, sizeof calib);
    memset(&evaluator, 0, sizeof evaluator);
}

static void report(const stad_calib_report *r)
{
    say("run: outcome ");
    say_dec(r->outcome);
    say(", ");
    say_dec(r->evaluations);
    say(" evaluations, other pose ");
    say_dec(r->judge_before_q20 / 105);
    say(" -> ");
    say_dec(r->judge_after_q20 / 105);
    say(" in 10000\n");
}

int main(void)
{
    stad_setup first, found;
    uint32_t hash;
    int good, restored, outcome;
    chip_new();
    if (!read_frame(0)) {
        say("no recording here\n");
        return 2;
    }
    good = start(&first, &restored) && !restored;
    hash = live_frames(HASH_START);
    outcome = stad_calib_report_of(&calib)->outcome;
    report(stad_calib_report_of(&calib));
    reset();
    good &= start(&found, &restored) && restored && memcmp(&found.params, &first.params, sizeof found.params) != 0;
    good &= read_frame(0);
    hash = hash_add(hash, match_live(&found), 4);
    say("replay: ");
    say_hex(hash);
    say(hash == EXPECT_REPLAY ? " ok\n" : " WRONG\n");
    good &= outcome == STAD_CALIB_ADOPTED && hash == EXPECT_REPLAY;
    say_dec((int32_t)board_stack_used());
    say(" bytes of stack\n");
    say(good ? "done\n" : "failed\n");
    return good ? 0 : 1;
}
