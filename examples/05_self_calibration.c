/* SPDX-License-Identifier: MIT
 * examples/05_self_calibration.c - the loop of a board that tunes itself when the printed target comes into view.
 *
 *     stad scene -o recording --target --pgm --frames 10 --width 320 --height 240 --noise 30
 *     05_self_calibration 10 192 recording          (10 frames, focal length 192 px; without arguments: nothing to see)
 *
 * What a firmware does between two frames is in serve(): a request is asked for, done, and reported; nothing blocks. The
 * cameras are files here; without files they show nothing, and the run ends so. */
#include <stad/stad.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { W = 320, H = 240, D = 64, BLOCK = 11, P2 = 8192, CAP = 127, EVALUATIONS_A_FRAME = 8 };

#define MATCH_BYTES STAD_MATCH_BYTES(W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST)
#define WORK_BYTES  STAD_CALIB_WORK_BYTES(W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST)

typedef struct frame {
    uint8_t left[H][W], right[H][W];
} frame;

static stad_match live;
static stad_calib calib;
static stad_evaluator evaluator;
static uint8_t live_work[MATCH_BYTES] STAD_ALIGNED, calib_work[WORK_BYTES] STAD_ALIGNED;
static frame now, held[2];
static stad_setup stored; /* stands for the flash: see 04_store.c */
static int ill;           /* live frames of cameras at fault */

/* By enum stad_calib_outcome and enum stad_calib_fault. */
static const char *const outcome_words[] = {"none",     "sound",   "adopted",    "corrected",    "kept",     "rolled back",
                                            "no marks", "no pose", "rig failed", "camera fault", "cancelled"};
static const char *const fault_words[] = {"none",  "late", "black", "saturated", "flat",   "frozen", "swapped", "marks",
                                          "range", "rig",  "size",  "camera",    "moving", "same",   "match"};

static stad_image view(uint8_t (*pix)[W])
{
    return stad_image_packed(&pix[0][0], W, H, 1);
}

static int read_pgm(const char *folder, int i, const char *side, uint8_t (*pix)[W])
{
    char path[512];
    snprintf(path, sizeof path, "%s/%03d_%s.pgm", folder, i, side);
    FILE *in = fopen(path, "rb");
    int width = 0, height = 0, most = 0;
    const int fits = in && fscanf(in, "P5 %d %d %d", &width, &height, &most) == 3 && width == W && height == H && most == 255;
    const int ok = fits && fgetc(in) != EOF && fread(pix, 1, (size_t)W * H, in) == (size_t)W * H;
    if (in)
        fclose(in);
    if (!ok)
        fprintf(stderr, "%s: %s\n", path, in ? "no whole PGM of 320 x 240 and 255 greys" : "cannot be opened");
    return ok;
}

/* A live frame: matched row by row with the set in use, its right view corrected on the way, and counted. */
static void match_live(void)
{
    const stad_setup *in_use = stad_calib_setup(&calib);
    const stad_image left = view(now.left), right = view(now.right);
    uint8_t straight[W];
    int16_t disp_q4[W];
    if (stad_calib_live(&calib, &left, &right) != STAD_FAULT_NONE)
        ill++; /* told at once, whatever the calibration does: black, frozen, dead, ... */
    stad_match_begin(&live, &in_use->params);
    for (int y = 0; y < H; y++) {
        if (in_use->corrected)
            stad_rig_row(&in_use->rig, &right, y, straight);
        stad_match_push(&live, now.left[y], in_use->corrected ? straight : now.right[y]);
        while (stad_match_pull(&live, disp_q4) >= 0)
            ; /* the application's use of the row */
    }
    stad_calib_counts(&calib, stad_match_counts_of(&live));
}

/* Does what the calibration wants, as much as there is time for. */
static void serve(void)
{
    stad_request r;
    int evaluations = EVALUATIONS_A_FRAME, given = 0;
    while (stad_calib_want(&calib, &r) != STAD_WANT_NOTHING) {
        if (r.want == STAD_WANT_FRAME) {
            const stad_image left = view(now.left), right = view(now.right);
            if (given++)
                return; /* one look a frame */
            if (stad_calib_frame(&calib, &left, &right, calib_work, sizeof calib_work) == 1)
                held[r.hold] = now;
        } else if (r.want == STAD_WANT_MATCH) {
            const stad_image left = view(held[r.hold].left), right = view(held[r.hold].right);
            if (evaluations-- == 0)
                return;
            stad_calib_cost(&calib, stad_calib_evaluate(&calib, &r, &evaluator, &left, &right, calib_work, sizeof calib_work));
        } else {
            stored = *stad_calib_setup(&calib);
            stad_calib_saved(&calib, STAD_OK);
        }
    }
}

static int start(double focal_px)
{
    const stad_geometry geometry = {W, H, 1, D, BLOCK, P2, CAP, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_camera camera = {(int32_t)(focal_px * 256), (W - 1) * 128, (H - 1) * 128};
    stad_calib_config config;
    stored.width = W;
    stored.height = H;
    stored.channels = 1;
    stad_params_sample(&stored.params, D, 3, 1);
    stad_rig_identity(&stored.rig, W, H);
    stad_calib_config_default(&config, &geometry, stad_target_relief(), &camera);
    config.patience = 8;
    config.budget = 40;
    config.probation_frames = 0; /* keep the page short: adopt without a second look */
    return stad_match_init(&live, &geometry, live_work, sizeof live_work) == STAD_OK &&
           stad_calib_init(&calib, &config, &stored) == STAD_OK && stad_calib_start(&calib) == STAD_OK;
}

int main(int argc, char **argv)
{
    int frames = argc > 2 ? atoi(argv[1]) : 12;
    if (!start(argc > 2 ? atof(argv[2]) : 192))
        return 1;
    for (int i = 0; i < frames; i++) {
        memset(&now, 128 + i % 2, sizeof now); /* a camera with nothing before it */
        if (argc > 3 && (!read_pgm(argv[3], i, "left", now.left) || !read_pgm(argv[3], i, "right", now.right)))
            return 1;
        match_live();
        serve();
    }

    const stad_calib_report *r = stad_calib_report_of(&calib);
    printf("%d live frames of cameras at fault\n", ill);
    printf("outcome: %s, fault: %s, %d evaluations", outcome_words[r->outcome], fault_words[r->fault], r->evaluations);
    if (r->judge_before_q20 >= 0) /* measured */
        printf(", other pose %.2f -> %.2f %%", 100.0 * r->judge_before_q20 / STAD_COST_ONE,
               100.0 * r->judge_after_q20 / STAD_COST_ONE);
    printf("; stored: p1 %d, p2 %d, block %d\n", stored.params.p1, stored.params.p2, stored.params.block_size);
    if (argc > 3)
        return ill == 0 && r->outcome == STAD_CALIB_ADOPTED && r->judge_after_q20 < r->judge_before_q20 ? 0 : 1;
    return r->outcome == STAD_CALIB_FAULT || r->outcome == STAD_CALIB_NO_MARKS ? 0 : 1;
}
