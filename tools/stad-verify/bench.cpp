// SPDX-License-Identifier: MIT
// stad-verify/bench.cpp - the library and OpenCV in turn, on one thread: paired ratios of thread-CPU time.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <stdexcept>

#include "stad/match.h"
#include "support/subject.h"
#include "verify.hpp"

namespace {

// The library's side: one matcher, whose workspace is kept, as OpenCV's object keeps its buffer.
class Subjected {
public:
    Subjected(const test_case &c, const Pair &pair) : pair_(pair), p_(c.params)
    {
        stad_params_normalize(&p_, c.mode);
        const stad_geometry g = subject_geometry(&c, &p_);
        const size_t bytes = stad_match_bytes(&g);
        work_ = subject_alloc(bytes, 0, 1);
        speckle_.resize(STAD_SPECKLE_BYTES(size_t(c.width), size_t(c.height)) / 4);
        disp_.resize(size_t(c.width) * size_t(c.height));
        if (stad_match_init(&match_, &g, work_, bytes) != STAD_OK) {
            throw std::runtime_error("the library refuses the case");
        }
    }
    ~Subjected() { subject_free(work_); }
    Subjected(const Subjected &) = delete;
    Subjected &operator=(const Subjected &) = delete;
    void run()
    {
        const stad_image l = stad_image_packed(pair_.left.data(), pair_.width, pair_.height, pair_.channels);
        const stad_image r = stad_image_packed(pair_.right.data(), pair_.width, pair_.height, pair_.channels);
        stad_match_frame(&match_, &p_, &l, &r, disp_.data(), pair_.width, speckle_.data(), speckle_.size() * 4);
    }

private:
    const Pair &pair_;
    stad_params p_;
    stad_match match_;
    void *work_;
    std::vector<int32_t> speckle_;
    std::vector<int16_t> disp_;
};

double seconds_now()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

template <class Side> double seconds_of(Side &side)
{
    const double start = seconds_now();
    side.run();
    return seconds_now() - start;
}

double quantile(std::vector<double> values, double at)
{
    std::sort(values.begin(), values.end());
    return values[size_t(at * double(values.size() - 1) + 0.5)];
}

} // namespace

void bench(const test_case &c, const Pair &pair, double seconds)
{
    Rival rival(c, pair);
    Subjected subject(c, pair);
    std::vector<double> ours, theirs, ratios;
    rival.run();
    subject.run(); // memory and tables are there from here on
    for (double spent = 0; spent < seconds || ratios.size() < 5;) {
        const bool first = ratios.size() % 2 == 0;
        const double early = first ? seconds_of(subject) : 0;
        theirs.push_back(seconds_of(rival));
        ours.push_back(first ? early : seconds_of(subject));
        ratios.push_back(theirs.back() / ours.back());
        spent += ours.back() + theirs.back();
    }
    const stad_params &p = c.params;
    const int columns = pair.width + std::min<int>(p.min_disparity, 0) - std::max<int>(p.min_disparity + p.num_disparities, 0);
    const double pxd = double(columns) * pair.height * p.num_disparities * 1e-9;
    std::printf("%-5s %-5s %4d x %-4d D %-3d block %-2d  %5.2fx [%.2f .. %.2f]  %.3f ns per pixel and disparity, OpenCV %.3f  "
                "(%zu pairs)\n",
                case_mode_name(c.mode), c.memory ? "small" : "fast", pair.width, pair.height, p.num_disparities, p.block_size,
                quantile(ratios, .5), quantile(ratios, .25), quantile(ratios, .75), quantile(ours, .5) / pxd,
                quantile(theirs, .5) / pxd, ratios.size());
    std::fflush(stdout);
}
