// The size of a point by its distance, and the planes of sprites. docs/manual/rasterization.md,
// "Points". Does not cover pixels.
#pragma once

#include "gw/command_list.h"

#include <cstdint>

namespace gw {

/// Whether points may have other sizes than State::point_size.
inline bool sizes_points(const State& s) { return s.point_parameters != PointParameters{}; }

/// The size of the point at vertex `index` of the draw's mesh, in pixels 1 .. 128.
float point_size_of(const State& state, const Draw& draw, std::uint32_t index);

/// Whether points have coverage. Sprites are squares.
constexpr bool smooths_points(const State& s) { return s.point_smooth && !s.point_sprite; }

/// Texture coordinates of sprites are planes over a denominator of 2^30: one half at the point, and
/// this gradient of s along rows, of -t along columns.
inline constexpr std::int64_t sprite_denominator = std::int64_t{1} << 30;
/// rne(2^46 / size); no tie exists.
constexpr std::int64_t sprite_gradient(int size) {
    return ((std::int64_t{1} << 46) + size / 2) / size;
}

/// Whether a unit's coordinates are a sprite's.
inline bool is_sprite(const State& s, std::size_t unit) {
    return s.point_sprite && texture_of(s, unit).coord_replace;
}

}  // namespace gw
