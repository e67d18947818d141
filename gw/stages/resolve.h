// State normalised once per draw, so that the fragment stages test less. docs/manual/machine.md,
// "State". Does not change the meaning of a state: a disabled test becomes one that always passes
// and writes nothing.
#pragma once

#include "gw/planes.h"
#include "gw/profile.h"
#include "gw/state.h"

namespace gw {

/// The map from clip coordinates to the window, with the viewport's default resolved.
struct ViewportTransform {
    double half_width = 1;
    double half_height = 1;  ///< negative under ClipOrigin::UpperLeft
    double center_x = 0, center_y = 0;
    bool zero_to_one = false;  ///< ClipDepth::ZeroToOne
};

/// What is the same at all pixels of a texture unit.
struct ResolvedTexture {
    Rgba env_color{}, border_color{};
    /// texture.lod: the scale factor of texels is multiplied, then clamped
    float rho_scale = 1, least_rho = 0, greatest_rho = 0;
};

/// The members of ResolvedTexture are those of unit 0.
struct Resolved : ResolvedTexture {
    /// tests normalised; blending off under logic_op; cull.front is the winding in the window;
    /// multisample off without samples, no antialiasing under it. Colour masks: written_bits
    State state;
    int bits = 8;     ///< of a colour channel
    int samples = 1;  ///< of a pixel of the surface
    Rect pixel_box;   ///< scissor and window: pixels outside never change
    Rect draw_box;    ///< pixel_box and viewport: primitives make no fragments outside
    ViewportTransform viewport;
    /// masks cut to stencil_bits; Always and Keep if the test is off
    StencilFace front, back;
    std::uint32_t stencil_max = 255;
    std::uint32_t alpha_ref = 0;
    Rgba fog_color{}, blend_color{};
    std::array<ResolvedTexture, max_texture_units - 1> more_textures;
    bool fragment_fog = false;
    Rgba written_bits{};             ///< of each channel, by the colour mask and its bits
    bool writes_color = true;        ///< a bit of a channel
    bool writes_whole_color = true;  ///< all bits of all channels
    bool writes_part_bits = false;   ///< of a channel some bits, but not all
    /// as given: for clears and pixel rectangles, which no depth test guards
    bool depth_mask = true;

    const ResolvedTexture& texture(std::size_t unit) const {
        return unit == 0 ? *this : more_textures[unit - 1];
    }
};

/// Of the window.
Resolved resolve(const State& state, const Profile& profile, int width, int height);
/// Of any surface. Planes that it lacks are neither tested nor written.
Resolved resolve(const State& state, const Profile& profile, const Surface& surface);

/// A channel's value where its bits are written [R12.19].
constexpr std::uint16_t with_written_bits(std::uint16_t stored, std::uint16_t incoming,
                                          std::uint16_t bits) {
    return std::uint16_t((stored & ~unsigned(bits)) | (incoming & bits));
}

/// The polygon mode of a face.
constexpr PolygonMode mode_of(const State& s, bool front) {
    return !front && s.two_side_polygon_mode ? s.back_polygon_mode : s.polygon_mode;
}

/// The whole size of points and lines that are not smooth.
constexpr int whole_size(float size) { return int(double(size) + 0.5); }

/// Whether the stencil test passes every fragment of this side and changes no value.
constexpr bool ignores_stencil(const StencilFace& f) {
    return f.func == StencilFunc::Always && keeps_stencil(f);
}

/// An empty intersection has width or height 0.
Rect intersect(const Rect& a, const Rect& b);

/// A colour as plane values: clamped, times 2^bits - 1, to nearest.
Rgba quantize_color(const vec4& color, int bits);

/// Bytes that one fragment moves, by the manual's model. Totals are linear in the kill counters.
struct FragmentBytes {
    std::uint64_t after_alpha = 0;    ///< stencil read and write
    std::uint64_t after_stencil = 0;  ///< depth read
    std::uint64_t written = 0;        ///< depth write, colour read and write
};
FragmentBytes fragment_bytes(const Resolved& resolved, const Profile& profile);

/// Bytes of one pixel of a plane.
std::uint64_t plane_bytes(Plane plane, const Profile& profile);

/// Whether colours are written to both colour planes.
constexpr bool draws_to_both(const State& s) { return s.draw_buffer == DrawBuffer::FrontAndBack; }

/// Bytes of a pixel that a command writes: of Color, in each plane of the draw buffer.
std::uint64_t written_bytes(Plane plane, const State& state, const Profile& profile);

}  // namespace gw
