// The state of textures: coordinates, look-up, environment. Part of gw/state.h. Does not compute
// anything.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace gw {

enum class CompareFunc : std::uint8_t {
    Never,
    Less,
    Equal,
    LEqual,
    Greater,
    NotEqual,
    GEqual,
    Always
};
enum class MinFilter : std::uint8_t {
    Nearest,
    Linear,
    NearestMipmapNearest,
    LinearMipmapNearest,
    NearestMipmapLinear,
    LinearMipmapLinear
};
enum class MagFilter : std::uint8_t { Nearest, Linear };
enum class Wrap : std::uint8_t {
    Repeat,
    Clamp,        ///< to the texels at the edge
    BorderClamp,  ///< extension texture_border: GL_CLAMP, half way into the border
    /// extension texture_wraps
    ClampToBorder,   ///< the border outside
    MirroredRepeat,  ///< every second repeat is mirrored
};
/// Whether the integer part of a coordinate is no distance.
constexpr bool repeats(Wrap wrap) { return wrap == Wrap::Repeat || wrap == Wrap::MirroredRepeat; }
enum class TexEnv : std::uint8_t {
    Modulate,
    Decal,
    Blend,
    Replace,
    /// extension texture_combine
    Add,
    Combine,  ///< TextureState::combine_rgb, combine_alpha
};
enum class CombineFunc : std::uint8_t {
    Replace,
    Modulate,
    Add,
    AddSigned,
    Interpolate,
    Subtract,
    Dot3Rgb,   ///< of colours only
    Dot3Rgba,  ///< of colours only: replaces alpha too
};
enum class CombineSource : std::uint8_t {
    Texture,
    Constant,
    PrimaryColor,
    Previous,
    /// extension texture_units: of that unit
    Texture0,
    Texture1,
    Texture2,
    Texture3,
};
/// Of alpha, Color is Alpha.
enum class CombineOperand : std::uint8_t { Color, OneMinusColor, Alpha, OneMinusAlpha };
/// A function of up to three arguments, for colours or for alpha.
struct CombineState {
    CombineFunc func = CombineFunc::Modulate;
    CombineSource source0 = CombineSource::Texture, source1 = CombineSource::Previous,
                  source2 = CombineSource::Constant;
    CombineOperand operand0 = CombineOperand::Color, operand1 = CombineOperand::Color,
                   operand2 = CombineOperand::Alpha;
    int scale = 1;  ///< 1, 2 or 4
    bool operator==(const CombineState&) const = default;
};
enum class TexGen : std::uint8_t {
    None,
    SphereMap,      ///< reflection map [K3.1]
    RefractionMap,  ///< sphere map looked up with the refracted ray, ratio `eta` [K1]
    EyeLinear,      ///< (s, t, r, q) = plane matrix * p_eye: projected textures and shadow maps
    PerCoordinate,  ///< each coordinate by its own rule: TextureState::coordinates
};
/// The rule of one texture coordinate.
enum class CoordinateMode : std::uint8_t {
    Given,         ///< the vertex's own
    ObjectLinear,  ///< dot(plane, p_object)
    EyeLinear,     ///< dot(plane, p_eye)
    SphereMap,     ///< of s and t only
    /// extension texture_cube, of s, t and r only
    NormalMap,      ///< x, y and z of the normal in eye space
    ReflectionMap,  ///< of the eye's ray after reflection at the normal
};
struct CoordinateGen {
    CoordinateMode mode = CoordinateMode::Given;
    dvec4 plane{0, 0, 0, 0};
    bool operator==(const CoordinateGen&) const = default;
};
/// Extension texture_lod: which levels are used. The nearest existing ones stand for others.
struct TextureLodState {
    int base_level = 0, max_level = 1000;
    float bias = 0, min = -1000, max = 1000;  ///< of log2 of the texels per pixel
    bool operator==(const TextureLodState&) const = default;
};
struct TextureState {
    MinFilter min_filter = MinFilter::Linear;
    MagFilter mag_filter = MagFilter::Linear;
    Wrap wrap_s = Wrap::Repeat, wrap_t = Wrap::Repeat;
    TexEnv env = TexEnv::Modulate;
    vec4 env_color{0, 0, 0, 0};
    TexGen gen = TexGen::None;
    double eta = 1;                              ///< RefractionMap: n1 / n2
    dmat4 eye_linear{1};                         ///< EyeLinear: rows give s, t, r, q
    std::array<CoordinateGen, 4> coordinates{};  ///< PerCoordinate: s, t, r, q
    dmat4 matrix{1};                             ///< applied to given and generated coordinates
    vec4 border_color{0, 0, 0, 0};  ///< BorderClamp: of textures without a border of their own
    /// extension shadow_texture: 1 if r <= texel, else 0, as colour and alpha
    bool shadow_compare = false;
    CompareFunc compare_func = CompareFunc::LEqual;  ///< of r and texel: extension texture_depth
    Wrap wrap_r = Wrap::Repeat;                      ///< of three dimensions
    bool seamless = false;  ///< extension texture_seamless: filters reach over a cube's edges
    TextureLodState lod;
    CombineState combine_rgb;
    CombineState combine_alpha{.operand0 = CombineOperand::Alpha,
                               .operand1 = CombineOperand::Alpha};
    /// The level of detail by the square root of [GL11] 3.8.1, not by max{m_u, m_v}.
    bool exact_rho = false;
    bool coord_replace = false;  ///< under State::point_sprite, s and t go from 0 to 1 over a point
    bool operator==(const TextureState&) const = default;
};

inline constexpr std::size_t max_texture_units = 4;
/// Extension texture_units: units 1 to 3. Null: their initial states.
struct MoreTextures {
    std::shared_ptr<const std::array<TextureState, max_texture_units - 1>> units;
    bool operator==(const MoreTextures& other) const {
        return units == other.units || (units && other.units && *units == *other.units);
    }
};

}  // namespace gw
