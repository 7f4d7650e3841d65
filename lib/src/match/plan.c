/* SPDX-License-Identifier: MIT
 * geometry -> [PLAN] -> workspace
 * match/plan.c - the workspace: its parts in order, their bytes, and the pointers into them. */
#include "match/frame.h"
#include "base/arith.h"

enum part { PIXELS, FEATURES, COSTS, WINDOW, TOTALS, LANES, SEGMENT, CHECKPOINTS, RUN, ROWS, PART_COUNT };

/* The geometry in the type of the macros, and the terms that several parts share. The macros are for constants: of variables
 * each is much code, so that every term is expanded once, here. */
typedef struct shape {
    size_t w, h, cn, d, b, p2, cap;
    int mode, memory, two_pass, safe, narrow;
    size_t cells, row, lane, state, checkpoint; /* of one cost row; its bytes; bytes of path state */
    size_t pixel_rows, cost_slots, segment_rows, segments;
} shape;

/* STAD_SEGMENT_ROWS, its terms one by one. */
static size_t segment_rows_of(const shape *s)
{
    const size_t target = STAD_SEGMENT_TARGET(s->h, s->mode, s->narrow, s->safe);
    const size_t seed = STAD_ROOT_SEED(target), guess = STAD_ROOT_STEP(target, seed);
    const size_t root = STAD_ROOT_STEP(target, guess);
    return s->memory == STAD_MEMORY_SMALL && root < s->h ? root : s->h;
}

/* STAD_LANE_BYTES, of the cells that are known. */
static size_t lane_bytes_of(const shape *s)
{
    const size_t cells = 32 + s->cells + s->d + STAD_LANE_PAD(s->memory) * (s->w + 2);
    return s->narrow ? STAD_BYTES_UP(cells) : STAD_BYTES_UP(2 * cells) + STAD_BYTES_UP(2 * (s->w + 1));
}

static shape shape_of(const stad_geometry *g)
{
    shape s = {0};
    s.w = (size_t)g->width;
    s.h = (size_t)g->height;
    s.cn = (size_t)g->channels;
    s.d = (size_t)g->max_disparities;
    s.b = (size_t)g->max_block_size;
    s.p2 = (size_t)g->max_p2;
    s.cap = (size_t)g->max_pre_filter_cap;
    s.mode = g->mode;
    s.memory = g->memory;
    s.two_pass = g->mode == STAD_MODE_HH || g->mode == STAD_MODE_HH4;
    s.safe = STAD_COST_SAFE(s.cn, s.b, s.p2, s.cap);
    s.narrow = s.safe && s.memory == STAD_MEMORY_SMALL && s.mode != STAD_MODE_3WAY && s.p2 <= 255;
    s.cells = STAD_CELLS(s.w, s.d);
    s.row = STAD_BYTES_UP(2 * s.cells);
    s.lane = lane_bytes_of(&s);
    s.state = STAD_LANES_DOWN(s.mode) * s.lane;
    s.checkpoint = s.state + (s.safe ? 0 : s.row);
    s.pixel_rows = STAD_PIXEL_ROWS(s.h, s.b, s.mode);
    s.cost_slots = s.two_pass || s.memory == STAD_MEMORY_FAST ? s.b / 2 * 2 + 2 : s.safe ? 0 : 2;
    s.segment_rows = segment_rows_of(&s);
    s.segments = (s.h + s.segment_rows - 1) / s.segment_rows;
    return s;
}

static size_t totals_bytes(const shape *s)
{
    if (s->two_pass && s->memory == STAD_MEMORY_SMALL)
        return 0;
    return STAD_TOTAL_WHOLE(s->mode, s->memory, s->narrow) ? s->row
                                                           : STAD_BYTES_UP(2 * STAD_RUN * s->d) + STAD_RESUME_BYTES(s->w, s->d);
}

