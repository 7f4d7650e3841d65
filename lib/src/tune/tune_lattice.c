/* SPDX-License-Identifier: MIT
 * variables -> [LATTICE] -> points         tune/tune_lattice.c - from variables a gradient can be taken in to integers and back.
 *
 * p1 and p2 are walked as log2(v / block^1.5): what makes a smoothness penalty large or small is its ratio to the matching
 * cost, which grows with the block. Held so, a poll of the block size compares like with like. */
#include "tune/tune_core.h"
#include "base/arith.h"
#include "base/divide.h"
#include "base/log.h"

#define HALF_OCTAVE (TUNE_ONE / 2)

int stad_tune_is_free(const stad_tune_config *c, int i)
{
    return (c->free_mask >> i) & 1;
}

int stad_tune_is_continuous(const stad_tune_config *c, int i)
{
    return c->axis[i].scale <= STAD_TUNE_AREA;
}

int stad_tune_is_swept(const stad_tune *t, int i)
{
    return stad_tune_is_free(&t->config, i) && stad_tune_is_continuous(&t->config, i);
}

/* log2(block^1.5), Q16. */
static int32_t area_q16(int32_t block)
{
    return block < 1 ? 0 : 3 * stad_log2_q16((uint32_t)block) / 2;
}

/* The variable of integer `value` on axis i. */
static int32_t variable_of(const stad_tune_config *c, int i, int32_t value, int32_t block)
{
    const stad_tune_axis *a = &c->axis[i];
    switch (a->scale) {
    case STAD_TUNE_LINEAR:
        return clamp_i64(stad_div_i64((int64_t)value * TUNE_ONE, a->unit), -STAD_TUNE_UNITS * TUNE_ONE,
                         STAD_TUNE_UNITS * TUNE_ONE); /* clips fixed ones alone */
    case STAD_TUNE_LOG2:
        return stad_log2_q16((uint32_t)(value < 1 ? 1 : value));
    case STAD_TUNE_AREA:
        return stad_log2_q16((uint32_t)(value < 1 ? 1 : value)) - area_q16(block);
    default:
        return value;
    }
}

/* The integer nearest to variable v on axis i, not yet within bounds. */
static int64_t value_of(const stad_tune_config *c, int i, int32_t v, int32_t block)
{
    const stad_tune_axis *a = &c->axis[i];
    int64_t q16;
    switch (a->scale) {
    case STAD_TUNE_LINEAR:
        q16 = (int64_t)v * a->unit;
        return q16 >= 0 ? (q16 + TUNE_ONE / 2) / TUNE_ONE : -((TUNE_ONE / 2 - q16) / TUNE_ONE);
    case STAD_TUNE_LOG2:
        return (stad_exp2_q16(v) + TUNE_ONE / 2) >> 16;
    case STAD_TUNE_AREA:
        return (stad_exp2_q16(v + area_q16(block)) + TUNE_ONE / 2) >> 16;
    default:
        return v;
    }
}

/* An integer to the nearest one that axis a asks for. */
static int32_t continuous_value(const stad_tune_axis *a, int64_t value)
{
    const int32_t v = clamp_i64(value, a->lo, a->hi);
    if (a->scale == STAD_TUNE_LINEAR || a->unit == 1)
        return v;
    const int32_t up = (v - a->lo + a->unit / 2) / a->unit * a->unit + a->lo;
    return up <= a->hi ? up : up - a->unit;
}

/* A discrete value into its range, an even one of ODD to the next odd one, the lower at the upper end. */
static int32_t discrete_value(const stad_tune_axis *a, int32_t value)
{
    value = clamp_i64(value, a->lo, a->hi);
    if (a->scale == STAD_TUNE_ODD && value % 2 == 0)
        value += value < a->hi ? 1 : -1;
    return value;
}

/* p2 >= sqrt(2) * p1 with both free to move: a pair that is too close is spread about its mean, so that neither is jammed
 * by the other. */
static void spread_pair(const stad_tune_config *c, tune_vars *v)
{
    int32_t *a = &v->v[STAD_TUNE_P1];
    int32_t *b = &v->v[STAD_TUNE_P2];
    if (!c->ordered || *b - *a >= HALF_OCTAVE)
        return;
    if (stad_tune_is_free(c, STAD_TUNE_P1) && stad_tune_is_free(c, STAD_TUNE_P2)) {
        const int32_t sum = *a + *b;
        *a = (sum - HALF_OCTAVE) / 2;
        *b = *a + HALF_OCTAVE;
    } else if (stad_tune_is_free(c, STAD_TUNE_P1)) {
        *a = *b - HALF_OCTAVE;
    } else {
        *b = *a + HALF_OCTAVE;
    }
}

void stad_tune_to_point(const stad_tune *t, const tune_vars *vars, stad_point *x)
{
    const stad_tune_config *c = &t->config;
    tune_vars v = *vars;
    stad_point out = t->start;
    const int block = STAD_TUNE_BLOCK_SIZE;
    if (stad_tune_is_free(c, block) && !stad_tune_is_continuous(c, block))
        out.v[block] = (int16_t)discrete_value(&c->axis[block], v.v[block]);
    spread_pair(c, &v);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        const stad_tune_axis *a = &c->axis[i];
        if (!stad_tune_is_free(c, i))
            continue;
        if (stad_tune_is_continuous(c, i))
            out.v[i] = (int16_t)continuous_value(a, value_of(c, i, v.v[i], out.v[block]));
        else
            out.v[i] = (int16_t)discrete_value(a, v.v[i]);
    }
    if (c->ordered && out.v[STAD_TUNE_P2] <= out.v[STAD_TUNE_P1]) {
        if (stad_tune_is_free(c, STAD_TUNE_P2) && out.v[STAD_TUNE_P1] < c->axis[STAD_TUNE_P2].hi)
            out.v[STAD_TUNE_P2] = (int16_t)(out.v[STAD_TUNE_P1] + 1);
        else if (stad_tune_is_free(c, STAD_TUNE_P1) && out.v[STAD_TUNE_P2] > c->axis[STAD_TUNE_P1].lo)
            out.v[STAD_TUNE_P1] = (int16_t)(out.v[STAD_TUNE_P2] - 1);
    }
    *x = out;
}

void stad_tune_to_vars(const stad_tune_config *c, const stad_point *x, tune_vars *v)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++)
        v->v[i] = variable_of(c, i, x->v[i], x->v[STAD_TUNE_BLOCK_SIZE]);
}

int32_t stad_tune_room(const stad_tune *t, const tune_vars *v, int i, int side)
{
    const stad_tune_config *c = &t->config;
    const int32_t block = v->v[STAD_TUNE_BLOCK_SIZE];
    const int32_t end = variable_of(c, i, side > 0 ? c->axis[i].hi : c->axis[i].lo, block);
    int32_t room = side > 0 ? end - v->v[i] : v->v[i] - end;
    const int pair = c->ordered && (side > 0 ? i == STAD_TUNE_P1 : i == STAD_TUNE_P2);
    if (pair) {
        const int32_t gap = v->v[STAD_TUNE_P2] - v->v[STAD_TUNE_P1] - HALF_OCTAVE;
        room = room < gap ? room : gap;
    }
    return room > 0 ? room : 0;
}
