// What the reference machine reports to an observer: each fragment, the test that killed it, what
// it changed, and the depths that its textures were compared with. Does not store anything:
// inspect/ does.
#pragma once

#include "gw/planes.h"

#include <cstdint>

namespace gw {

/// A fragment on its way to the planes.
struct Fragment {
    int x = 0, y = 0;
    Rgba color{};
    std::uint32_t depth = 0;
    bool front = true;            ///< of a front face (lines, points, pixels: front)
    std::uint32_t primitive = 0;  ///< ordinal in the draw; span or pixel ordinal in a write
    std::uint32_t coverage = 0;   ///< in coverage_bits of a smooth primitive; else 0
    int sample = 0;               ///< the one that was tested, of a surface with samples [R17.3]
};

/// A comparison of r with a texel of a texture of depths, for a pixel of a primitive [R10.22].
struct DepthComparison {
    std::size_t unit = 0;
    int i = 0, j = 0;          ///< the texel; outside the texture: its border
    std::uint32_t r = 0;       ///< the pixel's, in the texture's bits
    std::uint32_t stored = 0;  ///< the texel's
    bool passes = false;       ///< the texture's value is 1, not 0
    bool operator==(const DepthComparison&) const = default;
};

/// The test that killed a fragment; Written if none did.
enum class Fate : std::uint8_t { AlphaTest, StencilTest, DepthTest, Written };

/// One pixel's values in all planes.
struct PixelValues {
    Rgba color{};
    std::uint32_t depth = 0;
    std::uint8_t stencil = 0;
    std::array<std::int32_t, 4> accum{};
    Rgba back{};  ///< 0 if there is one colour plane
    bool operator==(const PixelValues&) const = default;
};

inline PixelValues values_at(const Planes& planes, std::size_t index) {
    return {planes.color[index], planes.depth[index], planes.stencil[index],
            planes.accum.empty() ? std::array<std::int32_t, 4>{} : planes.accum[index],
            planes.back.empty() ? Rgba{} : planes.back[index]};
}

/// Called by the reference machine, for the pixels of one surface. `command` is the ordinal of the
/// command in its list.
class Observer {
public:
    virtual ~Observer() = default;
    virtual void begin_command(std::size_t command) = 0;
    virtual void fragment(const Fragment& fragment, Fate fate, const PixelValues& before,
                          const PixelValues& after) = 0;
    /// Before the fragments of a primitive at a pixel, for each of its units that compares.
    virtual void comparison(int /*x*/, int /*y*/, std::uint32_t /*primitive*/,
                            const DepthComparison&) {}
    /// A pixel touched by a clear, a pixel rectangle of depth or stencil, accumulation, a copy or
    /// an exchange of the colour planes.
    virtual void pixel(int x, int y, const PixelValues& before, const PixelValues& after) = 0;
};

}  // namespace gw
