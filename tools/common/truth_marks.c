/* SPDX-License-Identifier: MIT
 * common/truth_marks.c - ground truth from a frame pair that shows the printed target. */
#include "truth_marks.h"

#include <stdlib.h>
#include <string.h>

#include "stad/config.h"
#include "stad/mark.h"
#include "stad/rig.h"
#include "stad/status.h"
#include "stad/truth.h"

#define MARKS_MAX 16

typedef struct seen {
    stad_mark left[MARKS_MAX], right[MARKS_MAX];
    stad_pair pairs[MARKS_MAX];
    int count;
} seen;

static int find_pairs(seen *s, const picture *left, const picture *right, const char *names, tool_fail *f)
{
    const stad_image l = picture_view(left), r = picture_view(right);
    size_t bytes = stad_mark_bytes(left->width, left->height);
    void *work = NULL;
    if (bytes == 0)
        return tool_fail_set(f, TOOL_FILE, "%s: %d x %d is no size to look for marks in", names, left->width, left->height);
    if (posix_memalign(&work, STAD_ALIGN, bytes))
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory to look for marks", names);
    int nl = stad_mark_find(&l, NULL, s->left, MARKS_MAX, work, bytes);
    int nr = stad_mark_find(&r, NULL, s->right, MARKS_MAX, work, bytes);
    free(work);
    s->count = nl < 0 || nr < 0 ? 0 : stad_mark_pair(s->left, nl, s->right, nr, s->pairs, MARKS_MAX);
    if (s->count < 2)
        return tool_fail_set(f, TOOL_FILE, "%s: %d marks on the left, %d on the right, %d on both; at least 2 are needed", names,
                             nl, nr, s->count);
    return TOOL_OK;
}

static int check_rig(const seen *s, const picture *left, const char *names, tool_fail *f)
{
    stad_rig rig;
    stad_rig_report report;
    int verdict = stad_rig_fit(&rig, &report, s->pairs, s->count, left->width, left->height);
    if (verdict == STAD_RIG_GOOD || verdict == STAD_RIG_WATCH)
        return TOOL_OK;
    return tool_fail_set(f, TOOL_REFUSED,
                         "%s: the rows of the two views differ by up to %.2f px, and by %.2f px from a small correction: "
                         "rectify first, no parameters make up for that",
                         names, report.worst_q8 / 256.0, report.rms_after_q8 / 256.0);
}

static int fill(truth_map *t, const stad_truth *truth, const char *names, tool_fail *f)
{
    size_t n = (size_t)t->width * (size_t)t->height;
    t->q16 = malloc(n * sizeof *t->q16);
    t->label = malloc(n);
    if (!t->q16 || !t->label)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory for the truth", names);
    for (int y = 0; y < t->height; y++) {
        size_t row = (size_t)y * (size_t)t->width;
        stad_truth_row(truth, y, t->width, t->q16 + row, t->label + row);
    }
    return TOOL_OK;
}

/* Least and most disparity of the marks' corners, px. */
static void disparities_of(const seen *s, double *low, double *high)
{
    *low = 1e9;
    *high = -1e9;
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < 4; k++) {
            double d = (s->pairs[i].left[k].x_q8 - s->pairs[i].right[k].x_q8) / 256.0;
            *low = d < *low ? d : *low;
            *high = d > *high ? d : *high;
        }
}

static int check_range(const seen *s, const stad_params *p, const char *names, tool_fail *f)
{
    double low, high;
    int last = p->min_disparity + p->num_disparities - 1;
    disparities_of(s, &low, &high);
    if (low == 0 && high == 0)
        return tool_fail_set(f, TOOL_USAGE, "%s: both show the marks at the same place: the same picture twice", names);
    if (low >= p->min_disparity && high <= last)
        return TOOL_OK;
    if (high < 0 && high < p->min_disparity)
        return tool_fail_set(f, TOOL_USAGE,
                             "%s: the marks lie behind the cameras, at disparities %.1f .. %.1f px: left and right "
                             "are exchanged, or --min-disparity %d must be lower",
                             names, low, high, p->min_disparity);
    return tool_fail_set(f, TOOL_USAGE,
                         "%s: the target is out of range: its marks have disparities %.1f .. %.1f px, and "
                         "--min-disparity %d with --num-disparities %d searches %d .. %d",
                         names, low, high, p->min_disparity, p->num_disparities, p->min_disparity, last);
}

static int make_planes(stad_truth *truth, const truth_map *t, const seen *s, int min_disparity, int num_disparities,
                       const stad_camera *camera)
{
    int code = stad_truth_init(truth, t->width, t->height, min_disparity, num_disparities, 1);
    return code == STAD_OK ? stad_truth_from_target(truth, stad_target_relief(), s->pairs, s->count, camera) : code;
}

/* Why the marks gave no truth. */
static int explain(int code, const truth_map *t, const seen *s, const stad_params *p, const stad_camera *camera,
                   const char *names, tool_fail *f)
{
    stad_truth anywhere;
    if (code == STAD_E_RIG)
        return tool_fail_set(f, TOOL_USAGE,
                             "%s: with --focal %g and the principal point %g,%g the marks make no "
                             "rectangular sheet: one of them is wrong",
                             names, camera->f_q8 / 256.0, camera->cx_q8 / 256.0, camera->cy_q8 / 256.0);
    if (make_planes(&anywhere, t, s, 0, 1, camera) > 0)
        return tool_fail_set(f, TOOL_USAGE,
                             "%s: too little of the target is in the columns where the whole range is "
                             "searched, from %d on (--min-disparity, --num-disparities)",
                             names, p->min_disparity + p->num_disparities);
    return tool_fail_set(f, TOOL_FILE, "%s: the marks found are not those of a flat target with its relief (%s)", names,
                         stad_status_name(code));
}

int truth_from_marks(truth_map *t, const picture *left, const picture *right, const stad_params *p, const stad_camera *camera,
                     const char *names, tool_fail *f)
{
    seen s;
    stad_truth truth;
    memset(t, 0, sizeof *t);
    t->width = left->width;
    t->height = left->height;
    int status = find_pairs(&s, left, right, names, f);
    if (status == TOOL_OK)
        status = check_rig(&s, left, names, f);
    if (status == TOOL_OK)
        status = check_range(&s, p, names, f);
    if (status)
        return status;
    int code = make_planes(&truth, t, &s, p->min_disparity, p->num_disparities, camera);
    return code < 0 ? explain(code, t, &s, p, camera, names, f) : fill(t, &truth, names, f);
}
