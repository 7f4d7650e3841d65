// SPDX-License-Identifier: MIT
// stad-verify/oracle.cpp - the only place that speaks to OpenCV.
#include <opencv2/calib3d.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <stdexcept>

#include "verify.hpp"

std::string oracle_version()
{
    return CV_VERSION;
}

struct Rival::State {
    cv::Mat left, right, disp;
    cv::Ptr<cv::StereoSGBM> matcher;
};

Rival::Rival(const test_case &c, const Pair &pair) : state_(new State)
{
    const stad_params &p = c.params;
    const int type = pair.channels == 3 ? CV_8UC3 : CV_8UC1;
    cv::setNumThreads(1);
    state_->left = cv::Mat(pair.height, pair.width, type, const_cast<uint8_t *>(pair.left.data()));
    state_->right = cv::Mat(pair.height, pair.width, type, const_cast<uint8_t *>(pair.right.data()));
    state_->matcher = cv::StereoSGBM::create(p.min_disparity, p.num_disparities, p.block_size, p.p1, p.p2, p.disp12_max_diff,
                                             p.pre_filter_cap, p.uniqueness_ratio, p.speckle_window_size, p.speckle_range, c.mode);
}

Rival::~Rival() = default;

void Rival::run()
{
    state_->matcher->compute(state_->left, state_->right, state_->disp);
}

std::vector<int16_t> Rival::disparity() const
{
    const cv::Mat &disp = state_->disp;
    std::vector<int16_t> out;
    for (int y = 0; y < disp.rows; y++) {
        out.insert(out.end(), disp.ptr<int16_t>(y), disp.ptr<int16_t>(y) + disp.cols);
    }
    return out;
}

std::vector<int16_t> oracle(const test_case &c, const Pair &pair)
{
    Rival rival(c, pair);
    rival.run();
    return rival.disparity();
}

static cv::Mat read(const std::string &path, bool color)
{
    cv::Mat image = cv::imread(path, cv::IMREAD_COLOR), grey;
    if (image.empty()) {
        throw std::runtime_error(path + ": cannot be read as an image");
    }
    if (color) {
        return image;
    }
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    return grey;
}

Pair load(const std::string &left, const std::string &right, bool color)
{
    const cv::Mat l = read(left, color), r = read(right, color);
    if (l.size() != r.size()) {
        throw std::runtime_error("the two images differ in size");
    }
    Pair pair;
    pair.width = l.cols;
    pair.height = l.rows;
    pair.channels = l.channels();
    pair.left.assign(l.datastart, l.dataend);
    pair.right.assign(r.datastart, r.dataend);
    return pair;
}
