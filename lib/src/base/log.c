/* SPDX-License-Identifier: MIT
 * base/log.c - logarithm by repeated squaring, power of two by a table, square root bit by bit. */
#include "base/log.h"

int32_t stad_log2_q16(uint32_t v)
{
    int32_t whole = 0;
    if (v == 0)
        return 0;
    while (whole < 31 && v >> (whole + 1) != 0)
        whole++;
    uint64_t m = ((uint64_t)v << 31) >> whole; /* Q31 in [1, 2) */
    int32_t log_q16 = whole;
    for (int bit = 0; bit < 17; bit++) {
        m = (m * m) >> 31; /* < 2^33: squares of numbers below 2 in Q31 fit 64 bits */
        const int carry = m >> 32 != 0;
        m >>= carry;
        log_q16 = log_q16 * 2 + carry;
    }
    return (log_q16 + 1) >> 1;
}

/* round(65536 * 2^(i / 32)), i = 0..32 */
static const int32_t exp2_table[33] = {65536,  66971,  68438,  69936,  71468,  73032,  74632,  76266,  77936,  79642,  81386,
                                       83169,  84990,  86851,  88752,  90696,  92682,  94711,  96785,  98905,  101070, 103283,
                                       105545, 107856, 110218, 112631, 115098, 117618, 120194, 122825, 125515, 128263, 131072};

int64_t stad_exp2_q16(int32_t e_q16)
{
    const int32_t low = -16 * 65536;
    const int32_t high = 30 * 65536 - 1;
    const int32_t e = (e_q16 < low ? low : e_q16 > high ? high : e_q16) - low; /* >= 0, so shifts below floor */
    const int32_t i = (e & 65535) >> 11;
    const int64_t part = e & 2047;
    const int64_t chord = (exp2_table[i + 1] - exp2_table[i]) * part; /* Q27 */
    /* the curve hangs under the chord by ln(2)^2 / 2 * t * (1/32 - t); 15745 is ln(2)^2 / 2 in Q16; < 2^52 */
    const int64_t sag = (exp2_table[i] * part * (2048 - part) * 15745) >> 37;
    const int64_t m = exp2_table[i] + ((chord - sag + 1024) >> 11);
    const int32_t whole = (e >> 16) - 16;
    return whole >= 0 ? m << whole : m >> -whole;
}

uint32_t stad_isqrt(uint64_t v)
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        const uint64_t trial = root + bit;
        root >>= 1;
        if (v >= trial) {
            v -= trial;
            root += bit;
        }
    }
    return (uint32_t)root;
}
