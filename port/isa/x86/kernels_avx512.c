/* SPDX-License-Identifier: MIT
 * port/isa/x86/kernels_avx512.c - the templates instantiated for this tier. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "vec_avx512.h"

#define STAD_NARROWER(name) name##_avx2

#include "plane_row_x86.h"
#include "cost_row_x86.h"
#include "box_row_x86.h"
#include "block_row_x86.h"
#include "path_row_x86.h"
#include "best_row_x86.h"
#include "last_row_x86.h"
