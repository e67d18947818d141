// A vector of an ID buffer's pixels at a time; scalar twin: scene::id_of.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "radiosity/hemicube/present_ids.cpp"
#include <hwy/foreach_target.h>

#include "radiosity/hemicube/hemicube.h"

#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::radiosity::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::uint32_t id_bits = 0xFFFFFF;

/// Of an identifier's pixels only one that neither the next nor the one above has is marked: the
/// last is one.
void mark_present(std::span<const std::uint32_t> pixels, std::size_t row, char* present) {
    const hn::ScalableTag<std::uint32_t> d;
    const std::uint32_t* const at = pixels.data();
    const auto mark = [&](std::size_t i) { present[at[i] & id_bits] = 1; };
    std::size_t i = 0;
    for (; i + row + hn::Lanes(d) <= pixels.size(); i += hn::Lanes(d)) {
        const auto pixel = hn::LoadU(d, at + i);
        const auto differs = [&](std::size_t by) {
            return hn::Ne(pixel, hn::LoadU(d, at + i + by));
        };
        std::uint64_t last = 0;
        hn::StoreMaskBits(d, hn::And(differs(1), differs(row)),
                          reinterpret_cast<std::uint8_t*>(&last));
        for (; last != 0; last &= last - 1) mark(i + std::size_t(std::countr_zero(last)));
    }
    for (; i < pixels.size(); ++i)
        if (i + 1 == pixels.size() || at[i] != at[i + 1]) mark(i);
}

}  // namespace gw::radiosity::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::radiosity {

HWY_EXPORT(mark_present);

void mark_present_ids(std::span<const std::uint32_t> pixels, std::size_t row, char* present) {
    HWY_DYNAMIC_DISPATCH(mark_present)(pixels, row, present);
}

}  // namespace gw::radiosity
#endif  // HWY_ONCE
