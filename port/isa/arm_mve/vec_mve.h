/* SPDX-License-Identifier: MIT
 * port/isa/arm_mve/vec_mve.h - the vector verbs of the templates in arm_common, 8 lanes of 16 bits, for Helium (MVE).
 *
 * No load is predicated: sizes are multiples of 8, and gcc 12 makes two instructions of each `_z`. */
#ifndef STAD_VEC_H
#define STAD_VEC_H

#include <arm_mve.h>
#include <stdint.h>

#define STAD_TIER(name) name##_mve
#define VEC_ABREAST     2 /* lanes of the path kernel that 8 registers hold */

#define VEC_FOURS 0 /* no loads of four vectors */

/* Keeps the compiler from mixing groups of 8: it would run out of its 8 vector registers. */
#define VEC_IN_ORDER __asm__ volatile("" ::: "memory")

typedef int16x8_t vec;

/* Addresses must be aligned to the lane: bytes have verbs of their own. */
static inline vec vec_load(const void *p)
{
    return vld1q_s16(p);
}

static inline void vec_store(void *p, vec v)
{
    vst1q_s16(p, v);
}

/* The same lanes read as unsigned, or as twice as many bytes. */
#define VEC_U16(a)    vreinterpretq_u16_s16(a)
#define VEC_U8(a)     vreinterpretq_u8_s16(a)
#define VEC_OF_U16(a) vreinterpretq_s16_u16(a)
#define VEC_OF_U8(a)  vreinterpretq_s16_u8(a)

#define vec_load_u8(p)         VEC_OF_U8(vld1q_u8(p))
#define vec_store_u8(p, v)     vst1q_u8(p, VEC_U8(v))
#define vec_widen(p)           VEC_OF_U16(vldrbq_u16(p)) /* 8 bytes as 16-bit lanes */
#define vec_sub_widened(p, q)  vec_sub(vec_widen(p), vec_widen(q))
#define vec_store_low_u8(p, v) vstrbq_u16(p, VEC_U16(v))

#define vec_set(v)                    vdupq_n_s16((int16_t)(v))
#define vec_set_u8(v)                 VEC_OF_U8(vdupq_n_u8(v))
#define vec_min(a, b)                 vminq_s16(a, b)
#define vec_max(a, b)                 vmaxq_s16(a, b)
#define vec_min_u16(a, b)             VEC_OF_U16(vminq_u16(VEC_U16(a), VEC_U16(b)))
#define vec_add(a, b)                 vaddq_s16(a, b)
#define vec_add_scalar(a, v)          vaddq_n_s16(a, (int16_t)(v))
#define vec_sub(a, b)                 vsubq_s16(a, b)
#define vec_mul_scalar(a, v)          vmulq_n_s16(a, (int16_t)(v))
#define vec_add_sat(a, b)             vqaddq_s16(a, b)
#define vec_sub_floor(a, b)           VEC_OF_U16(vqsubq_u16(VEC_U16(a), VEC_U16(b))) /* max(a - b, 0), unsigned */
#define vec_min_u8(a, b)              VEC_OF_U8(vminq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_max_u8(a, b)              VEC_OF_U8(vmaxq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_add_u8(a, b)              VEC_OF_U8(vaddq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_mean_u8(a, b)             VEC_OF_U8(vhaddq_u8(VEC_U8(a), VEC_U8(b))) /* rounded down */
#define vec_sub_floor_u8(a, b)        VEC_OF_U8(vqsubq_u8(VEC_U8(a), VEC_U8(b)))
#define vec_sub_floor_scalar_u8(a, v) VEC_OF_U8(vqsubq_n_u8(VEC_U8(a), v))
#define vec_shift_right_u8(a, n)      VEC_OF_U8(vshrq_n_u8(VEC_U8(a), n))

/* The end of the path recurrence: C - floor(limit - reach). */
typedef vec vec_limit;
#define vec_limit_of(v)              vec_set(v)
#define vec_path_block(cost)         (cost)
#define vec_path(cost, reach, limit) vec_sub(cost, vec_sub_floor(limit, reach))

#define vec_add_quarter_u8(a, b) vec_add_u8(a, vec_shift_right_u8(b, 2))

static inline uint16_t vec_least(vec v)
{
    return vminvq_u16(UINT16_MAX, VEC_U16(v));
}

static inline int vec_least_signed(vec v)
{
    return vminvq_s16(INT16_MAX, v);
}

/* 0, 1, ... 7. */
static inline vec vec_count(void)
{
    return VEC_OF_U16(vidupq_n_u16(0, 1));
}

/* Lane by lane: a < b ? yes : no. */
#define vec_where_less(a, b, yes, no) vpselq_s16(yes, no, vcmpltq_s16(a, b))

/* Lane by lane: a == v ? yes : 32767. */
#define vec_where_equal(a, v, yes) vpselq_s16(yes, vec_set(INT16_MAX), vcmpeqq_n_s16(a, (int16_t)(v)))

/* Lane by lane: min(least, cost) where `place`, unsigned, is above v; else least. */
#define vec_min_where_above(least, cost, place, v) vminq_m_s16(least, least, cost, vcmphiq_n_u16(VEC_U16(place), v))

/* A scatter by falling offsets: the unit has no other way to cross its 32-bit columns. */
static inline void vec_store_reversed_u8(uint8_t *p, vec v)
{
    vstrbq_scatter_offset_u8(p, vddupq_n_u8(15, 1), VEC_U8(v));
}

#endif
