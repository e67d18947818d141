// A primitive's integer planes, relative to a tile. docs/manual.md, "Planes": closed form modulo
// 2^64. Does not evaluate them: the kernels do, a block at a time.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/fast/frame/tile_plane.h"
#include "gw/mesh.h"
#include "gw/state.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gw::fast {

struct GeometrySet;
struct SetupPrimitive;
struct Tile;

/// Nearest integer to num * 2^shift / den, ties to even.
inline int128 exact_gradient(std::int64_t num, int shift, std::int64_t den) {
    return divide_round_even(int128{num} * (int128{1} << shift), den);
}
/// The same where it fits 64 bits, else wrapped. A double gives a guess; integers decide.

inline std::int64_t gradient(std::int64_t num, int shift, std::int64_t den, bool& sliver) {
    if (num == 0) return 0;
    const double scaled = double(num) * double(std::int64_t{1} << shift);
    const double q = scaled / double(den);
    if (!(std::abs(q) < 1125899906842624.0)) {                      // 2^50
        sliver = sliver || !(std::abs(q) < 2305843009213693952.0);  // 2^61
        return static_cast<std::int64_t>(exact_gradient(num, shift, den));
    }
    std::int64_t g = static_cast<std::int64_t>(round_even(q));
    // 2^52: a rational is no closer to a half than 1/2D
    if (std::abs(scaled) < 4503599627370496.0) return g;
    const std::int64_t r = static_cast<std::int64_t>((std::uint64_t(num) << shift) -
                                                     std::uint64_t(g) * std::uint64_t(den));
    if (2 * r > den || (2 * r == den && (g & 1)))
        g += 1;
    else if (2 * r < -den || (2 * r == -den && (g & 1)))
        g -= 1;
    return g;
}

/// A plane at single places, limited to the values at the vertices. At an outer centre that is the
/// rule (R9.28); elsewhere the limits change nothing (R9.8).
struct LimitedPlane {
    std::array<int128, 2> gradients{};
    std::int64_t a0 = 0, x0 = 0, y0 = 0, low = 0, high = 0;
    int s = 3;

    /// In sub-pixels.
    std::int64_t at(std::int64_t x, std::int64_t y) const {
        const int128 step = (gradients[0] * (x - x0) + gradients[1] * (y - y0)) >> s;
        const int128 value = ((int128{a0} << 16) + (1 << 15) + step) >> 16;
        return static_cast<std::int64_t>(std::clamp<int128>(value, low, high));
    }
};

/// The data of one primitive in one tile that all its planes share.
struct PrimitiveFrame {
    MeshKind kind = MeshKind::Triangles;
    int s = 3;
    std::array<std::int64_t, 3> x{}, y{};                        ///< jittered
    std::int64_t dx1 = 0, dy1 = 0, dx2 = 0, dy2 = 0, area2 = 1;  ///< triangles
    bool x_major = true;                                         ///< lines
    std::int64_t length = 1;                                     ///< lines: of the major axis
    float point_size = 1;                                        ///< points
    std::uint32_t stippled = 0;                                  ///< lines: steps before it
    /// vertex that planes start from
    std::size_t base = 0;
    std::int64_t ax = 0, ay = 0;      ///< from the base to the centre of its pixel
    std::int64_t to_x = 0, to_y = 0;  ///< pixels from the base's to the tile
    /// The frame is for one place, in sub-pixels: planes are constant. `outer`: it is the centre of
    /// a pixel, outside the primitive (R9.28).
    bool at_place = false, outer = false;
    std::int64_t place_x = 0, place_y = 0;

    /// Plane through values at the primitive's vertices (1, 2 or 3 of them).
    TilePlane plane(const std::array<std::int64_t, 3>& a) const {
        if (at_place) return plane_at_place(a);
        switch (kind) {
            case MeshKind::Triangles: return triangle_plane(a);
            case MeshKind::Lines: return line_plane(a);
            case MeshKind::Points: break;
        }
        return constant(a[0]);
    }
    LimitedPlane limited_of(const std::array<std::int64_t, 3>& a) const;
    /// A plane of a sprite, with these gradients.
    TilePlane sprite_plane(std::int64_t a, std::int64_t gx, std::int64_t gy) const {
        return at_tile(a, gx, gy, false);
    }
    TilePlane sprite_plane_at_place(std::int64_t a, std::int64_t gx, std::int64_t gy) const {
        return constant(LimitedPlane{{gx, gy}, a, x[0], y[0], 0, 2 * a, s}.at(place_x, place_y));
    }
    static TilePlane constant(std::int64_t a) { return {(std::uint64_t(a) << 16) + (1u << 15)}; }

    /// The gradients before they wrap, for the level of detail and the polygon offset.
    std::array<int128, 2> exact_gradients(const std::array<std::int64_t, 3>& a) const;

private:
    std::array<int128, 2> gradients(const std::array<std::int64_t, 3>& a) const;
    TilePlane plane_at_place(const std::array<std::int64_t, 3>& a) const;
    TilePlane triangle_plane(const std::array<std::int64_t, 3>& a) const {
        const std::int64_t da1 = a[1] - a[0], da2 = a[2] - a[0];
        if ((da1 | da2) == 0) return constant(a[0]);
        bool sliver = false;
        const std::int64_t gx = gradient(da1 * dy2 - da2 * dy1, 16 + s, area2, sliver);
        const std::int64_t gy = gradient(da2 * dx1 - da1 * dx2, 16 + s, area2, sliver);
        return at_tile(a[0], gx, gy, sliver);
    }
    TilePlane line_plane(const std::array<std::int64_t, 3>& a) const {
        bool sliver = false;
        const std::int64_t g = gradient(a[1 - base] - a[base], 16 + s, length, sliver);
        return at_tile(a[base], x_major ? g : 0, x_major ? 0 : g, sliver);
    }
    TilePlane at_tile(std::int64_t a0, std::int64_t gx, std::int64_t gy, bool sliver) const {
        const auto u = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
        const std::int64_t to_center =
            static_cast<std::int64_t>(u(gx) * u(ax) + u(gy) * u(ay)) >> s;
        return {(u(a0) << 16) + (1u << 15) + u(to_center) + u(gx) * u(to_x) + u(gy) * u(to_y), gx,
                gy, sliver};
    }
};

PrimitiveFrame primitive_frame(const GeometrySet& set, const SetupPrimitive& p,
                               const JitterState& jitter, int subpixel_bits, const Tile& tile);

/// Edge functions of a triangle at the tile's pixels: inside if c + a i + b j >= 0 for all
/// three, in 32 bits.
struct TileEdges {
    std::array<std::int32_t, 3> c{}, a{}, b{};
};
TileEdges tile_edges(const PrimitiveFrame& frame, const Tile& tile);

}  // namespace gw::fast
