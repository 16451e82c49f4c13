// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

PointTerms pointTerms(const Vector3d& p, const Vector3d& m, const Pose& pose, const Matrix3d& S_o,
                      const Matrix3d& Gamma, double tail)
{
    PointTerms at;
    at.X = pose * p;
    at.s = m.dot(at.X);
    const Matrix3d S = S_o + at.s * at.s * Gamma;
    const Matrix3d A = hat(m);
    const Vector3d v = m.cross(at.X), Sv = S * v;
    at.D = m.dot(adjugate(S) * m);
    at.c = v.dot(Sv) / at.D;
    at.w = (1 + 2 * tail) / (1 + at.c * tail);
    at.z = Sv.cross(m) / at.D;
    at.Q = A.transpose() * S * A / at.D;
    at.zTilde = at.z - at.s * at.z.dot(Gamma * at.z) * m;
    at.Xhat = at.X - S_o * at.z;
    return at;
}

PointTerms pointTerms(const Correspondences& data, int i, const Pose& pose, const Noise& noise)
{
    Matrix3d Sigma = noise.Sigma, Gamma = noise.Gamma;
    if (data.hasKnown()) {
        Sigma += data.knownObject(i);
        Gamma += data.knownRay(i);
    }
    return pointTerms(data.pointAt(i), data.rayAt(i), pose, pose.R * Sigma * pose.R.transpose(), Gamma, noise.tail);
}

namespace {

// Symmetric 3x3: xx xy xz yy yz zz.
template <class T>
struct Sym3
{
    T xx, xy, xz, yy, yz, zz;

    void operator+=(const Sym3& o) { xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz; }
};

template <class T>
struct Vec3
{
    T x, y, z;

    void operator+=(const Vec3& o) { x += o.x, y += o.y, z += o.z; }
};

template <class T>
Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T dot(const Vec3<T>& a, const Vec3<T>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> operator*(const Sym3<T>& S, const Vec3<T>& v)
{
    return {S.xx * v.x + S.xy * v.y + S.xz * v.z, S.xy * v.x + S.yy * v.y + S.yz * v.z,
            S.xz * v.x + S.yz * v.y + S.zz * v.z};
}

template <class T>
Sym3<T> operator*(T k, const Sym3<T>& S)
{
    return {k * S.xx, k * S.xy, k * S.xz, k * S.yy, k * S.yz, k * S.zz};
}

template <class T>
Sym3<T> outer(const Vec3<T>& v)
{
    return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z};
}

// [m]^T_x S [m]_x
template <class T>
Sym3<T> sandwich(const Vec3<T>& m, const Sym3<T>& S)
{
    const Sym3<T> M = outer(m);
    return {
        M.zz * S.yy - 2. * M.yz * S.yz + M.yy * S.zz,          M.yz * S.xz + M.xz * S.yz - M.zz * S.xy - M.xy * S.zz,
        M.yz * S.xy + M.xy * S.yz - M.yy * S.xz - M.xz * S.yy, M.zz * S.xx - 2. * M.xz * S.xz + M.xx * S.zz,
        M.xz * S.xy + M.xy * S.xz - M.xx * S.yz - M.yz * S.xx, M.yy * S.xx - 2. * M.xy * S.xy + M.xx * S.yy};
}

template <class T>
T adjugateForm(const Vec3<T>& m, const Sym3<T>& S)  // m^T adj(S) m
{
    const Sym3<T> a = {S.yy * S.zz - S.yz * S.yz, S.xz * S.yz - S.xy * S.zz, S.xy * S.yz - S.xz * S.yy,
                       S.xx * S.zz - S.xz * S.xz, S.xy * S.xz - S.xx * S.yz, S.xx * S.yy - S.xy * S.xy};
    return dot(m, a * m);
}

Sym3<double> fromEigen(const Matrix3d& S)
{
    return {S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2)};
}

Matrix3d toEigen(const Sym3<double>& S)
{
    Matrix3d M;
    M << S.xx, S.xy, S.xz, S.xy, S.yy, S.yz, S.xz, S.yz, S.zz;
    return M;
}

// The accumulators as scalars; H in blocks:  phi-phi and delta-delta symmetric,  phi-delta by rows.
template <class T>
struct Sums
{
    Sym3<T> Hpp{}, Hdd{}, Zo{}, Go{}, Zb{}, Gb{};
    Vec3<T> Hpd[3]{}, gp{}, gd{};
    T c{}, c2{}, logD{}, logTail{}, inFront{};
};

// J^T Q J with J = [ -[X]_x , I ], X the lever arm:  phi-delta block [X]_x Q, phi-phi block [X]_x Q [X]_x^T.
template <class T>
void addInformation(const Vec3<T>& X, const Sym3<T>& Q, Sums<T>& sums)
{
    const Vec3<T> B0 = {X.y * Q.xz - X.z * Q.xy, X.y * Q.yz - X.z * Q.yy, X.y * Q.zz - X.z * Q.yz};
    const Vec3<T> B1 = {X.z * Q.xx - X.x * Q.xz, X.z * Q.xy - X.x * Q.yz, X.z * Q.xz - X.x * Q.zz};
    const Vec3<T> B2 = {X.x * Q.xy - X.y * Q.xx, X.x * Q.yy - X.y * Q.xy, X.x * Q.yz - X.y * Q.xz};
    sums.Hpd[0] += B0, sums.Hpd[1] += B1, sums.Hpd[2] += B2;
    sums.Hpp += Sym3<T>{X.y * B0.z - X.z * B0.y, X.z * B0.x - X.x * B0.z, X.x * B0.y - X.y * B0.x,
                        X.z * B1.x - X.x * B1.z, X.x * B1.y - X.y * B1.x, X.x * B2.y - X.y * B2.x};
    sums.Hdd += Q;
}

