/* SPDX-License-Identifier: MIT
 * stad/match_bytes.h - the matcher's workspace as an integer constant expression, part by part.
 *
 * STAD_MATCH_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory) is what a static array
 * needs; match/plan.c lays the same parts out in the same order. docs/MEMORY.md draws them. All arithmetic is in the type of
 * the arguments, which STAD_MATCH_BYTES() and plan.c make size_t. */
#ifndef STAD_MATCH_BYTES_H
#define STAD_MATCH_BYTES_H

#include <stddef.h>

/* 64-bit words of a stad_match (private struct inside; a static check in match.c pins it). */
#define STAD_MATCH_WORDS 96

/* Columns that are handled as one run, so that their costs stay in the nearest cache. */
#define STAD_RUN 16

/* What follows adds up to STAD_MATCH_BYTES(), and is of no use by itself. @cond */

#define STAD_BYTES_UP(n)     (((size_t)(n) + 63u) & ~(size_t)63u)
#define STAD_BYTES_MAX(a, b) ((a) > (b) ? (a) : (b))

/* Cells of one row of a cost volume. (width - d) * d grows until d = width / 2, and smaller d than the largest may be asked
 * for, so that the maximum over all d up to max_disp is reserved. */
#define STAD_CELLS(w, d) \
    (2 * (size_t)(d) <= (size_t)(w) ? ((size_t)(w) - (d)) * (d) : ((size_t)(w) / 2) * ((size_t)(w) - (size_t)(w) / 2))

/* Largest pixel cost (SPEC 3), the bytes it takes, and whether a block cost can never saturate: b rows of b, and the row
 * that SPEC 4 adds before it takes one away. */
#define STAD_COST_TOP(cn, cap)   ((size_t)(cn) * ((2 * ((size_t)(cap) | 1u) > 255 ? 255 : 2 * ((size_t)(cap) | 1u)) + 63))
#define STAD_COST_BYTES(cn, cap) (STAD_COST_TOP(cn, cap) <= 255 ? (size_t)1 : (size_t)2)
#define STAD_COST_SAFE(cn, b, p2, cap) \
    ((b) <= 181 && (size_t)(p2) + (size_t)(b) * ((size_t)(b) + 1) * STAD_COST_TOP(cn, cap) <= 32767)

/* Path state in bytes instead of int16: exact while p2 <= 255 and C cannot saturate. Not in 3WAY, where the sum row it
 * needs would cost more than it saves. */
#define STAD_LANE_NARROW(cn, b, p2, cap, mode, memory) \
    ((memory) == 1 && (mode) != 2 && (p2) <= 255 && STAD_COST_SAFE(cn, b, p2, cap))

/* One lane: fence, then width + 1 slots of D cells and their padding; then one least value a slot. */
#define STAD_LANE_PAD(memory)         ((memory) == 1 ? (size_t)1 : (size_t)16)
#define STAD_LANE_CELLS(w, d, memory) (32 + STAD_CELLS(w, d) + (size_t)(d) + STAD_LANE_PAD(memory) * ((size_t)(w) + 2))
#define STAD_LANE_BYTES(w, d, memory, narrow)                \
    ((narrow) ? STAD_BYTES_UP(STAD_LANE_CELLS(w, d, memory)) \
              : STAD_BYTES_UP(2 * STAD_LANE_CELLS(w, d, memory)) + STAD_BYTES_UP(2 * ((size_t)(w) + 1)))
#define STAD_LANES_DOWN(mode) ((mode) == 2 || (mode) == 3 ? (size_t)1 : (size_t)3)

/* HH and HH4, `small`: rows of a segment that is recomputed from a checkpoint. Bytes are (rows of checkpoint) * h / k +
 * (rows kept) * k, least at k = sqrt(h * checkpoint / kept): the root by two Newton steps from a power of two. */
#define STAD_ROOT_SEED(q)         \
    ((q) >= 65536   ? (size_t)256 \
     : (q) >= 16384 ? (size_t)128 \
     : (q) >= 4096  ? (size_t)64  \
     : (q) >= 1024  ? (size_t)32  \
     : (q) >= 256   ? (size_t)16  \
     : (q) >= 64    ? (size_t)8   \
                    : (size_t)4)
