// Packing and spreading a block's lanes on every vector target of the processor, for every mask.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/gw/fast/test_pack_lanes.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/simd/pack_lanes-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The lanes of `mask` side by side.
void pack(const float* from, std::uint32_t mask, float* to) {
    pack_parts(mask, [&](std::size_t first, const std::uint8_t* order, std::size_t at) {
        store_packed(from + first, order, to + at);
    });
}
void spread(const std::uint16_t* from, std::uint32_t mask, std::uint16_t* to) {
    spread_lanes(from, mask, to);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "gw/fast/simd/simd_target.h"

#include <gtest/gtest.h>

namespace gw::fast {

HWY_EXPORT(pack);
HWY_EXPORT(spread);

namespace {

void expect_packed(std::uint32_t mask, const std::string& target) {
    alignas(64) float from[block_pixels], to[2 * block_pixels] = {};
    for (std::size_t i = 0; i < block_pixels; ++i) from[i] = float(i) + 0.5f;
    HWY_DYNAMIC_DISPATCH(pack)(from, mask, to);
    std::size_t n = 0;
    for (std::size_t i = 0; i < block_pixels; ++i)
        if (mask >> i & 1) {
            ASSERT_EQ(to[n++], from[i]) << "mask " << mask << " on " << target;
        }
}

void expect_spread(std::uint32_t mask, const std::string& target) {
    alignas(64) std::uint16_t from[2 * block_pixels], to[block_pixels] = {};
    for (std::size_t i = 0; i < 2 * block_pixels; ++i) from[i] = std::uint16_t(0xFF00 + 3 * i);
    HWY_DYNAMIC_DISPATCH(spread)(from, mask, to);
    std::size_t n = 0;
    for (std::size_t i = 0; i < block_pixels; ++i)
        if (mask >> i & 1) {
            ASSERT_EQ(to[i], from[n++]) << "mask " << mask << " on " << target;
        }
}

TEST(PackLanes, EveryMask) {
    for (const std::string& target : simd_targets()) {
        ASSERT_TRUE(use_simd_target(target));
        for (std::uint32_t mask = 0; mask < 1u << block_pixels; ++mask) {
            expect_packed(mask, target);
            expect_spread(mask, target);
            if (HasFatalFailure()) return;
        }
    }
    use_simd_target("");
}

}  // namespace
}  // namespace gw::fast

#endif  // HWY_ONCE
