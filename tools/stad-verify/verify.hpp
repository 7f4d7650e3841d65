// SPDX-License-Identifier: MIT
// stad-verify/verify.hpp - one comparison of a subject (library or reference) with cv::StereoSGBM.
#ifndef STAD_VERIFY_HPP
#define STAD_VERIFY_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "support/case.h"

// What computes the map that is held against OpenCV's.
enum class Subject { Frame, Rows, Reference };

struct Pair {
    int width = 0, height = 0, channels = 1;
    std::vector<uint8_t> left, right;
};

struct Verdict {
    bool same = false;
    std::string error; // not empty: one side did not answer
    long differing = 0;
    int x = 0, y = 0, expected = 0, got = 0; // the first differing pixel
};

const char *subject_name(Subject s);

// cv::StereoSGBM::compute on one thread; throws what OpenCV throws.
std::vector<int16_t> oracle(const test_case &c, const Pair &pair);
std::string oracle_version();

// A matcher of OpenCV's that is made once.
class Rival {
public:
    Rival(const test_case &c, const Pair &pair);
    ~Rival();
    void run();
    std::vector<int16_t> disparity() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Runs both in turn for about this long and prints the median of the paired ratios, with quartiles.
void bench(const test_case &c, const Pair &pair, double seconds);

Pair render(const test_case &c);
Pair load(const std::string &left, const std::string &right, bool color); // throws std::runtime_error

// `mends` applies to the reference alone.
Verdict compare(const test_case &c, const Pair &pair, const std::vector<int16_t> &expected, Subject subject, unsigned mends);

// The smallest case found that still differs.
test_case shrink(test_case c, Subject subject, unsigned mends);

#endif