static size_t part_bytes(const shape *s, int part)
{
    switch (part) {
    case PIXELS:
        return STAD_BYTES_UP(s->pixel_rows * 2 * s->w * s->cn);
    case FEATURES:
        return STAD_PART_FEATURES(s->w, s->cn);
    case COSTS:
        return STAD_BYTES_UP(STAD_COST_BYTES(s->cn, s->cap) * STAD_BYTES_MAX(s->cost_slots * s->cells, STAD_RUN * s->d));
    case WINDOW:
        return s->row;
    case TOTALS:
        return totals_bytes(s);
    case LANES:
        return s->two_pass ? 2 * s->state : s->state;
    case SEGMENT:
        return s->two_pass ? s->segment_rows * (s->safe ? 1 : 2) * s->row : 0;
    case CHECKPOINTS:
        return s->two_pass ? (s->segments - 1) * s->checkpoint : 0;
    case RUN:
        return STAD_PART_RUN(s->d);
    default:
        return STAD_PART_ROWS(s->w);
    }
}

size_t stad_match_bytes(const stad_geometry *g)
{
    size_t bytes = 0;
    if (stad_geometry_check(g, NULL) != STAD_OK)
        return 0;
    const shape s = shape_of(g);
    for (int part = 0; part < PART_COUNT; part++)
        bytes += part_bytes(&s, part);
    return bytes;
}

size_t stad_match_part(const stad_geometry *g, int i, const char **name)
{
    static const char *const names[PART_COUNT] = {"pixels", "features", "costs",       "window", "totals",
                                                  "lanes",  "segment",  "checkpoints", "run",    "rows"};
    const int known = i >= 0 && i < PART_COUNT && stad_geometry_check(g, NULL) == STAD_OK;
    if (name)
        *name = known ? names[i] : NULL;
    if (!known)
        return 0;
    const shape s = shape_of(g);
    return part_bytes(&s, i);
}

static int refuse(const char **culprit, const char *field)
{
    if (culprit)
        *culprit = field;
    return STAD_E_PARAM;
}

/* Could the bytes of the workspace leave size_t? Only where it has 32 bits. Every part but the pixels is a number of rows of
 * at most `row` bytes: the segment and its checkpoints at most 4 rows an image row, the ring and the block's reach at most
 * 2 * block, lanes and the rest at most 32. No division, so that small cores need no 64-bit one. */
static int is_too_large(const stad_geometry *g)
{
    const uint64_t w = (uint64_t)g->width, h = (uint64_t)g->height, d = (uint64_t)g->max_disparities;
    const uint64_t row = 2 * (STAD_CELLS(w, d) + d + 16 * (w + 2) + 64) + 14 * w * (uint64_t)g->channels;
    const uint64_t rows = 4 * h + 2 * (uint64_t)g->max_block_size + 32;
    return row * rows + 2 * w * h * (uint64_t)g->channels > SIZE_MAX;
}

int stad_geometry_check(const stad_geometry *g, const char **culprit)
{
    if (g->width < 1)
        return refuse(culprit, "width");
    if (g->height < 1)
        return refuse(culprit, "height");
    if (g->channels != 1 && g->channels != 3)
        return refuse(culprit, "channels");
    if (g->max_disparities < 8 || g->max_disparities % 8 != 0 || g->max_disparities > 4088)
        return refuse(culprit, "max_disparities");
    if (g->max_block_size < 1 || g->max_block_size % 2 == 0)
        return refuse(culprit, "max_block_size");
    if (g->max_p2 < 2)
        return refuse(culprit, "max_p2");
    if (g->max_pre_filter_cap < 15 || g->max_pre_filter_cap % 2 == 0)
        return refuse(culprit, "max_pre_filter_cap");
    if (g->mode > STAD_MODE_HH4)
        return refuse(culprit, "mode");
    if (g->memory > STAD_MEMORY_SMALL)
        return refuse(culprit, "memory");
    if (is_too_large(g))
        return refuse(culprit, "height");
    if (culprit)
        *culprit = NULL;
    return STAD_OK;
}

