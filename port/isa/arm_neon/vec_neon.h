/* SPDX-License-Identifier: MIT
 * port/isa/arm_neon/vec_neon.h - the vector verbs of the templates in arm_common, 8 lanes of 16 bits: A64 and A32. */
#ifndef STAD_VEC_H
#define STAD_VEC_H

#include <arm_neon.h>
#include <stdint.h>

#define STAD_TIER(name) name##_neon

#define VEC_IN_ORDER /* of 8 disparities after 8: registers suffice for any order */

typedef int16x8_t vec;

#if defined(__aarch64__)
#    define VEC_ABREAST 4 /* lanes of the path kernel that 32 registers hold */
static inline uint16_t vec_least(vec v)
{
    return vminvq_u16(vreinterpretq_u16_s16(v));
}

static inline int vec_least_signed(vec v)
{
    return vminvq_s16(v);
}
#else
#    define VEC_ABREAST 2 /* of 16 registers */
static inline uint16_t vec_least(vec v)
{
    uint16x4_t half = vmin_u16(vreinterpret_u16_s16(vget_low_s16(v)), vreinterpret_u16_s16(vget_high_s16(v)));
    half = vpmin_u16(half, half);
    return vget_lane_u16(vpmin_u16(half, half), 0);
}

static inline int vec_least_signed(vec v)
{
    int16x4_t half = vmin_s16(vget_low_s16(v), vget_high_s16(v));
    half = vpmin_s16(half, half);
    return vget_lane_s16(vpmin_s16(half, half), 0);
}
#endif

/* 16 bytes: lanes of 16 bits in memory order on a little-endian core, which both are. */
static inline vec vec_load(const void *p)
{
    return vreinterpretq_s16_u8(vld1q_u8(p));
}

static inline void vec_store(void *p, vec v)
{
    vst1q_u8(p, vreinterpretq_u8_s16(v));
}

/* Four vectors in one instruction. */
#if defined(__aarch64__)
#    define VEC_FOURS 1
typedef int16x8x4_t vec4;
#    define vec4_load(p) vld1q_s16_x4(p)

#    if defined(__clang__)
#        define vec4_store(p, v) vst1q_s16_x4(p, v)
#    else
/* Not vst1q_s16_x4: gcc 12 moves the vectors into consecutive registers for it. Without, it stores pairs. */
static inline __attribute__((always_inline)) void vec4_store(int16_t *p, vec4 v)
{
    vec_store(p, v.val[0]);
    vec_store(p + 8, v.val[1]);
    vec_store(p + 16, v.val[2]);
    vec_store(p + 24, v.val[3]);
}
#    endif

/* Differences of 32 bytes. */
static inline vec4 vec4_sub_widened(const uint8_t *a, const uint8_t *b)
{
    const uint8x16x2_t in = vld1q_u8_x2(a), out = vld1q_u8_x2(b);
    const uint16x8_t first = vsubl_u8(vget_low_u8(in.val[0]), vget_low_u8(out.val[0])),
                     second = vsubl_high_u8(in.val[0], out.val[0]);
    const uint16x8_t third = vsubl_u8(vget_low_u8(in.val[1]), vget_low_u8(out.val[1])),
                     fourth = vsubl_high_u8(in.val[1], out.val[1]);
    const vec4 v = {{vreinterpretq_s16_u16(first), vreinterpretq_s16_u16(second), vreinterpretq_s16_u16(third),
                     vreinterpretq_s16_u16(fourth)}};
    return v;
}
#else
#    define VEC_FOURS 0
#endif

/* The same lanes read as unsigned, or as twice as many bytes. */
#define VEC_U16(a)    vreinterpretq_u16_s16(a)
#define VEC_U8(a)     vreinterpretq_u8_s16(a)
#define VEC_OF_U16(a) vreinterpretq_s16_u16(a)
#define VEC_OF_U8(a)  vreinterpretq_s16_u8(a)

#define vec_load_u8(p)           vec_load(p)
#define vec_store_u8(p, v)       vec_store(p, v)
#define vec_add_quarter_u8(a, b) VEC_OF_U8(vsraq_n_u8(VEC_U8(a), VEC_U8(b), 2)) /* a + b / 4 */
#define vec_widen(p)             VEC_OF_U16(vmovl_u8(vld1_u8(p)))               /* 8 bytes as 16-bit lanes */
#define vec_sub_widened(p, q)    VEC_OF_U16(vsubl_u8(vld1_u8(p), vld1_u8(q)))
#define vec_store_low_u8(p, v)   vst1_u8(p, vmovn_u16(VEC_U16(v)))

