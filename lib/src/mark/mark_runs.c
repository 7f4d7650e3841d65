/* SPDX-License-Identifier: MIT
 * dark map -> [mark/mark_runs.c] -> components - union-find over the runs of two live rows, no label image.
 *
 * Runs of a finished row point at roots. So while the next row is joined to them, a slot that loses a union is always one that
 * the row above points at, and one sweep over that row gives back the losers and the components that have ended. */
#include "mark/mark_work.h"

#include "base/arith.h"

enum { FREED = -1 };

void stad_mark_runs_first(mark_work *w)
{
    const int32_t slots = w->width + 8;
    for (int32_t i = 0; i < slots; i++)
        w->free_slots[i] = (int16_t)i;
    w->free_count = slots;
    w->run_count[0] = w->run_count[1] = 0;
}

/* The first x >= from whose dark bit is `value`, or the width. */
static int32_t next_bit(const mark_work *w, const uint8_t *row, int32_t from, unsigned value)
{
    const unsigned skip = value ? 0x00u : 0xFFu; /* a byte without the value */
    while (from < w->width) {
        if (from % 8 == 0 && row[from / 8] == skip)
            from += 8;
        else if (((unsigned)row[from / 8] >> (from % 8) & 1u) == value)
            return from;
        else
            from++;
    }
    return w->width;
}

static int32_t extract(mark_work *w, int32_t y, mark_run *runs)
{
    const uint8_t *row = w->dark + y * w->dark_stride;
    int32_t count = 0;
    for (int32_t x = next_bit(w, row, 0, 1); x < w->width; x = next_bit(w, row, x, 1)) {
        runs[count].first = (int16_t)x;
        x = next_bit(w, row, x, 0);
        runs[count].last = (int16_t)(x - 1);
        runs[count++].component = FREED;
    }
    return count;
}

/* The root of a slot, halving the way there. */
static int16_t root_of(mark_component *components, int16_t i)
{
    while (components[i].parent != i) {
        components[i].parent = components[components[i].parent].parent;
        i = components[i].parent;
    }
    return i;
}

static void add_run(mark_component *c, const mark_run *run, int32_t y)
{
    c->area += run->last - run->first + 1;
    c->left = min_i16(c->left, run->first);
    c->right = max_i16(c->right, run->last);
    c->bottom = (int16_t)y;
}

static int16_t new_component(mark_work *w, const mark_run *run, int32_t y)
{
    const int16_t i = w->free_slots[--w->free_count];
    mark_component *c = &w->components[i];
    c->area = 0;
    c->left = run->first;
    c->right = run->last;
    c->top = (int16_t)y;
    c->start_x = run->first;
    c->parent = i;
    add_run(c, run, y);
    return i;
}

/* Joins two roots into the one that began higher, or farther left: i, of a run left of k's, if both began in one row, since
 * they have not met yet. */
static int16_t join(mark_component *components, int16_t i, int16_t k)
{
    if (i == k)
        return i;
    const int swap = components[k].top < components[i].top;
    const int16_t winner = swap ? k : i, loser = swap ? i : k;
    mark_component *a = &components[winner], *b = &components[loser];
    a->area += b->area;
    a->left = min_i16(a->left, b->left);
    a->right = max_i16(a->right, b->right);
    a->bottom = max_i16(a->bottom, b->bottom);
    b->parent = winner;
    return winner;
}

/* Gives the runs of this row their components: those above that they touch, joined, or a new one. */
static void connect(mark_work *w, int32_t y)
{
    const mark_run *above = w->runs[0];
    int32_t k = 0;
    for (int32_t i = 0; i < w->run_count[1]; i++) {
        mark_run *run = &w->runs[1][i];
        while (k < w->run_count[0] && above[k].last < run->first)
            k++;
        for (int32_t m = k; m < w->run_count[0] && above[m].first <= run->last; m++) {
            const int16_t root = root_of(w->components, above[m].component);
            run->component = run->component == FREED ? root : join(w->components, run->component, root);
        }
        if (run->component == FREED)
            run->component = new_component(w, run, y);
        else
            add_run(&w->components[run->component], run, y);
    }
    for (int32_t i = 0; i < w->run_count[1]; i++)
        w->runs[1][i].component = root_of(w->components, w->runs[1][i].component);
}

/* Examines what ended with the row above, and gives back every slot that only that row pointed at. */
static void close_components(mark_work *w, int32_t y)
{
    for (int32_t i = 0; i < w->run_count[0]; i++) {
        const int16_t slot = w->runs[0][i].component;
        mark_component *c = &w->components[slot];
        if (c->parent == FREED || (c->parent == slot && c->bottom == y))
            continue;
        if (c->parent == slot)
            stad_mark_examine(w, c);
        c->parent = FREED;
        w->free_slots[w->free_count++] = slot;
    }
}

void stad_mark_runs_row(mark_work *w, int32_t y)
{
    w->run_count[1] = extract(w, y, w->runs[1]);
    connect(w, y);
    close_components(w, y);
    mark_run *above = w->runs[0];
    w->runs[0] = w->runs[1];
    w->run_count[0] = w->run_count[1];
    w->runs[1] = above;
}
