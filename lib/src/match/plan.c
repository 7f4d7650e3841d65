/* SPDX-License-Identifier: MIT
 * geometry -> [PLAN] -> workspace
 * match/plan.c - the workspace: its parts in order, their bytes, and the pointers into them. */
#include "match/frame.h"
#include "base/arith.h"

enum part { PIXELS, FEATURES, COSTS, SUMS, TOTALS, LANES, SEGMENT, CHECKPOINTS, RUN, ROWS, PART_COUNT };

/* The geometry in the type of the macros. */
typedef struct shape {
    size_t w, h, cn, d, b, p2, cap;
    int mode, memory, narrow, safe;
} shape;

static shape shape_of(const stad_geometry *g)
{
    shape s = {(size_t)g->width,          (size_t)g->height, (size_t)g->channels,
               (size_t)g->max_disparities, (size_t)g->max_block_size, (size_t)g->max_p2,
               (size_t)g->max_pre_filter_cap, g->mode, g->memory, 0, 0};
    s.safe = STAD_COST_SAFE(s.cn, s.b, s.p2, s.cap);
    s.narrow = STAD_LANE_NARROW(s.cn, s.b, s.p2, s.cap, s.mode, s.memory);
    return s;
}

static size_t part_bytes(const stad_geometry *g, int part)
{
    const shape s = shape_of(g);
    switch (part) {
    case PIXELS:
        return STAD_PART_PIXELS(s.w, s.h, s.cn, s.b, s.mode);
    case FEATURES:
        return STAD_PART_FEATURES(s.w, s.cn);
    case COSTS:
        return STAD_PART_COSTS(s.w, s.cn, s.d, s.b, s.p2, s.cap, s.mode, s.memory);
    case SUMS:
        return STAD_PART_SUMS(s.w, s.d);
    case TOTALS:
        return STAD_PART_TOTALS(s.w, s.d, s.mode, s.memory, s.narrow);
    case LANES:
        return STAD_PART_LANES(s.w, s.d, s.mode, s.memory, s.narrow);
    case SEGMENT:
        return STAD_PART_SEGMENT(s.w, s.h, s.d, s.mode, s.memory, s.narrow, s.safe);
    case CHECKPOINTS:
        return STAD_PART_CHECKPOINTS(s.w, s.h, s.d, s.mode, s.memory, s.narrow, s.safe);
    case RUN:
        return STAD_PART_RUN(s.d);
    default:
        return STAD_PART_ROWS(s.w);
    }
}

size_t stad_match_bytes(const stad_geometry *g)
{
    if (stad_geometry_check(g, NULL) != STAD_OK)
        return 0;
    return STAD_MATCH_BYTES(g->width, g->height, g->channels, g->max_disparities, g->max_block_size, g->max_p2,
                            g->max_pre_filter_cap, g->mode, g->memory);
}

size_t stad_match_part(const stad_geometry *g, int i, const char **name)
{
    static const char *const names[PART_COUNT] = {"pixels", "features", "costs",       "sums", "totals",
                                                  "lanes",  "segment",  "checkpoints", "run",  "rows"};
    const int known = i >= 0 && i < PART_COUNT && stad_geometry_check(g, NULL) == STAD_OK;
    if (name)
        *name = known ? names[i] : NULL;
    return known ? part_bytes(g, i) : 0;
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
    f->best = (stad_best *)(void *)take(&part, STAD_BYTES_UP(6 * STAD_RUN));
}

static void derive(stad_frame *f)
{
    const stad_geometry *g = &f->g;
    const shape s = shape_of(g);
    f->narrow = s.narrow;
    f->cost_slots = (int32_t)STAD_COST_SLOTS(s.cn, s.b, s.p2, s.cap, s.mode, s.memory);
    f->ring = s.memory == STAD_MEMORY_FAST || s.mode == STAD_MODE_HH || s.mode == STAD_MODE_HH4;
    f->pixel_rows = (int32_t)STAD_PIXEL_ROWS(s.h, s.b, s.mode);
    f->segment_rows = (int32_t)STAD_SEGMENT_ROWS(s.h, s.mode, s.memory, s.narrow, s.safe);
    f->segments = (int32_t)STAD_SEGMENTS(s.h, s.mode, s.memory, s.narrow, s.safe);
    f->cell_bytes = STAD_BYTES_UP(2 * STAD_CELLS(s.w, s.d));
    f->lane_bytes = STAD_LANE_BYTES(s.w, s.d, s.memory, s.narrow);
    f->state_bytes = STAD_STATE_BYTES(s.w, s.d, s.mode, s.memory, s.narrow);
    f->checkpoint_bytes = f->state_bytes + (s.safe ? 0 : f->cell_bytes);
}

void plan_bind(stad_frame *f, void *work)
{
    const stad_geometry *g = &f->g;
    uint8_t *rest = work;
    derive(f);
    f->pixels = take(&rest, part_bytes(g, PIXELS));
    f->features = take(&rest, part_bytes(g, FEATURES));
    f->costs = take(&rest, part_bytes(g, COSTS));
    f->sums = take_i16(&rest, part_bytes(g, SUMS));
    bind_totals(f, take(&rest, part_bytes(g, TOTALS)));
    f->down.memory = take(&rest, part_bytes(g, LANES));
    f->up.memory = f->down.memory + f->state_bytes;
    f->segment = take(&rest, part_bytes(g, SEGMENT));
    f->checkpoints = take(&rest, part_bytes(g, CHECKPOINTS));
    bind_run(f, take(&rest, part_bytes(g, RUN)));
    bind_rows(f, take(&rest, part_bytes(g, ROWS)));
}
