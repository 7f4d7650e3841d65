/* SPDX-License-Identifier: MIT
 * support/fixture.h - what the property tests share: cases with their images, and messages that replay. */
#ifndef TEST_FIXTURE_H
#define TEST_FIXTURE_H

#include "support/subject.h"

/* A case, its views and two maps, all on the heap. */
typedef struct fixture {
    test_case c;
    uint8_t *left, *right;
    int16_t *expected, *got;
    char text[600]; /* how to replay it */
} fixture;

/* Random case `index` (see case_random), settled, rendered. */
void fixture_make(fixture *f, uint32_t seed, uint32_t index, int mode, int memory, int stress);
void fixture_free(fixture *f);

/* Runs the library into f->got; fails the test with the replay line on an error. */
void fixture_run(fixture *f, int form);

/* Fails the test with the first differing pixel unless got equals expected. */
void fixture_expect_same(const fixture *f, const char *what);

/* A matcher on a workspace of its own, ready to begin. */
typedef struct bound_match {
    stad_match m;
    stad_params p; /* the case's, normalised */
    void *work;
    size_t bytes;
} bound_match;
void bound_make(bound_match *b, const fixture *f, uint32_t poison);
void bound_free(bound_match *b);

/* One row in, or one row out into f->got; returns the status (pull: the row number). */
int bound_push(bound_match *b, const fixture *f, int y);
int bound_pull(bound_match *b, fixture *f);

/* The rest of a frame that has been begun and got `pushed` rows, in order. */
void bound_finish(bound_match *b, fixture *f, int pushed);

#endif
