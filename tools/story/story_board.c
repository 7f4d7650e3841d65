/* SPDX-License-Identifier: MIT
 * frames -> [story/story_board.c] -> setup - what a firmware does with the library: match live frames, turn the pump,
 * keep flash. */
#include "story.h"

#include <stdlib.h>
#include <string.h>

/* -- flash ------------------------------------------------------------------------------------------------------- */

static uint8_t *flash_at(void *user, uint32_t offset)
{
    return (uint8_t *)user + offset;
}

static int flash_read(void *user, uint32_t offset, void *bytes, uint32_t count)
{
    memcpy(bytes, flash_at(user, offset), count);
    return 0;
}

static int flash_program(void *user, uint32_t offset, const void *bytes, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        flash_at(user, offset)[i] &= ((const uint8_t *)bytes)[i]; /* programming only clears bits */
    return 0;
}

static int flash_erase(void *user, uint32_t offset)
{
    memset(flash_at(user, offset), 0xff, STORY_SECTOR);
    return 0;
}

/* -- power on ---------------------------------------------------------------------------------------------------- */

static stad_setup factory_setup(void)
{
    stad_setup s;
    memset(&s, 0, sizeof s);
    s.width = STORY_WIDTH;
    s.height = STORY_HEIGHT;
    s.channels = 1;
    stad_params_sample(&s.params, STORY_DISPARITIES, 3, 1);
    stad_rig_identity(&s.rig, STORY_WIDTH, STORY_HEIGHT);
    return s;
}

int story_board_reset(story_board *b)
{
    stad_setup setup;
    stad_calib_config config;
    target_camera camera = story_camera(0); /* as calibrated once; what happened since is not known */
    stad_camera fixed = target_camera_fixed(&camera);
    memset(&b->calib, 0, sizeof b->calib);
    int slot = stad_store_load(&b->flash, &setup);
    if (slot < 0)
        return slot;
    stad_calib_config_default(&config, &b->geometry, stad_target_relief(), &fixed);
    config.patience = 12; /* frames of a failing camera that are enough for a story */
    int status = stad_calib_init(&b->calib, &config, &setup);
    return status < 0 ? status : slot;
}

static int take_memory(story_board *b, tool_fail *f)
{
    size_t frame = stad_calib_frame_bytes(STORY_WIDTH, STORY_HEIGHT), match = stad_calib_evaluate_bytes(&b->geometry);
    b->work_bytes = (frame > match ? frame : match) / STAD_ALIGN * STAD_ALIGN + STAD_ALIGN;
    if (posix_memalign(&b->work, STAD_ALIGN, b->work_bytes) != 0)
        return tool_fail_set(f, TOOL_FILE, "no memory");
    picture *const pictures[] = {&b->held[0].left, &b->held[0].right, &b->held[1].left, &b->held[1].right,
                                 &b->fresh.left,   &b->fresh.right,   &b->corrected};
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++)
        if (picture_alloc(pictures[i], STORY_WIDTH, STORY_HEIGHT, 1, f) != TOOL_OK)
            return f->status;
    return engine_open(&b->engine, &b->geometry, f);
}

int story_board_start(story_board *b, tool_fail *f)
{
    const stad_geometry g = {STORY_WIDTH, STORY_HEIGHT, 1, STORY_DISPARITIES, 11, 8192, 127, STAD_MODE_SGBM, STAD_MEMORY_FAST};
    const stad_flash flash = {
        flash_read, flash_program, flash_erase, b->flash_bytes, {0, STORY_SECTOR, 2 * STORY_SECTOR}, STORY_SECTOR, 8};
    stad_setup setup = factory_setup();
    b->geometry = g;
    b->flash = flash;
    memset(b->flash_bytes, 0xff, sizeof b->flash_bytes);
    if (take_memory(b, f) != TOOL_OK)
        return f->status;
    if (stad_store_save_factory(&b->flash, &setup) < 0 || story_board_reset(b) < 0)
        return tool_fail_set(f, TOOL_REFUSED, "the board does not start");
    return TOOL_OK;
}

