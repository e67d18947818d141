// docs/manual/numbers.md: the worked examples.
#include "gw/base/arithmetic.h"
#include "gw/base/to_bytes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace gw {
namespace {

// [R2.8] [R2.10]
TEST(ManualNumbers, QuantizeMulAndRescale) {
    EXPECT_EQ(quantize(0.5, 8), 128u);
    EXPECT_EQ(quantize(0.25, 8), 64u);
    EXPECT_EQ(quantize(-3, 8), 0u);
    EXPECT_EQ(quantize(std::numeric_limits<double>::quiet_NaN(), 8), 0u);
    EXPECT_EQ(quantize(std::numeric_limits<double>::infinity(), 32), 4294967295u);
    EXPECT_EQ(mul(127, 3, 8), 1u);
    EXPECT_EQ(mul(128, 3, 8), 2u);
    EXPECT_EQ(mul(255, 77, 8), 77u);
    EXPECT_EQ(rescale(200, 8, 12), 3212u);
    EXPECT_EQ(rescale(3212, 12, 8), 200u);
    EXPECT_EQ(rescale(25700, 16, 8), 100u);
}

// [R2.10]
TEST(ManualNumbers, MulIsTheNearestForAllOperandsOf8And12Bits) {
    for (const int bits : {8, 12}) {
        const std::uint32_t one = (1u << bits) - 1;
        for (std::uint32_t a = 0; a <= one; ++a)
            for (std::uint32_t b = 0; b <= one; b += bits == 8 ? 1 : 7)
                ASSERT_EQ(mul(a, b, bits), (2 * a * b + one) / (2 * one)) << a << " " << b;
    }
}

TEST(ManualNumbers, RescalingUpAndDownKeepsAValue) {
    for (int n = 4; n <= 12; ++n)
        for (int m = n; m <= 16; ++m)
            for (std::uint32_t v = 0; v < 1u << n; ++v) {
                ASSERT_EQ(rescale(rescale(v, n, m), m, n), v);
                const std::uint64_t from = (1u << n) - 1, to = (1u << m) - 1;
                ASSERT_EQ(rescale(v, n, m), (2 * v * to + from) / (2 * from));
            }
}

TEST(ManualNumbers, RescaleToBytesOfAllValues) {
    std::vector<std::uint16_t> values(65536);
    std::iota(values.begin(), values.end(), std::uint16_t{0});
    std::vector<std::uint8_t> bytes(values.size());
    rescale_to_bytes(values, bytes.data());
    for (std::uint32_t v = 0; v < 65536; ++v)
        ASSERT_EQ(bytes[v], (2 * v * 255 + 65535) / (2 * 65535)) << v;
}

// [R2.6]
TEST(ManualNumbers, FloatsAreClampedBeforeTheyBecomeIntegers) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(to_integer(infinity, -5, 7), 7);
    EXPECT_EQ(to_integer(-infinity, -5, 7), -5);
    EXPECT_EQ(to_integer(-infinity + infinity, -5, 7), -5);
    EXPECT_EQ(to_integer(-1.75, -5, 7), -1);
    EXPECT_EQ(bounded(1e300, 4), 4);
    EXPECT_EQ(bounded(-infinity + infinity, 4), -4);
}

}  // namespace
}  // namespace gw
