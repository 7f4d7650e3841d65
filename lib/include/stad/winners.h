/* SPDX-License-Identifier: MIT
 * stad/winners.h - a frame's winners, kept, so that the same frame with another uniqueness_ratio, disp12_max_diff or speckle
 * filter needs no matching.
 *
 *     stad_winners_init(&w, &geometry, memory, sizeof memory);
 *     stad_match_keep(&m, &w);
 *     stad_match_frame(&m, &params, ...);                  matches, and leaves the winners in w
 *     params.uniqueness_ratio = 15;
 *     if (stad_winners_serve(&w, &params))
 *         stad_match_frame_again(&m, &params, &w, ...);    the same bits as stad_match_frame(), in a sixth of its time
 *
 * A winner is the place, the cost and the best rival of a pixel, and its sub-pixel place: all that comes after the sums of
 * the paths asks for no more. Tuning profits, since it often moves only what is decided after the winners.
 * Memory: the caller owns both the struct and STAD_WINNERS_BYTES(width, height), which belong to the winners while a matcher
 * keeps or reads them. Nothing is freed. */
#ifndef STAD_WINNERS_H
#define STAD_WINNERS_H

#include "stad/match.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes of a row of winners: 8 a pixel. */
#define STAD_WINNERS_ROW(width) ((size_t)(width) * 8)

/* Bytes of a frame of them. */
#define STAD_WINNERS_BYTES(width, height) (STAD_WINNERS_ROW(width) * (size_t)(height))

/* The winners of one frame. Private. */
typedef struct stad_winners {
    stad_params params;    /* they were found with */
    int16_t width, height; /* of the frame */
    uint8_t mode;          /* enum stad_mode */
    int32_t rows;          /* of winners that are there */
    void *memory;          /* theirs */
} stad_winners;

/* The number that STAD_WINNERS_BYTES() gives at compile time; 0 if the geometry is invalid. */
size_t stad_winners_bytes(const stad_geometry *g);

/* Binds winners to their memory, aligned for int16_t; there are none yet. STAD_E_PARAM: bad geometry; STAD_E_SIZE: `memory` is
 * NULL, misaligned or too small. */
int stad_winners_init(stad_winners *w, const stad_geometry *g, void *memory, size_t bytes);

/* Drops the winners: to be called when another pair of images comes, not while a frame is being kept. */
void stad_winners_forget(stad_winners *w);

/* 1: these winners are whole and were found with parameters that differ from `p` at most in uniqueness_ratio,
 * disp12_max_diff and the speckle filter's; 0 otherwise. Whether they are of the same images only the caller knows. */
int stad_winners_serve(const stad_winners *w, const stad_params *p);

/* From the next stad_match_begin() on a matcher leaves the winners of its frames in w, each frame's in the place of the one
 * before; NULL: no longer. A frame that is under way is dropped. STAD_E_SIZE: w is for another size or mode. */
int stad_match_keep(stad_match *m, stad_winners *w);

/* Starts a frame whose winners are known: nothing is pushed, rows are pulled at once, all counters are as a match would
 * count. Errors of stad_match_begin(); STAD_E_SIZE: w is for another size or mode; STAD_E_STATE: w does not serve p. */
int stad_match_again(stad_match *m, const stad_params *p, const stad_winners *w);

/* The whole frame, as stad_match_frame(). */
int stad_match_frame_again(stad_match *m, const stad_params *p, const stad_winners *w, int16_t *disp_q4, ptrdiff_t disp_stride,
                           void *speckle_work, size_t speckle_bytes);

#ifdef __cplusplus
}
#endif

#endif
