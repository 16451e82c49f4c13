// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The loops over the points. The source file of each instruction set includes this header once, and everything here is
// local to that file. T is a double or a vector of doubles that the operators of the language apply to. The formulas
// are derived in doc/theory.md, section 2; pointTerms() (rays/ray_pass.cpp) is their readable twin, and a test compares
// the two.

#include <cmath>
#include <cstring>

#include "kernels.hpp"

#if defined(__GNUC__)
#define GMLPNP_INLINE_LAMBDA __attribute__((always_inline))
#define GMLPNP_INLINE inline GMLPNP_INLINE_LAMBDA
#else
#define GMLPNP_INLINE_LAMBDA
#define GMLPNP_INLINE inline
#endif

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

template <class T>
struct Vec3
{
    T x, y, z;
};

// A symmetric 3x3 matrix.
template <class T>
struct Sym3
{
    T xx, xy, xz, yy, yz, zz;
};

template <class T>
GMLPNP_INLINE void operator+=(Vec3<T>& a, const Vec3<T>& b)
{
    a.x += b.x, a.y += b.y, a.z += b.z;
}

template <class T>
GMLPNP_INLINE void operator+=(Sym3<T>& a, const Sym3<T>& b)
{
    a.xx += b.xx, a.xy += b.xy, a.xz += b.xz, a.yy += b.yy, a.yz += b.yz, a.zz += b.zz;
}

template <class T>
GMLPNP_INLINE T dot(const Vec3<T>& a, const Vec3<T>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
GMLPNP_INLINE Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
GMLPNP_INLINE Vec3<T> operator*(T k, const Vec3<T>& v)
{
    return {k * v.x, k * v.y, k * v.z};
}

template <class T>
GMLPNP_INLINE Sym3<T> operator*(T k, const Sym3<T>& S)
{
    return {k * S.xx, k * S.xy, k * S.xz, k * S.yy, k * S.yz, k * S.zz};
}

template <class T>
GMLPNP_INLINE Vec3<T> operator*(const Sym3<T>& S, const Vec3<T>& v)
{
    return {S.xx * v.x + S.xy * v.y + S.xz * v.z, S.xy * v.x + S.yy * v.y + S.yz * v.z,
            S.xz * v.x + S.yz * v.y + S.zz * v.z};
}

template <class T>
GMLPNP_INLINE Sym3<T> outer(const Vec3<T>& v)
{
    return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z};
}

template <class T>
GMLPNP_INLINE Sym3<T> adjugate(const Sym3<T>& S)
{
    return {S.yy * S.zz - S.yz * S.yz, S.xz * S.yz - S.xy * S.zz, S.xy * S.yz - S.xz * S.yy,
            S.xx * S.zz - S.xz * S.xz, S.xy * S.xz - S.xx * S.yz, S.xx * S.yy - S.xy * S.xy};
}

template <class T>
GMLPNP_INLINE T traceOfProduct(const Sym3<T>& A, const Sym3<T>& B)
{
    return A.xx * B.xx + A.yy * B.yy + A.zz * B.zz + 2. * (A.xy * B.xy + A.xz * B.xz + A.yz * B.yz);
}

// Returns [m]_x^T S [m]_x from M = m m^T.
template <class T>
GMLPNP_INLINE Sym3<T> sandwich(const Sym3<T>& M, const Sym3<T>& S)
{
    return {
        M.zz * S.yy - 2. * M.yz * S.yz + M.yy * S.zz,          M.yz * S.xz + M.xz * S.yz - M.zz * S.xy - M.xy * S.zz,
        M.yz * S.xy + M.xy * S.yz - M.yy * S.xz - M.xz * S.yy, M.zz * S.xx - 2. * M.xz * S.xz + M.xx * S.zz,
        M.xz * S.xy + M.xy * S.xz - M.xx * S.yz - M.yz * S.xx, M.yy * S.xx - 2. * M.xy * S.xy + M.xx * S.yy};
}

// Says how a number type is spread, summed and seen as bits.
template <class T>
struct Lanes;

template <>
struct Lanes<double>
{
    using Bits = unsigned long long;
    static constexpr int COUNT = 1;
    static GMLPNP_INLINE Bits from(int) { return ~0ull; }
    static GMLPNP_INLINE double spread(double x) { return x; }
    static GMLPNP_INLINE double sum(double x) { return x; }
    static GMLPNP_INLINE double product(double x) { return x; }
    static GMLPNP_INLINE double squareRoot(double x) { return std::sqrt(x); }
    static GMLPNP_INLINE Bits sumBits(Bits b) { return b; }
    static GMLPNP_INLINE Bits bits(double x)
    {
        Bits b;
        std::memcpy(&b, &x, sizeof b);
        return b;
    }
    static GMLPNP_INLINE double number(Bits b)
    {
        double x;
        std::memcpy(&x, &b, sizeof x);
        return x;
    }
};

