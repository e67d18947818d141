// Shared by the tests of the elementary functions: errors in ulp against long double (64 bits of
// mantissa on x86, 113 elsewhere), walks over float32 values in the order of their bits, and the
// claims of gw/base/elementary.h by the stride of the walk. The quick test takes every 9973rd
// float, the long one every float.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gw/base/elementary.h"

namespace gw::oracle {

static_assert(std::numeric_limits<long double>::digits >= 64,
              "an oracle must be more precise than what it judges");

inline constexpr long double pi_long = 3.14159265358979323846264338327950288L;

// |got - exact| in units in the last place of a double of exact's binade. 0.5 for the correctly
// rounded value, 0 where exact is a double, infinite where only one of them is finite.
inline double ulp_error(double got, long double exact) {
    if (got == exact) return 0;
    if (got == static_cast<double>(exact)) return 0.5;
    if (!std::isfinite(got) || !std::isfinite(static_cast<double>(exact)))
        return std::numeric_limits<double>::infinity();
    const int exponent = exact == 0 ? -1074 : std::max(std::ilogb(exact) - 52, -1074);
    return static_cast<double>(
        std::fabs(std::ldexp(static_cast<long double>(got) - exact, -exponent)));
}

// The worst error seen and where.
struct Worst {
    double error = 0;
    double argument = 0;

    void see(double x, double got, long double exact) {
        const double e = ulp_error(got, exact);
        if (e > error) *this = {e, x};
    }
};

// The figure reached goes into the test's record (--gtest_output).
inline void expect_below(Worst worst, double bound, const char* key = "worst_ulp") {
    EXPECT_LT(worst.error, bound) << "ulp, at the argument " << std::hexfloat << worst.argument;
    testing::Test::RecordProperty(key, std::to_string(worst.error));
}

// Over every stride-th float32 of [from, to], 0 <= from.
template <class Own, class Exact>
Worst worst_over_floats(float from, float to, std::uint32_t stride, Own own, Exact exact) {
    Worst worst;
    const auto last = std::bit_cast<std::uint32_t>(to);
    for (auto bits = std::bit_cast<std::uint32_t>(from); bits <= last; bits += stride) {
        const double x = std::bit_cast<float>(bits);
        worst.see(x, own(x), exact(static_cast<long double>(x)));
    }
    return worst;
}

// Deterministic doubles: SplitMix64 [Steele, Lea, Flood 2014], uniform in [from, to).
class Doubles {
public:
    explicit Doubles(std::uint64_t seed) : state_(seed) {}

    double operator()(double from, double to) {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return from + (to - from) * (static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53);
    }

private:
    std::uint64_t state_;
};

// Over 200,000 doubles of [from, to).
template <class Own, class Exact>
Worst worst_over_doubles(double from, double to, Own own, Exact exact) {
    Worst worst;
    Doubles next(1);
    for (int i = 0; i < 200'000; ++i) {
        const double x = next(from, to);
        worst.see(x, own(x), exact(static_cast<long double>(x)));
    }
    return worst;
}

// The claims. Close to 0 the oracles take the first terms of the series, which are as exact and
// much faster.
inline Worst exp_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 104, stride, [](double x) { return exp(-x); },
        [](long double x) { return x < 0x1p-40L ? 1 - x : std::exp(-x); });
}

inline Worst log_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        std::numeric_limits<float>::denorm_min(), 1, stride, [](double x) { return log(x); },
        [](long double x) { return std::log(x); });
}

inline Worst sin_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 6.2831855F, stride, [](double x) { return sin(x); },
        [](long double x) { return x < 0x1p-20L ? x - x * x * x / 6 : std::sin(x); });
}

inline Worst cos_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 6.2831855F, stride, [](double x) { return cos(x); },
        [](long double x) { return x < 0x1p-20L ? 1 - x * x / 2 : std::cos(x); });
}

inline Worst tan_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 6.2831855F, stride, [](double x) { return tan(x); },
        [](long double x) { return x < 0x1p-20L ? x + x * x * x / 3 : std::tan(x); });
}

inline Worst acos_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 1, stride, [](double x) { return acos(x); },
        [](long double x) { return x < 0x1p-20L ? pi_long / 2 - x : std::acos(x); });
}

inline Worst asin_over_floats(std::uint32_t stride) {
    return worst_over_floats(
        0, 1, stride, [](double x) { return asin(x); },
        [](long double x) { return x < 0x1p-20L ? x + x * x * x / 6 : std::asin(x); });
}

// x^y for x in [from, to]. Where x^y is below 2^-1080 both sides are 0.
inline Worst pow_over_floats(double y, float from, float to, std::uint32_t stride) {
    const auto smallest = static_cast<long double>(std::exp2(-1080 / y));
    return worst_over_floats(
        from, to, stride, [y](double x) { return pow(x, y); },
        [y, smallest](long double x) -> long double {
            if (x < smallest) return 0;
            if (y == 0.5) return std::sqrt(x);
            if (y == 1) return x;
            if (y == 10) {
                const long double x4 = (x * x) * (x * x);
                return x4 * x4 * (x * x);
            }
            return std::pow(x, static_cast<long double>(y));
        });
}

// Bounds of gw/base/elementary.h, in ulp.
inline constexpr double exp_bound = 0.52, log_bound = 0.51, pow_bound = 0.52,
                        pow_denormal_bound = 0.76;
inline constexpr double sin_bound = 0.60, cos_bound = 0.60, tan_bound = 0.60;
inline constexpr double acos_bound = 2.2, asin_bound = 2.2, atan2_bound = 1.5;

// x^y over [0, 1]: denormal results are rounded twice.
inline void expect_pow_accurate(double y, std::uint32_t stride) {
    SCOPED_TRACE(y);
    const auto first_normal = static_cast<float>(std::exp2(-1021.9 / y));
    expect_below(pow_over_floats(y, 0, first_normal, stride), pow_denormal_bound,
                 "worst_ulp_denormal");
    expect_below(pow_over_floats(y, first_normal, 1, stride), pow_bound);
}

}  // namespace gw::oracle
