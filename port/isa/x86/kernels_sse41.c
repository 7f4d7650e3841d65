/* SPDX-License-Identifier: MIT
 * port/isa/x86/kernels_sse41.c - the templates instantiated for this tier. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "vec_sse41.h"

#define STAD_NARROWER(name) name##_c

#include "plane_row_x86.h"
#include "cost_row_x86.h"
#include "box_row_x86.h"
#include "block_row_x86.h"
#include "path_row_x86.h"
#include "best_row_x86.h"
#include "last_row_x86.h"