#define STAD_ROOT_STEP(q, k) (((k) + (q) / (k)) / 2)
#define STAD_ROOT(q)         STAD_ROOT_STEP(q, STAD_ROOT_STEP(q, STAD_ROOT_SEED(q)))
#define STAD_SEGMENT_TARGET(h, mode, narrow, safe) \
    ((mode) == 1 ? ((narrow) ? 3 * (size_t)(h) / 2 \
                    : (safe) ? 3 * (size_t)(h)     \
                             : 2 * (size_t)(h))    \
                 : ((narrow) ? (size_t)(h) / 2 : (size_t)(h)))
#define STAD_SEGMENT_ROWS(h, mode, memory, narrow, safe)                                  \
    ((memory) == 1 && STAD_ROOT(STAD_SEGMENT_TARGET(h, mode, narrow, safe)) < (size_t)(h) \
         ? STAD_ROOT(STAD_SEGMENT_TARGET(h, mode, narrow, safe))                          \
         : (size_t)(h))
#define STAD_SEGMENTS(h, mode, memory, narrow, safe) \
    (((size_t)(h) + STAD_SEGMENT_ROWS(h, mode, memory, narrow, safe) - 1) / STAD_SEGMENT_ROWS(h, mode, memory, narrow, safe))

/* -- the parts, in order ------------------------------------------------------------------------------------------------ */

/* Rows of pixels of both images: what the window and the prefilter reach; 3WAY goes back over its stripes' overlap; HH and
 * HH4 come back from the bottom and keep all. */
#define STAD_PIXEL_ROWS_WANTED(h, b, mode) \
    ((size_t)((b) / 2) * 2 + 4 + ((mode) == 2 ? (size_t)((b) / 2) + 1 + (((size_t)(h) + 3) / 4 + 9) / 10 : 0))
#define STAD_PIXEL_ROWS(h, b, mode)                                                               \
    ((mode) == 1 || (mode) == 3 || STAD_PIXEL_ROWS_WANTED(h, b, mode) > (size_t)(h) ? (size_t)(h) \
                                                                                    : STAD_PIXEL_ROWS_WANTED(h, b, mode))
#define STAD_PART_PIXELS(w, h, cn, b, mode) STAD_BYTES_UP(STAD_PIXEL_ROWS(h, b, mode) * 2 * (size_t)(w) * (cn))

/* Feature rows of both images (value, low, high of 2 cn planes) and the planes they come from. */
#define STAD_PART_FEATURES(w, cn) STAD_BYTES_UP(14 * (size_t)(w) * (cn))

/* Pixel costs: a ring of whole rows where time counts (and in HH and HH4, which move their window twice), two rows where
 * sums may saturate, else one run of columns. */
#define STAD_COST_SLOTS(cn, b, p2, cap, mode, memory)                        \
    ((memory) == 0 || (mode) == 1 || (mode) == 3 ? (size_t)((b) / 2) * 2 + 2 \
     : STAD_COST_SAFE(cn, b, p2, cap)            ? (size_t)0                 \
                                                 : (size_t)2)
#define STAD_PART_COSTS(w, cn, d, b, p2, cap, mode, memory) \
    STAD_BYTES_UP(STAD_COST_BYTES(cn, cap) *                \
                  STAD_BYTES_MAX(STAD_COST_SLOTS(cn, b, p2, cap, mode, memory) * STAD_CELLS(w, d), STAD_RUN * (size_t)(d)))

/* The block costs C of a row; where no rows of pixel costs are kept and C cannot saturate, vertical sums. */
#define STAD_PART_WINDOW(w, d) STAD_BYTES_UP(2 * STAD_CELLS(w, d))

/* S of one row (HH and HH4 copy it to and from the segment, whose rows lie too far for the sweeps to work in); or, where
 * the lanes can give it back, one run and the horizontal path's state at the start of each run. */
#define STAD_TOTAL_WHOLE(mode, memory, narrow) ((memory) == 0 || (narrow))
#define STAD_RESUME_BYTES(w, d)                (((size_t)(w) + STAD_RUN - 1) / STAD_RUN * STAD_BYTES_UP(2 * ((size_t)(d) + 1)))
#define STAD_PART_TOTALS(w, d, mode, memory, narrow)                                     \
    (((mode) == 1 || (mode) == 3) && (memory) == 1 ? (size_t)0                           \
     : STAD_TOTAL_WHOLE(mode, memory, narrow)      ? STAD_BYTES_UP(2 * STAD_CELLS(w, d)) \
                                                   : STAD_BYTES_UP(2 * STAD_RUN * (size_t)(d)) + STAD_RESUME_BYTES(w, d))

