// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_PRECOMP_HPP
#define OPENCV_TEST_GMLPNP_PRECOMP_HPP

// One set of tests for two harnesses: GoogleTest in the standalone build (which defines GMLPNP_STANDALONE), OpenCV's
// own `ts` inside OpenCV. Tests use what both have; they live in namespace opencv_test.
#ifdef GMLPNP_STANDALONE

#include <gtest/gtest.h>

#include "opencv2/gmlpnp.hpp"

namespace opencv_test {
using namespace cv;
// `ts` has functions of these names and makes tests write cv:: before OpenCV's; what compiles here shall compile there.
class this_name_needs_cv_before_it;
using norm = this_name_needs_cv_before_it;
using add = this_name_needs_cv_before_it;
using multiply = this_name_needs_cv_before_it;
using divide = this_name_needs_cv_before_it;
using transpose = this_name_needs_cv_before_it;
using compare = this_name_needs_cv_before_it;
using threshold = this_name_needs_cv_before_it;
}  // namespace opencv_test

// Ends the test as skipped, with the reason.
#define GMLPNP_SKIP(message) GTEST_SKIP() << (message)

#else

#include "opencv2/gmlpnp.hpp"
#include "opencv2/ts.hpp"

#define GMLPNP_HAVE_DRAW

// The GoogleTest inside OpenCV 4.x predates the renaming of "test case" to "test suite".
#ifndef INSTANTIATE_TEST_SUITE_P
#define INSTANTIATE_TEST_SUITE_P INSTANTIATE_TEST_CASE_P
#endif
#ifndef TYPED_TEST_SUITE
#define TYPED_TEST_SUITE TYPED_TEST_CASE
#endif

// It has no GTEST_SKIP either; `ts` skips by an exception, which its TEST and TEST_P (not TYPED_TEST) report.
#define GMLPNP_SKIP(message) throw SkipTestException(message)

#endif  // GMLPNP_STANDALONE

#endif  // OPENCV_TEST_GMLPNP_PRECOMP_HPP
