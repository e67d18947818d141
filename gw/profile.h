// A machine's profile: the number of bits of each value, and its extensions. Plain data.
// Does not define the arithmetic: docs/manual.md does, in terms of these numbers.
#pragma once

#include "gw/planes.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gw {

/// Features that a machine may lack. A list that uses one is refused on a profile without it; the
/// message names both.
struct Extensions {
    bool polygon_offset = false;
    /// depth textures compared with r (the RealityEngine's shadow maps)
    bool shadow_texture = false;
    bool stencil_wrap = false;            ///< StencilOp::IncrWrap, DecrWrap
    bool two_sided_stencil = false;       ///< separate stencil state for back faces
    bool texture_border = false;          ///< Wrap::BorderClamp, textures with a border
    bool texture_formats = false;         ///< formats other than RGBA, given levels, 1D
    bool stipple = false;                 ///< of lines and filled polygons
    bool two_sided_polygon_mode = false;  ///< separate polygon modes of front and back faces
    bool logic_op = false;                ///< logical operations
    bool blend_color = false;             ///< a constant colour as blend factor
    bool blend_minmax = false;            ///< BlendEquation::Min, Max
    bool blend_subtract = false;          ///< BlendEquation::Subtract, ReverseSubtract
    bool draw_pixels = false;             ///< DrawPixels
    bool blend_separate = false;          ///< BlendAlphaState
    bool blend_square = false;            ///< colours as factors of their own side
    bool texture_sizes = false;           ///< sides that are no powers of two, or up to 8192
    bool texture_wraps = false;           ///< Wrap::ClampToBorder, MirroredRepeat
    bool texture_lod = false;             ///< TextureLodState
    bool texture_combine = false;         ///< TexEnv::Add, Combine
    bool texture_srgb = false;            ///< Texture::srgb
    bool secondary_color = false;         ///< a second colour, added after texture
    bool fog_coordinate = false;          ///< FogSource::Coordinate
    bool occlusion_query = false;         ///< Query
    bool clip_control = false;            ///< ClipControlState
    bool texture_units = false;           ///< MoreTextures, Draw::more_maps
    bool texture_depth = false;           ///< Texture::depths, TextureState::compare_func
    bool texture_cube = false;      ///< Texture::cube, CoordinateMode::NormalMap, ReflectionMap
    bool texture_seamless = false;  ///< TextureState::seamless
    bool texture_3d = false;        ///< three dimensions
    bool surfaces = false;          ///< MakeSurface, UseSurface, Blit
    bool point_parameters = false;  ///< PointParameters
    bool point_sprite = false;      ///< State::point_sprite
    bool multisample = false;       ///< Surface::samples, MultisampleState
    bool operator==(const Extensions&) const = default;
};

/// Bits are per value; allowed ranges are checked by `validate`.
struct Profile {
    std::string name = "vgx";
    int color_bits = 8;     ///< per channel R, G, B, A: 8 .. 16
    int depth_bits = 24;    ///< 16 .. 32
    int stencil_bits = 8;   ///< 1 .. 8
    int accum_bits = 16;    ///< per channel, signed, in units of the frame buffer: 16 .. 32
    int subpixel_bits = 3;  ///< 1 .. 8; 3 is the VGX's 8x8 grid
    int lit_bits = 8;       ///< of a lit vertex colour: 4 .. color_bits
    int max_lights = 8;     ///< in one pass: 1 .. 1024
    int texel_bits = 0;     ///< of a texel's channel: 1 .. 16; 0: color_bits
    int coverage_bits = 0;  ///< of antialiasing: 1 .. 16; 0: the machine has none
    int color_planes = 1;   ///< 2: front and back
    /// fog factor per fragment by default; else at the vertex, as in [K] Fig. 2
    bool fragment_fog = false;
    /// Gouraud shading in perspective; else linear on the screen, as in the hardware
    bool perspective_color = false;
    Extensions extensions;
    bool operator==(const Profile&) const = default;
};

/// IRIS 4D/340 VGX class: the machine of the Hitachi paper.
Profile vgx();
/// RealityEngine class.
Profile reality();
/// More bits and all extensions.
Profile ideal();

/// All features of OpenGL 1.1, and common extensions of its time.
Profile opengl();

/// An extension's name and place.
struct ExtensionName {
    const char* name;
    bool Extensions::*member;
};
/// All extensions, in the order of Extensions.
std::span<const ExtensionName> extension_names();

/// The machines that the papers' systems run on: vgx, reality and ideal.
const std::vector<Profile>& paper_profiles();
/// The built-in profiles, in the order above.
const std::vector<Profile>& profiles();

/// The bits of a texel's channel.
constexpr int texel_bits(const Profile& p) {
    return p.texel_bits != 0 ? p.texel_bits : p.color_bits;
}

/// Of a surface's depth plane.
constexpr int depth_bits(const Profile& p, const Surface& surface) {
    return surface.depth_bits != 0 ? surface.depth_bits : p.depth_bits;
}
/// The profile with the depth_bits of a surface: that of all commands on it.
Profile profile_of(const Profile& profile, const Surface& surface);

/// The planes of its machines.
constexpr PlaneMask planes_of(const Profile& p) {
    return p.color_planes == 2 ? PlaneMask(all_planes | mask_of(Plane::Back)) : all_planes;
}

/// The built-in profile of this name. Throws Error naming the known ones.
const Profile& profile_named(std::string_view name);

/// Throws Error naming the first field that is out of its range.
void validate(const Profile& profile);

}  // namespace gw