// A block has as many points as there are lanes. A last block that would not be full starts earlier. Lanes whose
// points an earlier block already had do not count.
template <class T>
struct Block
{
    explicit GMLPNP_INLINE Block(int i) : first(i), counts(~typename Lanes<T>::Bits{}) {}
    GMLPNP_INLINE Block(int i, int end)
        : first(i + Lanes<T>::COUNT <= end ? i : end - Lanes<T>::COUNT), counts(Lanes<T>::from(i - first))
    {}

    GMLPNP_INLINE T choose(T counted, T other) const
    {
        return Lanes<T>::number((Lanes<T>::bits(counted) & counts) | (Lanes<T>::bits(other) & ~counts));
    }
    GMLPNP_INLINE Vec3<T> choose(const Vec3<T>& counted, const Vec3<T>& other) const
    {
        return {choose(counted.x, other.x), choose(counted.y, other.y), choose(counted.z, other.z)};
    }
    GMLPNP_INLINE T only(T x) const { return Lanes<T>::number(Lanes<T>::bits(x) & counts); }
    GMLPNP_INLINE Vec3<T> only(const Vec3<T>& v) const { return {only(v.x), only(v.y), only(v.z)}; }

    const int first;
    const typename Lanes<T>::Bits counts;
};

// Calls the body for all blocks. The full blocks have a loop of their own, in which the masks are constants.
template <class T, class Body>
GMLPNP_INLINE void forBlocks(int first, int last, const Body& body)
{
    int i = first;
    for (; i + Lanes<T>::COUNT <= last; i += Lanes<T>::COUNT)
        body(Block<T>(i));
    if (i < last)
        body(Block<T>(i, last));
}

template <class T, class Body>
GMLPNP_INLINE void forBlocks(int size, const Body& body)
{
    forBlocks<T>(0, size, body);
}

template <class T>
GMLPNP_INLINE T load(const double* from)
{
    T x;
    std::memcpy(&x, from, sizeof x);
    return x;
}

template <class T>
GMLPNP_INLINE Vec3<T> load3(const double* const* from, int i)
{
    return {load<T>(from[0] + i), load<T>(from[1] + i), load<T>(from[2] + i)};
}

template <class T>
GMLPNP_INLINE void store(T x, double* to)
{
    std::memcpy(to, &x, sizeof x);
}

template <class T>
GMLPNP_INLINE void store3(const Vec3<T>& v, double* const* to, int i)
{
    store(v.x, to[0] + i), store(v.y, to[1] + i), store(v.z, to[2] + i);
}

template <class T>
GMLPNP_INLINE Sym3<T> load6(const double* const* from, int i)
{
    return {load<T>(from[0] + i), load<T>(from[1] + i), load<T>(from[2] + i),
            load<T>(from[3] + i), load<T>(from[4] + i), load<T>(from[5] + i)};
}

template <class T>
GMLPNP_INLINE Vec3<T> spread3(const double* v)
{
    return {Lanes<T>::spread(v[0]), Lanes<T>::spread(v[1]), Lanes<T>::spread(v[2])};
}

template <class T>
GMLPNP_INLINE Sym3<T> spread6(const double* S)
{
    return {Lanes<T>::spread(S[0]), Lanes<T>::spread(S[1]), Lanes<T>::spread(S[2]),
            Lanes<T>::spread(S[3]), Lanes<T>::spread(S[4]), Lanes<T>::spread(S[5])};
}

template <class T>
struct SpreadPose
{
    explicit GMLPNP_INLINE SpreadPose(const double* pose)
        : R{spread3<T>(pose), spread3<T>(pose + 3), spread3<T>(pose + 6)}, t(spread3<T>(pose + 9))
    {}

    const Vec3<T> R[3], t;
};

// Returns X = R p + t.
template <class T>
GMLPNP_INLINE Vec3<T> operator*(const SpreadPose<T>& at, const Vec3<T>& p)
{
    return {dot(at.R[0], p) + at.t.x, dot(at.R[1], p) + at.t.y, dot(at.R[2], p) + at.t.z};
}

template <class T>
void addTo(double* out, const Vec3<T>& v)
{
    const T all[3] = {v.x, v.y, v.z};
    for (int k = 0; k < 3; ++k)
        out[k] += Lanes<T>::sum(all[k]);
}

template <class T>
void addTo(double* out, const Sym3<T>& S)
{
    const T all[6] = {S.xx, S.xy, S.xz, S.yy, S.yz, S.zz};
    for (int k = 0; k < 6; ++k)
        out[k] += Lanes<T>::sum(all[k]);
}

