// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/spd3.hpp"
#include "p3p.hpp"

// With the cosines b_ij = m_i . m_j and the squared distances a_ij = |p_i - p_j|^2 the law of cosines is
//
//     s^T M_ij s = a_ij,   s^T M_ij s = s_i^2 + s_j^2 - 2 b_ij s_i s_j
//
// and s, up to its length, lies on the conics  D1 = a_23 M_12 - a_12 M_23  and  D2 = a_23 M_13 - a_13 M_23. The pencil
// and its degenerate member follow Persson and Nordberg 2018, the split into lines Ding et al. 2023.

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

constexpr int PAIRS[3][2] = {{0, 1}, {0, 2}, {1, 2}};

struct Triangle
{
    Triple rays;
    double b[3], a[3];  // cosine and squared distance of each pair; the largest a is 1
};

// Returns M_ij.
Matrix3d lawOfCosines(int pair, double b)
{
    const int i = PAIRS[pair][0], j = PAIRS[pair][1];
    Matrix3d M = Matrix3d::Zero();
    M(i, i) = M(j, j) = 1;
    M(i, j) = M(j, i) = -b;
    return M;
}

// Returns the real root of  x^3 + c2 x^2 + c1 x + c0  that is farthest from the other two. Newton's method starts
// beyond an extremum, on the side where the curve bends away from zero, and so is monotonic.
double isolatedRoot(double c2, double c1, double c0)
{
    constexpr int MOST_ROUNDS = 50;
    constexpr double LAST_DIGIT = 1e-15;  // rounding, of the last step, relative
    const double inflection = -c2 / 3;
    const auto value = [=](double x) { return ((x + c2) * x + c1) * x + c0; };
    const double halfWidth2 = (c2 * c2 - 3 * c1) / 9;  // squared, of the interval between the extrema
    double x = inflection;
    if (halfWidth2 > 0)
        x += (value(inflection) > 0 ? -2 : 2) * std::sqrt(halfWidth2);
    else if (c1 == c2 * c2 / 3)
        return inflection - std::cbrt(value(inflection));
    for (int round = 0; round < MOST_ROUNDS; ++round) {
        const double step = value(x) / ((3 * x + 2 * c2) * x + c1);
        x -= step;
        if (!(std::abs(step) > LAST_DIGIT * std::abs(x)))
            break;
    }
    return x;
}

// The member of the pencil that is a pair of lines, and a conic that is not this member.
struct DegenerateConic
{
    Matrix3d pair, other;
};

// Solves det(A + gamma B) = 0, a cubic in gamma, for A and B among D1 and D2.
DegenerateConic degenerateConic(const Matrix3d& D1, const Matrix3d& D2)
{
    const Matrix3d adjugate1 = adjugate(D1), adjugate2 = adjugate(D2);
    const double det1 = adjugate1.col(0).dot(D1.col(0)), det2 = adjugate2.col(0).dot(D2.col(0));
    const double mixed1 = adjugate1.cwiseProduct(D2).sum(), mixed2 = adjugate2.cwiseProduct(D1).sum();
    const bool swap = std::abs(det2) < std::abs(det1);
    const Matrix3d& A = swap ? D2 : D1;
    const Matrix3d& B = swap ? D1 : D2;
    const double detB = swap ? det1 : det2;
    if (detB == 0)
        return {A, B};
    const double gamma =
        isolatedRoot((swap ? mixed1 : mixed2) / detB, (swap ? mixed2 : mixed1) / detB, (swap ? det2 : det1) / detB);
    const Matrix3d pair = A + gamma * B;
    return {pair, std::abs(gamma) * B.squaredNorm() < A.cwiseAbs().maxCoeff() * B.norm() ? B : A};
}

// Splits  C = g l^T + l g^T  into its lines g and l. Returns false where they are complex. For v = g x l, up to sign,
// adj(C) = -v v^T, and C + [v]_x is 2 g l^T or 2 l g^T, a matrix of rank 1.
bool splitIntoLines(const Matrix3d& C, Vector3d& g, Vector3d& l)
{
    constexpr double DOUBLE_LINE = 1e-12;  // rounding, relative to the squared size of C
    const Matrix3d minusAdjugate = -adjugate(C);
    int k;
    const double largest = minusAdjugate.diagonal().maxCoeff(&k);
    if (largest < -DOUBLE_LINE * C.squaredNorm())
        return false;
    Matrix3d N = C;
    if (largest > 0)
        N += hat(minusAdjugate.col(k) / std::sqrt(largest));
    int row, column;
    N.cwiseAbs().maxCoeff(&row, &column);
    g = N.col(column);
    l = N.row(row).transpose();
    return true;
}

