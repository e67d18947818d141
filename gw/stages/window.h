// From clip coordinates to the window: division, viewport, snap. docs/manual/geometry.md, "Window
// coordinates". Does not clip or jitter.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/stages/clip.h"
#include "gw/stages/resolve.h"

#include <cstdint>

namespace gw {

/// A snapped vertex. x, y are in 1/2^subpixel_bits of a pixel, z is in units of the depth plane. w
/// is the clip coordinate, > 0.
struct WindowVertex {
    std::int64_t x = 0, y = 0;
    std::uint32_t z = 0;
    double w = 1;
};

/// floor(v * 2^s + 1/2), clamped to the guard band.
inline std::int64_t snap(double v, int subpixel_bits) {
    const double scale = double(1 << subpixel_bits);
    return to_integer(std::floor(v * scale + 0.5), guard_low * scale, guard_high * scale - 1);
}

/// z / w in the window: times scale, plus center.
struct DepthMap {
    double scale, center;
};
inline DepthMap depth_map(const ViewportTransform& viewport, const DepthRangeState& range) {
    const double n = clamp01(range.near_value), f = clamp01(range.far_value);
    if (viewport.zero_to_one) return {f - n, n};
    return {(f - n) / 2, (f + n) / 2};
}

inline WindowVertex to_window(const ClipPosition& v, const ViewportTransform& viewport,
                              const DepthRangeState& range, const Profile& profile) {
    const double w = v.clip.w;
    const DepthMap map = depth_map(viewport, range);
    const double z = (v.clip.z / w) * map.scale + map.center;
    return {snap((v.clip.x / w) * viewport.half_width + viewport.center_x, profile.subpixel_bits),
            snap((v.clip.y / w) * viewport.half_height + viewport.center_y, profile.subpixel_bits),
            quantize(z, profile.depth_bits), w};
}

}  // namespace gw