// A product of positive numbers. It keeps its exponent apart, so that it may leave the range of a double.
template <class T>
struct Product
{
    using Bits = typename Lanes<T>::Bits;
    T mantissa = Lanes<T>::spread(1);
    Bits exponents{};

    GMLPNP_INLINE void operator*=(T x)
    {
        const Bits b = Lanes<T>::bits(mantissa * x);
        exponents += (b >> 52) - 1023;
        mantissa = Lanes<T>::number((b & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
    }
};

template <class T>
void addTo(ScaledProduct& out, const Product<T>& product)
{
    out.mantissa *= Lanes<T>::product(product.mantissa);
    out.exponent += static_cast<long long>(Lanes<T>::sumBits(product.exponents));
}

template <class T>
struct Accumulator
{
    Sym3<T> Hpp{}, Hdd{}, Zo{}, Go{}, Zb{}, Gb{};
    Vec3<T> Hpd[3]{}, gp{}, gd{};
    T c{}, c2{}, QQ[21]{};
    Product<T> D, tailed;
    typename Lanes<T>::Bits behind{};
};

// Adds J^T Q J with J = [ -[X]_x , I ] and the lever arm X (doc/theory.md, section 2). The phi-delta block is [X]_x Q,
// the phi-phi block [X]_x Q [X]_x^T.
template <class T>
GMLPNP_INLINE void addInformation(const Vec3<T>& X, const Sym3<T>& Q, Accumulator<T>& sums)
{
    const Vec3<T> B0 = {X.y * Q.xz - X.z * Q.xy, X.y * Q.yz - X.z * Q.yy, X.y * Q.zz - X.z * Q.yz};
    const Vec3<T> B1 = {X.z * Q.xx - X.x * Q.xz, X.z * Q.xy - X.x * Q.yz, X.z * Q.xz - X.x * Q.zz};
    const Vec3<T> B2 = {X.x * Q.xy - X.y * Q.xx, X.x * Q.yy - X.y * Q.xy, X.x * Q.yz - X.y * Q.xz};
    sums.Hpd[0] += B0, sums.Hpd[1] += B1, sums.Hpd[2] += B2;
    sums.Hpp += Sym3<T>{X.y * B0.z - X.z * B0.y, X.z * B0.x - X.x * B0.z, X.x * B0.y - X.y * B0.x,
                        X.z * B1.x - X.x * B1.z, X.x * B1.y - X.y * B1.x, X.x * B2.y - X.y * B2.x};
}

// Adds the upper triangle of weight v v^T.
template <class T>
GMLPNP_INLINE void addOuter(const T (&v)[6], T weight, T* sums)
{
    for (int a = 0, k = 0; a < 6; ++a) {
        const T weighted = weight * v[a];
        for (int b = a; b < 6; ++b, ++k)
            sums[k] += weighted * v[b];
    }
}

template <class T>
GMLPNP_INLINE void addProducts(const Sym3<T>& Q, T weight, T* sums)
{
    addOuter({Q.xx, Q.xy, Q.xz, Q.yy, Q.yz, Q.zz}, weight, sums);
}

// Returns the weight of the products: s^4 for the bearing noise, because S holds s^2 Gamma.
template <class T>
GMLPNP_INLINE T depthWeight(Products products, T s2)
{
    return products == OF_OBJECT ? Lanes<T>::spread(1) : s2 * s2;
}

template <class T>
GMLPNP_INLINE void addProducts(Products products, const Sym3<T>& Q, T s2, Accumulator<T>& sums)
{
    addProducts(Q, depthWeight(products, s2), sums.QQ);
}

// The products for both noises at once.
template <class T>
struct InformationAccumulator
{
    T object[21]{}, bearing[21]{}, both[21]{};
};

template <class T>
GMLPNP_INLINE void addProducts(Products, const Sym3<T>& Q, T s2, InformationAccumulator<T>& sums)
{
    const Sym3<T> s2Q = s2 * Q;
    const T q[6] = {Q.xx, Q.xy, Q.xz, Q.yy, Q.yz, Q.zz}, s2q[6] = {s2Q.xx, s2Q.xy, s2Q.xz, s2Q.yy, s2Q.yz, s2Q.zz};
    for (int a = 0, k = 0; a < 6; ++a)
        for (int b = a; b < 6; ++b, ++k) {
            sums.object[k] += q[a] * q[b];
            sums.bearing[k] += s2q[a] * s2q[b];
            sums.both[k] += q[a] * s2q[b];
        }
}

// Returns e^x for x <= 0, to about 3 units in the last place, and e^-690 for any lower x. With k = round(x / ln 2) and
// r = x - k ln 2 it is 2^k e^r, and Taylor's series gives e^r to the last digits because |r| <= ln 2 / 2.
template <class T>
GMLPNP_INLINE T exponential(T x)
{
    constexpr double LOWEST = -690;  // range of doubles: 2^k must not underflow
    constexpr double LOG2_E = 1.4426950408889634, LN2_HIGH = 0.693147180369123816490, LN2_LOW = 1.90821492927058770e-10;
    constexpr double ROUNDER = 6755399441055744.;  // 1.5 * 2^52: adding it leaves an integer in the lowest bits
    x = x > LOWEST ? x : Lanes<T>::spread(LOWEST);
    const T rounded = x * LOG2_E + ROUNDER, k = rounded - ROUNDER;
    const T r = (x - k * LN2_HIGH) - k * LN2_LOW;
    T series = Lanes<T>::spread(1. / 479001600);  // the highest term of the series
    constexpr double TERMS[] = {1. / 39916800, 1. / 3628800, 1. / 362880, 1. / 40320, 1. / 5040, 1. / 720,
                                1. / 120,      1. / 24,      1. / 6,      0.5,        1.,        1.};
    for (double term : TERMS)
        series = series * r + term;
    return Lanes<T>::number(Lanes<T>::bits(series) + (Lanes<T>::bits(rounded) << 52));  // times 2^k
}

template <class T>
class SpreadTails
{
public:
    explicit GMLPNP_INLINE SpreadTails(const Tails& tails)
        : most_(Lanes<T>::spread(1 - tails.share)),
          wide_(Lanes<T>::spread(tails.share / tails.spread2)),
          perC_(Lanes<T>::spread(1 / (tails.dof * tails.spread2))),
          slope_(Lanes<T>::spread((tails.dof + 2) / (tails.dof * tails.spread2))),
          dof_(tails.dof)
    {}

    // Returns g(c) and sets w = -2 g'(c) / g(c) (doc/theory.md, section 1).
    GMLPNP_INLINE T density(T c, T& w) const
    {
        const T gaussian = most_ * exponential(-0.5 * c), u = 1. / (1. + perC_ * c);
        T student = wide_ * u;
        for (int k = dof_; k > 1; k -= 2)
            student *= u;
        if (dof_ % 2)
            student *= Lanes<T>::squareRoot(u);
        const T g = gaussian + student + LEAST_DENSITY;
        w = (gaussian + slope_ * u * student) / g;
        return g;
    }

private:
    T most_, wide_, perC_, slope_;
    int dof_;
};

// The parts of a loop that can be left out at compile time.
enum Features
{
    BEARING_NOISE = 1,  // Gamma is not zero
    TAILS = 2,          // the noise is not Gaussian
    KNOWN = 4,          // each point has covariances of its own
    PRODUCTS = 8,       // the loop sums products of Q
    NOTHING_ELSE = 16,  // the loop sums only them
    DEPTH_MATTERS = BEARING_NOISE | KNOWN
};

// Returns R C R^T.
template <class T>
GMLPNP_INLINE Sym3<T> rotated(const Vec3<T> (&R)[3], const Sym3<T>& C)
{
    const Vec3<T> c0 = C * R[0], c1 = C * R[1], c2 = C * R[2];
    return {dot(R[0], c0), dot(R[0], c1), dot(R[0], c2), dot(R[1], c1), dot(R[1], c2), dot(R[2], c2)};
}

template <class T>
struct PassState : SpreadPose<T>
{
    explicit GMLPNP_INLINE PassState(const PassInput& in)
        : SpreadPose<T>(in.pose),
          S_o(spread6<T>(in.S_o)),
          Gamma(spread6<T>(in.Gamma)),
          adjS(adjugate(S_o)),
          tails(in.tails),
          lever(Lanes<T>::spread(in.lever)),
          products(in.products)
    {}

    const Sym3<T> S_o, Gamma, adjS;
    const SpreadTails<T> tails;
    const T lever;
    const Products products;
};

template <int FEATURES, class T>
GMLPNP_INLINE T addResidual(const PassState<T>& at, const Block<T>& block, const Vec3<T>& X, const Vec3<T>& m, T s,
                            T s2, T D, T inverseD, const Sym3<T>& S_o, const Sym3<T>& Gamma, const Sym3<T>& S,
                            const Sym3<T>& Q, Accumulator<T>& sums)
{
    // z is not computed as Q X: on exact data X is so much longer than v that the digits of v would be lost.
    const Vec3<T> v = cross(m, X), Sv = S * v, z = inverseD * cross(Sv, m);
    const T c = inverseD * dot(v, Sv);

    Sym3<T> wQ = Q, wzz = outer(z);
    Vec3<T> zTilde = z;
    if constexpr ((FEATURES & DEPTH_MATTERS) != 0) {
        const T pull = s * dot(z, Gamma * z);
        zTilde = {z.x - pull * m.x, z.y - pull * m.y, z.z - pull * m.z};
    }
    if constexpr ((FEATURES & TAILS) != 0) {
        T w;
        sums.tailed *= block.choose(at.tails.density(c, w), Lanes<T>::spread(1));
        wQ = w * Q;
        wzz = w * wzz;
        zTilde = w * zTilde;
    }
    // The lever arm is that of the paper's Eq. (5), generalised to Gamma.
    const Vec3<T> e = at.lever * (S_o * z), Xhat = {X.x - e.x, X.y - e.y, X.z - e.z};
    addInformation(Xhat, wQ, sums);
    if constexpr ((FEATURES & TAILS) != 0)
        sums.Hdd += wQ;
    sums.gp += cross(Xhat, zTilde);
    sums.gd += zTilde;
    sums.Go += Q;
    sums.Zo += wzz;
    if constexpr ((FEATURES & DEPTH_MATTERS) != 0) {
        sums.Zb += s2 * wzz;
        sums.Gb += s2 * Q;
    }
    sums.c += c;
    sums.c2 += c * c;
    sums.D *= D;
    sums.behind += (Lanes<T>::bits(s) & block.counts) >> 63;
    return c;
}

// Adds one block of points: S, D and Q of doc/theory.md, section 1, then the sums of section 2. A lane that does not
// count has a ray of zeros, which adds nothing once its D is replaced by 1.
template <int FEATURES, class T, class Sums>
GMLPNP_INLINE T addPoint(const PassState<T>& at, const Block<T>& block, const Vec3<T>& p, const Vec3<T>& m,
                         const Sym3<T>& knownObject, const Sym3<T>& knownRay, Sums& sums)
{
    const Vec3<T> X = at * p;
    const Sym3<T> M = outer(m);
    const T s = dot(m, X), s2 = s * s;
    Sym3<T> S_o = at.S_o, Gamma = at.Gamma;
    if constexpr ((FEATURES & KNOWN) != 0) {
        S_o += rotated(at.R, knownObject);
        Gamma += knownRay;
    }
    Sym3<T> S = S_o, adjS = at.adjS;
    if constexpr ((FEATURES & DEPTH_MATTERS) != 0) {
        S += s2 * Gamma;
        adjS = adjugate(S);
    }
    const T D = block.choose(traceOfProduct(M, adjS), Lanes<T>::spread(1)), inverseD = 1. / D;
    const Sym3<T> Q = inverseD * sandwich(M, S);
    if constexpr ((FEATURES & PRODUCTS) != 0)
        addProducts(at.products, Q, s2, sums);
    if constexpr ((FEATURES & NOTHING_ELSE) == 0)
        return addResidual<FEATURES>(at, block, X, m, s, s2, D, inverseD, S_o, Gamma, S, Q, sums);
    return T{};
}

template <class T, int FEATURES, class Sums>
GMLPNP_INLINE void addBlock(const PointArrays& data, const PassState<T>& at, const Block<T>& block, double* c,
                            Sums& sums)
{
    const int i = block.first;
    Sym3<T> knownObject{}, knownRay{};
    if constexpr ((FEATURES & KNOWN) != 0) {
        knownObject = load6<T>(data.known, i);
        knownRay = load6<T>(data.known + 6, i);
    }
    const Vec3<T> p = load3<T>(data.point, i), m = block.only(load3<T>(data.ray, i));
    const T squared = addPoint<FEATURES>(at, block, p, m, knownObject, knownRay, sums);
    if (c)
        store(block.choose(squared, load<T>(c + i)), c + i);
}

template <class T>
void addProductsTo(double* out, const T* sums)
{
    for (int a = 0; a < 21; ++a)
        out[a] += Lanes<T>::sum(sums[a]);
}

template <class T, int FEATURES>
void addAll(const PointArrays& data, const PassInput& in, PassSums& out)
{
    const PassState<T> at(in);
    Accumulator<T> sums;
    int i = 0;
    // This loop does not use forBlocks(), by which both noises take a tenth longer.
    for (; i + Lanes<T>::COUNT <= data.size; i += Lanes<T>::COUNT)
        addBlock<T, FEATURES>(data, at, Block<T>(i), in.c, sums);
    if (i < data.size)
        addBlock<T, FEATURES>(data, at, Block<T>(i, data.size), in.c, sums);
    addTo(out.Hpp, sums.Hpp);
    for (size_t k = 0; k < 3; ++k)
        addTo(out.Hpd + 3 * k, sums.Hpd[k]);
    addTo(out.Hdd, (FEATURES & TAILS) != 0 ? sums.Hdd : sums.Go);
    addTo(out.Zo, sums.Zo);
    addTo(out.Go, sums.Go);
    addTo(out.Zb, sums.Zb);
    addTo(out.Gb, sums.Gb);
    addTo(out.gp, sums.gp);
    addTo(out.gd, sums.gd);
    out.c += Lanes<T>::sum(sums.c);
    out.c2 += Lanes<T>::sum(sums.c2);
    if constexpr ((FEATURES & PRODUCTS) != 0)
        addProductsTo(out.QQ, sums.QQ);
    addTo(out.D, sums.D);
    addTo(out.tailed, sums.tailed);
    out.behind += Lanes<T>::sumBits(sums.behind);
}

// A quarter of the points tells enough where the products only steer the scoring: the first SAMPLE of each STRETCH.
// fitted: scripts/bench.sh (doc/lab/performance.md, "Steps"); held by Gmlpnp_AccuracyStatistics
constexpr int STRETCH = 16, SAMPLE = 4;

template <class T, int NOISE>
void addSampledProducts(const PointArrays& data, const PassInput& in, PassSums& out)
{
    const PassState<T> at(in);
    Accumulator<T> sums;
    constexpr int FEATURES = NOISE | PRODUCTS | NOTHING_ELSE;
    int first = 0;
    for (; first + SAMPLE <= data.size; first += STRETCH)
        for (int i = first; i < first + SAMPLE; i += Lanes<T>::COUNT)
            addBlock<T, FEATURES>(data, at, Block<T>(i), nullptr, sums);
    for (int i = first; i < data.size; i += Lanes<T>::COUNT)
        addBlock<T, FEATURES>(data, at, Block<T>(i, data.size), nullptr, sums);
    addProductsTo(out.QQ, sums.QQ);
}

template <class T, int NOISE>
void passWith(const PointArrays& data, const PassInput& in, PassSums& out)
{
    const bool all = in.products && !in.sampled;
    if (in.tails.share > 0)
        all ? addAll<T, NOISE | TAILS | PRODUCTS>(data, in, out) : addAll<T, NOISE | TAILS>(data, in, out);
    else
        all ? addAll<T, NOISE | PRODUCTS>(data, in, out) : addAll<T, NOISE>(data, in, out);
    if (in.products && in.sampled)
        addSampledProducts<T, NOISE>(data, in, out);
}

template <int FEATURES>
struct Constant
{
    static constexpr int VALUE = FEATURES;
};

// Calls the body with the Constant of KNOWN, of BEARING_NOISE or of neither, whichever the data need.
template <class Body>
void forNoise(const PointArrays& data, const PassInput& in, const Body& body)
{
    bool bearing = false;
    for (double entry : in.Gamma)
        bearing = bearing || entry != 0;
    if (data.known[0])
        body(Constant<KNOWN>());
    else if (bearing)
        body(Constant<BEARING_NOISE>());
    else
        body(Constant<0>());
}

template <class T>
void pass(const PointArrays& data, const PassInput& in, PassSums& out)
{
    out = PassSums();
    const int rest = data.size % STRETCH;
    out.inProducts = in.sampled ? data.size / STRETCH * SAMPLE + (rest < SAMPLE ? rest : SAMPLE) : data.size;
    forNoise(data, in, [&](auto noise) { passWith<T, decltype(noise)::VALUE>(data, in, out); });
}

template <class T, int NOISE>
void informationWith(const PointArrays& data, const PassInput& in, InformationSums& out)
{
    const PassState<T> at(in);
    InformationAccumulator<T> sums;
    forBlocks<T>(data.size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        addBlock<T, NOISE | PRODUCTS | NOTHING_ELSE>(data, at, block, nullptr, sums);
    });
    out = InformationSums();
    addProductsTo(out.object, sums.object);
    addProductsTo(out.bearing, sums.bearing);
    addProductsTo(out.both, sums.both);
}

template <class T>
void information(const PointArrays& data, const PassInput& in, InformationSums& out)
{
    forNoise(data, in, [&](auto noise) { informationWith<T, decltype(noise)::VALUE>(data, in, out); });
}

template <class T>
void prepare(double* const* point, double* const* ray, int size, const double* centre, ColumnSums& out)
{
    const Vec3<double> along0 = load3<double>(ray, 0), unit0 = 1 / std::sqrt(dot(along0, along0)) * along0;
    const double firstRay[3] = {unit0.x, unit0.y, unit0.z};
    const Vec3<T> c = spread3<T>(centre), m0 = spread3<T>(firstRay);
    Sym3<T> scatter{};
    T ray2{}, inverse2{}, apart2{};
    forBlocks<T>(size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const Vec3<T> given = load3<T>(point, block.first), p = {given.x - c.x, given.y - c.y, given.z - c.z};
        store3(block.choose(p, given), point, block.first);
        scatter += outer(block.only(p));
        const Vec3<T> along = load3<T>(ray, block.first);
        const T length2 = dot(along, along);
        const Vec3<T> m = 1. / Lanes<T>::squareRoot(length2) * along, d = {m.x - m0.x, m.y - m0.y, m.z - m0.z};
        store3(block.choose(m, along), ray, block.first);
        ray2 += block.only(length2);
        inverse2 += block.only(1. / length2);
        apart2 += block.only(dot(d, d));
    });
    out = ColumnSums();
    addTo(out.scatter, scatter);
    out.ray2 = Lanes<T>::sum(ray2);
    out.inverse2 = Lanes<T>::sum(inverse2);
    out.apart2 = Lanes<T>::sum(apart2);
}

