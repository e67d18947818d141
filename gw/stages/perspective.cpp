#include "gw/stages/perspective.h"

#include "gw/base/arithmetic.h"
#include "gw/base/powers.h"

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

constexpr double unit = 1073741824.0;  // 2^30

/// The integer part of a wide coordinate and its exponent are limited to these powers of two.
constexpr int widest_offset = 30, widest_exponent = 32;

float to_float(double v) { return static_cast<float>(v); }

/// A gradient or value as float32. Only slivers have gradients beyond 2^62; clamped, they do not
/// overflow.
double slope_factor(double v) { return to_float(bounded(v, 4611686018427387904.0)); }

}  // namespace

std::array<std::int64_t, 3> denominators(std::span<const double> w) {
    const double w_min = *std::min_element(w.begin(), w.end());
    std::array<std::int64_t, 3> q{};
    for (std::size_t i = 0; i < w.size(); ++i)
        q[i] = to_integer(round_even(unit * (w_min / w[i])), 1, unit);
    return q;
}

Numerators numerators(std::span<const double> s, std::span<const double> w, double k,
                      int largest_exponent, int least_exponent) {
    const double w_min = *std::min_element(w.begin(), w.end());
    Numerators n;
    n.offset = k;
    n.exponent =
        exponent_above(*std::max_element(s.begin(), s.end()) - k, least_exponent, largest_exponent);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double f = clamp01((s[i] - k) / power_of_two(n.exponent));
        n.at[i] = to_integer(round_even((unit * f) * (w_min / w[i])), 0, unit);
    }
    return n;
}

bool is_wide(double least, double greatest) {
    return greatest - std::floor(least) > power_of_two(largest_exponent_in_float);
}

Numerators texture_numerators(std::span<const double> s, std::span<const double> w, bool repeats) {
    const auto [least, greatest] = std::minmax_element(s.begin(), s.end());
    const double k = std::floor(*least);
    if (is_wide(*least, *greatest))
        return numerators(s, w, repeats ? k : bounded(k, power_of_two(widest_offset)),
                          widest_exponent, largest_exponent_in_float + 1);
    return numerators(s, w, repeats ? k : std::clamp(k, -1024.0, 1023.0),
                      largest_exponent_in_float);
}

Numerators fog_numerators(std::span<const double> f, std::span<const double> w) {
    constexpr int largest_exponent = 512;  // no range is greater
    return numerators(f, w, *std::min_element(f.begin(), f.end()), largest_exponent);
}

int wide_position(std::int64_t u, std::int64_t q, int exponent, std::int64_t k, int log2_size,
                  bool repeats) {
    constexpr std::int64_t limit = std::int64_t{1} << 30;
    const int shift = log2_size + 8;
    const auto p =
        static_cast<std::int64_t>(std::floor(std::ldexp(double(u) / double(q), exponent + shift)));
    if (repeats) return static_cast<int>(p & ((std::int64_t{1} << shift) - 1));
    return static_cast<int>(std::clamp(p + k * (std::int64_t{1} << shift), -limit, limit));
}

std::int64_t added_part(double k, Wrap wrap) {
    if (wrap == Wrap::Repeat) return 0;
    if (wrap == Wrap::MirroredRepeat) return std::fmod(k, 2.0) != 0 ? 1 : 0;
    return static_cast<std::int64_t>(k);
}

int any_position(double quotient, int exponent, std::int64_t k, int size, Wrap wrap) {
    constexpr std::int64_t limit = std::int64_t{1} << 30;
    constexpr double largest = 4611686018427387904.0;  // 2^62
    const std::int64_t texels = 256 * std::int64_t{size};
    const auto n = static_cast<std::int64_t>(
        bounded(std::floor(quotient * times_power_of_two(double(texels), exponent)), largest));
    const auto modulo = [](std::int64_t v, std::int64_t m) { return int((v % m + m) % m); };
    if (wrap == Wrap::Repeat) return modulo(n, texels);
    if (wrap == Wrap::MirroredRepeat) return modulo(n + k * texels, 2 * texels);
    return static_cast<int>(std::clamp(n + k * texels, -limit, limit));
}

Projective projective(std::span<const dvec4> strq, std::span<const double> w) {
    double h = 0;
    for (std::size_t i = 0; i < w.size(); ++i) h = std::max(h, std::abs(strq[i].w / w[i]));
    Projective p;
    if (!(h > 0) || !std::isfinite(h)) return p;  // denominators 0: outside everywhere
    for (std::size_t i = 0; i < w.size(); ++i)
        p.denominator[i] = to_integer(round_even(unit * ((strq[i].w / w[i]) / h)), -unit, unit);
    for (int c = 0; c < 3; ++c) {
        Numerators& n = p.numerator[std::size_t(c)];
        double largest = 0;
        for (std::size_t i = 0; i < w.size(); ++i)
            largest = std::max(largest, std::abs(strq[i][c] / w[i]) / h);
        n.exponent = exponent_above(largest, -60, 60);
        for (std::size_t i = 0; i < w.size(); ++i)
            n.at[i] = to_integer(
                round_even(unit * (((strq[i][c] / w[i]) / h) / power_of_two(n.exponent))), -unit,
                unit);
    }
    return p;
}

CoordinateSlope coordinate_slope(const PlaneSlope& u, const PlaneSlope& q) {
    // Products of float32 factors are exact in double, so each component rounds once.
    const double ux = slope_factor(u.gx), uy = slope_factor(u.gy), u0 = slope_factor(u.value);
    const double qx = slope_factor(q.gx), qy = slope_factor(q.gy), q0 = slope_factor(q.value);
    return {ux * q0 - u0 * qx, uy * q0 - u0 * qy, to_float((ux * qy - uy * qx) / 65536)};
}

double CoordinateSlope::along_row(int dy) const { return std::abs(a + double(k) * dy); }
double CoordinateSlope::along_column(int dx) const { return std::abs(b - double(k) * dx); }

void JoinedSlopes::add(const CoordinateSlope& slope, int dx, int dy, double scale) {
    const double r = slope.along_row(dy) * scale, c = slope.along_column(dx) * scale;
    row = exact ? row + r * r : std::max(row, r);
    column = exact ? column + c * c : std::max(column, c);
}

double JoinedSlopes::value() const {
    const double most = std::max(row, column);
    return exact ? std::sqrt(most) : most;
}

}  // namespace gw
