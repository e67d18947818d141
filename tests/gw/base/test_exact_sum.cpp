// Sums and products without rounding, compared with integers of 128 bits.
#include "gw/base/arithmetic.h"
#include "gw/base/exact_sum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace gw {
namespace {

using Wide = int128;

class Numbers {
public:
    /// An integer of at most 53 bits, of both signs.
    std::int64_t integer() {
        return std::int64_t(bits_() >> 11 >> bits_() % 53) * (bits_() % 2 == 0 ? 1 : -1);
    }
    int up_to(int most) { return int(bits_() % std::uint64_t(most + 1)); }

private:
    std::mt19937_64 bits_{1};
};

TEST(ExactSum, OfTwoHasAllBits) {
    Numbers numbers;
    for (int i = 0; i < 100'000; ++i) {
        const double a = double(numbers.integer()), b = std::ldexp(double(numbers.integer()), 60);
        const Sum sum = two_sum(a, b);
        EXPECT_EQ(Wide(sum.hi) + Wide(sum.lo), Wide(a) + Wide(b));
        EXPECT_EQ(sum.hi, a + b);
    }
}

TEST(ExactSum, ProductOfTwoHasAllBits) {
    Numbers numbers;
    for (int i = 0; i < 100'000; ++i) {
        const std::int64_t a = numbers.integer(), b = numbers.integer();
        const Sum product = two_product(double(a), double(b));
        EXPECT_EQ(Wide(product.hi) + Wide(product.lo), Wide(a) * b);
        EXPECT_EQ(product.hi, double(a) * double(b));
    }
}

/// Then the sum's opposite, up to four times, so that little remains or nothing.
TEST(ExactSum, OfManyHasTheRightSignAndSize) {
    Numbers numbers;
    for (int i = 0; i < 20'000; ++i) {
        ExactSum<24> sum;
        Wide expected = 0;
        const auto add = [&](double x) {
            sum.add(x);
            expected += Wide(x);
        };
        for (int k = 0; k < 12; ++k) add(std::ldexp(double(numbers.integer()), numbers.up_to(60)));
        for (auto k = numbers.up_to(4); k > 0; --k) add(-double(expected));
        const double value = sum.value();
        EXPECT_EQ(value > 0, expected > 0);
        EXPECT_EQ(value < 0, expected < 0);
        EXPECT_LE(std::abs(value - double(expected)), std::abs(double(expected)) * 0x1p-51);
    }
}

}  // namespace
}  // namespace gw