template <class T>
void moments(const PointArrays& data, MomentSums& out)
{
    Sym3<T> sumQ{}, sumPQ[3]{}, sumPPQ[6]{};
    forBlocks<T>(data.size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const Vec3<T> p = load3<T>(data.point, block.first), m = load3<T>(data.ray, block.first);
        const Sym3<T> M = block.only(1. / dot(m, m)) * outer(m);
        const T one = block.only(Lanes<T>::spread(1));
        const Sym3<T> Q = {one - M.xx, -M.xy, -M.xz, one - M.yy, -M.yz, one - M.zz};
        const Sym3<T> xQ = p.x * Q, yQ = p.y * Q, zQ = p.z * Q;
        sumQ += Q;
        sumPQ[0] += xQ, sumPQ[1] += yQ, sumPQ[2] += zQ;
        sumPPQ[0] += p.x * xQ, sumPPQ[1] += p.y * xQ, sumPPQ[2] += p.z * xQ;
        sumPPQ[3] += p.y * yQ, sumPPQ[4] += p.z * yQ, sumPPQ[5] += p.z * zQ;
    });
    out = MomentSums();
    addTo(out.Q, sumQ);
    for (int k = 0; k < 3; ++k)
        addTo(out.pQ[k], sumPQ[k]);
    for (int k = 0; k < 6; ++k)
        addTo(out.ppQ[k], sumPPQ[k]);
}