template <class T>
void addPoint(const Vec3<T>& X, const Vec3<T>& m, const Sym3<T>& S_o, const Sym3<T>& Gamma, T tail, T lever,
              Sums<T>& sums)
{
    const T s = dot(m, X), s2 = s * s;
    Sym3<T> S = s2 * Gamma;
    S += S_o;
    const T D = adjugateForm(m, S), inverseD = 1. / D;
    const Vec3<T> v = cross(m, X), Sv = S * v, u = cross(Sv, m);
    const T c = inverseD * dot(v, Sv), tailed = 1. + tail * c, w = (1. + 2. * tail) / tailed;
    const Vec3<T> z = {u.x * inverseD, u.y * inverseD, u.z * inverseD};
    const Sym3<T> Q = inverseD * sandwich(m, S), wzz = w * outer(z);
    const T pull = s * dot(z, Gamma * z);
    const Vec3<T> zTilde = {w * (z.x - pull * m.x), w * (z.y - pull * m.y), w * (z.z - pull * m.z)};
    const Vec3<T> e = S_o * z, Xhat = {X.x - lever * e.x, X.y - lever * e.y, X.z - lever * e.z};

    addInformation(Xhat, w * Q, sums);
    sums.gp += cross(Xhat, zTilde);
    sums.gd += zTilde;
    sums.Go += Q;
    sums.Zo += wzz;
    sums.Zb += s2 * wzz;
    sums.Gb += s2 * Q;
    sums.c += c;
    sums.c2 += c * c;
    sums.logD += std::log(D);
    if (tail > 0)
        sums.logTail += std::log(tailed);
    sums.inFront += s > 0 ? 1 : 0;
}

RaySums assembled(const Sums<double>& sums, double tail)
{
    RaySums out;
    out.Zo = toEigen(sums.Zo);
    out.Go = toEigen(sums.Go);
    out.Zb = toEigen(sums.Zb);
    out.Gb = toEigen(sums.Gb);
    out.H.topLeftCorner<3, 3>() = toEigen(sums.Hpp);
    out.H.bottomRightCorner<3, 3>() = toEigen(sums.Hdd);
    for (int k = 0; k < 3; ++k)
        out.H.block<1, 3>(k, 3) << sums.Hpd[k].x, sums.Hpd[k].y, sums.Hpd[k].z;
    out.H.bottomLeftCorner<3, 3>() = out.H.topRightCorner<3, 3>().transpose();
    out.g << sums.gp.x, sums.gp.y, sums.gp.z, sums.gd.x, sums.gd.y, sums.gd.z;
    out.c = sums.c;
    out.c2 = sums.c2;
    out.misfit = tail > 0 ? 0.5 * (1 / tail + 2) * sums.logTail : 0.5 * sums.c;
    out.L = 0.5 * sums.logD + out.misfit;
    out.inFront = static_cast<int>(sums.inFront);
    return out;
}

// R C R^T of the six entries of C.
Sym3<double> rotated(const Matrix3d& R, const Sym3<double>& C)
{
    const Vec3<double> r[3] = {{R(0, 0), R(0, 1), R(0, 2)}, {R(1, 0), R(1, 1), R(1, 2)}, {R(2, 0), R(2, 1), R(2, 2)}};
    const Vec3<double> c[3] = {C * r[0], C * r[1], C * r[2]};
    return {dot(r[0], c[0]), dot(r[0], c[1]), dot(r[0], c[2]), dot(r[1], c[1]), dot(r[1], c[2]), dot(r[2], c[2])};
}

Sym3<double> knownOf(const Correspondences& data, int i, int first)
{
    const auto entry = [&](int k) { return data.knownEntry(first + k)[i]; };
    return {entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)};
}

template <bool KNOWN>
Sums<double> addAll(const Correspondences& data, const Pose& pose, const Noise& noise, LeverArm leverArm)
{
    const Matrix3d& R = pose.R;
    const Sym3<double> Sigma = fromEigen(R * noise.Sigma * R.transpose()), Gamma = fromEigen(noise.Gamma);
    const double lever = leverArm == LeverArm::CORRECTED ? 1 : 0;
    const double *px = data.point(0), *py = data.point(1), *pz = data.point(2);
    const double *mx = data.ray(0), *my = data.ray(1), *mz = data.ray(2);
    Sums<double> sums;
    for (int i = 0; i < data.size(); ++i) {
        const Vec3<double> X = {R(0, 0) * px[i] + R(0, 1) * py[i] + R(0, 2) * pz[i] + pose.t(0),
                                R(1, 0) * px[i] + R(1, 1) * py[i] + R(1, 2) * pz[i] + pose.t(1),
                                R(2, 0) * px[i] + R(2, 1) * py[i] + R(2, 2) * pz[i] + pose.t(2)};
        Sym3<double> S_o = Sigma, Gamma_i = Gamma;
        if (KNOWN) {
            S_o += rotated(R, knownOf(data, i, 0));
            Gamma_i += knownOf(data, i, 6);
        }
        addPoint(X, {mx[i], my[i], mz[i]}, S_o, Gamma_i, noise.tail, lever, sums);
    }
    return sums;
}

}  // namespace

RaySums rayPass(const Correspondences& data, const Pose& pose, const Noise& noise, LeverArm lever)
{
    return assembled(data.hasKnown() ? addAll<true>(data, pose, noise, lever) : addAll<false>(data, pose, noise, lever),
                     noise.tail);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
