/* SPDX-License-Identifier: MIT
 * stad/plan_board.h - plan -> [BOARD]         what of a plan a board of port/board has room for, and what a frame takes. */
#ifndef STAD_PLAN_BOARD_H
#define STAD_PLAN_BOARD_H

#include <stddef.h>

#include "stad/match.h"

typedef struct plan_board plan_board;

/* The board of that name, or NULL. */
const plan_board *plan_board_named(const char *name);

/* All names with commas between them. */
void plan_board_names(char *to, size_t bytes);

/* Its core and memory, and what a matcher needs there beside its workspace. */
void plan_board_print(const plan_board *b, const stad_geometry *g);

/* Bytes of RAM the matcher leaves there: workspace, context, a row of every kind, stack; negative: it lacks as many. */
long plan_board_left(const plan_board *b, const stad_geometry *g);

/* Instructions of a frame, about: as counted at 160 x 120 with 32 disparities; 0: not counted. */
double plan_board_instructions(const plan_board *b, const stad_geometry *g);

/* The line about self-calibration on the board, of a geometry of SGBM and the small plan: frames held, one workspace for
 * live matches, marks and evaluations. */
void plan_board_print_loop(const plan_board *b, const stad_geometry *g);

#endif