void story_board_free(story_board *b)
{
    engine_close(&b->engine);
    free(b->work);
    picture_free(&b->fresh.left);
    picture_free(&b->fresh.right);
    picture_free(&b->corrected);
    for (int i = 0; i < 2; i++) {
        picture_free(&b->held[i].left);
        picture_free(&b->held[i].right);
    }
}

/* -- a frame ----------------------------------------------------------------------------------------------------- */

void story_correct(const stad_rig *rig, const picture *right, picture *out)
{
    const stad_image raw = picture_view(right);
    for (int y = 0; y < raw.height; y++)
        stad_rig_row(rig, &raw, y, out->pix + (size_t)y * (size_t)raw.width);
}

static int match(story_board *b, const story_frame *frame, const stad_params *p, const stad_rig *rig, disparity *d, tool_fail *f)
{
    story_correct(rig, &frame->right, &b->corrected);
    return engine_run(&b->engine, p, &frame->left, &b->corrected, d, NULL, f);
}

int story_board_live(story_board *b, const story_frame *frame, tool_fail *f)
{
    disparity d;
    const stad_setup *setup = stad_calib_setup(&b->calib);
    memset(&d, 0, sizeof d);
    int status = match(b, frame, &setup->params, &setup->rig, &d, f);
    disparity_free(&d);
    if (status != TOOL_OK)
        return status;
    b->frames++;
    stad_calib_counts(&b->calib, stad_match_counts_of(&b->engine.match));
    return TOOL_OK;
}

int story_add_bad(story_board *b, const story_world *w, const story_frame *frame, const stad_setup *setup, disparity *d,
                  double *bad, tool_fail *f)
{
    stad_score score;
    stad_score_config config;
    const stad_params *p = &setup->params;
    if (match(b, frame, p, &setup->rig, d, f) != TOOL_OK)
        return f->status;
    stad_score_config_init(&config, STAD_SCORE_BAD, p->min_disparity, p->num_disparities);
    stad_score_begin(&score, &config);
    for (int y = 0; y < STORY_HEIGHT; y++) {
        const ptrdiff_t at = (ptrdiff_t)y * STORY_WIDTH;
        stad_score_row(&score, y, d->q4 + at, w->truth_q16[frame->pose] + at, w->rest[frame->pose] + at, STORY_WIDTH);
    }
    *bad += 100.0 * stad_score_end(&score) / STAD_COST_ONE;
    return TOOL_OK;
}

/* -- the pump ---------------------------------------------------------------------------------------------------- */

/* Somebody moves the target when the board asks for another pose, and again later. */
static int pose_for(const stad_calib *c)
{
    switch (stad_calib_report_of(c)->phase) {
    case STAD_CALIB_OTHER:
        return 1;
    case STAD_CALIB_CONFIRM:
        return 2;
    case STAD_CALIB_RECHECK:
        return 3;
    default:
        return 0;
    }
}

int story_board_turn(story_board *b, story_world *w)
{
    stad_request r;
    int want = stad_calib_want(&b->calib, &r);
    if (want == STAD_WANT_FRAME) {
        /* Held pairs stay as they are while a correction is confirmed. */
        const int confirms = stad_calib_report_of(&b->calib)->phase == STAD_CALIB_CONFIRM;
        story_frame *frame = confirms ? &b->fresh : &b->held[r.hold];
        story_expose(w, pose_for(&b->calib), frame);
        const stad_image left = picture_view(&frame->left), right = picture_view(&frame->right);
        stad_calib_frame(&b->calib, &left, &right, b->work, b->work_bytes);
        b->frames++;
    } else if (want == STAD_WANT_MATCH) {
        const story_frame *frame = &b->held[r.hold];
        const stad_image left = picture_view(&frame->left), right = picture_view(&frame->right);
        stad_calib_cost(&b->calib, stad_calib_evaluate(&b->calib, &r, &b->evaluator, &left, &right, b->work, b->work_bytes));
        b->matches++;
    } else if (want == STAD_WANT_SAVE) {
        stad_calib_saved(&b->calib, stad_store_save(&b->flash, stad_calib_setup(&b->calib)));
        b->saves++;
    }
    return want;
}
