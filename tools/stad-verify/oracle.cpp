// SPDX-License-Identifier: MIT
// stad-verify/oracle.cpp - the only place that speaks to OpenCV.
#include <opencv2/calib3d.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstring>
#include <stdexcept>

#include "verify.hpp"

std::string oracle_version()
{
    return CV_VERSION;
}

std::vector<int16_t> oracle(const test_case &c, const Pair &pair)
{
    const stad_params &p = c.params;
    const int type = pair.channels == 3 ? CV_8UC3 : CV_8UC1;
    const cv::Mat left(pair.height, pair.width, type, const_cast<uint8_t *>(pair.left.data()));
    const cv::Mat right(pair.height, pair.width, type, const_cast<uint8_t *>(pair.right.data()));
    cv::Mat disp;
    cv::setNumThreads(1);
    cv::StereoSGBM::create(p.min_disparity, p.num_disparities, p.block_size, p.p1, p.p2, p.disp12_max_diff, p.pre_filter_cap,
                           p.uniqueness_ratio, p.speckle_window_size, p.speckle_range, c.mode)
        ->compute(left, right, disp);
    std::vector<int16_t> out(size_t(pair.width) * size_t(pair.height));
    for (int y = 0; y < pair.height; y++) {
        std::memcpy(&out[size_t(y) * size_t(pair.width)], disp.ptr<int16_t>(y), size_t(pair.width) * sizeof(int16_t));
    }
    return out;
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
