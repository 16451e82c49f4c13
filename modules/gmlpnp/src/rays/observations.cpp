// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "observations.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Mat_<double> chosenRows(const Mat_<double>& all, const std::vector<int>& rows)
{
    if (all.empty() || static_cast<int>(rows.size()) == all.rows)
        return all;
    Mat_<double> chosen(static_cast<int>(rows.size()), all.cols);
    for (int k = 0; k < chosen.rows; ++k)
        std::copy(all[rows[k]], all[rows[k]] + all.cols, chosen[k]);
    return chosen;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
