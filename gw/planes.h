// The planes of a machine as the host sees them. docs/manual/machine.md, "Planes of the machine".
// Row 0 is the bottom row of the window (GL's origin). Does not draw.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gw {

/// The planes of a machine; each is one bit of a PlaneMask.
/// Color is the front plane. Back belongs to machines with two colour planes; commands that name
/// Color mean the planes of the draw buffer or the read buffer.
enum class Plane : std::uint8_t { Color, Depth, Stencil, Accum, Back };
inline constexpr std::array every_plane{Plane::Color, Plane::Depth, Plane::Stencil, Plane::Accum,
                                        Plane::Back};

using PlaneMask = std::uint8_t;
constexpr PlaneMask mask_of(Plane plane) {
    return static_cast<PlaneMask>(1u << static_cast<unsigned>(plane));
}
inline constexpr PlaneMask all_planes = 15;  ///< that commands name: all but Back

/// The largest side of a surface.
inline constexpr int max_surface_size = 8192;
/// The most samples of a pixel.
inline constexpr int max_samples = 8;
/// The most samples of a surface that has samples: the pixels of the largest one.
inline constexpr std::int64_t max_surface_samples =
    std::int64_t{max_surface_size} * max_surface_size;
/// Surfaces have the numbers 1 to this.
inline constexpr std::uint32_t max_surfaces = 1023;

/// What commands draw to and read from: the window, which has the number 0, or, with extension
/// surfaces, planes of another size. docs/manual/surfaces.md.
struct Surface {
    int width = 0, height = 0;
    PlaneMask planes = 0;  ///< of Color, Depth and Stencil; the window also has Accum
    int depth_bits = 0;    ///< 16 .. 32; 0: the profile's
    int samples = 0;       ///< of a pixel: 2, 4 or 8 with extension multisample; 0: none
    int sample_count() const { return samples > 0 ? samples : 1; }  ///< sets of planes
    bool has(Plane plane) const { return (planes & mask_of(plane)) != 0; }
    bool is_window() const { return has(Plane::Accum); }
    bool operator==(const Surface&) const = default;
};
inline constexpr PlaneMask surface_planes =
    PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth) | mask_of(Plane::Stencil));

struct Planes {
    int width = 0, height = 0;
    std::vector<Rgba> color;            ///< 0 .. 2^color_bits - 1
    std::vector<std::uint32_t> depth;   ///< 0 nearest .. 2^depth_bits - 1 farthest
    std::vector<std::uint8_t> stencil;  ///< 0 .. 2^stencil_bits - 1
    /// units of the frame buffer, wrapped to accum_bits
    std::vector<std::array<std::int32_t, 4>> accum;
    std::vector<Rgba> back;  ///< as color; empty if there is one colour plane

    Planes() = default;
    /// All planes are 0, depth too. OpenGL leaves them undefined before the first clear.
    Planes(int width, int height, int color_planes = 1);
    /// Of a surface: one colour plane, depth and stencil, whichever it has. No accumulation.
    explicit Planes(const Surface& surface);
    std::size_t index(int x, int y) const { return pixel_index(x, y, width); }
    bool operator==(const Planes&) const = default;
};

/// XXH3-128 of a plane, taken over the XXH3-128 digests of its 64x64 blocks. Blocks are ordered in
/// rows from the bottom.
struct Digest {
    std::uint64_t high = 0, low = 0;
    auto operator<=>(const Digest&) const = default;
};

/// Of a plane that is there; else Digest{}.
Digest digest(const Planes& planes, Plane plane);
/// 32 lower-case hexadecimal digits.
std::string to_string(const Digest& digest);

}  // namespace gw
