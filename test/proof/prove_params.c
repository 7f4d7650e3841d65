/* SPDX-License-Identifier: MIT
 * proof/prove_params.c - parameters of any value: normalised, checked and made without overflow.
 * SOURCES: match/params.c */
#include <limits.h>

#include "proof/prove.h"
#include "stad/params.h"

static stad_params any_params(void)
{
    stad_params p;
    p.min_disparity = (int16_t)any(-32768, 32767);
    p.num_disparities = (int16_t)any(-32768, 32767);
    p.block_size = (int16_t)any(-32768, 32767);
    p.p1 = (int16_t)any(-32768, 32767);
    p.p2 = (int16_t)any(-32768, 32767);
    p.disp12_max_diff = (int16_t)any(-32768, 32767);
    p.pre_filter_cap = (int16_t)any(-32768, 32767);
    p.uniqueness_ratio = (int16_t)any(-32768, 32767);
    p.speckle_window_size = any(INT_MIN, INT_MAX);
    p.speckle_range = any(INT_MIN, INT_MAX);
    return p;
}

int main(void)
{
    stad_params p = any_params();
    const char *culprit;
    stad_params_normalize(&p, any(INT_MIN, INT_MAX));
    stad_params_check(&p, any(0, 3), any(1, 32767), &culprit);
    p = any_params();
    stad_params_check(&p, any(INT_MIN, INT_MAX), any(-32768, 32767), &culprit);
    stad_params_sample(&p, any(-32768, 32767), any(-32768, 32767), any(1, 3));
    stad_params_default(&p, any(-32768, 32767));
    return 0;
}
