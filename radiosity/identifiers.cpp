// Identifiers from the colours of an ID buffer, a vector at a time; scalar twin: scene::id_of.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/identifiers.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/identifiers.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::uint32_t id_bits = 0xFFFFFF;

/// Identifiers in a vector and those one before: pixels side by side mostly have the same, and only where
/// they differ is there something new to mark.
void identify_all(std::span<const std::uint32_t> colors, std::uint32_t* ids, char* seen) {
    const hn::ScalableTag<std::uint32_t> d;
    auto last = hn::Set(d, ~0u);
    std::size_t i = 0;
    for (; i + hn::Lanes(d) <= colors.size(); i += hn::Lanes(d)) {
        const auto id = hn::And(hn::LoadU(d, colors.data() + i), hn::Set(d, id_bits));
        hn::StoreU(id, d, ids + i);
        if (hn::AllTrue(d, hn::Eq(id, last))) continue;
        for (std::size_t k = i; k < i + hn::Lanes(d); ++k) seen[ids[k]] = 1;
        last = hn::Set(d, ids[i + hn::Lanes(d) - 1]);
    }
    for (; i < colors.size(); ++i) seen[ids[i] = colors[i] & id_bits] = 1;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(identify_all);

void identify(std::span<const std::uint32_t> colors, std::uint32_t* ids, char* seen) {
    HWY_DYNAMIC_DISPATCH(identify_all)(colors, ids, seen);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
