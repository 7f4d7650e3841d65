/* SPDX-License-Identifier: MIT
 * common/grid.h - numbers in rows: NumPy's .npy and Middlebury's .pfm, both ways. */
#ifndef TOOL_GRID_H
#define TOOL_GRID_H

#include <stdint.h>

#include "fail.h"

#ifdef __cplusplus
extern "C" {
#endif

/* height rows of width numbers, top row first. `integer`: the file held int16 (v is exact); else floating point, where
 * a NaN or an infinity means that there is no value. Owned; grid_free() frees. */
typedef struct grid {
    int width, height, integer;
    float *v;
} grid;

void grid_free(grid *g);

/* A two-dimensional array of int16, float32 or float64, either byte order, C order; of an .npz the
 * first array. */
int grid_read_npy(grid *g, const char *path, tool_fail *f);

/* One channel ("Pf"), either byte order; its rows are stored bottom up. */
int grid_read_pfm(grid *g, const char *path, tool_fail *f);

int npy_write_i16(const int16_t *v, int width, int height, const char *path, tool_fail *f);
int pfm_write(const float *v, int width, int height, const char *path, tool_fail *f);

#ifdef __cplusplus
}
#endif

#endif
