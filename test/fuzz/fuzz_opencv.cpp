// SPDX-License-Identifier: MIT
// fuzz/fuzz_opencv.cpp - the library against cv::StereoSGBM, guided by the library's coverage: any parameters and sizes of
// the defined domain, any pixels. A differing pixel is a crash.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "support/case.h"
#include "support/subject.h"
#include "verify.hpp"

namespace {

struct Bytes {
    const uint8_t *at;
    size_t left;
    int next()
    {
        return left ? (left--, *at++) : 0;
    }
    int pick(int usual, int low, int high) // mostly 0 .. usual - 1, else anything
    {
        int v = next();
        return v < 220 ? v % usual : low + (next() * 256 + next()) % (high - low + 1);
    }
};

test_case decode(Bytes &b)
{
    test_case c;
    std::memset(&c, 0, sizeof c);
    c.mode = b.next() % 4;
    c.memory = b.next() % 2;
    c.channels = b.next() % 3 ? 1 : 3;
    c.width = 1 + b.next() % 70;
    c.height = 1 + b.next() % 20;
    c.interleave = uint32_t(b.next());
    c.params.num_disparities = int16_t(16 * (1 + b.next() % 3));
    c.params.min_disparity = int16_t(b.pick(16, -60, 60) - 8);
    c.params.block_size = int16_t(b.pick(12, -1, 31));
    c.params.p1 = int16_t(b.pick(200, -1, 32766));
    c.params.p2 = int16_t(b.pick(240, -1, 32767));
    c.params.disp12_max_diff = int16_t(b.pick(4, -1, 40));
    c.params.pre_filter_cap = int16_t(b.pick(100, 0, 1001));
    c.params.uniqueness_ratio = int16_t(b.pick(30, -1, 99));
    c.params.speckle_window_size = b.pick(20, 0, 200);
    c.params.speckle_range = b.pick(3, 0, 20);
    case_settle(&c);
    return c;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Bytes b{data, size};
    test_case c = decode(b);
    if (!case_defined(&c)) {
        return 0;
    }
    Pair pair;
    pair.width = c.width, pair.height = c.height, pair.channels = c.channels;
    const size_t line = size_t(c.width) * size_t(c.channels), n = line * size_t(c.height);
    const int shift = b.next() % 20, noise = b.next();
    for (size_t i = 0; i < n; i++) {
        const size_t k = i + size_t(shift) * size_t(c.channels);
        pair.left.push_back(b.left ? b.at[(i * 7 + i / line) % b.left] : uint8_t(i * 29));
        pair.right.push_back(noise & 1 && b.left ? b.at[(i * 13 + 5) % b.left]
                                                 : (b.left ? b.at[(k * 7 + i / line) % b.left] : uint8_t(k * 31)));
    }
    const std::vector<int16_t> expected = oracle(c, pair);
    std::vector<int16_t> got(expected.size());
    const char *why = nullptr;
    const int status = subject_run(&c, noise & 2 ? SUBJECT_ROWS : SUBJECT_FRAME, pair.left.data(), pair.right.data(), got.data(), &why);
    if (status != 0 || expected != got) {
        char text[500];
        case_text(&c, text, sizeof text);
        std::fprintf(stderr, "status %d %s: %s\n", status, why ? why : "", text);
        std::abort();
    }
    return 0;
}
