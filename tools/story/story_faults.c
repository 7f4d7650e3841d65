/* SPDX-License-Identifier: MIT
 * story/story_faults.c - cameras that fail in front of a sound target: what the board says of them, at once and in a run. */
#include <string.h>

#include "story.h"

#define PIXELS ((size_t)STORY_WIDTH * STORY_HEIGHT)
#define ROWS   12 /* by which the right view's are shifted */

static void black(story_frame *f)
{
    memset(f->left.pix, 4, PIXELS);
    memset(f->right.pix, 4, PIXELS);
}

static void saturated(story_frame *f)
{
    memset(f->left.pix, 255, PIXELS);
    memset(f->right.pix, 255, PIXELS);
}

static void one_dead(story_frame *f)
{
    memset(f->right.pix, 128, PIXELS);
}

static void swapped(story_frame *f)
{
    picture left = f->left;
    f->left = f->right;
    f->right = left;
}

static void one_for_both(story_frame *f)
{
    memcpy(f->right.pix, f->left.pix, PIXELS);
}

static void rows_shifted(story_frame *f)
{
    memmove(f->right.pix + (size_t)ROWS * STORY_WIDTH, f->right.pix, PIXELS - (size_t)ROWS * STORY_WIDTH);
}

static const struct {
    const char *name;
    void (*spoil)(story_frame *); /* NULL: the same frame again and again */
} kinds[STORY_FAULTS] = {{"black", black},
                         {"saturated", saturated},
                         {"frozen", NULL},
                         {"swapped", swapped},
                         {"one dead", one_dead},
                         {"one for both", one_for_both},
                         {"rows shifted", rows_shifted}};

/* A run in front of such cameras, to its end. */
static void run(story_board *b, story_world *w, int kind, story_frame *frame, story_fault *told)
{
    stad_request r;
    told->live = STAD_FAULT_NONE;
    story_expose(w, 0, frame);
    stad_calib_start(&b->calib);
    while (stad_calib_want(&b->calib, &r) == STAD_WANT_FRAME) {
        if (kinds[kind].spoil) {
            story_expose(w, 0, frame);
            kinds[kind].spoil(frame);
        }
        const stad_image left = picture_view(&frame->left), right = picture_view(&frame->right);
        int live = stad_calib_live(&b->calib, &left, &right);
        told->live = live != STAD_FAULT_NONE ? live : told->live;
        stad_calib_frame(&b->calib, &left, &right, b->work, b->work_bytes);
    }
}

int story_fault_of(story_board *b, story_world *w, int kind, story_frame *frame, story_fault *told)
{
    int status = story_board_reset(b);
    if (status < 0)
        return status;
    const stad_setup before = *stad_calib_setup(&b->calib);
    run(b, w, kind, frame, told);
    const stad_calib_report *report = stad_calib_report_of(&b->calib);
    told->name = kinds[kind].name;
    told->fault = report->fault;
    told->outcome = report->outcome;
    told->adopted = memcmp(&before, stad_calib_setup(&b->calib), sizeof before) != 0;
    return STAD_OK;
}
