/* SPDX-License-Identifier: MIT
 * common/grid_bytes.h - private to the grid files: numbers as bytes. */
#ifndef TOOL_GRID_BYTES_H
#define TOOL_GRID_BYTES_H

#include <stddef.h>
#include <stdint.h>

#include "grid.h"

/* Largest file read: the largest sides in float64 would be more, but not a disparity map. */
#define GRID_FILE_MAX ((size_t)1 << 30)

enum grid_kind { GRID_I16 = 2, GRID_F32 = 4, GRID_F64 = 8 }; /* the value is the size in bytes */

uint64_t grid_word(const uint8_t *at, int bytes, int big_endian);
float grid_number(const uint8_t *at, enum grid_kind kind, int big_endian);
int grid_alloc(grid *g, long width, long height, const char *path, tool_fail *f);

/* Unpacks the first member of an archive into *npy (malloc). */
int npz_first(const uint8_t *file, size_t size, uint8_t **npy, size_t *n, const char *path, tool_fail *f);

#endif
