// The form factors of a plane figure's texels from a point, and the part of each that the ID buffers
// show [F2.2, F2.2o]. Works on a vector of texels at a time. Does not choose or add up (texel_scan.h).
#pragma once

#include "radiosity/hemicube/figure_view.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace gw::radiosity {

/// How a texel's light is found out.
using TexelKind = std::int32_t;
inline constexpr TexelKind decided = 0;  ///< all of it is seen, or nothing
/// 1 + i: sample_counts[i] samples are looked up. 1 + i + at_border: beside the figure's own border.
inline constexpr std::array<int, 9> sample_counts{5, 8, 13, 21, 34, 55, 89, 144, 233};
inline constexpr double pixels_per_sample = 1.5;  ///< of a texel's pixels, at most
inline constexpr TexelKind at_border = 9;
inline constexpr TexelKind near_point = 19;  ///< divided until its parts are small (near_texels.h)

/// A texel is near if the point is closer than this many of its sides.
inline constexpr double near_sides = 3;

/// A place at which a texel's light is looked up, in texels from its middle.
struct Sample {
    float u = 0, v = 0;
};

/// Those of all sample_counts, one after the other: Fibonacci lattices, even in every direction.
constexpr auto fibonacci_samples() {
    constexpr int all = std::accumulate(sample_counts.begin(), sample_counts.end(), 0);
    std::array<Sample, all> samples;
    std::size_t next = 0;
    for (std::size_t n = 0; n < sample_counts.size(); ++n) {
        const int count = sample_counts[n], step = n > 0 ? sample_counts[n - 1] : 3;
        const auto at = [&](int i) { return static_cast<float>((i % count + 0.5) / count - 0.5); };
        for (int i = 0; i < count; ++i) samples[next++] = {at(i), at(i * step)};
    }
    return samples;
}

/// Those of sample_counts[number].
inline std::span<const Sample> samples_of(std::size_t number) {
    static constexpr auto samples = fibonacci_samples();
    const auto first =
        std::accumulate(sample_counts.begin(), sample_counts.begin() + int(number), 0);
    return std::span(samples).subspan(std::size_t(first), std::size_t(sample_counts[number]));
}

/// A row of texels: (first + i, v), i = 0 .. count - 1.
struct TexelRow {
    int first = 0, v = 0, count = 0;
};

/// The integrand at the corners (first + i, v), i = 0 .. count; space for a vector more.
void find_corners(const FigureView& view, const TexelRow& row, float* corners) noexcept;

/// One figure in one hemicube.
struct TexelSight {
    const FigureView& view;
    const SeenIds& seen;
    std::uint32_t id = 0;
};

/// Of the row's texels: their form factors if they are whole and nothing hides them, or 0 if all of
/// a texel is hidden; and their kinds. low, high: find_corners of v and v + 1. Space for a vector
/// more.
void find_row(const TexelSight& sight, const TexelRow& row, const float* low, const float* high,
              float* factors, TexelKind* kinds) noexcept;

/// Texels of one kind. Each member has space for `count` texels and a vector more.
struct TexelList {
    std::vector<float> u, v;  ///< the middle
    /// a point of the texel that is inside the figure
    std::vector<float> inside_u, inside_v;
    std::vector<float> shares;         ///< filled in by find_shares
    std::vector<std::uint32_t> texel;  ///< its number
    std::size_t count = 0;

    void add(const dvec2& middle, const dvec2& inside, std::size_t number);
};

/// shares: of the light that falls on a texel if nothing hides it, the part that the buffers show.
void find_shares(const TexelSight& sight, TexelKind kind, TexelList& list) noexcept;

}  // namespace gw::radiosity
