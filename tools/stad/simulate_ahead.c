/* SPDX-License-Identifier: MIT
 * stad/simulate_ahead.c - frames read and matched ahead of their turn, some at a time. */
#include "simulate_ahead.h"

#include <stdlib.h>
#include <string.h>

static void forget(ahead_frame *a)
{
    picture_free(&a->left);
    picture_free(&a->right);
    a->number = -1;
}

static int read_frame(ahead_frame *a, tool_fail *f)
{
    const recording *r = a->job->frames;
    const stad_geometry *g = &a->engine.geometry;
    int status = recording_read(r, a->number, a->job->color, &a->left, &a->right, f);
    if (status == TOOL_OK && (a->left.width != g->width || a->left.height != g->height))
        status = tool_fail_set(f, TOOL_FILE, "%s: frame %d is %d x %d, those before were %d x %d", r->where, a->number,
                               a->left.width, a->left.height, g->width, g->height);
    return status ? status : degrade_pair(a->job->bad, a->number, &a->left, &a->right, f);
}

/* The right view as the setup corrects it. */
static int corrected(const ahead_frame *a, picture *out, tool_fail *f)
{
    const picture *right = &a->right;
    const stad_image image = picture_view(right);
    int status = picture_alloc(out, right->width, right->height, right->channels, f);
    size_t row = (size_t)right->width * (size_t)right->channels;
    if (status == TOOL_OK && !a->setup.corrected)
        memcpy(out->pix, right->pix, row * (size_t)right->height);
    for (int y = 0; y < right->height && status == TOOL_OK && a->setup.corrected; y++)
        if (stad_rig_row(&a->setup.rig, &image, y, out->pix + (size_t)y * row) != STAD_OK)
            status = tool_fail_set(f, TOOL_FILE, "the correction in use does not fit the frames");
    return status;
}

static int match_frame(ahead_frame *a, tool_fail *f)
{
    picture straight = {0};
    disparity d = {0};
    int status = corrected(a, &straight, f);
    if (status == TOOL_OK)
        status = engine_run(&a->engine, &a->setup.params, &a->left, &straight, &d, NULL, f);
    if (status == TOOL_OK)
        a->counts = *stad_match_counts_of(&a->engine.match);
    picture_free(&straight);
    disparity_free(&d);
    return status;
}

static void *work_on(void *frame)
{
    ahead_frame *a = frame;
    memset(&a->fail, 0, sizeof a->fail);
    a->status = a->left.pix ? TOOL_OK : read_frame(a, &a->fail);
    if (a->status == TOOL_OK)
        a->status = match_frame(a, &a->fail);
    return NULL;
}

/* A thread for each frame but the last, which this one does itself, with any that had no thread to be had. */
static void work_on_all(ahead *a, int count)
{
    int started = 0;
    while (started < count - 1 && pthread_create(&a->thread[started], NULL, work_on, a->todo[started]) == 0)
        started++;
    for (int k = started; k < count; k++)
        work_on(a->todo[k]);
    for (int k = 0; k < started; k++)
        pthread_join(a->thread[k], NULL);
}

static int done_with(const ahead_frame *a, int number, const stad_setup *setup)
{
    return a->number == number && (!a->left.pix || memcmp(&a->setup, setup, sizeof *setup) == 0);
}

/* Frames from i on, as many as there are slots; a picture that is there already is kept. */
static void next_round(ahead *a, int i, const stad_setup *setup)
{
    int count = 0;
    for (int k = i; k < i + a->jobs && k < a->job.end; k++) {
        ahead_frame *slot = &a->frame[k % a->jobs];
        if (done_with(slot, k, setup))
            continue;
        if (slot->number != k)
            forget(slot);
        slot->number = k;
        slot->setup = *setup;
        a->todo[count++] = slot;
    }
    work_on_all(a, count);
}

const ahead_frame *ahead_take(ahead *a, int i, const stad_setup *setup)
{
    ahead_frame *slot = &a->frame[i % a->jobs];
    if (!done_with(slot, i, setup))
        next_round(a, i, setup);
    return slot;
}

int ahead_open(ahead *a, const ahead_job *job, int jobs, const stad_geometry *g, tool_fail *f)
{
    int status = TOOL_OK;
    a->job = *job;
    a->jobs = jobs;
    a->frame = calloc((size_t)jobs, sizeof *a->frame);
    a->todo = calloc((size_t)jobs, sizeof *a->todo);
    a->thread = calloc((size_t)jobs, sizeof *a->thread);
    if (!a->frame || !a->todo || !a->thread)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for %d frames at a time", jobs);
    for (int k = 0; k < jobs && status == TOOL_OK; k++) {
        a->frame[k].number = -1;
        a->frame[k].job = &a->job;
        status = engine_open(&a->frame[k].engine, g, f);
    }
    return status;
}

void ahead_close(ahead *a)
{
    for (int k = 0; k < a->jobs && a->frame; k++) {
        forget(&a->frame[k]);
        engine_close(&a->frame[k].engine);
    }
    free(a->frame);
    free(a->todo);
    free(a->thread);
}