/* Cuts `bytes` off the front of what is left of the workspace. */
static uint8_t *take(uint8_t **rest, size_t bytes)
{
    uint8_t *start = *rest;
    *rest += bytes;
    return start;
}

static int16_t *take_i16(uint8_t **rest, size_t bytes)
{
    return (int16_t *)(void *)take(rest, STAD_BYTES_UP(bytes));
}

static void bind_totals(stad_frame *f, uint8_t *part)
{
    const stad_geometry *g = &f->g;
    f->total_row = NULL;
    f->run_total = NULL;
    f->resume = NULL;
    const int two_pass = g->mode == STAD_MODE_HH || g->mode == STAD_MODE_HH4;
    if (two_pass && g->memory == STAD_MEMORY_SMALL)
        return;
    if (STAD_TOTAL_WHOLE(g->mode, g->memory, f->narrow)) {
        f->total_row = take_i16(&part, f->cell_bytes);
    } else {
        f->run_total = take_i16(&part, 2 * STAD_RUN * (size_t)g->max_disparities);
        f->resume = part;
    }
}

static stad_lane take_across(uint8_t **rest, int32_t disparities)
{
    stad_lane lane = {NULL, NULL, 2, 0};
    lane.cost = take_i16(rest, 2 * (32 + 2 * ((size_t)disparities + 16))) + 16;
    lane.least = take_i16(rest, 4);
    return lane;
}

static void bind_run(stad_frame *f, uint8_t *part)
{
    const size_t d = (size_t)f->g.max_disparities;
    f->run_block = take_i16(&part, 2 * STAD_RUN * d);
    f->across = take_across(&part, f->g.max_disparities);
    f->resumed = take_across(&part, f->g.max_disparities);
    f->hs = take_i16(&part, 2 * d);
    take_i16(&part, 2 * d); /* hs holds two rows' running sums: the second follows the first */
}

static void bind_rows(stad_frame *f, uint8_t *part)
{
    const size_t w = (size_t)f->g.width;
    for (int i = 0; i < 3; i++) {
        f->raw[i] = take_i16(&part, 2 * w);
        f->votes[i] = take_i16(&part, 2 * w);
        f->confidence[i] = take(&part, STAD_BYTES_UP(w));
    }
    f->vote_cost = take_i16(&part, 2 * w);
    f->run_best = (stad_best *)(void *)take(&part, STAD_BYTES_UP(8 * STAD_RUN));
    f->run_fine = (int16_t *)(void *)(f->run_best + STAD_RUN);
}

static void derive(stad_frame *f, const shape *s)
{
    f->narrow = s->narrow;
    f->cost_slots = (int32_t)s->cost_slots;
    f->ring = s->memory == STAD_MEMORY_FAST || s->two_pass;
    f->pixel_rows = (int32_t)s->pixel_rows;
    f->segment_rows = (int32_t)s->segment_rows;
    f->segments = (int32_t)s->segments;
    f->cell_bytes = s->row;
    f->lane_bytes = s->lane;
    f->state_bytes = s->state;
    f->checkpoint_bytes = s->checkpoint;
}

void stad_plan_bind(stad_frame *f, void *work)
{
    const shape s = shape_of(&f->g);
    uint8_t *part[PART_COUNT], *rest = work;
    derive(f, &s);
    for (int i = 0; i < PART_COUNT; i++)
        part[i] = take(&rest, part_bytes(&s, i));
    f->pixels = part[PIXELS];
    f->features = part[FEATURES];
    f->costs = part[COSTS];
    f->window = (int16_t *)(void *)part[WINDOW];
    bind_totals(f, part[TOTALS]);
    f->down.memory = part[LANES];
    f->up.memory = part[LANES] + s.state;
    f->segment = part[SEGMENT];
    f->checkpoints = part[CHECKPOINTS];
    bind_run(f, part[RUN]);
    bind_rows(f, part[ROWS]);
}