template <class T>
int behind(const PointArrays& data, const double* pose)
{
    const SpreadPose<T> at(pose);
    typename Lanes<T>::Bits sum{};
    forBlocks<T>(data.size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const T s = dot(load3<T>(data.ray, block.first), at * load3<T>(data.point, block.first));
        sum += (Lanes<T>::bits(s) & block.counts) >> 63;
    });
    return static_cast<int>(Lanes<T>::sumBits(sum));
}

// Sums for all tails at once. One after the other they would wait for each other's exponentials.
template <class T>
void tails(const double* c, int size, const Tails* tails, const double* factors, TailSums* out)
{
    static_assert(TRIED_TAILS == 4, "tried[] lists so many");
    const SpreadTails<T> tried[] = {SpreadTails<T>(tails[0]), SpreadTails<T>(tails[1]), SpreadTails<T>(tails[2]),
                                    SpreadTails<T>(tails[3])};
    T inverse[TRIED_TAILS], wc[TRIED_TAILS]{};
    for (int k = 0; k < TRIED_TAILS; ++k)
        inverse[k] = Lanes<T>::spread(1 / factors[k]);
    Product<T> product[TRIED_TAILS];
    forBlocks<T>(size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const T given = load<T>(c + block.first);
        for (int k = 0; k < TRIED_TAILS; ++k) {
            const T ck = inverse[k] * given;
            T w;
            product[k] *= block.choose(tried[k].density(ck, w), Lanes<T>::spread(1));
            wc[k] += block.only(w * ck);
        }
    });
    for (int k = 0; k < TRIED_TAILS; ++k) {
        out[k] = TailSums();
        out[k].wc = Lanes<T>::sum(wc[k]);
        addTo(out[k].g, product[k]);
    }
}

