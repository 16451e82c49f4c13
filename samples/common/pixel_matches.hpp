// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_PIXEL_MATCHES_HPP
#define GMLPNP_SAMPLES_PIXEL_MATCHES_HPP

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace samples {

/** The same places in two pictures. */
struct PixelMatches
{
    std::vector<cv::Point2d> reference, query;  //!< px
};

/** Reads matches that were found elsewhere: a row `u v u' v'` per match, pixel of the reference and of the query
picture, and any further words, such as a confidence, which are not read. `#` begins a comment. Pixels are OpenCV's:
the centre of the top-left one is (0, 0). No row is no match, and no error.
@throws std::runtime_error with "file:line: what is wrong". */
PixelMatches readMatches(const std::string& path);

struct SiftFeatures
{
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptors;
};

/** The strongest features of a grey picture.
@param mask 255 where it shows something; empty: everywhere. */
SiftFeatures siftFeatures(const cv::Mat& picture, const cv::Mat& mask, int count);

/** Nearest neighbours of the query's features by brute force, kept where the nearest is closer than `ratio` times the
second nearest. */
PixelMatches matchSift(const SiftFeatures& reference, const SiftFeatures& query, double ratio);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_PIXEL_MATCHES_HPP
