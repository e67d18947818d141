// Each function reduces its argument to a node of a table and a small rest, then takes a few terms
// of the rest's Taylor series. A value whose rounding would show is carried as a Sum of two
// doubles. Not written for speed: set-up, vertices and tables use it.
#include "gw/base/elementary.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "gw/base/elementary_tables.h"
#include "gw/base/powers.h"

namespace gw {
namespace {

using namespace elementary;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double rounded(Sum x) noexcept { return x.hi + x.lo; }

// a / b to about 2^-100 of itself, for sums whose lo is below the last place of hi; b.hi not 0.
Sum divide(Sum a, Sum b) noexcept {
    const double quotient = a.hi / b.hi;
    const Sum back = two_product(quotient, b.hi);
    return {quotient, ((a.hi - back.hi) - back.lo + a.lo - quotient * b.lo) / b.hi};
}

// Nearest integer, ties to even; |x| < 2^51.
double nearest(double x) noexcept { return (x + 0x1.8p52) - 0x1.8p52; }

// c[0] + c[1] z + c[2] z^2 + ..., evaluated from the last term.
template <std::size_t n>
double polynomial(double z, const double (&c)[n]) noexcept {
    double sum = c[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) sum = c[i] + z * sum;
    return sum;
}

// x * 2^e with one rounding, for x in (0.5, 2.5) and -1080 <= e <= 1024.
double scale(double x, int e) noexcept {
    if (e < -1022) return x * power_of_two(e + 1022) * power_of_two(-1022);
    if (e > 1023) return x * 2 * power_of_two(e - 1);
    return x * power_of_two(e);
}

// e^(x.hi + x.lo) for any x.hi, |x.lo| < 2^-40: with 64 x / ln 2 = 64 e + i + rest, 2^e *
// exp2_node[i] * e^rest.
double exp_of_sum(Sum x) noexcept {
    if (x.hi > 710) return infinity;
    if (x.hi < -746) return 0;
    const double k = nearest(x.hi * 0x1.71547652b82fep6);                  // 64 / ln 2
    const double r = (x.hi - k * ln2_64th.hi) + (x.lo - k * ln2_64th.lo);  // |r| < 0.0055
    constexpr double terms[] = {1 / 2.0, 1 / 6.0, 1 / 24.0, 1 / 120.0, 1 / 720.0};
    const double p = r + r * r * polynomial(r, terms);  // e^r - 1

    const int index = static_cast<int>(k) & 63;
    const Sum node = exp2_node[index];
    return scale(node.hi + (node.lo + node.hi * p), (static_cast<int>(k) - index) / 64);
}

// x = m * 2^k with m in [45.25/64, 90.5/64), a range around 1. So x just below 1 has k = 0, and log
// x keeps its precision.
struct Scaled {
    double m;
    int k;
};

Scaled mantissa_around_one(double x) noexcept {
    if (x < 0x1p-1022) {
        const Scaled normal = mantissa_around_one(x * 0x1p54);
        return {normal.m, normal.k - 54};
    }
    const auto bits = std::bit_cast<std::int64_t>(x);
    const std::int64_t k = (bits - std::bit_cast<std::int64_t>(45.25 / 64)) >> 52;
    return {std::bit_cast<double>(bits - (k << 52)), static_cast<int>(k)};
}

// log x for finite x > 0, to about 2^-66 of itself. With node c = i/64 near m: k ln 2 + log c + 2
// atanh s, s = (m-c)/(m+c).
Sum log_as_sum(double x) noexcept {
    const auto [m, k] = mantissa_around_one(x);
    const int i = static_cast<int>(nearest(m * 64));
    const double c = i / 64.0;
    const Sum s = divide({m - c, 0}, two_sum(m, c));

    // 2 atanh s = 2 s + 2 s^3 / 3 + ...; |s| < 0.0056.
    constexpr double terms[] = {2 / 3.0, 2 / 5.0, 2 / 7.0, 2 / 9.0, 2 / 11.0};
    const double tail = s.hi * (s.hi * s.hi) * polynomial(s.hi * s.hi, terms);
    const Sum node = log_node[i - first_log_node];
    const Sum sum = two_sum(k * ln2.hi + node.hi, 2 * s.hi);
    const double rest = sum.lo + (tail + (2 * s.lo + (k * ln2.lo + node.lo)));
    return two_sum(sum.hi, rest);
}

// An angle as quadrant * pi/2 + rest; |rest| exceeds pi/4 by rounding errors at most.
struct Reduced {
    int quadrant;  // 0 .. 3
    Sum rest;
};

// False for NaN too.
bool in_range(double angle) noexcept { return std::fabs(angle) <= 0x1p20; }

Reduced reduce_radians(double x) noexcept {
    const double k = nearest(x * 0x1.45f306dc9c883p-1);  // 2 / pi
    Sum rest = {x, 0};
    for (const double part : half_pi_parts) {
        const Sum next = two_sum(rest.hi, -k * part);
        rest = two_sum(next.hi, next.lo + rest.lo);
    }
    return {static_cast<int>(k) & 3, rest};
}

Reduced reduce_degrees(double x) noexcept {
    const double k = nearest(x / 90);
    const double r = x - 90 * k;  // exact
    const Sum rest = two_product(r, degree.hi);
    return {static_cast<int>(k) & 3, {rest.hi, rest.lo + r * degree.lo}};
}

// sin and cos on [-pi/4, pi/4]: Taylor series to x^17 and x^18, terms below x^4 as a Sum.
Sum sin_of_rest(Sum x) noexcept {
    constexpr double terms[] = {
        1 / 120.0,        -1 / 5040.0,          1 / 362880.0,         -1 / 39916800.0,
        1 / 6227020800.0, -1 / 1307674368000.0, 1 / 355687428096000.0};
    const Sum z = two_product(x.hi, x.hi);
    const Sum cube = two_product(x.hi, z.hi);
    const Sum sixth = divide({cube.hi, cube.lo + x.hi * z.lo}, {6, 0});
    const Sum head = two_sum(x.hi, -sixth.hi);
    const double tail = x.hi * z.hi * z.hi * polynomial(z.hi, terms) + x.lo * (1 - 0.5 * z.hi);
    return two_sum(head.hi, head.lo + (tail - sixth.lo));
}

Sum cos_of_rest(Sum x) noexcept {
    constexpr double terms[] = {
        1 / 24.0,        -1 / 720.0,         1 / 40320.0,          -1 / 3628800.0,
        1 / 479001600.0, -1 / 87178291200.0, 1 / 20922789888000.0, -1 / 6402373705728000.0};
    const Sum z = two_product(x.hi, x.hi);
    const Sum head = two_sum(1, -0.5 * z.hi);
    const double tail = z.hi * z.hi * polynomial(z.hi, terms) - x.hi * x.lo;
    return two_sum(head.hi, head.lo + (tail - 0.5 * z.lo));
}

// Signs are turned by subtraction from 0, so no function returns -0 if it could return 0.
Sum sin_as_sum(Reduced x) noexcept {
    const Sum value = x.quadrant % 2 == 0 ? sin_of_rest(x.rest) : cos_of_rest(x.rest);
    return x.quadrant < 2 ? value : Sum{0 - value.hi, 0 - value.lo};
}

Sum cos_as_sum(Reduced x) noexcept { return sin_as_sum({(x.quadrant + 1) % 4, x.rest}); }

double sin_of(Reduced x) noexcept { return rounded(sin_as_sum(x)); }

double cos_of(Reduced x) noexcept { return rounded(cos_as_sum(x)); }

// +infinity at a pole, which only an angle in degrees can hit.
double tan_of(Reduced x) noexcept {
    const Sum cosine = cos_as_sum(x);
    return cosine.hi == 0 ? infinity : rounded(divide(sin_as_sum(x), cosine));
}

// f(x) for an odd f, from its values at |x|.
double odd(double x, double value_at_magnitude) noexcept {
    return x < 0 ? 0 - value_at_magnitude : value_at_magnitude;
}

// atan q for q in [0, 1], node c = i/32: atan c + atan t, t = (q - c) / (1 + q c), |t| <= 1/64;
// Taylor series to t^11.
Sum atan_as_sum(double q) noexcept {
    const int i = static_cast<int>(nearest(q * 32));
    const double c = i / 32.0;
    const Sum product = two_product(q, c);
    const Sum denominator = two_sum(1, product.hi);
    const Sum t = divide({q - c, 0}, {denominator.hi, denominator.lo + product.lo});
    constexpr double terms[] = {-1 / 3.0, 1 / 5.0, -1 / 7.0, 1 / 9.0, -1 / 11.0};
    const double tail = t.hi * (t.hi * t.hi) * polynomial(t.hi * t.hi, terms);
    const Sum sum = two_sum(atan_node[i].hi, t.hi);
    return {sum.hi, sum.lo + (tail + (t.lo + atan_node[i].lo))};
}

// quarters * pi/2 - angle
Sum complement(int quarters, Sum angle) noexcept {
    const Sum sum = two_sum(quarters * half_pi.hi, -angle.hi);
    return {sum.hi, sum.lo + (quarters * half_pi.lo - angle.lo)};
}

}  // namespace

double exp(double x) noexcept { return x == x ? exp_of_sum({x, 0}) : nan; }

double log(double x) noexcept {
    if (x == 0) return -infinity;
    if (!(x > 0)) return nan;
    if (x == infinity) return infinity;
    return rounded(log_as_sum(x));
}

double pow(double x, double y) noexcept {
    if (y == 0 || x == 1) return 1;
    if (!(x >= 0) || y != y) return nan;
    if (x == 0) return y > 0 ? 0 : infinity;
    if (x == infinity) return y > 0 ? infinity : 0;
    const Sum log_x = log_as_sum(x);
    const double estimate = y * log_x.hi;
    if (estimate > 710) return infinity;
    if (estimate < -746) return 0;
    const Sum product = two_product(y, log_x.hi);
    return exp_of_sum({product.hi, product.lo + y * log_x.lo});
}

double sin(double x) noexcept {
    return in_range(x) ? odd(x, sin_of(reduce_radians(std::fabs(x)))) : nan;
}
double cos(double x) noexcept { return in_range(x) ? cos_of(reduce_radians(std::fabs(x))) : nan; }
double tan(double x) noexcept {
    return in_range(x) ? odd(x, tan_of(reduce_radians(std::fabs(x)))) : nan;
}

double sin_degrees(double x) noexcept {
    return in_range(x) ? odd(x, sin_of(reduce_degrees(std::fabs(x)))) : nan;
}
double cos_degrees(double x) noexcept {
    return in_range(x) ? cos_of(reduce_degrees(std::fabs(x))) : nan;
}
double tan_degrees(double x) noexcept {
    return in_range(x) ? odd(x, tan_of(reduce_degrees(std::fabs(x)))) : nan;
}

double atan2(double y, double x) noexcept {
    const double a = std::fabs(x), b = std::fabs(y);
    const bool steep = b > a;
    const double smaller = steep ? a : b, larger = steep ? b : a;

    // Unfold the octant.
    Sum angle = atan_as_sum(larger == 0 ? 0 : smaller / larger);
    if (steep) angle = complement(1, angle);
    if (std::signbit(x)) angle = complement(2, angle);
    return std::copysign(rounded(angle), y);
}

double acos(double x) noexcept {
    if (!(std::fabs(x) <= 1)) return nan;
    return atan2(std::sqrt((1 - x) * (1 + x)), x);
}

double asin(double x) noexcept {
    if (!(std::fabs(x) <= 1)) return nan;
    return atan2(x, std::sqrt((1 - x) * (1 + x)));
}

}  // namespace gw
