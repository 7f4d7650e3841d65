/* SPDX-License-Identifier: MIT
 * tools/study/marks/print_codes.c - prints lib/src/mark/mark_codes.c from libapriltag.
 *
 *     cc print_codes.c -lapriltag -o print_codes && ./print_codes > lib/src/mark/mark_codes.c
 *
 * libapriltag numbers the bits of a word along a spiral of quadrants; here they are put in reading order, the bit of the top
 * left cell highest. The words are data of the AprilTag family 36h11 (libapriltag: BSD-2-Clause). */
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <inttypes.h>
#include <stdio.h>

#define WORDS 32

static uint64_t reading_order(const apriltag_family_t *family, uint64_t code)
{
    uint64_t word = 0;
    for (uint32_t bit = 0; bit < family->nbits; bit++) {
        uint64_t value = code >> (family->nbits - 1 - bit) & 1;
        uint32_t cell = (family->bit_y[bit] - 1) * 6 + family->bit_x[bit] - 1;
        word |= value << (35 - cell);
    }
    return word;
}

int main(void)
{
    apriltag_family_t *family = tag36h11_create();
    if (family->nbits != 36 || family->ncodes < WORDS || family->width_at_border != 8)
        return 1;
    puts("/* SPDX-License-Identifier: MIT\n"
         " * mark/mark_codes.c - the first 32 words of the AprilTag family 36h11.\n"
         " *\n"
         " * Printed by tools/study/marks/print_codes.c from libapriltag (Copyright 2013-2016 The Regents of The University of\n"
         " * Michigan, BSD-2-Clause). Bit 35 is the top left cell, in reading order; a set bit is white. */\n"
         "#include \"mark/mark_work.h\"\n"
         "\n"
         "const uint64_t stad_mark_codes[STAD_MARK_IDS] = {");
    for (int i = 0; i < WORDS; i += 4) {
        printf("    ");
        for (int k = i; k < i + 4; k++)
            printf("0x%09" PRIx64 "u,%s", reading_order(family, family->codes[k]), k < i + 3 ? " " : "\n");
    }
    puts("};");
    tag36h11_destroy(family);
    return 0;
}
