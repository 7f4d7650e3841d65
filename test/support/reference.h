/* SPDX-License-Identifier: MIT
 * support/reference.h - docs/SPEC.md written out as slowly and plainly as it reads.
 *
 * Whole image, whole cost volumes, no kernel and no line of the library: the second opinion that needs no OpenCV. It takes
 * parameters as OpenCV does and repairs them by section 1 on its own. Each quirk of the specification can be mended, to
 * prove that a set of tests would notice. */
#ifndef TEST_REFERENCE_H
#define TEST_REFERENCE_H

#include <stdint.h>

#include "stad/params.h"

#ifdef __cplusplus
extern "C" {
#endif

enum reference_mend {
    MEND_SATURATION = 1 << 0,       /* plain int, wrapped on store */
    MEND_BORDER_INTENSITY = 1 << 1, /* first and last column keep their intensity */
    MEND_HH4_LAST_ROWS = 1 << 2,    /* HH4 sums the last rows like the others */
    MEND_3WAY_TIES = 1 << 3,        /* 3WAY takes the first minimum */
    MEND_3WAY_LANES = 1 << 4,       /* 3WAY ties as 16 lanes would leave them */
    MEND_3WAY_UNIQUENESS = 1 << 5,  /* 3WAY uses the exact uniqueness test */
    MEND_UNSET_RIGHT = 1 << 6,      /* right pixels without a vote never reject */
    MEND_CHECK_OFF = 1 << 7,        /* disp12_max_diff <= 0 switches the check off */
    MEND_MEDIAN = 1 << 8,           /* no median */
    MEND_3WAY_BLOCK = 1 << 9,       /* 3WAY's default block is 5 too */
    MEND_SUBPIXEL = 1 << 10,        /* sub-pixel division rounds down */
    MEND_3WAY_SHIFT = 1 << 11,      /* tiny heights do not shift 3WAY's stripes */
    MEND_COST_ORDER = 1 << 12,      /* block sums swap the order of + and - */
    MEND_PATH_ORDER = 1 << 13,      /* paths are summed in the opposite order */
    MEND_COST_GATE = 1 << 14,       /* no saturation half way through a step where the sums themselves fit */
    MEND_COUNT = 15
};

/* Name of mend number i (0 .. MEND_COUNT - 1), as the option --mend takes it. */
const char *reference_mend_name(int i);

/* What lies beyond OpenCV (docs/SPEC.md, section 11): each pointer may be NULL; the maps have width * height values. */
typedef struct reference_extras {
    int32_t considered, firm, rejected_uniqueness, rejected_check, valid, rejected_speckle;
    int16_t *right_q4;
    uint8_t *confidence;
} reference_extras;

/* disp_q4: width * height values. 0, or -1 when memory runs out or no column can have a disparity. */
int reference_match(const stad_params *raw, int mode, unsigned mends, const uint8_t *left, const uint8_t *right, int width,
                    int height, int channels, int16_t *disp_q4);
int reference_match_extras(const stad_params *raw, int mode, unsigned mends, const uint8_t *left, const uint8_t *right, int width,
                           int height, int channels, int16_t *disp_q4, reference_extras *extras);

#ifdef __cplusplus
}
#endif

#endif
