/* SPDX-License-Identifier: MIT
 * support/subject.h - the library under test, driven through its public headers on guarded memory. */
#ifndef TEST_SUBJECT_H
#define TEST_SUBJECT_H

#include <stdint.h>

#include "case.h"
#include "stad/match.h"

#ifdef __cplusplus
extern "C" {
#endif

enum subject_form {
    SUBJECT_FRAME, /* stad_match_frame */
    SUBJECT_ROWS   /* push and pull in a random order, then the speckle filter */
};

/* The smallest geometry that holds a case with normalised parameters. */
stad_geometry subject_geometry(const test_case *c, const stad_params *normal);

/* Allocates exactly `bytes` at STAD_ALIGN + offset, filled with noise, guard bytes on both sides; subject_check answers 1
 * while the guards stand, subject_free releases. */
void *subject_alloc(size_t bytes, size_t offset, uint32_t seed);
int subject_guards_stand(const void *p);
void subject_free(void *p);

/* Computes a case. 0, or a negative stad_status, or SUBJECT_GUARD when something outside the buffers was written. On an
 * error *why names the call (or the culprit). */
#define SUBJECT_GUARD (-1000)
int subject_run(const test_case *c, int form, const uint8_t *left, const uint8_t *right, int16_t *disp_q4, const char **why);

#ifdef __cplusplus
}
#endif

#endif
