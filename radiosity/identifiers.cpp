// Identifiers from the colours of an ID buffer, a vector at a time; scalar twin: scene::id_of.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/identifiers.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/identifiers.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using U64 = hn::ScalableTag<std::uint64_t>;
using U32 = hn::Rebind<std::uint32_t, U64>;

std::uint32_t id_of_word(std::uint64_t color) {
    return std::uint32_t((color & 0xFF) | (color >> 8 & 0xFF00) | (color >> 16 & 0xFF0000));
}

/// Identifiers in a vector and those one before: pixels side by side mostly have the same, and only where
/// they differ is there something new to mark.
void identify_all(std::span<const Rgba> colors, std::uint32_t* ids, char* seen) {
    const U64 d;
    const U32 half;
    const auto* words = reinterpret_cast<const std::uint64_t*>(colors.data());
    const auto byte = [&](auto v, std::uint64_t mask) { return hn::And(v, hn::Set(d, mask)); };
    auto last = hn::Set(half, ~0u);
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= colors.size(); i += hn::Lanes(d)) {
        const auto color = hn::LoadU(d, words + i);
        const auto wide = hn::Or(byte(color, 0xFF), hn::Or(byte(hn::ShiftRight<8>(color), 0xFF00),
                                                           byte(hn::ShiftRight<16>(color), 0xFF0000)));
        const auto id = hn::TruncateTo(half, wide);
        hn::StoreU(id, half, ids + i);
        if (hn::AllTrue(half, hn::Eq(id, last))) continue;
        for (std::size_t k = i; k < i + hn::Lanes(d); ++k) seen[ids[k]] = 1;
        last = hn::Set(half, ids[i + hn::Lanes(d) - 1]);
    }
    for (; i < colors.size(); ++i) seen[ids[i] = id_of_word(words[i])] = 1;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(identify_all);

void identify(std::span<const Rgba> colors, std::uint32_t* ids, char* seen) {
    HWY_DYNAMIC_DISPATCH(identify_all)(colors, ids, seen);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
