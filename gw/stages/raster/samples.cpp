#include "gw/stages/raster/samples.h"

#include "gw/base/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace gw {
namespace {

/// In 1/8 pixel from the lower left corner.
using Place = std::pair<int, int>;
constexpr std::array<Place, 2> places_of_2{{{6, 6}, {2, 2}}};
constexpr std::array<Place, 4> places_of_4{{{3, 1}, {7, 3}, {1, 5}, {5, 7}}};
constexpr std::array<Place, 8> places_of_8{
    {{4, 2}, {3, 5}, {6, 4}, {2, 1}, {1, 6}, {0, 3}, {5, 7}, {7, 0}}};

const Place& place(int samples, int k) {
    if (samples == 2) return places_of_2[std::size_t(k)];
    return samples == 4 ? places_of_4[std::size_t(k)] : places_of_8[std::size_t(k)];
}

}  // namespace

JitterState sample_shift(int samples, int k, int subpixel_bits) {
    const auto& [x, y] = place(samples, k);
    const int eighth = 1 << (subpixel_bits - 3);
    return {(4 - x) * eighth, (4 - y) * eighth};
}

std::uint32_t least_alpha(int samples, int k, int color_bits) {
    const std::uint64_t parts = 2 * std::uint64_t(samples);
    return std::uint32_t(((2 * std::uint64_t(k) + 1) * max_of_bits(color_bits) + parts - 1) /
                         parts);
}

SampleMask tested_samples(const Resolved& r) {
    const MultisampleState& m = r.state.multisample;
    const SampleMask all = all_samples(r.samples);
    if (!m.coverage_test) return all;
    const double part = std::clamp(double(m.coverage), 0.0, 1.0);
    const SampleMask first = all_samples(int(std::floor(part * r.samples + 0.5)));
    return m.invert ? SampleMask(all & ~first) : first;
}

SampleMask kept_samples(const Resolved& r, std::uint32_t alpha) {
    SampleMask kept = tested_samples(r);
    if (!r.state.multisample.alpha_to_coverage) return kept;
    for (int k = 0; k < r.samples; ++k)
        if (alpha < least_alpha(r.samples, k, r.bits)) kept = SampleMask(kept & ~(1u << k));
    return kept;
}

Planes one_of_each(std::span<const Planes> samples) {
    Planes mean = samples[0];
    const auto count = std::uint32_t(samples.size());
    std::vector<std::array<std::uint32_t, 4>> sums(mean.color.size(),
                                                   {count / 2, count / 2, count / 2, count / 2});
    for (const Planes& sample : samples)
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (std::size_t c = 0; c < 4; ++c) sums[i][c] += sample.color[i][c];
    for (std::size_t i = 0; i < sums.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) mean.color[i][c] = std::uint16_t(sums[i][c] / count);
    return mean;
}

}  // namespace gw
