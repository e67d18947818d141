// Vectors of powers on every vector target of the processor: bit for bit those of gw::pow.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/gw/fast/test_power_lanes.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/vertices/power-inl.h"

#include <hwy/highway.h>

#include <array>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

using Eight = std::array<double, 8>;

/// base^exponent by vectors. Returns false where this target has no vectors of doubles.
bool powers(const Eight& base, double exponent, Eight& out) {
#if HWY_HAVE_FLOAT64
    const D64 d;
    const auto wanted = hn::FirstN(d, hn::Lanes(d));
    for (std::size_t i = 0; i < base.size(); i += hn::Lanes(d))
        hn::StoreU(power(hn::LoadU(d, base.data() + i), exponent, wanted), d, out.data() + i);
    return true;
#else
    out = base;
    return exponent != exponent;
#endif
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "gw/fast/simd/simd_target.h"
#include "tests/gw/random.h"

#include <gtest/gtest.h>

#include <bit>

namespace gw::fast {

HWY_EXPORT(powers);

namespace {

using Eight = std::array<double, 8>;

/// The first base whose power differs.
void expect_same_bits(const Eight& base, double exponent, const std::string& target) {
    Eight out{};
    if (!HWY_DYNAMIC_DISPATCH(powers)(base, exponent, out)) return;
    for (std::size_t i = 0; i < base.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint64_t>(out[i]),
                  std::bit_cast<std::uint64_t>(gw::pow(base[i], exponent)))
            << base[i] << " ^ " << exponent << " on " << target;
}

constexpr double exponents[] = {0,   0x1p-149, 0.5,   1,   2,    10,      27.3, 60,
                                128, 1000,     10000, 1e6, 1e-3, 0x1p101, -2};
constexpr Eight edges = {0,   1,          0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp-1,
                         0.5, 45.25 / 64, 0x1.6ap-1};

TEST(PowerLanes, HaveTheBitsOfPow) {
    for (const std::string& target : simd_targets()) {
        ASSERT_TRUE(use_simd_target(target));
        test::Random random(7);
        for (const double exponent : exponents) {
            expect_same_bits(edges, exponent, target);
            for (int i = 0; i < 4000; ++i) {
                Eight base;
                for (double& b : base) b = double(random.next() >> 11) * 0x1p-53;
                if (i % 4 == 0)  // close to 1, where highlights are
                    for (double& b : base) b = 1 - b / 1000;
                expect_same_bits(base, exponent, target);
            }
        }
    }
    use_simd_target("");
}

}  // namespace
}  // namespace gw::fast

#endif  // HWY_ONCE
