// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"

#include <cmath>

#include "test/synthetic.hpp"

namespace fuzz {

using cv::Mat;
using cv::Mat_;
using cv::gmlpnp::CameraModel;

namespace {

struct Problem
{
    Mat_<double> objectPoints, imagePoints, rays;
    cv::Vec3d rvec, tvec;
};

std::vector<synthetic::Vector3d> cameraPointsFrom(Bytes& bytes, cv::RNG& rng, int n)
{
    enum Shape
    {
        BOX,
        FLAT,
        AROUND,
        LINE,
        ONE_PLACE,
        TWICE
    };
    const Shape shape = bytes.pick({BOX, BOX, BOX, FLAT, AROUND, LINE, ONE_PLACE, TWICE});
    std::vector<synthetic::Vector3d> points =
        shape == AROUND ? synthetic::surroundingPoints(rng, n) : synthetic::boxPoints(rng, n, shape == FLAT);
    for (size_t i = 0; i < points.size(); ++i) {
        if (shape == LINE)
            points[i] = points[0] + static_cast<double>(i) * synthetic::Vector3d(0.1, 0.2, 0.05);
        else if (shape == ONE_PLACE || (shape == TWICE && i % 2 == 1))
            points[i] = points[shape == TWICE ? i - 1 : 0];
    }
    return points;
}

void disturb(Mat_<double>& m, cv::RNG& rng, double sigma)
{
    for (double& value : m)
        value += rng.gaussian(sigma);
}

// At any scale and place, of any noise; some correspondences wrong.
Problem problemFrom(Bytes& bytes)
{
    const int n = bytes.pick({12, 30, 6, 5, 4, 3, 2, 1, 0, 7, 8, 9, 17, 40, 65, 130});
    cv::RNG rng(bytes.take<uint32_t>());
    const synthetic::Scene scene = synthetic::exactScene(rng, cameraPointsFrom(bytes, rng, n));
    Problem problem{scene.objectPoints, scene.imagePoints, scene.rays, {}, {}};
    const double noise = bytes.pick({0.0, 1e-3, 1e-9, 1e-1, 1e2});
    disturb(problem.objectPoints, rng, noise);
    disturb(problem.imagePoints, rng, noise * bytes.pick({0, 1, 100}));
    const double scale = std::pow(10.0, bytes.pick({0, 0, 0, 3, -6, 9, 150, -150, 300, -300}));
    const double offset = bytes.pick({0.0, 0.0, 0.0, 1e3, 1e8, 1e300});
    for (double& value : problem.objectPoints)
        value = (value + offset) * scale;
    for (double& value : problem.rays)
        value *= bytes.empty() ? 1 : scale;
    const int wrong = bytes.between(0, 15) * n / 16;
    for (int i = 0; i < wrong; ++i)
        for (int k = 0; k < 2; ++k)
            problem.imagePoints(i, k) = rng.uniform(0., 640.);
    const synthetic::Vector3d r = cv::gmlpnp::detail::logSO3(scene.truth.R), t = scene.truth.t * scale;
    problem.rvec = {r.x(), r.y(), r.z()};
    problem.tvec = {t.x(), t.y(), t.z()};
    return problem;
}

// A few numbers of an array become any others.
template <class Array>
void spoil(Bytes& bytes, Array& numbers, int count)
{
    const int changes = std::max(0, bytes.between(0, 15) - 10);
    for (int i = 0; i < changes && count > 0; ++i)
        numbers(bytes.take<uint16_t>() % count) = bytes.number();
}

// The caller's own lens, which keeps no promise.
class CarelessLens : public CameraModel
{
public:
    CarelessLens(double ray, double jacobian) : ray_(ray), jacobian_(jacobian) {}

    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        ray = cv::Vec3d(pixel.x, pixel.y, ray_);
        if (jacobian != nullptr)
            *jacobian = cv::Matx32d::all(jacobian_);
        return pixel.x < 500;
    }