template <class T>
void residuals(const PointArrays& data, const double* pose, double* depth2, double* residual2)
{
    const SpreadPose<T> at(pose);
    forBlocks<T>(data.size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const int first = block.first;
        const Vec3<T> p = load3<T>(data.point, first), m = load3<T>(data.ray, first);
        const Vec3<T> X = at * p, v = cross(m, X);
        const T s = dot(m, X);
        store(s * s, depth2 + first);
        store(0.5 * dot(v, v) / dot(m, m), residual2 + first);
    });
}

template <class T>
void line(const double* x, const double* y, int size, double a, double b, LineSums& out)
{
    T w{}, wx{}, wxx{}, wy{}, wxy{}, misfit{};
    Product<T> variances;
    forBlocks<T>(size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const T xi = load<T>(x + block.first), yi = load<T>(y + block.first), variance = a + b * xi;
        const T inverse = block.only(1. / variance), wi = inverse * inverse, wxi = wi * xi;
        w += wi, wx += wxi, wxx += wxi * xi, wy += wi * yi, wxy += wxi * yi;
        misfit += yi * inverse;
        variances *= block.choose(variance, Lanes<T>::spread(1));
    });
    out = LineSums();
    const T sums[] = {w, wx, wxx, wy, wxy, misfit};
    double* const to[] = {&out.w, &out.wx, &out.wxx, &out.wy, &out.wxy, &out.misfit};
    for (int k = 0; k < 6; ++k)
        *to[k] = Lanes<T>::sum(sums[k]);
    addTo(out.variance, variances);
}

