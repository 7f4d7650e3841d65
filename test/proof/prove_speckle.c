/* SPDX-License-Identifier: MIT
 * proof/prove_speckle.c - the speckle filter on any map of up to 4 x 3 px, any sizes and thresholds.
 * SOURCES: match/speckle.c
 * KNOWN: valid_read(label + parent)
 * GUARD: match/speckle.c label[b] = a;
 * OPTIONS: -eva-min-loop-unroll 16
 * The analysis does not see that a parent is the index of a pixel joined before. */
#include "proof/prove.h"
#include "stad/match.h"

int main(void)
{
    static int16_t disp[4 * 3];
    static int32_t work[4 * 3 * 4];
    any_i16(disp, 12, -32768, 32767);
    stad_speckle_filter(disp, 4, 4, 3, (int16_t)any(-32768, 32767), any(0, INT32_MAX), any(0, INT32_MAX), work, sizeof work);
    stad_speckle_filter(disp, 4, any(INT32_MIN, 0), any(INT32_MIN, INT32_MAX), -16, 3, 16, work, sizeof work);
    return 0;
}