#if VEC_FOURS
/* One or two vectors of each of three rows. */
typedef struct vec_rows_u8 {
    uint8x16x2_t value, low, high;
} vec_rows_u8;

static inline __attribute__((always_inline)) uint8x16x2_t vec_load_row_u8(const uint8_t *from, int32_t groups)
{
    if (groups == 2)
        return vld1q_u8_x2(from);
    const uint8x16x2_t one = {{vld1q_u8(from), vdupq_n_u8(0)}};
    return one;
}

static inline __attribute__((always_inline)) vec_rows_u8 vec_load_rows_u8(const uint8_t *value, const uint8_t *low,
                                                                          const uint8_t *high, int32_t groups)
{
    const vec_rows_u8 rows = {vec_load_row_u8(value, groups), vec_load_row_u8(low, groups), vec_load_row_u8(high, groups)};
    return rows;
}
#    define vec_row_u8(row, from, k) VEC_OF_U8((row).val[k])
#endif

/* In what follows `scalar` operands stand for a vector of that value. */
#define vec_set(v)                    vdupq_n_s16((int16_t)(v))
#define vec_set_u8(v)                 VEC_OF_U8(vdupq_n_u8(v))
#define vec_min(a, b)                 vminq_s16(a, b)
#define vec_max(a, b)                 vmaxq_s16(a, b)
#define vec_min_u16(a, b)             VEC_OF_U16(vminq_u16(VEC_U16(a), VEC_U16(b)))
#define vec_add(a, b)                 vaddq_s16(a, b)
#define vec_add_scalar(a, v)          vaddq_s16(a, vec_set(v))
#define vec_sub(a, b)                 vsubq_s16(a, b)
#define vec_mul_scalar(a, v)          vmulq_s16(a, vec_set(v))
#define vec_add_sat(a, b)             vqaddq_s16(a, b)
#define vec_sub_floor(a, b)           VEC_OF_U16(vqsubq_u16(VEC_U16(a), VEC_U16(b))) /* max(a - b, 0), unsigned */
#define vec_min_u8(a, b)              VEC_OF_U8(vminq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_max_u8(a, b)              VEC_OF_U8(vmaxq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_add_u8(a, b)              VEC_OF_U8(vaddq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_mean_u8(a, b)             VEC_OF_U8(vhaddq_u8(VEC_U8(a), VEC_U8(b))) /* rounded down */
#define vec_sub_floor_u8(a, b)        VEC_OF_U8(vqsubq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_sub_floor_scalar_u8(a, v) vec_sub_floor_u8(a, vec_set_u8(v))
#define vec_shift_right_u8(a, n)      VEC_OF_U8(vshrq_n_u8(VEC_U8(a), n))

/* The end of the path recurrence: C - floor(limit - reach). */
typedef vec vec_limit;
#define vec_limit_of(v)              vec_set(v)
#define vec_path_block(cost)         (cost)
#define vec_path(cost, reach, limit) vec_sub(cost, vec_sub_floor(limit, reach))

/* 0, 1, ... 7. */
static inline vec vec_count(void)
{
    static const int16_t count[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    return vld1q_s16(count);
}

/* Lane by lane: a < b ? yes : no. */
#define vec_where_less(a, b, yes, no) vbslq_s16(vcltq_s16(a, b), yes, no)

/* Lane by lane: a == v ? yes : 32767. */
#define vec_where_equal(a, v, yes) vbslq_s16(vceqq_s16(a, vec_set(v)), yes, vec_set(INT16_MAX))

/* Lane by lane: min(least, cost) where `place`, unsigned, is above v; else least. */
#define vec_min_where_above(least, cost, place, v) \
    vbslq_s16(vcgtq_u16(VEC_U16(place), vdupq_n_u16(v)), vec_min(least, cost), least)

static inline void vec_store_reversed_u8(uint8_t *p, vec v)
{
    const uint8x16_t swapped = vrev64q_u8(VEC_U8(v));
    vst1q_u8(p, vextq_u8(swapped, swapped, 8));
}

#endif
