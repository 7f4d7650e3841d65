/* SPDX-License-Identifier: MIT
 * stad/measure.c - every measure of a disparity map against truth, by the library's scorer. */
#include "measure.h"

#include <string.h>

const double measure_threshold[MEASURE_THRESHOLDS] = {0.5, 1, 2, 3};

void measure_feed(stad_score *s, const disparity *d, const truth_map *t)
{
    for (int y = 0; y < d->height; y++) {
        size_t row = (size_t)y * (size_t)d->width;
        stad_score_row(s, y, d->q4 + row, t->q16 + row, t->label + row, d->width);
    }
}

static int score_at(stad_score *s, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f)
{
    stad_score_config c;
    stad_score_config_init(&c, STAD_SCORE_BAD, d->none_q4 / 16 + 1, num_disparities);
    c.threshold_q16 = (int32_t)(threshold * 65536 + 0.5);
    if (stad_score_begin(s, &c) != STAD_OK)
        return tool_fail_set(f, TOOL_USAGE, "the scorer refuses min_disparity %d, num_disparities %d, threshold %g",
                             c.min_disparity, num_disparities, threshold);
    measure_feed(s, d, t);
    return TOOL_OK;
}

static double ratio(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

static double bad_of(const stad_score_counts *c)
{
    return ratio(c->wrong_visible + c->missing_visible, c->visible);
}

static void take_main(measures *m, const stad_score *s)
{
    const stad_score_counts *c = &s->counts;
    double estimated = c->visible - c->missing_visible;
    m->counts = *c;
    m->bad_at_threshold = bad_of(c);
    m->chow =
        ratio(2.0 * c->wrong_visible + 2.0 * c->wrong_occluded + c->missing_visible, 2.0 * ((double)c->visible + c->occluded));
    m->d1 = ratio((double)c->d1_visible + c->missing_visible, c->visible);
    m->d1_estimated = ratio(c->d1_visible, estimated);
    m->rmse = stad_score_rmse_q16(s) / 65536.0;
    m->mae = stad_score_mae_q16(s) / 65536.0;
    m->density = ratio(estimated, c->visible);
}

int measure_at(measures *m, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f)
{
    stad_score s;
    memset(m, 0, sizeof *m);
    m->threshold = threshold;
    if (d->width != t->width || d->height != t->height)
        return tool_fail_set(f, TOOL_USAGE, "the disparity map is %d x %d, the truth %d x %d", d->width, d->height, t->width,
                             t->height);
    int status = score_at(&s, d, t, num_disparities, threshold, f);
    if (status)
        return status;
    take_main(m, &s);
    if (s.counts.visible == 0)
        return tool_fail_set(f, TOOL_USAGE, "no pixel can be scored: the truth has none visible right of column %d",
                             d->none_q4 / 16 + 1 + num_disparities);
    return TOOL_OK;
}

int measure(measures *m, const disparity *d, const truth_map *t, int num_disparities, double threshold, tool_fail *f)
{
    stad_score s;
    int status = measure_at(m, d, t, num_disparities, threshold, f);
    for (int i = 0; i < MEASURE_THRESHOLDS && status == TOOL_OK; i++) {
        status = score_at(&s, d, t, num_disparities, measure_threshold[i], f);
        m->bad[i] = bad_of(&s.counts);
        m->bad_estimated[i] = ratio(s.counts.wrong_visible, s.counts.visible - s.counts.missing_visible);
    }
    return status;
}
