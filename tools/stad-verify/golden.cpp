// SPDX-License-Identifier: MIT
// stad-verify/golden.cpp - prints test/golden/vectors.inc: small cases and the CRC-32 of OpenCV's disparity.
//
// Ordinary and stressed cases of every mode, then more until each quirk of the specification, mended in the reference,
// changes at least one row.
#include <cstdio>
#include <set>

#include "support/reference.h"
#include "verify.hpp"

static const uint32_t GOLDEN_SEED = 20;
static const int ROWS_PER_MODE = 14;

static bool small(const test_case &c)
{
    return c.width <= 90 && c.height <= 24 && c.params.num_disparities <= 48;
}

static void print_row(const test_case &c, uint32_t crc)
{
    const stad_params &p = c.params;
    std::printf("{{{%luu, %d, %d, %d, %d, %d}, %d, %d, %d, %d, 0, %luu,\n {%d, %d, %d, %d, %d, %d, %d, %d, %d, %d}}, 0x%08lxu},\n",
                (unsigned long)c.view.seed, c.view.kind, c.view.x0, c.view.y0, c.view.disp_min, c.view.disp_count, c.width,
                c.height, c.channels, c.mode, (unsigned long)c.interleave, p.min_disparity, p.num_disparities, p.block_size,
                p.p1, p.p2, p.disp12_max_diff, p.pre_filter_cap, p.uniqueness_ratio, int(p.speckle_window_size),
                int(p.speckle_range), (unsigned long)crc);
}

void print_golden()
{
    std::set<int> noticed; // mends that some row notices
    std::printf("/* SPDX-License-Identifier: MIT\n * golden/vectors.inc - made by `stad-verify --golden`: do not edit. OpenCV %s. */\n",
                oracle_version().c_str());
    for (int mode = 0; mode < 4; mode++) {
        int rows = 0;
        for (uint32_t i = 0; i < 4000; i++) {
            test_case c;
            case_random(&c, GOLDEN_SEED, i, mode, int(i & 1));
            case_settle(&c);
            if (!small(c)) {
                continue;
            }
            const Pair pair = render(c);
            const std::vector<int16_t> map = oracle(c, pair);
            bool wanted = rows < ROWS_PER_MODE;
            for (int k = 0; k < MEND_COUNT && rows < 3 * ROWS_PER_MODE; k++) {
                if (!noticed.count(mode * 100 + k) && !compare(c, pair, map, Subject::Reference, 1u << k).same) {
                    wanted = noticed.insert(mode * 100 + k).second;
                }
            }
            if (wanted) {
                print_row(c, disparity_crc(map.data(), map.size()));
                rows++;
            }
        }
    }
}
