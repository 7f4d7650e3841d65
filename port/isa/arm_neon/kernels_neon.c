/* SPDX-License-Identifier: MIT
 * port/isa/arm_neon/kernels_neon.c - the templates instantiated for NEON. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "vec_neon.h"

#include "../arm_common/plane_row_arm.h"
#include "../arm_common/cost_row_arm.h"
#include "../arm_common/box_row_arm.h"
#include "../arm_common/block_row_arm.h"
#include "../arm_common/path_row_arm.h"
#include "../arm_common/best_row_arm.h"
