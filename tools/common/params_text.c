/* SPDX-License-Identifier: MIT
 * common/params_text.c - stad_params by name, and messages that a person can act on. */
#include "params_text.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stad/status.h"

typedef struct field_info {
    const char *name, *option, *domain;
    long least, most; /* of the field's type */
} field_info;

static const field_info fields[FIELD_COUNT] = {
    {"min_disparity", "min-disparity", "-2047 or more, and at most 2047 with num_disparities added", INT16_MIN, INT16_MAX},
    {"num_disparities", "num-disparities", "a positive multiple of 16 (of 8 will do but in 3way)", INT16_MIN, INT16_MAX},
    {"block_size", "block-size", "odd and at least 1", INT16_MIN, INT16_MAX},
    {"p1", "p1", "in 1..32766", INT16_MIN, INT16_MAX},
    {"p2", "p2", "above p1 and at most 32767", INT16_MIN, INT16_MAX},
    {"disp12_max_diff", "disp12-max-diff", "at least 1", INT16_MIN, INT16_MAX},
    {"pre_filter_cap", "pre-filter-cap", "odd, at least 15", INT16_MIN, INT16_MAX},
    {"uniqueness_ratio", "uniqueness-ratio", "in 0..99", INT16_MIN, INT16_MAX},
    {"speckle_window_size", "speckle-window-size", "0 (off) or more: the largest component to remove, in pixels", INT32_MIN,
     INT32_MAX},
    {"speckle_range", "speckle-range", "in 0..134217727 pixels of disparity, because 16 times it must fit 32 bits", INT32_MIN,
     INT32_MAX},
};

static const char *const modes[4] = {"sgbm", "hh", "3way", "hh4"};

const char *params_field_name(int field)
{
    return fields[field].name;
}

const char *params_field_option(int field)
{
    return fields[field].option;
}

int params_field_find(const char *name)
{
    for (int i = 0; i < FIELD_COUNT; i++)
        if (strcmp(name, fields[i].name) == 0 || strcmp(name, fields[i].option) == 0)
            return i;
    return -1;
}

long params_get(const stad_params *p, int field)
{
    const long v[FIELD_COUNT] = {
        p->min_disparity,  p->num_disparities,  p->block_size,          p->p1,           p->p2, p->disp12_max_diff,
        p->pre_filter_cap, p->uniqueness_ratio, p->speckle_window_size, p->speckle_range};
    return v[field];
}

int params_fits(int field, long value)
{
    return value >= fields[field].least && value <= fields[field].most;
}

void params_set(stad_params *p, int field, long value)
{
    int16_t *const narrow[] = {&p->min_disparity,   &p->num_disparities, &p->block_size,      &p->p1, &p->p2,
                               &p->disp12_max_diff, &p->pre_filter_cap,  &p->uniqueness_ratio};
    if (field == FIELD_SPECKLE_WINDOW_SIZE)
        p->speckle_window_size = (int32_t)value;
    else if (field == FIELD_SPECKLE_RANGE)
        p->speckle_range = (int32_t)value;
    else
        *narrow[field] = (int16_t)value;
}

void params_some_init(params_some *s)
{
    memset(s, 0, sizeof *s);
    s->mode = -1;
}

int params_number(const char *text, long *value)
{
    char *end;
    errno = 0;
    *value = strtol(text, &end, 10);
    return end != text && *end == 0 && errno == 0;
}

int params_some_set(params_some *s, int field, const char *text, tool_fail *f)
{
    const field_info *i = &fields[field];
    long v;
    if (!params_number(text, &v))
        return tool_fail_set(f, TOOL_USAGE, "--%s %s: not a whole number (%s is %s)", i->option, text, i->name, i->domain);
    if (!params_fits(field, v))
        return tool_fail_set(f, TOOL_USAGE, "--%s %s: outside %ld..%ld (%s is %s)", i->option, text, i->least, i->most, i->name,
                             i->domain);
    s->value[field] = v;
    s->given |= 1u << field;
    return TOOL_OK;
}

