/* SPDX-License-Identifier: MIT
 * support/case.h - one random case: a scene, a size, a mode, a memory plan and parameters of the defined domain. */
#ifndef TEST_CASE_H
#define TEST_CASE_H

#include <stddef.h>
#include <stdint.h>

#include "scene.h"
#include "stad/params.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct test_case {
    scene view;
    int width, height, channels;
    int mode;            /* enum stad_mode */
    int memory;          /* enum stad_memory */
    uint32_t interleave; /* seed of the order of pushes and pulls */
    stad_params params;  /* as a user of OpenCV may give them: even, zero or negative values included */
} test_case;

/* Case number `index` of a run. stress: every parameter from the far ends of its domain, saturation the rule; otherwise
 * customary values. memory is left at 0. */
void case_random(test_case *c, uint32_t seed, uint32_t index, int mode, int stress);

/* Repairs the one value that the library cannot take as OpenCV does: in 3WAY a block_size <= 0 means radius 1, but its raw
 * number sizes the overlap of the stripes (docs/SPEC.md, section 7), which no stad_params in the domain can say. */
void case_settle(test_case *c);

/* 1 if the case lies in the defined domain (W > r, 8 or 16 divides D, |disparity| * 16 fits, ...). */
int case_defined(const test_case *c);

/* The case as options of stad-verify, in `text` (400 bytes are enough). */
void case_text(const test_case *c, char *text, size_t size);

/* Renders both views into buffers of width * height * channels bytes. */
void case_render(const test_case *c, uint8_t *left, uint8_t *right);

const char *case_mode_name(int mode);
int case_mode_of(const char *name); /* -1 if none */

/* CRC-32 (reflected 0xEDB88320) of a disparity map, each value as two bytes, low byte first, on any machine. */
uint32_t disparity_crc(const int16_t *disp, size_t count);

#ifdef __cplusplus
}
#endif

#endif
