/* SPDX-License-Identifier: MIT
 * examples/mcu/say.c - the little printing a firmware log needs. */
#include "say.h"

#include "board.h"

void say(const char *text)
{
    board_print(text);
}

void say_dec(int32_t value)
{
    char text[12];
    char *t = text + sizeof text;
    uint32_t rest = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
    *--t = '\0';
    do {
        *--t = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest > 0);
    if (value < 0)
        *--t = '-';
    board_print(t);
}

void say_hex(uint32_t value)
{
    char text[9];
    int i;
    for (i = 7; i >= 0; i--, value >>= 4)
        text[i] = "0123456789abcdef"[value & 15];
    text[8] = '\0';
    board_print(text);
}
