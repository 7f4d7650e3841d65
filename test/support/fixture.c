/* SPDX-License-Identifier: MIT
 * support/fixture.c - cases with their images for the property tests (needs Unity). */
#include "support/fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "stad/status.h"
#include "unity.h"

static size_t pixels(const fixture *f)
{
    return (size_t)f->c.width * (size_t)f->c.height;
}

void fixture_make(fixture *f, uint32_t seed, uint32_t index, int mode, int memory, int stress)
{
    size_t bytes;
    case_random(&f->c, seed, index, mode, stress);
    case_settle(&f->c);
    f->c.memory = memory;
    bytes = pixels(f) * (size_t)f->c.channels;
    f->left = malloc(bytes);
    f->right = malloc(bytes);
    f->expected = malloc(pixels(f) * sizeof(int16_t));
    f->got = malloc(pixels(f) * sizeof(int16_t));
    case_render(&f->c, f->left, f->right);
    case_text(&f->c, f->text, sizeof f->text);
}

void fixture_free(fixture *f)
{
    free(f->left);
    free(f->right);
    free(f->expected);
    free(f->got);
}

void fixture_run(fixture *f, int form)
{
    const char *why = "";
    char message[700];
    int status = subject_run(&f->c, form, f->left, f->right, f->got, &why);
    snprintf(message, sizeof message, "%s %s: stad-verify %s", stad_status_name(status), why, f->text);
    TEST_ASSERT_EQUAL_INT_MESSAGE(0, status, message);
}

void fixture_expect_same(const fixture *f, const char *what)
{
    for (size_t i = 0; i < pixels(f); i++) {
        if (f->got[i] != f->expected[i]) {
            char message[800];
            snprintf(message, sizeof message, "%s: x=%d y=%d expected %d, got %d: stad-verify %s", what,
                     (int)(i % (size_t)f->c.width), (int)(i / (size_t)f->c.width), f->expected[i], f->got[i], f->text);
            TEST_FAIL_MESSAGE(message);
        }
    }
}

void bound_make(bound_match *b, const fixture *f, uint32_t poison)
{
    stad_geometry g;
    b->p = f->c.params;
    stad_params_normalize(&b->p, f->c.mode);
    b->p.speckle_window_size = 0;
    g = subject_geometry(&f->c, &b->p);
    b->bytes = stad_match_bytes(&g);
    b->work = subject_alloc(b->bytes, 0, poison);
    TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, stad_match_init(&b->m, &g, b->work, b->bytes), f->text);
}

void bound_free(bound_match *b)
{
    TEST_ASSERT_TRUE_MESSAGE(subject_guards_stand(b->work), "bytes outside the workspace were written");
    subject_free(b->work);
}

int bound_push(bound_match *b, const fixture *f, int y)
{
    size_t at = (size_t)y * (size_t)f->c.width * (size_t)f->c.channels;
    return stad_match_push(&b->m, f->left + at, f->right + at);
}

int bound_pull(bound_match *b, fixture *f)
{
    int16_t row[8192];
    int y = stad_match_pull(&b->m, row);
    if (y >= 0) {
        TEST_ASSERT_LESS_THAN_INT(f->c.height, y);
        memcpy(f->got + (size_t)y * (size_t)f->c.width, row, (size_t)f->c.width * sizeof row[0]);
    }
    return y;
}

void bound_finish(bound_match *b, fixture *f, int pushed)
{
    int pulled;
    for (int y = pushed; y < f->c.height; y++) {
        while (bound_pull(b, f) >= 0) {
        }
        TEST_ASSERT_EQUAL_INT_MESSAGE(STAD_OK, bound_push(b, f, y), f->text);
    }
    for (pulled = 0; bound_pull(b, f) >= 0 && pulled < f->c.height; pulled++) {
    }
}
