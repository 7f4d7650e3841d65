/* SPDX-License-Identifier: MIT
 * port/isa/arm_mve/kernels_mve.c - the templates instantiated for Helium. */
#include <stddef.h>

#include "kernel/kernel.h"
#include "vec_mve.h"

#include "../arm_common/plane_row_arm.h"
#include "../arm_common/cost_row_arm.h"
#include "../arm_common/box_row_arm.h"
#include "../arm_common/block_row_arm.h"
#include "../arm_common/path_row_arm.h"
#include "../arm_common/best_row_arm.h"
