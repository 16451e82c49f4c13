# OpenCV's test_solvepnp_ransac.cpp on cv::gmlpnp, with our two flags in its lists of methods. Its tests count methods
# from 0 to SOLVEPNP_MAX_COUNT and keep a bound for each; ours are the next two, with the bounds of SQPNP.
s/\bSOLVEPNP_MAX_COUNT\b/METHODS/g
s/^\( *\)eps\[SOLVEPNP_SQPNP\] = \(.*\);/&\
\1eps[METHODS - 2] = eps[METHODS - 1] = \2;/
s/\(int methods\[\] = {SOLVEPNP_ITERATIVE.*\)};/\1, gmlpnp::SOLVEPNP_GMLPNP, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};/
# Of four or five points RANSAC finds the pose of the same method on all of them; of theirs, that is EPNP or P3P.
s/, rvec2, Tvec2, false, SOLVEPNP_\(EPNP\|P3P\));/, rvec2, Tvec2);/
/solveP3P/!{
s/(SolvePnPMethod)method\b/flagOf(method)/
s/, method);/, flagOf(method));/
s/\b\(solvePnP\|solvePnPRansac\|solvePnPGeneric\|solvePnPRefineLM\|solvePnPRefineVVS\)(/cv::gmlpnp::\1(/
}
s/#include "test_precomp.hpp"/&\
#include <opencv2\/gmlpnp.hpp>\
static const int METHODS = cv::SOLVEPNP_MAX_COUNT + 2;\
static int flagOf(int method)\
{\
    return method < cv::SOLVEPNP_MAX_COUNT ? method : cv::gmlpnp::SOLVEPNP_GMLPNP + method - cv::SOLVEPNP_MAX_COUNT;\
}/