// Finds where a line meets a conic. Returns the number of points, 0 or 2.
int meet(const Vector3d& line, const Matrix3d& conic, Vector3d (&points)[2])
{
    constexpr double TANGENT = 1e-10;  // rounding, of the discriminant, relative
    int k;
    line.cwiseAbs().maxCoeff(&k);
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    Vector3d u = Vector3d::Zero(), v = Vector3d::Zero();
    u(i) = v(j) = line(k);
    u(k) = -line(i);
    v(k) = -line(j);
    const Vector3d Cu = conic * u, Cv = conic * v;
    const double uu = u.dot(Cu), uv = u.dot(Cv), vv = v.dot(Cv);
    const double discriminant = uv * uv - uu * vv;
    if (!(discriminant >= -TANGENT * (uv * uv + std::abs(uu * vv))))
        return 0;
    const double h = -(uv + std::copysign(std::sqrt(std::max(discriminant, 0.)), uv));
    points[0] = h * u + uu * v;
    points[1] = vv * u + h * v;
    return 2;
}

// Refines the depths by Newton's method on the three distances, and says whether they come out right. Where two poses
// coincide the steps are arbitrary, so a step that does not help is undone.
bool polish(const Triangle& triangle, Vector3d& s)
{
    constexpr int MOST_ROUNDS = 4;
    constexpr double EXACT_DISTANCE = 1e-14, WRONG_DISTANCE = 1e-9;  // rounding, relative to the longest, squared
    Vector3d before = s;
    double worstBefore = std::numeric_limits<double>::infinity();
    for (int round = 0;; ++round) {
        Vector3d residual;
        double slope[3][2];  // derivative of half the squared distance by the two depths of the pair
        for (int pair = 0; pair < 3; ++pair) {
            const int i = PAIRS[pair][0], j = PAIRS[pair][1];
            const Vector3d d = s(i) * triangle.rays[i] - s(j) * triangle.rays[j];
            residual(pair) = 0.5 * (d.squaredNorm() - triangle.a[pair]);
            slope[pair][0] = d.dot(triangle.rays[i]);
            slope[pair][1] = -d.dot(triangle.rays[j]);
        }
        const double worst = residual.cwiseAbs().maxCoeff();
        if (!(worst < worstBefore))
            s = before;
        if (!(worst < worstBefore) || worst < EXACT_DISTANCE || round == MOST_ROUNDS)
            return std::min(worst, worstBefore) < WRONG_DISTANCE && s.minCoeff() > 0;
        before = s;
        worstBefore = worst;
        const auto& [d01, d02, d12] = slope;
        const double det = d01[0] * d02[1] * d12[0] + d01[1] * d02[0] * d12[1];
        const auto& r = residual;
        s -= Vector3d(r(0) * d02[1] * d12[0] + r(1) * d01[1] * d12[1] - r(2) * d01[1] * d02[1],
                      r(0) * d02[0] * d12[1] - r(1) * d01[0] * d12[1] + r(2) * d01[0] * d02[1],
                      -r(0) * d02[0] * d12[0] + r(1) * d01[0] * d12[0] + r(2) * d01[1] * d02[0]) /
             det;
    }
}

// Returns the orthonormal axes of a triangle: along its first side, across it in the plane, and normal to the plane.
Matrix3d frame(const Vector3d& p0, const Vector3d& p1, const Vector3d& p2)
{
    Matrix3d F;
    F.col(0) = (p1 - p0).normalized();
    F.col(2) = F.col(0).cross(p2 - p0).normalized();
    F.col(1) = F.col(2).cross(F.col(0));
    return F;
}

}  // namespace

int p3p(const Triple& points, const Triple& rays, std::array<Pose, 4>& poses)
{
    Triangle triangle{rays, {}, {}};
    Matrix3d M[3];
    for (int pair = 0; pair < 3; ++pair) {
        const int i = PAIRS[pair][0], j = PAIRS[pair][1];
        triangle.a[pair] = (points[i] - points[j]).squaredNorm();
        triangle.b[pair] = rays[i].dot(rays[j]);
        M[pair] = lawOfCosines(pair, triangle.b[pair]);
    }
    auto& a = triangle.a;
    const double unit2 = std::max(a[0], std::max(a[1], a[2]));
    if (!(unit2 > 0))
        return 0;
    for (double& each : a)
        each /= unit2;

    const DegenerateConic conic = degenerateConic(a[2] * M[0] - a[0] * M[2], a[2] * M[1] - a[1] * M[2]);
    Vector3d lines[2];
    if (!splitIntoLines(conic.pair, lines[0], lines[1]))
        return 0;
    const Matrix3d total = M[0] + M[1] + M[2], F = frame(points[0], points[1], points[2]);
    const Vector3d centroid = (points[0] + points[1] + points[2]) / 3;
    int found = 0;
    for (const Vector3d& line : lines) {
        Vector3d meets[2];
        const int count = meet(line, conic.other, meets);
        for (int k = 0; k < count; ++k) {
            Vector3d s = meets[k](0) < 0 ? Vector3d(-meets[k]) : meets[k];
            const double length2 = s.dot(total * s);
            if (!(s.minCoeff() > 0) || !(length2 > 0))
                continue;
            s *= std::sqrt((a[0] + a[1] + a[2]) / length2);
            if (!polish(triangle, s))
                continue;
            s *= std::sqrt(unit2);
            const Matrix3d R = frame(s(0) * rays[0], s(1) * rays[1], s(2) * rays[2]) * F.transpose();
            poses[found++] = {R, (s(0) * rays[0] + s(1) * rays[1] + s(2) * rays[2]) / 3 - R * centroid};
        }
    }
    return found;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
