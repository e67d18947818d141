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

void identify_all(std::span<const Rgba> colors, std::uint32_t* ids) {
    const U64 d;
    const auto* words = reinterpret_cast<const std::uint64_t*>(colors.data());
    const auto byte = [&](auto v, std::uint64_t mask) { return hn::And(v, hn::Set(d, mask)); };
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= colors.size(); i += hn::Lanes(d)) {
        const auto color = hn::LoadU(d, words + i);
        const auto id = hn::Or(byte(color, 0xFF), hn::Or(byte(hn::ShiftRight<8>(color), 0xFF00),
                                                         byte(hn::ShiftRight<16>(color), 0xFF0000)));
        hn::StoreU(hn::TruncateTo(U32(), id), U32(), ids + i);
    }
    for (; i < colors.size(); ++i) ids[i] = id_of_word(words[i]);
}

/// Pixels side by side mostly have one identifier: only where a vector differs from what stands one before
/// it is there something new.
void mark_all(std::span<const std::uint32_t> ids, char* seen) {
    const hn::ScalableTag<std::uint32_t> d;
    const std::size_t lanes = hn::Lanes(d);
    if (ids.empty()) return;
    seen[ids[0]] = 1;
    std::size_t i = 1;
    for (; i + lanes <= ids.size(); i += lanes) {
        const auto same = hn::Eq(hn::LoadU(d, &ids[i]), hn::LoadU(d, &ids[i - 1]));
        if (hn::AllTrue(d, same)) continue;
        for (std::size_t k = i; k < i + lanes; ++k) seen[ids[k]] = 1;
    }
    for (; i < ids.size(); ++i) seen[ids[i]] = 1;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(identify_all);
HWY_EXPORT(mark_all);

void identify(std::span<const Rgba> colors, std::uint32_t* ids) {
    HWY_DYNAMIC_DISPATCH(identify_all)(colors, ids);
}
void mark_seen(std::span<const std::uint32_t> ids, char* seen) { HWY_DYNAMIC_DISPATCH(mark_all)(ids, seen); }

}  // namespace gw::radiosity
#endif  // HWY_ONCE
