/* SPDX-License-Identifier: MIT
 * proof/prove_depth.c - depth of any disparities with any camera.
 * SOURCES: depth/depth.c */
#include "proof/prove.h"
#include "stad/depth.h"

int main(void)
{
    int16_t disp[24];
    uint16_t depth[24];
    stad_depth d = {(uint32_t)any64(0, UINT32_MAX), (int16_t)any(-32768, 32767), (int16_t)any(-32768, 32767)};
    any_i16(disp, 24, -32768, 32767);
    stad_depth_row(&d, disp, any(0, 24), depth);
    return 0;
}
