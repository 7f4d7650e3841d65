/* SPDX-License-Identifier: MIT
 * story/story_main.c - tells the story, writes before and after: pictures and summary.json.
 *
 *     stad-story [-o FOLDER]
 *
 * Exit status 0: adopted, restored, every camera fault told; 1: the board did not help itself; 3: a file cannot be written. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../common/calib_names.h"
#include "../common/colour.h"
#include "../common/whole_file.h"
#include "story.h"

typedef struct chapter {
    const char *name;
    double bad;
} chapter;

typedef struct telling {
    const char *folder;
    story_world healthy, disturbed;
    story_board board;
    story_frame frame;
    chapter healthy_map, disturbed_map, corrected_map, after_map;
    story_fault fault[STORY_FAULTS];
    tool_fail fail;
} telling;

static int write_maps(telling *t, const chapter *c, disparity *d, const story_frame *frame)
{
    char path[600];
    picture colours;
    snprintf(path, sizeof path, "%s/story-%s-left.png", t->folder, c->name);
    if (picture_write_png(&frame->left, path, &t->fail) != TOOL_OK)
        return t->fail.status;
    snprintf(path, sizeof path, "%s/story-%s.png", t->folder, c->name);
    if (colour_disparity(&colours, d, STORY_DISPARITIES, &t->fail) != TOOL_OK)
        return t->fail.status;
    int status = picture_write_png(&colours, path, &t->fail);
    picture_free(&colours);
    return status;
}

/* Mean over five frames of the bad share outside the target; the last one's map is kept. */
static int look(telling *t, chapter *c, const char *name, story_world *w, const stad_setup *setup)
{
    disparity d;
    int status = TOOL_OK;
    c->name = name;
    c->bad = 0;
    memset(&d, 0, sizeof d);
    for (int i = 0; i < 5 && status == TOOL_OK; i++) {
        story_expose(w, 0, &t->frame);
        status = story_add_bad(&t->board, w, &t->frame, setup, &d, &c->bad, &t->fail);
    }
    c->bad /= 5;
    if (status == TOOL_OK) {
        printf("%-10s %5.1f %% of the scene outside the target is wrong or missing\n", name, c->bad);
        status = write_maps(t, c, &d, &t->frame);
    }
    disparity_free(&d);
    return status;
}

/* Live frames until the board asks for something. Returns how many, or -1. */
static int watch(telling *t, story_world *w, int most)
{
    stad_request r;
    for (int i = 1; i <= most; i++) {
        story_expose(w, 0, &t->frame);
        if (story_board_live(&t->board, &t->frame, &t->fail) != TOOL_OK)
            return -1;
        if (stad_calib_want(&t->board.calib, &r) != STAD_WANT_NOTHING)
            return i;
    }
    return most;
}

static const char *verdict_name(int v)
{
    static const char *const names[] = {"GOOD", "WATCH", "CORRECT", "FAIL"};
    return v >= 0 && v <= STAD_RIG_FAIL ? names[v] : "UNKNOWN";
}

static void tell_params(const char *what, const stad_params *p)
{
    printf("  %s: p1 %d p2 %d block %d uniqueness %d cap %d disp12 %d\n", what, p->p1, p->p2, p->block_size, p->uniqueness_ratio,
           p->pre_filter_cap, p->disp12_max_diff);
}

/* Turns the pump until it rests, with live frames where it watches. */
static int work(telling *t, story_world *w)
{
    int phase = -1;
    for (int i = 0; i < 2000 && stad_calib_report_of(&t->board.calib)->phase != STAD_CALIB_IDLE; i++) {
        const stad_calib_report *r = stad_calib_report_of(&t->board.calib);
        if (r->phase != phase && r->phase == STAD_CALIB_PROBATION)
            printf("  on probation\n");
        phase = r->phase;
        if (story_board_turn(&t->board, w) == STAD_WANT_NOTHING && watch(t, w, 1) < 0)
            return t->fail.status;
    }
    return TOOL_OK;
}

/* Cameras that fail, one after the other. Returns 1 when each was told and nothing adopted. */
static int fail_cameras(telling *t)
{
    int good = 1;
    printf("\ncameras fail, the target before them: what a live frame tells at once; what a run tells; what is adopted\n");
    for (int i = 0; i < STORY_FAULTS; i++) {
        story_fault *k = &t->fault[i];
        if (story_fault_of(&t->board, &t->disturbed, i, &t->frame, k) < 0)
            return 0;
        printf("  %-13s %-10s %-10s outcome: %-11s %s\n", k->name, calib_fault_name(k->live), calib_fault_name(k->fault),
               calib_outcome_name(k->outcome), k->adopted ? "ADOPTED" : "nothing");
        good &= k->fault != STAD_FAULT_NONE && !k->adopted;
    }
    return good;
}

static void write_faults(const telling *t, FILE *to)
{
    fputs(" \"camera_faults\": {", to);
    for (int i = 0; i < STORY_FAULTS; i++) {
        const story_fault *k = &t->fault[i];
        fprintf(to, "%s\n  \"%s\": {\"live\": \"%s\", \"run\": \"%s\", \"outcome\": \"%s\", \"adopted\": %s}", i ? "," : "",
                k->name, calib_fault_name(k->live), calib_fault_name(k->fault), calib_outcome_name(k->outcome),
                k->adopted ? "true" : "false");
    }
    fputs("},\n", to);
}

