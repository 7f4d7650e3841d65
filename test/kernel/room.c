/* SPDX-License-Identifier: MIT
 * kernel/room.c - guarded buffers from mmap, and random contents. */
#define _DEFAULT_SOURCE
#include "kernel/room.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { ROOMS = 32, PATTERN = 0xa7 };

/* `pages` bytes between two forbidden pages, kept from case to case; the buffer lies at `offset` and has `bytes`. */
typedef struct room {
    uint8_t *base;
    size_t pages, offset, bytes;
} room;

static room rooms[ROOMS];
static int taken;
static char fault[80];

uint32_t chance_draw(chance *c)
{
    c->state ^= c->state << 13;
    c->state ^= c->state >> 17;
    c->state ^= c->state << 5;
    return c->state;
}

int32_t chance_between(chance *c, int32_t low, int32_t high)
{
    return low + (int32_t)(chance_draw(c) % (uint32_t)(high - low + 1));
}

int32_t chance_value(chance *c, int32_t low, int32_t high)
{
    const uint32_t coin = chance_draw(c);
    const int32_t inner = low < high;
    switch (c->fill) {
    case FILL_LEAST:
        return low;
    case FILL_MOST:
        return high;
    case FILL_NEARLY:
        return coin % 4 == 0 ? low + inner : coin % 4 == 1 ? high - inner : coin % 4 == 2 ? high : low;
    case FILL_ENDS:
        return coin % 3 == 0 ? low : coin % 3 == 1 ? high : chance_between(c, low, high);
    default:
        return chance_between(c, low, high);
    }
}

static size_t page(void)
{
    return (size_t)sysconf(_SC_PAGESIZE);
}

static void *must(void *p)
{
    if (p == MAP_FAILED || p == NULL) {
        fputs("room: no memory\n", stderr);
        exit(3);
    }
    return p;
}

/* The next room with place for `bytes`, all pattern. */
static room *next_room(size_t bytes)
{
    room *r = &rooms[taken++];
    const size_t want = (bytes + 64 + page() - 1) / page() * page();
    must(taken <= ROOMS ? r : NULL);
    if (r->pages < want) {
        if (r->base)
            munmap(r->base - page(), r->pages + 2 * page());
        r->base = must(mmap(NULL, want + 2 * page(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
        r->base += page();
        r->pages = want;
        must(mprotect(r->base, want, PROT_READ | PROT_WRITE) == 0 ? r : NULL);
    }
    memset(r->base, PATTERN, r->pages);
    r->bytes = bytes;
    return r;
}

void *room_take(chance *c, size_t bytes, size_t element)
{
    room *r = next_room(bytes);
    r->offset = chance_draw(c) % 3 ? r->pages - bytes : element * (chance_draw(c) % (64 / element));
    return r->base + r->offset;
}

void *room_twin(const void *other)
{
    int i = 0;
    room *r;
    while (rooms[i].base + rooms[i].offset != (const uint8_t *)other)
        i++;
    r = next_room(rooms[i].bytes);
    r->offset = rooms[i].offset + r->bytes == rooms[i].pages ? r->pages - r->bytes : rooms[i].offset;
    memcpy(r->base + r->offset, other, r->bytes);
    return r->base + r->offset;
}

int rooms_intact(void)
{
    for (int i = 0; i < taken; i++)
        for (size_t at = 0; at < rooms[i].pages; at++) {
            if (at == rooms[i].offset)
                at += rooms[i].bytes;
            if (at < rooms[i].pages && rooms[i].base[at] != PATTERN) {
                snprintf(fault, sizeof fault, "buffer %d of %zu bytes: written at byte %td", i, rooms[i].bytes,
                         (ptrdiff_t)at - (ptrdiff_t)rooms[i].offset);
                return 0;
            }
        }
    return 1;
}

const char *room_last_fault(void)
{
    return fault;
}

void rooms_release(void)
{
    taken = 0;
    fault[0] = '\0';
}

uint8_t *room_u8(chance *c, int32_t n, int32_t low, int32_t high)
{
    uint8_t *p = room_take(c, (size_t)n, 1);
    for (int32_t i = 0; i < n; i++)
        p[i] = (uint8_t)chance_value(c, low, high);
    return p;
}

int16_t *room_i16(chance *c, int32_t n, int32_t low, int32_t high)
{
    int16_t *p = room_take(c, 2 * (size_t)n, 2);
    for (int32_t i = 0; i < n; i++)
        p[i] = (int16_t)chance_value(c, low, high);
    return p;
}

uint16_t *room_u16(chance *c, int32_t n, int32_t low, int32_t high)
{
    uint16_t *p = room_take(c, 2 * (size_t)n, 2);
    for (int32_t i = 0; i < n; i++)
        p[i] = (uint16_t)chance_value(c, low, high);
    return p;
}
