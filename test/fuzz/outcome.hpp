// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_FUZZ_OUTCOME_HPP
#define GMLPNP_FUZZ_OUTCOME_HPP

#include <vector>

#include <opencv2/gmlpnp.hpp>

namespace fuzz {

/** Ends the program with `promise` where it does not hold: to a fuzzer, a crash. */
void require(bool holds, const char* promise);

/** Calls `function`, from which only cv::Exception may come. @return whether it returned. */
template <class Function>
bool call(const Function& function)
{
    try {
        function();
        return true;
    } catch (const cv::Exception&) {
        return false;
    }
}

/** A result as no function makes it, to see whether one was written. */
cv::gmlpnp::Result untouchedResult();

/** Whether two results are equal in every bit. */
bool same(const cv::gmlpnp::Result& a, const cv::gmlpnp::Result& b);

/** Whether it is still untouchedResult(), its status apart. */
bool untouched(const cv::gmlpnp::Result& result);

/** What every result keeps that came with success: all finite, covariances symmetric with a diagonal that is not
negative, no more points used than there are. */
void requireSound(const cv::gmlpnp::Result& result);

/** Ascending rows of `points`, four or more. */
void requireInliers(const std::vector<int>& inliers, int points);

}  // namespace fuzz

#endif  // GMLPNP_FUZZ_OUTCOME_HPP
