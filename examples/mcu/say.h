/* SPDX-License-Identifier: MIT
 * examples/mcu/say.h - the little printing a firmware log needs. */
#ifndef SAY_H
#define SAY_H

#include <stdint.h>

void say(const char *text);
void say_dec(int32_t value);
void say_hex(uint32_t value); /* eight digits */

#endif