    bool projectPoint(const cv::Vec3d& point, cv::Point2d& pixel) const override
    {
        pixel = {point[0], ray_};
        return point[1] > 0;
    }

private:
    double ray_, jacobian_;
};

Mat plainCamera()
{
    return Mat(synthetic::paperCamera());
}

// Positive semidefinite, or any matrix.
Mat noiseFrom(Bytes& bytes)
{
    if (bytes.between(0, 7) < 6)
        return {};
    Mat_<double> noise(3, 3, 0.0);
    for (int i = 0; i < 3; ++i)
        noise(i, i) = std::abs(bytes.number());
    spoil(bytes, noise, 9);
    return bytes.between(0, 7) < 6 ? Mat(noise) : anyMat(bytes);
}

Mat covariancesFrom(Bytes& bytes, int points, int columns)
{
    if (bytes.between(0, 7) < 6)
        return {};
    Mat_<double> rows(points, columns, 0.0);
    const double variance = std::abs(bytes.number());
    for (int i = 0; i < points; ++i)
        for (int k = 0; k < columns; k += columns == 9 ? 4 : 3)  // the diagonal
            rows(i, k) = variance * (1 + i % 3);
    spoil(bytes, rows, static_cast<int>(rows.total()));
    return bytes.between(0, 7) < 6 ? Mat(rows) : anyMat(bytes);
}

cv::gmlpnp::Params paramsFrom(Bytes& bytes, const Problem& problem)
{
    using namespace cv::gmlpnp;
    Params params;
    params.method = bytes.pick<int>({SOLVEPNP_GMLPNP_MARGINAL, SOLVEPNP_GMLPNP_MARGINAL, SOLVEPNP_GMLPNP,
                                     SOLVEPNP_GMLPNP, SOLVEPNP_SQPNP, 99, -1, 102});
    params.maxRounds = bytes.pick({0, 0, 1, 2, 3, 30, -1, -2147483647});
    if (bytes.between(0, 7) == 7)
        params.tolerance = bytes.number();
    params.robust = !bytes.flip();
    params.useExtrinsicGuess = bytes.flip();
    params.rvec = problem.rvec;
    params.tvec = problem.tvec;
    spoil(bytes, params.rvec, 3);
    spoil(bytes, params.tvec, 3);
    params.objectNoise = noiseFrom(bytes);
    params.bearingNoise = noiseFrom(bytes);
    params.objectCovariances = covariancesFrom(bytes, problem.objectPoints.rows, 9);
    params.pixelCovariances = covariancesFrom(bytes, problem.objectPoints.rows, bytes.flip() ? 4 : 1);
    return params;
}

}  // namespace

Mat anyMat(Bytes& bytes)
{
    const int depth = bytes.between(0, 7), type = CV_MAKETYPE(depth, bytes.between(1, 5));
    const int sizes[] = {bytes.between(0, 15), bytes.between(0, 5), bytes.between(0, 5)};
    Mat m(bytes.between(0, 7) < 6 ? 2 : 3, sizes, type, cv::Scalar::all(0));
    uchar* const data = m.data;
    for (size_t i = 0; i < m.total() * m.elemSize() && !bytes.empty(); ++i)
        data[i] = bytes.take<uchar>();
    return m;
}

bool sameBits(const Mat& a, const Mat& b)
{
    if (a.empty() && b.empty())
        return true;
    if (a.type() != b.type() || a.dims != b.dims || !std::equal(a.size.p, a.size.p + a.dims, b.size.p))
        return false;
    const Mat x = a.isContinuous() ? a : a.clone(), y = b.isContinuous() ? b : b.clone();
    return std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0;
}

Array::Array(Bytes& bytes, const Mat_<double>& plain)
{
    Mat_<double> numbers = plain.clone();
    spoil(bytes, numbers, static_cast<int>(numbers.total()));
    arrange(bytes, numbers);
    for (const Mat& m : data())
        before_.push_back(m.clone());
}

void Array::arrange(Bytes& bytes, Mat m)
{
    const int dim = m.cols, layout = std::max(0, bytes.between(0, 31) - 12);
    kind_ = MAT;
    if (bytes.between(0, 15) == 15)
        m.convertTo(m, bytes.between(0, 7));
    else if (bytes.between(0, 3) == 3)
        m.convertTo(m, CV_32F);
    if (layout == 1)
        m = m.reshape(m.cols);
    else if (layout == 2 && !m.empty())
        m = m.reshape(m.cols, 1);
    else if (layout == 3 && !m.empty())
        m = m.t();
    else if (layout == 4 && !m.empty())
        m = m.rowRange(0, m.rows - 1).clone();
    else if (layout == 5 || layout == 6)
        m = anyMat(bytes);
    else if (layout == 7 && !m.empty())
        m = m.reshape(1, std::vector<int>{1, m.rows, m.cols});
    else if (layout == 8)
        kind_ = NONE;
    else if (layout >= 9 && layout <= 11)
        kind_ = layout == 9 ? UMAT : LIST;
    memory_ = m;
    mat_ = m;
    if (layout >= 12 && layout < 16 && !m.empty()) {  // a part of a wider matrix, so not continuous
        cv::copyMakeBorder(m, memory_, 1, 1, 1, 2, cv::BORDER_CONSTANT, cv::Scalar::all(-7));
        mat_ = memory_(cv::Rect(1, 1, m.cols, m.rows));
    } else if (layout >= 16 && m.type() == CV_64F && m.cols == dim && (dim == 2 || dim == 3)) {
        kind_ = VECTOR;
        if (dim == 2)
            m.reshape(2).copyTo(points2_);
        else
            m.reshape(3).copyTo(points3_);
    }
    if (kind_ == UMAT)
        m.copyTo(umat_);
    if (kind_ == LIST)
        list_ = {m, m};
}

