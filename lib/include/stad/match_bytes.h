/* SPDX-License-Identifier: MIT
 * stad/match_bytes.h - the matcher's workspace as integer constant expressions.
 *
 * PLACEHOLDER of the arithmetic: filled in by match/plan.c's twin. */
#ifndef STAD_MATCH_BYTES_H
#define STAD_MATCH_BYTES_H
#include <stddef.h>
#define STAD_MATCH_WORDS 96
#define STAD_SPECKLE_BYTES(width, height) ((size_t)(width) * (size_t)(height) * 4)
#endif
