/* SPDX-License-Identifier: MIT
 * board/common/memory.c - the four functions of string.h that compilers and the library call.
 *
 * Copies go by words where both ends share their alignment. Built with -fno-builtin, or the compiler would turn each loop
 * into a call of the function it stands in. */
#include <stdint.h>
#include <string.h>

typedef uintptr_t __attribute__((may_alias)) word;

static int aligned(const void *a, const void *b)
{
    return (((uintptr_t)a | (uintptr_t)b) & (sizeof(word) - 1)) == 0;
}

void *memcpy(void *restrict to, const void *restrict from, size_t bytes)
{
    uint8_t *t = to;
    const uint8_t *f = from;
    if (aligned(t, f)) {
        for (; bytes >= sizeof(word); bytes -= sizeof(word)) {
            *(word *)(void *)t = *(const word *)(const void *)f;
            t += sizeof(word);
            f += sizeof(word);
        }
    }
    while (bytes-- > 0)
        *t++ = *f++;
    return to;
}

void *memmove(void *to, const void *from, size_t bytes)
{
    uint8_t *t = to;
    const uint8_t *f = from;
    if ((uintptr_t)t < (uintptr_t)f) {
        while (bytes-- > 0)
            *t++ = *f++;
    } else {
        while (bytes-- > 0)
            t[bytes] = f[bytes];
    }
    return to;
}

void *memset(void *to, int value, size_t bytes)
{
    uint8_t *t = to;
    const word fill = (word)-1 / 0xff * (uint8_t)value;
    for (; bytes > 0 && !aligned(t, t); bytes--)
        *t++ = (uint8_t)value;
    for (; bytes >= sizeof(word); bytes -= sizeof(word)) {
        *(word *)(void *)t = fill;
        t += sizeof(word);
    }
    while (bytes-- > 0)
        *t++ = (uint8_t)value;
    return to;
}

int memcmp(const void *a, const void *b, size_t bytes)
{
    const uint8_t *p = a, *q = b;
    for (; bytes > 0; bytes--, p++, q++)
        if (*p != *q)
            return *p - *q;
    return 0;
}