cv::_InputArray Array::in() const
{
    switch (kind_) {
        case VECTOR:
            return points3_.empty() ? cv::_InputArray(points2_) : cv::_InputArray(points3_);
        case UMAT:
            return {umat_};
        case LIST:
            return {list_};
        case NONE:
            return cv::noArray();
        default:
            return {mat_};
    }
}

std::vector<Mat> Array::data() const
{
    switch (kind_) {
        case VECTOR:
            return {Mat(points2_), Mat(points3_)};
        case UMAT:
            return {umat_.getMat(cv::ACCESS_READ)};
        case LIST:
            return list_;
        case NONE:
            return {};
        default:
            return {mat_, memory_};
    }
}

bool Array::unchanged() const
{
    const std::vector<Mat> now = data();
    return std::equal(now.begin(), now.end(), before_.begin(), before_.end(), sameBits);
}

Arguments::Arguments(Bytes& bytes)
{
    const Problem problem = problemFrom(bytes);
    rvec = problem.rvec;
    tvec = problem.tvec;
    params = paramsFrom(bytes, problem);
    camera = lensFrom(bytes);
    objectPoints = Array(bytes, problem.objectPoints);
    imagePoints = Array(bytes, problem.imagePoints);
    rays = Array(bytes, problem.rays);
    cameraMatrix = Array(bytes, plainCamera());
    distCoeffs = Array(bytes, Mat_<double>(1, bytes.pick({5, 4, 8, 12, 14, 3}), 0.0));
}

bool Arguments::unchanged() const
{
    return objectPoints.unchanged() && imagePoints.unchanged() && rays.unchanged() && cameraMatrix.unchanged() &&
           distCoeffs.unchanged();
}

cv::gmlpnp::RansacParams ransacFrom(Bytes& bytes)
{
    cv::gmlpnp::RansacParams ransac;
    if (bytes.between(0, 3) == 3)
        ransac.threshold = bytes.number();
    if (bytes.between(0, 3) == 3)
        ransac.confidence = bytes.flip() ? bytes.number() : 1 - 1 / (1.5 + bytes.take<uint32_t>());
    ransac.maxIterations = bytes.pick({100, 1, 2, 10, 500, 0, -1, -2147483647});
    ransac.seed = bytes.take<int>();
    ransac.ordered = bytes.flip();
    return ransac;
}

cv::Ptr<CameraModel> lensFrom(Bytes& bytes)
{
    const cv::Matx33d K = synthetic::paperCamera();
    const auto parameter = [&](double plain) { return bytes.between(0, 7) == 7 ? bytes.number() : plain; };
    cv::Vec4d D;
    spoil(bytes, D, 4);
    const int lens = bytes.between(0, 8);
    // One after the other: compilers differ in the order of a call's arguments.
    const double first = parameter(lens == 2 ? 0.8 : lens == 4 ? -0.2 : 0.6), second = parameter(lens == 3 ? 1.1 : 0.6);
    try {
        switch (lens) {
            case 1:
                return CameraModel::fisheye(K, D);
            case 2:
                return CameraModel::omnidir(K, D, first);
            case 3:
                return CameraModel::eucm(K, first, second);
            case 4:
                return CameraModel::doubleSphere(K, first, second);
            case 5:
                return CameraModel::equirectangular({bytes.between(0, 255) * 8, bytes.between(0, 255) * 4});
            case 6:
                return cv::makePtr<CarelessLens>(first, second);
            case 7:
                return nullptr;
            default:
                return CameraModel::pinhole(K, D);
        }
    } catch (const cv::Exception&) {
        return CameraModel::pinhole(K);  // refused, as it should be: fuzz_camera looks at that
    }
}

Output::Output(Bytes& bytes, const cv::Vec3d& value) : fixed_(bytes.flip()), vec_(value), vecBefore_(value)
{
    const int kind = bytes.between(0, 15);
    Mat(value).convertTo(mat_, kind < 8 ? CV_64F : CV_32F);
    if (kind == 14)
        mat_ = mat_.reshape(1, 1);
    if (kind == 15)
        mat_ = anyMat(bytes);
    matBefore_ = mat_.clone();
}

cv::_InputOutputArray Output::ref()
{
    return fixed_ ? cv::_InputOutputArray(vec_) : cv::_InputOutputArray(mat_);
}

bool Output::unchanged() const
{
    return fixed_ ? sameBits(cv::Mat(vec_), cv::Mat(vecBefore_)) : sameBits(mat_, matBefore_);
}

bool Output::finite() const
{
    const Mat m = fixed_ ? Mat(vec_) : mat_;
    return m.total() == 3 && cv::checkRange(m, true, nullptr, -DBL_MAX, DBL_MAX);
}

}  // namespace fuzz
