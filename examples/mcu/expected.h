/* SPDX-License-Identifier: MIT
 * examples/mcu/expected.h - the hashes every core must reach.
 *
 * Those of the matcher are what cv::StereoSGBM gives for the same pixels (4.14.0, one thread; test/target/reference.py
 * recomputes them); that of the tuner is the host's
 * (test/target/bless writes it anew after a change of the method). */
#ifndef EXPECTED_H
#define EXPECTED_H

#define EXPECT_SGBM       0x20cd0a1du /* 160 x 120, D 32, block 5, both memory plans */
#define EXPECT_3WAY       0x9632cd81u /* the same scene */
#define EXPECT_HH         0xcd60c3e5u /* 96 x 64, D 16, block 5 */
#define EXPECT_HH4        0x2cc8b473u /* the same scene */
#define EXPECT_BYTES      0xe13eb537u /* 96 x 64, D 16, block 1: p2 <= 255, path state in bytes */
#define EXPECT_SATURATING 0x9cbfaea1u /* 96 x 64, D 16, block 15: costs beyond int16 */
#define EXPECT_TUNE       0x2b9f8bb7u /* points and costs of a search */

#endif
