/* SPDX-License-Identifier: MIT
 * proof/prove_base.c - arithmetic verbs, logarithm, power, root, status names, the affine fit: any arguments.
 * SOURCES: base/log.c base/affine.c base/status.c
 *
 * The fit: any sums that points of the stated ranges (affine.h) can make, each taken apart from the others. */
#include "base/affine.h"
#include "base/arith.h"
#include "base/log.h"
#include "proof/prove.h"
#include "stad/status.h"

static void prove_verbs(void)
{
    int32_t v = any(INT32_MIN, INT32_MAX);
    int16_t a = (int16_t)any(-32768, 32767), b = (int16_t)any(-32768, 32767);
    sat_i16(v);
    wrap_i16(v);
    add_sat_i16(a, b);
    sub_sat_i16(a, b);
    mod_i32(v, any(1, INT32_MAX));
    abs_i32(any(-INT32_MAX, INT32_MAX));
    sub_floor_u8((uint8_t)any(0, 255), (uint8_t)any(0, 255));
    stad_status_name(v);
}

static void prove_logs(void)
{
    stad_log2_q16((uint32_t)any64(0, UINT32_MAX));
    stad_exp2_q16(any(INT32_MIN, INT32_MAX));
    stad_isqrt((uint64_t)any64(INT64_MIN, INT64_MAX));
}

/* Of up to `most` points. */
static stad_affine_sums any_sums(int most)
{
    const stad_affine_sums s = {any64(0, most),
                                any64(-(1ll << 27), 1ll << 27),
                                any64(-(1ll << 27), 1ll << 27),
                                any64(-(1ll << 34), 1ll << 34),
                                any64(0, 1ll << 42),
                                any64(-(1ll << 42), 1ll << 42),
                                any64(0, 1ll << 42),
                                any64(-(1ll << 49), 1ll << 49),
                                any64(-(1ll << 49), 1ll << 49)};
    return s;
}

static void prove_sums(void)
{
    stad_affine_sums s = any_sums(4095);
    stad_affine_add(&s, any(-32768, 32768), any(-32768, 32768), any(-(1 << 22), 1 << 22));
}

static void prove_fit(void)
{
    stad_affine_sums s = any_sums(4097);
    stad_affine fit;
    if (stad_affine_solve(&s, &fit))
        stad_affine_at_q8(&fit, any(-(1 << 20), 1 << 20), any(-(1 << 20), 1 << 20));
}

int main(void)
{
    prove_verbs();
    prove_logs();
    prove_sums();
    prove_fit();
    return 0;
}
