// gw/base/elementary_tables.h computed again from its series, in integers.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "gw/base/elementary_tables.h"

namespace gw::elementary {
namespace {

// value * 2^120
using Fixed = __int128;
constexpr int fraction_bits = 120;
constexpr Fixed one = Fixed{1} << fraction_bits;

Fixed fixed(double x) { return static_cast<Fixed>(std::ldexp(x, fraction_bits)); }

// 0 <= a, b < 4; off by less than 4 units.
Fixed multiply(Fixed a, Fixed b) {
    constexpr Fixed low = (Fixed{1} << 60) - 1;
    const Fixed a1 = a >> 60, a0 = a & low, b1 = b >> 60, b0 = b & low;
    return a1 * b1 + ((a1 * b0) >> 60) + ((a0 * b1) >> 60);
}

// sum over k of sign^k * (p/q)^(2k+1) / (2k+1), for p * p < 2^12: atanh (sign 1) or atan (sign -1)
// of p/q.
Fixed odd_series(int p, int q, int sign) {
    Fixed sum = 0;
    Fixed term = one / q * p;
    for (int k = 0; term != 0; ++k) {
        sum += (k % 2 == 0 ? 1 : sign) * term / (2 * k + 1);
        term = term / q * p / q * p;
    }
    return sum;
}

Fixed atanh_of(int p, int q) { return odd_series(p, q, 1); }
Fixed atan_of(int p, int q) { return odd_series(p, q, -1); }

const Fixed ln2_fixed = 2 * atanh_of(1, 3);
const Fixed pi_fixed = 16 * atan_of(1, 5) - 4 * atan_of(1, 239);  // Machin

Fixed exp_of(Fixed x) {
    Fixed sum = 0;
    Fixed term = one;
    for (int k = 1; term != 0; ++k) {
        sum += term;
        term = multiply(term, x) / k;
    }
    return sum;
}

// hi + lo is within half a unit of lo's last place, and 2^-105 for the series' own error.
void expect_value(Sum sum, Fixed exact, const char* what) {
    const Fixed off = fixed(sum.hi) + fixed(sum.lo) - exact;
    const Fixed unit = sum.lo == 0 ? 0 : fixed(std::ldexp(1.0, std::ilogb(sum.lo) - 53));
    EXPECT_LE(off < 0 ? -off : off, unit + (Fixed{1} << (fraction_bits - 105)))
        << what << " " << sum.hi;
}

void expect_grid(Sum sum) {
    EXPECT_EQ(std::ldexp(sum.hi, 42), std::floor(std::ldexp(sum.hi, 42)));
    EXPECT_LE(std::fabs(sum.lo), 0x1p-43);
}

}  // namespace

TEST(ElementaryTables, Logarithms) {
    expect_value(ln2, ln2_fixed, "ln 2");
    expect_value(ln2_64th, ln2_fixed / 64, "ln 2 / 64");
    expect_grid(ln2);
    expect_grid(ln2_64th);
    // log(i/64) = 2 atanh((i - 64) / (i + 64))
    for (int i = first_log_node; i <= 90; ++i) {
        const Fixed exact = i < 64 ? -2 * atanh_of(64 - i, i + 64) : 2 * atanh_of(i - 64, i + 64);
        expect_value(log_node[i - first_log_node], exact, "log");
        expect_grid(log_node[i - first_log_node]);
    }
}

TEST(ElementaryTables, PowersOfTwo) {
    for (int i = 0; i < 64; ++i) {
        expect_value(exp2_node[i], exp_of(ln2_fixed / 64 * i), "2^(i/64)");
        EXPECT_EQ(exp2_node[i].hi + exp2_node[i].lo, exp2_node[i].hi);
    }
}

TEST(ElementaryTables, ArcTangents) {
    // atan(i/32) - atan((i-1)/32) = atan(32 / (1024 + i (i-1)))
    Fixed exact = 0;
    for (int i = 1; i <= 32; ++i) {
        exact += atan_of(32, 1024 + i * (i - 1));
        expect_value(atan_node[i], exact, "atan");
        EXPECT_EQ(atan_node[i].hi + atan_node[i].lo, atan_node[i].hi);
    }
    EXPECT_EQ(atan_node[0].hi, 0);
    EXPECT_EQ(atan_node[0].lo, 0);
}

TEST(ElementaryTables, Pi) {
    expect_value(half_pi, pi_fixed / 2, "pi/2");
    expect_value(degree, pi_fixed / 180, "pi/180");
    Fixed sum = 0;
    for (const double part : half_pi_parts) sum += fixed(part);
    EXPECT_LE(std::abs(static_cast<std::int64_t>(sum - pi_fixed / 2)), 1 << 9);
    // 20 bits of k and 33 of a part fill a double.
    for (int i = 0; i < 3; ++i) {
        const double scaled = std::ldexp(half_pi_parts[i], 32 - std::ilogb(half_pi_parts[i]));
        EXPECT_EQ(scaled, std::floor(scaled));
    }
}

}  // namespace gw::elementary
