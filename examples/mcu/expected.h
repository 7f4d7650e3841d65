/* SPDX-License-Identifier: MIT
 * examples/mcu/expected.h - the hashes every core must reach.
 *
 * Those of the matcher are what cv::StereoSGBM gives for the same pixels (4.14.0, one thread; test/target/reference.py
 * recomputes them); the others are the
 * host's (test/target/bless writes them anew after a change that is meant to alter them). */
#ifndef EXPECTED_H
#define EXPECTED_H

#define EXPECT_SGBM       0x20cd0a1du /* 160 x 120, D 32, block 5, both memory plans */
#define EXPECT_3WAY       0x9632cd81u /* the same scene */
#define EXPECT_HH         0xcd60c3e5u /* 96 x 64, D 16, block 5 */
#define EXPECT_HH4        0x2cc8b473u /* the same scene */
#define EXPECT_BYTES      0xe13eb537u /* 96 x 64, D 16, block 1: p2 <= 255, path state in bytes */
#define EXPECT_SATURATING 0x9cbfaea1u /* 96 x 64, D 16, block 15: costs beyond int16 */
#define EXPECT_WATCH      0x80740124u /* what the monitor computes from live frames */
#define EXPECT_MARKS      0xbd3bfe5cu /* corners of four marks in both views, and the correction */
#define EXPECT_STORE      0xdebb20e3u /* the record that is found after a reset */
#define EXPECT_TUNE       0x0d108dbcu /* points and costs of a search */
#define EXPECT_REPLAY     0x94363799u /* disparity of a recording's frames while it calibrates, and after the reset */

#endif