// A point of RANSAC at a pose. Its residual e is defined in ransac/metric.hpp; e is zero where the point is not in
// front.
template <class T>
struct ScoredPoint
{
    GMLPNP_INLINE ScoredPoint(const ScoredArrays& data, const SpreadPose<T>& at, int i)
        : m(load3<T>(data.ray, i)),
          B{load3<T>(data.metric, i), load3<T>(data.metric + 3, i)},
          X(at * load3<T>(data.point, i)),
          s(dot(m, X)),
          inverse(s > 0. ? 1. / s : T{}),
          e{dot(B[0], X) * inverse, dot(B[1], X) * inverse},
          e2(e[0] * e[0] + e[1] * e[1])
    {}

    GMLPNP_INLINE T truncated() const
    {
        const T one = Lanes<T>::spread(1), cost = s > 0. ? e2 : one;
        return cost < 1. ? cost : one;
    }

    const Vec3<T> m, B[2], X;
    const T s, inverse, e[2], e2;
};

template <class T>
void truncated(const ScoredArrays& data, const double* pose, int first, int last, TruncatedSums& out)
{
    const SpreadPose<T> at(pose);
    T sum{}, inliers{};
    forBlocks<T>(first, last, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const T cost = ScoredPoint<T>(data, at, block.first).truncated();
        sum += block.only(cost);
        inliers += block.only(cost < 1. ? Lanes<T>::spread(1) : T{});
    });
    out.cost = Lanes<T>::sum(sum);
    out.inliers = Lanes<T>::sum(inliers);
}

