/* SPDX-License-Identifier: MIT
 * mark/mark_codes.c - the first 32 words of the AprilTag family 36h11.
 *
 * Printed by tools/study/marks/print_codes.c from libapriltag (Copyright 2013-2016 The Regents of The University of
 * Michigan, BSD-2-Clause). Bit 35 is the top left cell, in reading order; a set bit is white. */
#include "mark/mark_work.h"

const uint64_t stad_mark_codes[STAD_MARK_IDS] = {
    0xd5d628584u, 0xd97f18b49u, 0xdd280910eu, 0xe479e9c98u, 0xebcbca822u, 0xf31dab3acu, 0x056a5d085u, 0x10652e1d4u,
    0x22b1dfeadu, 0x265ad0472u, 0x34fe91b86u, 0x3ff962cd5u, 0x43a25329au, 0x474b4385fu, 0x4e9d243e9u, 0x5246149aeu,
    0x5997f5538u, 0x683bb6c4cu, 0x6be4a7211u, 0x7e3158eeau, 0x81da494afu, 0x858339a74u, 0x8cd51a5feu, 0x9f21cc2d7u,
    0xa2cabc89cu, 0xadc58d9ebu, 0xb16e7dfb0u, 0xb8c05eb3au, 0xd25ef139du, 0xd607e1962u, 0xe4aba3076u, 0x2dde6a3dau,
};
