/* SPDX-License-Identifier: MIT
 * base/bytes.h - what a freestanding library does without: it asks for memcpy and memset alone. */
#ifndef STAD_BASE_BYTES_H
#define STAD_BASE_BYTES_H

#include <stddef.h>

static inline int bytes_equal(const void *a, const void *b, size_t count)
{
    const unsigned char *p = a, *q = b;
    size_t i = 0;
    while (i < count && p[i] == q[i])
        i++;
    return i == count;
}

#endif