template <class T>
void inliers(const ScoredArrays& data, const double* pose, double* isInlier)
{
    const SpreadPose<T> at(pose);
    forBlocks<T>(data.size, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const T cost = ScoredPoint<T>(data, at, block.first).truncated();
        store(cost < 1. ? Lanes<T>::spread(1) : T{}, isInlier + block.first);
    });
}

template <class T>
void robustStep(const ScoredArrays& data, const double* pose, double width, int count, StepSums& out)
{
    const SpreadPose<T> at(pose);
    const double inverseWidth2 = 1 / (width * width);
    T H[21]{}, g[6]{};
    forBlocks<T>(count, [&](const Block<T>& block) GMLPNP_INLINE_LAMBDA {
        const ScoredPoint<T> point(data, at, block.first);
        const T left = 1. - inverseWidth2 * point.e2, near = left > 0. ? left * left : T{};
        const T w = block.only(point.s > 0. ? near : T{});
        for (int row = 0; row < 2; ++row) {
            const T e = point.e[row];
            const Vec3<T>&B = point.B[row], &m = point.m;
            const Vec3<T> byX = point.inverse * Vec3<T>{B.x - e * m.x, B.y - e * m.y, B.z - e * m.z};
            const Vec3<T> byPhi = cross(point.X, byX);
            const T J[6] = {byPhi.x, byPhi.y, byPhi.z, byX.x, byX.y, byX.z}, we = w * e;
            addOuter(J, w, H);
            for (int i = 0; i < 6; ++i)
                g[i] += we * J[i];
        }
    });
    for (int k = 0; k < 21; ++k)
        out.H[k] = Lanes<T>::sum(H[k]);
    for (int i = 0; i < 6; ++i)
        out.g[i] = Lanes<T>::sum(g[i]);
}

template <class T>
constexpr RayKernels kernelsOf(const char* name)
{
    return {name,     Lanes<T>::COUNT, prepare<T>, pass<T>,      information<T>, moments<T>,   behind<T>,
            tails<T>, residuals<T>,    line<T>,    truncated<T>, inliers<T>,     robustStep<T>};
}

}  // namespace
}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