/* Path state: the downward lanes, and in HH and HH4 the upward ones. */
#define STAD_STATE_BYTES(w, d, mode, memory, narrow) (STAD_LANES_DOWN(mode) * STAD_LANE_BYTES(w, d, memory, narrow))
#define STAD_PART_LANES(w, d, mode, memory, narrow) \
    (((mode) == 1 || (mode) == 3 ? (size_t)2 : (size_t)1) * STAD_STATE_BYTES(w, d, mode, memory, narrow))

/* S (and C where it may saturate) of a segment's rows, and the checkpoints before every segment but the first. */
#define STAD_PART_SEGMENT(w, h, d, mode, memory, narrow, safe)                                                          \
    ((mode) == 1 || (mode) == 3 ? STAD_SEGMENT_ROWS(h, mode, memory, narrow, safe) * ((safe) ? (size_t)1 : (size_t)2) * \
                                      STAD_BYTES_UP(2 * STAD_CELLS(w, d))                                               \
                                : (size_t)0)
#define STAD_PART_CHECKPOINTS(w, h, d, mode, memory, narrow, safe)                                                         \
    ((mode) == 1 || (mode) == 3                                                                                            \
         ? (STAD_SEGMENTS(h, mode, memory, narrow, safe) - 1) *                                                            \
               (STAD_STATE_BYTES(w, d, mode, memory, narrow) + ((safe) ? (size_t)0 : STAD_BYTES_UP(2 * STAD_CELLS(w, d)))) \
         : (size_t)0)

/* One run of block costs, two horizontal lanes, two running sums. */
#define STAD_ACROSS_BYTES(d) (STAD_BYTES_UP(2 * (32 + 2 * ((size_t)(d) + 16))) + STAD_BYTES_UP(4))
#define STAD_PART_RUN(d) \
    (STAD_BYTES_UP(2 * STAD_RUN * (size_t)(d)) + 2 * STAD_ACROSS_BYTES(d) + 2 * STAD_BYTES_UP(2 * (size_t)(d)))

/* Three rows each of raw disparities, votes of the right view and confidence; the votes' costs; one run of winners. */
#define STAD_PART_ROWS(w) (7 * STAD_BYTES_UP(2 * (size_t)(w)) + 3 * STAD_BYTES_UP(w) + STAD_BYTES_UP(8 * STAD_RUN))

#define STAD_MATCH_BYTES_(w, h, cn, d, b, p2, cap, mode, memory, narrow, safe)                                               \
    (STAD_PART_PIXELS(w, h, cn, b, mode) + STAD_PART_FEATURES(w, cn) + STAD_PART_COSTS(w, cn, d, b, p2, cap, mode, memory) + \
     STAD_PART_WINDOW(w, d) + STAD_PART_TOTALS(w, d, mode, memory, narrow) + STAD_PART_LANES(w, d, mode, memory, narrow) +   \
     STAD_PART_SEGMENT(w, h, d, mode, memory, narrow, safe) + STAD_PART_CHECKPOINTS(w, h, d, mode, memory, narrow, safe) +   \
     STAD_PART_RUN(d) + STAD_PART_ROWS(w))

/* @endcond */

/* The whole workspace, bytes. All arguments as in stad_geometry; each is used many times: pass constants. */
#define STAD_MATCH_BYTES(width, height, channels, max_disp, max_block, max_p2, max_cap, mode, memory)                     \
    STAD_MATCH_BYTES_(                                                                                                    \
        (size_t)(width), (size_t)(height), (size_t)(channels), (size_t)(max_disp), (size_t)(max_block), (size_t)(max_p2), \
        (size_t)(max_cap), (mode), (memory),                                                                              \
        STAD_LANE_NARROW((size_t)(channels), (size_t)(max_block), (size_t)(max_p2), (size_t)(max_cap), (mode), (memory)), \
        STAD_COST_SAFE((size_t)(channels), (size_t)(max_block), (size_t)(max_p2), (size_t)(max_cap)))

/* Workspace of stad_speckle_filter(): one 32-bit label a pixel. */
#define STAD_SPECKLE_BYTES(width, height) (STAD_BYTES_UP((size_t)(width) * (size_t)(height) * 4))

#endif
