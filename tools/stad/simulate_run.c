/* SPDX-License-Identifier: MIT
 * stad/simulate_run.c - plays a board: every frame is matched and counted, and what the calibration asks for is done. */
#include <stdlib.h>
#include <string.h>

#include "../common/whole_file.h"
#include "interrupt.h"
#include "simulate.h"
#include "simulate_flash.h"
#include "tool.h"

/* The library's own bounds of the search, so that nothing is refused for want of memory. */
#define MAX_BLOCK 11
#define MAX_P2    8192
#define MAX_CAP   127

static int at_least(int v, int least)
{
    return v < least ? least : v;
}

static stad_geometry geometry_of(const simulation *s, const stad_params *p, const picture *left)
{
    stad_geometry g =
        engine_geometry(p, match_options_mode(&s->options), s->options.memory, left->width, left->height, left->channels);
    g.max_block_size = (int16_t)at_least(g.max_block_size, MAX_BLOCK);
    g.max_p2 = (int16_t)at_least(g.max_p2, MAX_P2);
    g.max_pre_filter_cap = (int16_t)at_least(g.max_pre_filter_cap, MAX_CAP);
    return g;
}

static int start_calib(simulation *s, const stad_geometry *g, const picture *left, tool_fail *f)
{
    stad_calib_config config;
    stad_camera camera =
        tool_camera(s->rig.focal_px > 0 ? s->rig.focal_px : left->width, s->cx, s->cy, left->width, left->height);
    stad_calib_config_default(&config, g, stad_target_relief(), &camera);
    config.cost = (uint8_t)s->cost;
    if (s->budget)
        config.budget = (int16_t)s->budget;
    if (s->learn_frames)
        config.monitor.learn_frames = (int16_t)s->learn_frames;
    if (s->probation_frames >= 0)
        config.probation_frames = (int16_t)s->probation_frames;
    if (stad_calib_frame_bytes(g->width, g->height) == 0)
        return tool_fail_set(f, TOOL_USAGE, "frames of %d x %d px: the board takes 16 to %d px a side", g->width, g->height,
                             STAD_MARK_MAX_SIZE);
    int status = stad_calib_init(&s->calib, &config, &s->initial);
    if (status != STAD_OK)
        return tool_fail_set(f, TOOL_USAGE, "no board for frames of %d x %d px, --focal %g, --center %g,%g: %s", g->width,
                             g->height, s->rig.focal_px, s->cx, s->cy, stad_status_name(status));
    return TOOL_OK;
}

static int take_work(simulation *s, const stad_geometry *g, tool_fail *f)
{
    size_t marks = stad_calib_frame_bytes(g->width, g->height), match = stad_calib_evaluate_bytes(g);
    s->work_bytes = ((marks > match ? marks : match) + STAD_ALIGN - 1) / STAD_ALIGN * STAD_ALIGN;
    if (posix_memalign(&s->work, STAD_ALIGN, s->work_bytes))
        s->work = NULL;
    s->rows = calloc((size_t)s->end, sizeof *s->rows);
    return s->work && s->rows ? TOOL_OK : tool_fail_set(f, TOOL_FILE, "not enough memory for the simulated board");
}

/* Everything that the first frame's size decides. */
static int set_up(simulation *s, const picture *left, tool_fail *f)
{
    stad_params p;
    int status = match_options_params(&s->options, left->width, left->channels, &p, f);
    if (status)
        return status;
    stad_geometry g = geometry_of(s, &p, left);
    const ahead_job job = {&s->frames, &s->bad, s->options.color, s->end};
    s->geometry = g;
    status = ahead_open(&s->ahead, &job, (int)s->jobs, &g, f);
    if (status == TOOL_OK)
        status = take_work(s, &g, f);
    memset(&s->initial, 0, sizeof s->initial);
    s->initial.width = g.width;
    s->initial.height = g.height;
    s->initial.mode = g.mode;
    s->initial.channels = (uint8_t)g.channels;
    s->initial.params = p;
    stad_rig_identity(&s->initial.rig, g.width, g.height);
    sim_flash_init(&s->flash);
    return status ? status : start_calib(s, &g, left, f);
}

/* What the monitor makes of a frame that was matched. */
static void count_live(simulation *s, const ahead_frame *frame, sim_row *row)
{
    const stad_image left = picture_view(&frame->left), right = picture_view(&frame->right);
    row->live = stad_calib_live(&s->calib, &left, &right);
    row->params = frame->setup.params;
    row->counts = frame->counts;
    row->state = stad_calib_counts(&s->calib, &row->counts);
    row->share = row->counts.considered > 0 ? (double)row->counts.firm / row->counts.considered : 0;
    s->alarms += row->state == STAD_MONITOR_DEGRADED;
}

