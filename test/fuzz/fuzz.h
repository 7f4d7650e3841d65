/* SPDX-License-Identifier: MIT
 * fuzz/fuzz.h - the fuzzer's bytes as numbers and fills, and what must hold. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef struct bytes {
    const uint8_t *at;
    size_t left;
} bytes;

/* The next byte, 0 past the end. */
static inline int next(bytes *b)
{
    int v = b->left ? *b->at : 0;
    b->at += b->left > 0;
    b->left -= b->left > 0;
    return v;
}

static inline int next_i16(bytes *b)
{
    int high = next(b);
    return high * 256 + next(b) - 32768;
}

static inline int32_t next_i32(bytes *b)
{
    uint32_t v = 0;
    for (int i = 0; i < 4; i++) {
        v = v << 8 | (uint32_t)next(b);
    }
    return (int32_t)v;
}

/* Mostly 0 .. usual - 1, sometimes any int16. */
static inline int16_t number(bytes *b, int usual)
{
    int v = next(b);
    return (int16_t)(v < 240 ? v % usual : next_i16(b));
}

/* n bytes made of what is left, from a place that `key` chooses. */
static inline void fill(uint8_t *to, size_t n, const bytes *b, size_t key)
{
    for (size_t i = 0; i < n; i++) {
        to[i] = b->left ? b->at[(i * 7 + i / b->left + key) % b->left] : (uint8_t)(i * 29 + key);
    }
}

#define expect(condition)                                                                  \
    do {                                                                                   \
        if (!(condition)) {                                                                \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition); \
            abort();                                                                       \
        }                                                                                  \
    } while (0)

#endif
