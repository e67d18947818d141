// Identifiers from the colours of an ID buffer, a vector at a time; scalar twin: scene::id_of.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/identifiers.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/identifiers.h"

#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::uint32_t id_bits = 0xFFFFFF;

/// Pixels side by side mostly have the same identifier: only one that its right neighbour has not is marked.
void identify_all(std::span<std::uint32_t> pixels, char* seen) {
    const hn::ScalableTag<std::uint32_t> d;
    std::uint32_t* const ids = pixels.data();
    const auto id_at = [&](std::size_t i) { return hn::And(hn::LoadU(d, ids + i), hn::Set(d, id_bits)); };
    std::size_t i = 0;
    for (; i + hn::Lanes(d) < pixels.size(); i += hn::Lanes(d)) {
        const auto id = id_at(i), right = id_at(i + 1);
        hn::StoreU(id, d, ids + i);
        std::uint64_t last = 0;
        hn::StoreMaskBits(d, hn::Ne(id, right), reinterpret_cast<std::uint8_t*>(&last));
        for (; last != 0; last &= last - 1) seen[ids[i + std::size_t(std::countr_zero(last))]] = 1;
    }
    for (; i < pixels.size(); ++i) seen[ids[i] &= id_bits] = 1;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(identify_all);

void identify(std::span<std::uint32_t> pixels, char* seen) {
    HWY_DYNAMIC_DISPATCH(identify_all)(pixels, seen);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
