// Sums and products of doubles without rounding [Shewchuk 1997, Adaptive Precision Floating-Point
// Arithmetic]. Exact while nothing overflows or underflows. Does not divide.
#pragma once

#include <array>
#include <cstddef>

namespace gw {

/// A number as the unevaluated sum of two doubles, |lo| at most half a unit in the last place of hi
/// unless stated.
struct Sum {
    double hi, lo;
};

/// Exact: hi + lo = a + b. [Knuth, TAOCP 2, 4.2.2, theorem B]
inline Sum two_sum(double a, double b) noexcept {
    const double hi = a + b;
    const double b_part = hi - a;
    return {hi, (a - (hi - b_part)) + (b - b_part)};
}

/// Exact: hi + lo = a * b while nothing underflows and |a|, |b| < 2^990. [Dekker 1971: each factor
/// split into halves of 26 bits]
inline Sum two_product(double a, double b) noexcept {
    const double a_up = a * 134217729.0, b_up = b * 134217729.0;  // 2^27 + 1
    const double a_hi = a_up - (a_up - a), b_hi = b_up - (b_up - b);
    const double a_lo = a - a_hi, b_lo = b - b_hi;
    const double hi = a * b;
    return {hi, ((a_hi * b_hi - hi) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

/// A sum of at most `most` doubles: an expansion, whose parts do not overlap.
template <std::size_t most>
class ExactSum {
public:
    /// Shewchuk's Grow-Expansion, without parts that are 0.
    void add(double b) noexcept {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const Sum sum = two_sum(part_[i], b);
            if (sum.lo != 0) part_[kept++] = sum.lo;
            b = sum.hi;
        }
        if (b != 0) part_[kept++] = b;
        size_ = kept;
    }

    /// Within a few units in the last place. Its sign is exact, and it is 0 only if the sum is.
    double value() const noexcept {
        double sum = 0;
        for (std::size_t i = 0; i < size_; ++i) sum += part_[i];
        return sum;
    }

private:
    std::array<double, most> part_;  ///< the first size_ of them, smallest first
    std::size_t size_ = 0;
};

}  // namespace gw
