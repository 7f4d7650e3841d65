/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_tune.c - any config, any start, any costs: refused by name, or a search that ends within its budget, asks each
 * point once and only inside the bounds, knows its best, and can be copied at any turn. */
#include <string.h>

#include "fuzz/fuzz.h"
#include "stad/tune.h"

static void some_axis(stad_tune_axis *a, bytes *b)
{
    int how = next(b);
    if (how & 1) {
        a->lo = number(b, 40);
        a->hi = (int16_t)(next(b) % 4 ? a->lo + number(b, 200) % 32000 : next_i16(b));
    }
    if (how & 2) {
        a->unit = number(b, 20);
    }
    if (how & 4) {
        a->scale = (uint8_t)(next(b) % 6);
    }
    if (how & 8) {
        a->side = (int8_t)next(b);
    }
}

static void some_config(stad_tune_config *c, bytes *b)
{
    int how = next(b);
    stad_tune_config_stereo(c, how % 3);
    c->method = (uint8_t)(next(b) % 5);
    c->free_mask = (uint8_t)(how & 4 ? next(b) : 63);
    c->ordered = (uint8_t)(how >> 3 & 1);
    c->budget = (int16_t)(how & 16 ? number(b, 241) : 60);
    c->patience = (uint8_t)(how >> 5 & 1);
    c->seed = (uint32_t)next_i32(b);
    c->cheap_mask = (uint8_t)(c->seed >> 8 & 63);
    for (int i = 0; how & 64 && i < STAD_TUNE_DIMS; i++) {
        some_axis(&c->axis[i], b);
    }
    if (how & 128) {
        c->ladder_count = (uint8_t)(next(b) % 8);
        for (int i = 0; i < STAD_TUNE_LADDER * STAD_TUNE_DIMS; i++) {
            c->ladder[i / STAD_TUNE_DIMS].v[i % STAD_TUNE_DIMS] = number(b, 100);
        }
    }
}

/* A cost of any shape: noise, a bowl, a plane, constant, extremes. */
static int32_t cost_of(const stad_point *x, int shape, const bytes *b, int turn)
{
    int64_t sum = 0;
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        int64_t v = x->v[i];
        sum += shape % 4 == 0 ? v * v : shape % 4 == 1 ? v * (i + 1) : shape % 4 == 2 ? (v * 2654435761) % 9973 : 7;
    }
    int die = b->left ? b->at[(size_t)turn % b->left] : 0;
    sum = shape & 8 ? (sum < 0 ? -sum : sum) << (die % 24) : sum;
    sum = shape & 16 ? INT32_MAX - 1 - (sum < 0 ? -sum : sum) % 1000000 : sum;
    if (shape & 32 && die % 5 == 0) {
        return STAD_COST_FAILED;
    }
    sum = sum < 0 ? -sum : sum;
    return (int32_t)(sum % INT32_MAX) + 1 > 0 && !(shape & 64) ? (int32_t)(sum % (INT32_MAX - 1)) : (int32_t)(die * 4000);
}

static void check_point(const stad_tune_config *c, const stad_point *x)
{
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        expect(!(c->free_mask >> i & 1) || (x->v[i] >= c->axis[i].lo && x->v[i] <= c->axis[i].hi));
    }
}

static void check_trace(const stad_tune *t, int count, int32_t least)
{
    stad_point x, y, best;
    int32_t cost, other, best_cost = 1;
    for (int i = 0; i < count; i++) {
        expect(stad_tune_trace(t, i, &x, &cost) == STAD_OK);
        for (int k = 0; k < i; k++) {
            expect(stad_tune_trace(t, k, &y, &other) == STAD_OK && memcmp(&x, &y, sizeof x) != 0);
        }
    }
    expect(stad_tune_trace(t, count, &x, &cost) == STAD_E_PARAM && stad_tune_trace(t, -1, &x, &cost) == STAD_E_PARAM);
    int status = stad_tune_best(t, &best, &best_cost);
    expect(least == STAD_COST_FAILED ? status == STAD_E_STATE : status == STAD_OK && best_cost == least);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static stad_tune t, copy;
    bytes b = {data, size};
    stad_tune_config c;
    stad_point start, x, again;
    const char *culprit = NULL;
    int turns = 0;
    int32_t least = STAD_COST_FAILED;
    some_config(&c, &b);
    for (int i = 0; i < STAD_TUNE_DIMS; i++) {
        start.v[i] = number(&b, 200);
    }
    int shape = next(&b), copy_at = next(&b);
    int status = stad_tune_init(&t, &c, &start);
    expect(status == stad_tune_config_check(&c, &culprit) && (status == STAD_OK || culprit));
    if (status != STAD_OK) {
        expect(stad_tune_ask(&t, &x) == 0 && stad_tune_tell(&t, 5) == STAD_E_STATE);
        return 0;
    }
    while (stad_tune_ask(&t, &x) == 1) {
        int32_t cost = cost_of(&x, shape, &b, turns);
        expect(++turns <= c.budget);
        check_point(&c, &x);
        expect(stad_tune_ask(&t, &again) == 1 && memcmp(&x, &again, sizeof x) == 0);
        expect(stad_tune_tell(&t, -1) == STAD_E_PARAM);
        if (turns == copy_at) {
            copy = t;
            memset(&t, 0x5a, sizeof t);
            t = copy;
        }
        expect(stad_tune_tell(&t, cost) == STAD_OK);
        least = cost < least ? cost : least;
    }
    expect(stad_tune_tell(&t, 5) == STAD_E_STATE);
    expect(stad_tune_counts_of(&t).evaluations == turns);
    check_trace(&t, turns, least);
    return 0;
}