static int hold(picture *to, const picture *from, tool_fail *f)
{
    picture_free(to);
    int status = picture_alloc(to, from->width, from->height, from->channels, f);
    if (status == TOOL_OK)
        memcpy(to->pix, from->pix, (size_t)from->width * (size_t)from->height * (size_t)from->channels);
    return status;
}

static int give_frame(simulation *s, const stad_request *r, const picture *left, const picture *right, tool_fail *f)
{
    const stad_image l = picture_view(left), rt = picture_view(right);
    if (stad_calib_frame(&s->calib, &l, &rt, s->work, s->work_bytes) != 1)
        return TOOL_OK;
    int status = hold(&s->held[r->hold][0], left, f);
    return status ? status : hold(&s->held[r->hold][1], right, f);
}

static void evaluate(simulation *s, const stad_request *r)
{
    const stad_image l = picture_view(&s->held[r->hold][0]), rt = picture_view(&s->held[r->hold][1]);
    stad_calib_cost(&s->calib, stad_calib_evaluate(&s->calib, r, &s->evaluator, &l, &rt, s->work, s->work_bytes));
}

/* Room for one more run, twice as much whenever there is none. */
static int make_room(simulation *s, tool_fail *f)
{
    if (s->run_count < s->run_room)
        return TOOL_OK;
    const int room = s->run_room ? 2 * s->run_room : 16;
    sim_run *runs = realloc(s->runs, (size_t)room * sizeof *runs);
    if (!runs)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for %d runs", room);
    s->runs = runs;
    s->run_room = room;
    return TOOL_OK;
}

/* Notes an outcome when it appears; it is `none` again while the next run is under way. */
static int note_run(simulation *s, int frame, tool_fail *f)
{
    const stad_calib_report *ended = stad_calib_report_of(&s->calib);
    int news = ended->outcome != s->last_outcome && ended->outcome != STAD_CALIB_NONE;
    s->last_outcome = ended->outcome;
    int status = news ? make_room(s, f) : TOOL_OK;
    if (!news || status)
        return status;
    sim_run *run = &s->runs[s->run_count++];
    run->frame = frame;
    run->report = *ended;
    run->setup = *stad_calib_setup(&s->calib);
    return TOOL_OK;
}

/* Does what is asked for, up to so many evaluations; the pictures are this frame's, or NULL when there is none. */
static int serve(simulation *s, int frame, const picture *left, const picture *right, long evaluations, tool_fail *f)
{
    stad_request r;
    int status = TOOL_OK, given = 0;
    while (status == TOOL_OK && !interrupt_seen() && stad_calib_want(&s->calib, &r) != STAD_WANT_NOTHING) {
        if (r.want == STAD_WANT_FRAME && (given || !left || s->rig.focal_px <= 0))
            break;
        if (r.want == STAD_WANT_MATCH && evaluations-- <= 0)
            break;
        if (r.want == STAD_WANT_FRAME)
            status = give_frame(s, &r, left, right, f);
        else if (r.want == STAD_WANT_MATCH)
            evaluate(s, &r);
        else
            stad_calib_saved(&s->calib, stad_store_save(&s->flash.flash, stad_calib_setup(&s->calib)));
        given |= r.want == STAD_WANT_FRAME;
        if (status == TOOL_OK)
            status = note_run(s, frame, f);
    }
    return status;
}

/* Where the calibration stands after a frame. */
static void note_stand(const simulation *s, sim_row *row)
{
    row->phase = stad_calib_report_of(&s->calib)->phase;
    row->fault = stad_calib_report_of(&s->calib)->fault;
}

static int play(simulation *s, int i, tool_fail *f)
{
    sim_row *row = &s->rows[s->row_count];
    const ahead_frame *frame = ahead_take(&s->ahead, i, stad_calib_setup(&s->calib));
    int status = frame->status;
    *f = frame->fail;
    if (status == TOOL_OK && i == s->calibrate_at)
        stad_calib_start(&s->calib);
    if (status == TOOL_OK)
        count_live(s, frame, row);
    if (status == TOOL_OK)
        status = note_run(s, i, f);
    if (status == TOOL_OK)
        status = serve(s, i, &frame->left, &frame->right, s->evaluations_per_frame, f);
    row->frame = i;
    note_stand(s, row);
    return status;
}

/* A frame that cannot be had: what a board sees as a late one. */
static int miss(simulation *s, int i, tool_fail *f)
{
    stad_request r;
    sim_row *row = &s->rows[s->row_count];
    memset(row, 0, sizeof *row);
    if (stad_calib_want(&s->calib, &r) == STAD_WANT_FRAME)
        stad_calib_frame(&s->calib, NULL, NULL, s->work, s->work_bytes);
    row->frame = i;
    row->skipped = 1;
    row->live = stad_calib_live(&s->calib, NULL, NULL);
    note_stand(s, row);
    row->params = stad_calib_setup(&s->calib)->params;
    s->skipped++;
    return note_run(s, i, f);
}