void params_some_merge(params_some *under, const params_some *over)
{
    for (int i = 0; i < FIELD_COUNT; i++)
        if (over->given >> i & 1) {
            under->value[i] = over->value[i];
            under->path[i] = over->path[i];
        }
    under->given |= over->given;
    if (over->mode >= 0)
        under->mode = over->mode;
}

void params_from_some(stad_params *p, const params_some *s, int width, int channels)
{
    int num = s->given >> FIELD_NUM_DISPARITIES & 1 ? (int)s->value[FIELD_NUM_DISPARITIES] : (width / 8 + 15) / 16 * 16;
    int block = s->given >> FIELD_BLOCK_SIZE & 1 ? (int)s->value[FIELD_BLOCK_SIZE] : 3;
    stad_params_sample(p, num, block, channels);
    for (int i = 0; i < FIELD_COUNT; i++)
        if (s->given >> i & 1)
            params_set(p, i, s->value[i]);
}

int params_mode_of(const char *name)
{
    for (int i = 0; i < 4; i++)
        if (strcmp(name, modes[i]) == 0)
            return i;
    return -1;
}

const char *params_mode_name(int mode)
{
    return mode >= 0 && mode < 4 ? modes[mode] : NULL;
}

/* Where a field's value came from: "p.json: p1 0", "p1 0 (--p1)". */
static void origin(char *text, size_t room, const params_some *from, int field, long is)
{
    const field_info *i = &fields[field];
    if (from->path[field])
        snprintf(text, room, "%.300s: %s %ld", from->path[field], i->name, is);
    else
        snprintf(text, room, "%s %ld (--%s)", i->name, is, i->option);
}

/* What is wrong with a field that is fine by itself but not with the others or the width; 0 when that is not it. */
static int clash(char *text, size_t room, const stad_params *p, int field, int width)
{
    const int min = p->min_disparity, num = p->num_disparities, end = min + num;
    const int columns = width + (min < 0 ? min : 0) - (end > 0 ? end : 0);
    if (field > FIELD_BLOCK_SIZE || num <= 0)
        return 0;
    if (field == FIELD_BLOCK_SIZE && p->block_size > 0 && p->block_size % 2 == 1)
        return snprintf(text, room,
                        "half of it must be less than the %d columns that min_disparity %d + num_disparities "
                        "%d leave of a %d pixel wide image",
                        columns, min, num, width);
    if (field == FIELD_BLOCK_SIZE || min < -2047)
        return 0;
    if (end > 2047)
        return snprintf(text, room, "min_disparity %d + num_disparities %d is %d; 2047 is the most that 16 bits hold", min, num,
                        end);
    if (columns < 1)
        return snprintf(text, room, "min_disparity %d + num_disparities %d leaves no column of a %d pixel wide image", min, num,
                        width);
    return 0;
}

int params_check_text(const stad_params *p, const params_some *from, int mode, int width, tool_fail *f)
{
    const char *culprit = NULL;
    char what[400], why[200];
    if (stad_params_check(p, mode, width, &culprit) == STAD_OK)
        return TOOL_OK;
    int field = culprit ? params_field_find(culprit) : -1;
    if (field < 0)
        return tool_fail_set(f, TOOL_USAGE, "%s is outside its domain", culprit ? culprit : "a parameter");
    stad_params n = *p;
    stad_params_normalize(&n, mode);
    long is = params_get(p, field), becomes = params_get(&n, field);
    origin(what, sizeof what, from, field, is);
    if (clash(why, sizeof why, p, field, width))
        return tool_fail_set(f, TOOL_USAGE, "%s: %s", what, why);
    if (is == becomes || (field == FIELD_P1 && is > 0)) /* OpenCV keeps a p1 that leaves no p2 above it */
        return tool_fail_set(f, TOOL_USAGE, "%s: must be %s", what, fields[field].domain);
    return tool_fail_set(f, TOOL_USAGE, "%s: must be %s; OpenCV would silently make it %ld", what, fields[field].domain, becomes);
}