static int write_summary(telling *t, const stad_calib_report *r, int restored)
{
    char path[600];
    tool_out out;
    snprintf(path, sizeof path, "%s/summary.json", t->folder);
    if (tool_out_open(&out, path, &t->fail) != TOOL_OK)
        return t->fail.status;
    fprintf(out.stream,
            "{\"healthy\": {\"bad\": %.2f}, \"disturbed\": {\"bad\": %.2f}, \"corrected\": {\"bad\": %.2f}, "
            "\"after\": {\"bad\": %.2f},\n"
            " \"verdict_before\": \"%s\", \"verdict_after\": \"%s\", \"adopted\": %s, \"restored\": %s,\n",
            t->healthy_map.bad, t->disturbed_map.bad, t->corrected_map.bad, t->after_map.bad, verdict_name(r->verdict_before),
            verdict_name(r->verdict_after), r->outcome == STAD_CALIB_ADOPTED ? "true" : "false", restored ? "true" : "false");
    write_faults(t, out.stream);
    fprintf(out.stream, " \"evaluations\": %d, \"frames\": %d}\n", r->evaluations, t->board.frames);
    return tool_out_close(&out, 1, &t->fail);
}

static int tell(telling *t)
{
    stad_calib *c = &t->board.calib;
    stad_setup factory = *stad_calib_setup(c);
    printf("a board with sound cameras in good light learns what is usual\n");
    if (watch(t, &t->healthy, 60) < 0 || look(t, &t->healthy_map, "healthy", &t->healthy, &factory) != TOOL_OK)
        return t->fail.status;
    printf("\nthe right camera is knocked (1.1 px, 0.45 degrees, 0.2 %%) and the light goes\n");
    int frames = watch(t, &t->disturbed, 40);
    if (frames < 0)
        return t->fail.status;
    printf("  alarm after %d frames\n", stad_calib_report_of(c)->alarmed ? frames : -1);
    if (look(t, &t->disturbed_map, "disturbed", &t->disturbed, &factory) != TOOL_OK)
        return t->fail.status;
    printf("\nthe board looks for marks, checks the rig, tunes, judges on another pose\n");
    if (work(t, &t->disturbed) != TOOL_OK)
        return t->fail.status;
    stad_calib_report r = *stad_calib_report_of(c);
    stad_setup adopted = *stad_calib_setup(c);
    printf("  rig %s -> %s, %d evaluations", verdict_name(r.verdict_before), verdict_name(r.verdict_after), r.evaluations);
    if (r.judge_before_q20 >= 0) /* measured */
        printf("; on the other pose %.1f %% -> %.1f %%", r.judge_before_q20 / 10485.76, r.judge_after_q20 / 10485.76);
    printf("; outcome: %s\n", calib_outcome_name(r.outcome));
    tell_params("before", &factory.params);
    tell_params("after ", &adopted.params);
    stad_setup corrected = adopted;
    corrected.params = factory.params;
    if (look(t, &t->corrected_map, "corrected", &t->disturbed, &corrected) != TOOL_OK ||
        look(t, &t->after_map, "after", &t->disturbed, &adopted) != TOOL_OK)
        return t->fail.status;
    int slot = story_board_reset(&t->board);
    int restored = slot >= 0 && slot != STAD_SLOT_FACTORY && memcmp(&adopted, stad_calib_setup(c), sizeof adopted) == 0;
    printf("\nafter a reset the setup comes from slot %d: %s\n", slot, restored ? "the adopted one" : "NOT the adopted one");
    int told = fail_cameras(t);
    if (write_summary(t, &r, restored) != TOOL_OK)
        return t->fail.status;
    return r.outcome == STAD_CALIB_ADOPTED && restored && told ? TOOL_OK : TOOL_REFUSED;
}

/* Can the folder be written? Asked before anything is worked out. */
static int check_folder(telling *t)
{
    char path[600];
    if (strlen(t->folder) > 500)
        return tool_fail_set(&t->fail, TOOL_USAGE, "the folder's name is too long");
    mkdir(t->folder, 0777); /* it may be there; the check tells */
    snprintf(path, sizeof path, "%s/summary.json", t->folder);
    return tool_out_check(path, &t->fail);
}

int main(int argc, char **argv)
{
    static telling t;
    t.folder = argc == 3 ? argv[2] : "build/demo";
    if (argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)) {
        puts("usage: stad-story [-o FOLDER]\n\nTells how a board helps itself; pictures and summary.json go to FOLDER "
             "(build/demo).");
        return TOOL_OK;
    }
    if (argc != 1 && (argc != 3 || strcmp(argv[1], "-o") != 0)) {
        fprintf(stderr, "usage: stad-story [-o FOLDER]\n");
        return TOOL_USAGE;
    }
    if (check_folder(&t) != TOOL_OK || story_board_start(&t.board, &t.fail) != TOOL_OK ||
        picture_alloc(&t.frame.left, STORY_WIDTH, STORY_HEIGHT, 1, &t.fail) != TOOL_OK ||
        picture_alloc(&t.frame.right, STORY_WIDTH, STORY_HEIGHT, 1, &t.fail) != TOOL_OK ||
        story_world_make(&t.healthy, 0, 1, 11, &t.fail) != TOOL_OK ||
        story_world_make(&t.disturbed, 1, STORY_POSES, 12, &t.fail) != TOOL_OK) {
        fprintf(stderr, "stad-story: %s\n", t.fail.text);
        return t.fail.status;
    }
    int status = tell(&t);
    if (t.fail.text[0])
        fprintf(stderr, "stad-story: %s\n", t.fail.text);
    story_world_free(&t.healthy);
    story_world_free(&t.disturbed);
    story_board_free(&t.board);
    picture_free(&t.frame.left);
    picture_free(&t.frame.right);
    return status;
}
