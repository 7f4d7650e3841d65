/* SPDX-License-Identifier: MIT
 * kernel/room.h - buffers between pages that may not be touched, and random contents for them.
 *
 * A buffer either ends at the page that follows or begins a few elements behind the page before, so its base is misaligned
 * as often as not and a read past either end stops the program. What is left of its pages holds a pattern that
 * rooms_intact() looks for. */
#ifndef TEST_KERNEL_ROOM_H
#define TEST_KERNEL_ROOM_H

#include <stddef.h>
#include <stdint.h>

/* The fills of a case; EVEN is plain chance. */
enum fill { FILL_LEAST, FILL_MOST, FILL_NEARLY, FILL_ENDS, FILL_EVEN, FILL_COUNT };

/* Random numbers and the fill of the case at hand. */
typedef struct chance {
    uint32_t state;
    enum fill fill;
} chance;

uint32_t chance_draw(chance *c);
int32_t chance_between(chance *c, int32_t low, int32_t high);
int32_t chance_value(chance *c, int32_t low, int32_t high); /* as the fill says */

void *room_take(chance *c, size_t bytes, size_t element); /* never NULL; lives until rooms_release */
void *room_twin(const void *other);                       /* the same size, place and contents once more */
int rooms_intact(void);                                   /* nothing was written beside a buffer */
void rooms_release(void);
const char *room_last_fault(void); /* which buffer rooms_intact() found spoilt */

uint8_t *room_u8(chance *c, int32_t n, int32_t low, int32_t high);
int16_t *room_i16(chance *c, int32_t n, int32_t low, int32_t high);
uint16_t *room_u16(chance *c, int32_t n, int32_t low, int32_t high);

#endif
