// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// How near the loops over the points come to what the machine can do.
//
//   roofline     a Markdown table: operations per point, time per point of each instruction set, share of the peak
//
// Operations are counted by running the loops themselves with a number type that counts; a division is one operation,
// as is each addition and multiplication. The peak is measured: independent fused multiplications and additions in
// registers, two operations each.

#include "../../modules/gmlpnp/src/kernels/loops.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <vector>

#include "../../modules/gmlpnp/src/precomp.hpp"
#include "../../modules/gmlpnp/src/rays/ray_pass.hpp"
#include "common/output_file.hpp"
#include "measuring.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

long operations = 0;

struct Counting
{
    double value;
};

Counting operator+(Counting a, Counting b)
{
    ++operations;
    return {a.value + b.value};
}

Counting operator-(Counting a, Counting b)
{
    ++operations;
    return {a.value - b.value};
}

Counting operator*(Counting a, Counting b)
{
    ++operations;
    return {a.value * b.value};
}

Counting operator/(Counting a, Counting b)
{
    ++operations;
    return {a.value / b.value};
}

Counting operator/(double a, Counting b)
{
    return Counting{a} / b;
}

Counting operator+(double a, Counting b)
{
    return Counting{a} + b;
}

Counting operator+(Counting a, double b)
{
    return a + Counting{b};
}

Counting operator-(Counting a, double b)
{
    return a - Counting{b};
}

Counting operator*(double a, Counting b)
{
    return Counting{a} * b;
}

Counting operator*(Counting a, double b)
{
    return a * Counting{b};
}

bool operator>(Counting a, double b)
{
    return a.value > b;
}

void operator*=(Counting& a, Counting b)
{
    a = a * b;
}

void operator+=(Counting& a, Counting b)
{
    a = a + b;
}

template <>
struct Lanes<Counting>
{
    using Bits = unsigned long long;
    static constexpr int COUNT = 1;
    static Bits from(int) { return ~0ull; }
    static Counting spread(double x) { return {x}; }
    static double sum(Counting x) { return x.value; }
    static double product(Counting x) { return x.value; }
    static Counting squareRoot(Counting x)
    {
        ++operations;
        return {std::sqrt(x.value)};
    }
    static Bits sumBits(Bits b) { return b; }
    static Bits bits(Counting x) { return Lanes<double>::bits(x.value); }
    static Counting number(Bits b) { return {Lanes<double>::number(b)}; }
};

// --- Data ---

struct Loop
{
    const char* name;
    bool bearing, tails;
    Products products;
};

const Loop LOOPS[] = {{"object noise", false, false, NO_PRODUCTS},
                      {"object noise, with products", false, false, OF_OBJECT},
                      {"both noises", true, false, NO_PRODUCTS},
                      {"both noises, tails", true, true, NO_PRODUCTS}};

Correspondences someData(int n)
{
    RNG rng(1);
    Mat_<double> points(n, 3), rays(n, 3);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) {
            rays(i, k) = k < 2 ? rng.uniform(-2., 2.) : rng.uniform(4., 8.);
            points(i, k) = rays(i, k) + rng.gaussian(0.1);
        }
    return Correspondences(points, rays);
}

PassInput inputOf(const Loop& loop)
{
    PassInput in{};
    const double identity[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.01, 0.01, 3};
    std::copy_n(identity, 12, in.pose);
    for (int k : {0, 3, 5}) {
        in.S_o[k] = 0.01;
        in.Gamma[k] = loop.bearing ? 1e-5 : 0;
    }
    in.tails.share = loop.tails ? 0.1 : 0;
    in.lever = 1;
    in.products = loop.products;
    return in;
}

double operationsPerPoint(const Correspondences& data, const Loop& loop)
{
    PassSums few, many;
    PointArrays arrays = data.arrays();
    const PassInput in = inputOf(loop);
    const auto count = [&](int size, PassSums& sums) {
        arrays.size = size;
        operations = 0;
        pass<Counting>(arrays, in, sums);
        return operations;
    };
    const int n = data.size();
    const int half = n / 2;
    return static_cast<double>(count(n, many) - count(half, few)) / (n - half);
}

// --- Time ---

// The least of several measurements: what disturbs can only add.
template <class Function>
double leastSeconds(int calls, Function call)
{
    constexpr int MEASUREMENTS = 15;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < MEASUREMENTS; ++k) {
        const double start = threadSeconds();
        for (int c = 0; c < calls; ++c)
            call();
        least = std::min(least, (threadSeconds() - start) / calls);
    }
    return least;
}

#if defined(__GNUC__) && defined(__x86_64__)
using Four = double __attribute__((vector_size(32)));

// Ten chains hide the latency of a fused multiplication and addition.
__attribute__((target("avx2,fma"))) void multiplyAdd(int rounds, double* out)
{
    Four chains[10], factor = {0.5, 0.5, 0.5, 0.5}, term = {1, 1, 1, 1};
    for (Four& chain : chains)
        chain = term;
    for (int r = 0; r < rounds; ++r)
        for (Four& chain : chains)
            chain = chain * factor + term;
    for (const Four& chain : chains)
        *out += chain[0] + chain[1] + chain[2] + chain[3];
}

double peak()
{
    constexpr int ROUNDS = 20000;
    double sink = 0;
    const double seconds = leastSeconds(10, [&] { multiplyAdd(ROUNDS, &sink); });
    if (!(sink > 0))
        std::printf("unexpected sum\n");
    return 10. * 4 * 2 * ROUNDS / seconds;
}
#else
double peak()
{
    return std::numeric_limits<double>::quiet_NaN();
}
#endif

void printTable(int n)
{
    const Correspondences data = someData(n);
    const double best = peak();
    std::printf("%d points; peak of one core, AVX2: %.1f Gflop/s.\n\n| loop | operations |", n, 1e-9 * best);
    for (const RayKernels* kernels : availableKernels())
        std::printf(" %s |", kernels->name);
    std::printf(" share of the peak |\n|---|--:|");
    for (size_t k = 0; k <= availableKernels().size(); ++k)
        std::printf("--:|");
    std::printf("\n");
    for (const Loop& loop : LOOPS) {
        const double count = operationsPerPoint(data, loop);
        const PassInput in = inputOf(loop);
        PassSums sums;
        double fastest = 0;
        std::printf("| %s | %.0f |", loop.name, count);
        for (const RayKernels* kernels : availableKernels()) {
            const double seconds =
                leastSeconds(std::max(1, 200000 / n), [&] { kernels->pass(data.arrays(), in, sums); }) / n;
            std::printf(" %.1f ns |", 1e9 * seconds);
            fastest = std::max(fastest, count / seconds);
        }
        std::printf(" %.0f %% |\n", 100 * fastest / best);
    }
}

}  // namespace
}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

int main()
try {
    cv::gmlpnp::detail::printTable(1000);
    files::flushStandardOutput();
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "roofline: %s\n", error.what());
    return 1;
}
