// A vector of an ID buffer's pixels at a time; scalar twin: scene::id_of.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/seen.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/seen.h"

#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::uint32_t id_bits = 0xFFFFFF;

/// Pixels side by side mostly have the same identifier: only one that its right neighbour has not is marked.
void mark_all(std::span<const std::uint32_t> pixels, char* seen) {
    const hn::ScalableTag<std::uint32_t> d;
    const std::uint32_t* const at = pixels.data();
    std::size_t i = 0;
    for (; i + hn::Lanes(d) < pixels.size(); i += hn::Lanes(d)) {
        std::uint64_t last = 0;
        hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, at + i), hn::LoadU(d, at + i + 1)),
                          reinterpret_cast<std::uint8_t*>(&last));
        for (; last != 0; last &= last - 1) seen[at[i + std::size_t(std::countr_zero(last))] & id_bits] = 1;
    }
    for (; i < pixels.size(); ++i) seen[at[i] & id_bits] = 1;
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(mark_all);

void mark_seen(std::span<const std::uint32_t> pixels, char* seen) {
    HWY_DYNAMIC_DISPATCH(mark_all)(pixels, seen);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