static void show_progress(const simulation *s, int done, double start)
{
    double seconds = tool_seconds() - start, rate = seconds > 0 ? done / seconds : 0;
    progress_line("%d / %d frames, %.1f a second, %.0f s left, %s", done, s->end, rate, rate > 0 ? (s->end - done) / rate : 0.0,
                  calib_phase_name(stad_calib_report_of(&s->calib)->phase));
}

/* The first frame that can be read decides the size. */
static int first_frame(simulation *s, tool_fail *f)
{
    picture left, right;
    int status = TOOL_FILE;
    for (int i = 0; i < s->frames.count && status; i++) {
        status = recording_read(&s->frames, i, s->options.color, &left, &right, f);
        if (status && !s->keep_going)
            return status;
    }
    if (status)
        return status;
    status = set_up(s, &left, f);
    picture_free(&left);
    picture_free(&right);
    return status;
}

static int check_apart(const simulation *s, tool_fail *f)
{
    const recording *r = &s->frames;
    const char *const outs[] = {s->csv, s->json, s->report}, *const files[] = {s->where, s->options.params_path};
    int status = tool_out_apart(outs, 3, files, 2, f);
    for (int i = 0; i < r->count && r->left && status == TOOL_OK; i++) {
        const char *const ins[] = {r->left[i], r->right ? r->right[i] : NULL};
        status = tool_out_apart(outs, 3, ins, 2, f);
    }
    return status;
}

/* Frame numbers that the recording never reaches. */
static int check_numbers(const simulation *s, tool_fail *f)
{
    if (s->calibrate_at >= s->end)
        return tool_fail_set(f, TOOL_USAGE, "--calibrate-at %ld: the frames are 0..%d", s->calibrate_at, s->end - 1);
    if (s->bad.from >= s->end)
        return tool_fail_set(f, TOOL_USAGE, "--from %d: the frames are 0..%d", s->bad.from, s->end - 1);
    return TOOL_OK;
}

static int check_interrupt(const simulation *s, tool_fail *f)
{
    if (!interrupt_seen())
        return TOOL_OK;
    return tool_fail_set(f, 128 + interrupt_seen(), "interrupted after %d of %d frames", s->row_count, s->end);
}

/* The frames one by one, to the last, to the first that fails, or to a signal. */
static int play_all(simulation *s, double start, tool_fail *f)
{
    int status = TOOL_OK;
    for (int i = 0; i < s->end && status == TOOL_OK; i++) {
        status = play(s, i, f);
        if (status && s->keep_going) {
            progress_end();
            tool_note("stad simulate", "skipped: ", f);
            status = miss(s, i, f);
        }
        s->row_count += status == TOOL_OK;
        if (status == TOOL_OK)
            status = check_interrupt(s, f);
        show_progress(s, i + 1, start);
    }
    return status;
}

int simulate_run(simulation *s, tool_fail *f)
{
    double start = tool_seconds();
    interrupt_watch();
    int status = recording_open(&s->frames, s->where, s->side_by_side, s->raw_width, s->raw_height, f);
    s->end = s->limit && s->limit < s->frames.count ? (int)s->limit : s->frames.count;
    if (status == TOOL_OK)
        status = check_numbers(s, f);
    if (status == TOOL_OK)
        status = check_apart(s, f);
    if (status == TOOL_OK)
        status = first_frame(s, f);
    s->stored_slot = -1;
    if (status == TOOL_OK)
        status = play_all(s, start, f);
    if (status == TOOL_OK)
        status = serve(s, s->end - 1, NULL, NULL, STAD_TUNE_LOG, f); /* a run under way needs no frame to be finished */
    if (status == TOOL_OK)
        status = check_interrupt(s, f);
    if (status)
        snprintf(s->stopped, sizeof s->stopped, "%s", f->text);
    if (s->rows)
        s->stored_slot = stad_store_load(&s->flash.flash, &s->stored);
    if (s->skipped == s->row_count && status == TOOL_OK)
        status = tool_fail_set(f, TOOL_FILE, "%s: no frame could be read", s->where);
    s->seconds = tool_seconds() - start;
    interrupt_leave();
    progress_end();
    return status;
}

void simulate_free(simulation *s)
{
    for (int i = 0; i < 4; i++)
        picture_free(&s->held[i / 2][i % 2]);
    ahead_close(&s->ahead);
    free(s->work);
    free(s->rows);
    free(s->runs);
    free(s->command);
    recording_close(&s->frames);
}
