// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_OUTLIERS_HPP
#define GMLPNP_SAMPLES_OUTLIERS_HPP

#include "common/correspondences.hpp"

namespace samples {

/** Keeps the correspondences that one pose explains to `thresholdPixels`, or none where they are fewer than ten: five
always agree somewhere, they are a sample of RANSAC. 0 keeps all. Every program rejects wrong matches here and nowhere
else.

A pinhole's by cv::solvePnPRansac (EPnP); cv::theRNG(), from which some versions draw, is seeded, so that the result of
a set does not depend on the sets before. Through any other lens by this module's robust estimate, repeated without what
it finds too far away: that stands up to tracks that drift, not to a majority of wrong matches. */
void rejectOutliers(CorrespondenceSet& set, double thresholdPixels, int seed);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_OUTLIERS_HPP
