// The pipeline's state: OpenGL 1.1's words and initial values. One struct per group, plain data.
// docs/vocabulary.md gives IRIS GL's words. Does not compute anything.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

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
enum class StencilOp : std::uint8_t { Keep, Zero, Replace, Incr, Decr, Invert, IncrWrap, DecrWrap };
enum class BlendFactor : std::uint8_t {
    Zero,
    One,
    SrcColor,          ///< destination factor only, without extension blend_square
    OneMinusSrcColor,  ///< destination factor only, without extension blend_square
    DstColor,          ///< source factor only, without extension blend_square
    OneMinusDstColor,  ///< source factor only, without extension blend_square
    SrcAlpha,
    OneMinusSrcAlpha,
    DstAlpha,
    OneMinusDstAlpha,
    SrcAlphaSaturate,  ///< source factor only
    /// extension blend_color: of BlendState::color, either side
    ConstantColor,
    OneMinusConstantColor,
    ConstantAlpha,
    OneMinusConstantAlpha,
};
using DepthFunc = CompareFunc;
using StencilFunc = CompareFunc;
using AlphaFunc = CompareFunc;

/// Lower left corner and size in pixels. Width and height 0 mean the whole window.
struct ViewportState {
    int x = 0, y = 0, width = 0, height = 0;
    bool operator==(const ViewportState&) const = default;
};

struct DepthRangeState {
    double near_value = 0, far_value = 1;  ///< clamped to [0, 1]
    bool operator==(const DepthRangeState&) const = default;
};

/// A user clip plane in eye space: points with dot(plane, p_eye) >= 0 are kept.
struct ClipPlane {
    bool enable = false;
    dvec4 plane{0, 0, 0, 0};
    bool operator==(const ClipPlane&) const = default;
};
inline constexpr int max_clip_planes = 6;

enum class Face : std::uint8_t { Front, Back, FrontAndBack };
enum class Winding : std::uint8_t { CW, CCW };
struct CullState {
    bool enable = false;
    Face face = Face::Back;
    Winding front = Winding::CCW;
    bool operator==(const CullState&) const = default;
};

enum class PolygonMode : std::uint8_t { Point, Line, Fill };

/// Extension polygon_offset: factor * m + units is added to the depth of filled polygons, and to
/// that of the lines and points of their outlines.
struct PolygonOffsetState {
    bool enable = false;
    float factor = 0, units = 0;
    bool lines = false, points = false;  ///< of PolygonMode Line and Point
    bool operator==(const PolygonOffsetState&) const = default;
};

/// Moves every primitive by whole sub-pixel units after the snap; |x|, |y| < 2^subpixel_bits. [K4a]
struct JitterState {
    int x = 0, y = 0;
    bool operator==(const JitterState&) const = default;
};

/// Extension stipple: a line makes a fragment at its step n if bit (n / factor) mod 16 of the
/// pattern is set.
struct LineStippleState {
    bool enable = false;
    int factor = 1;  ///< 1 .. 256
    std::uint16_t pattern = 0xFFFF;
    bool operator==(const LineStippleState&) const = default;
};

/// Extension stipple: filled polygons make fragments at pixel x, y of the window only if bit
/// 31 - x mod 32 of row y mod 32 is set. Null: at all pixels.
struct PolygonStippleState {
    std::shared_ptr<const std::array<std::uint32_t, 32>> pattern;
    bool operator==(const PolygonStippleState& other) const {
        return pattern == other.pattern || (pattern && other.pattern && *pattern == *other.pattern);
    }
};
/// Whether pixel x, y of the window has a fragment.
constexpr bool stipple_bit(const std::array<std::uint32_t, 32>& pattern, int x, int y) {
    return (pattern[unsigned(y) % 32] >> (31 - unsigned(x) % 32) & 1) != 0;
}

enum class ShadeModel : std::uint8_t { Flat, Smooth };

/// The source of a primitive's colour.
enum class ColorSource : std::uint8_t {
    Vertex,    ///< mesh colours (lighting off)
    Lighting,  ///< the lighting equation at the vertices
    /// R, G, B are 8 bits each of (id_base + polygon id) >> id_shift, without texture and fog
    PolygonId,
};

/// The material's parameters that follow the vertex colour.
enum class ColorMaterial : std::uint8_t {
    Emission,
    Ambient,
    Diffuse,  ///< and alpha
    Specular,
    AmbientAndDiffuse,  ///< and alpha
};
struct ColorMaterialState {
    bool enable = false;
    Face face = Face::FrontAndBack;
    ColorMaterial mode = ColorMaterial::AmbientAndDiffuse;
    bool operator==(const ColorMaterialState&) const = default;
};

struct LightingState {
    bool local_viewer = false;
    bool two_side = false;           ///< back faces are lit with the reversed normal
    vec4 model_ambient{0, 0, 0, 1};  ///< GL's initial value is 0.2; the papers have no such term
    ColorMaterialState color_material;
    bool operator==(const LightingState&) const = default;
};

enum class FogMode : std::uint8_t { Linear, Exp, Exp2 };
enum class FogCoordinate : std::uint8_t { Profile, Vertex, Fragment };
struct FogState {
    bool enable = false;
    FogMode mode = FogMode::Exp;
    float density = 1, start = 0, end = 1;  ///< in eye units
    vec4 color{0, 0, 0, 0};
    FogCoordinate coordinate = FogCoordinate::Profile;
    bool operator==(const FogState&) const = default;
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
enum class CombineSource : std::uint8_t { Texture, Constant, PrimaryColor, Previous };
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
    TextureLodState lod;
    CombineState combine_rgb;
    CombineState combine_alpha{.operand0 = CombineOperand::Alpha,
                               .operand1 = CombineOperand::Alpha};
    bool operator==(const TextureState&) const = default;
};

struct ScissorState {
    bool test = false;
    Rect box;
    bool operator==(const ScissorState&) const = default;
};

struct AlphaState {
    bool test = false;
    AlphaFunc func = AlphaFunc::Always;
    /// clamped to [0, 1], compared as round to nearest of ref * (2^color_bits - 1)
    float ref = 0;
    bool operator==(const AlphaState&) const = default;
};

/// The stencil test of one side of a face.
struct StencilFace {
    StencilFunc func = StencilFunc::Always;
    int ref = 0;
    std::uint32_t mask = ~0u;  ///< for the comparison
    StencilOp fail = StencilOp::Keep, zfail = StencilOp::Keep, zpass = StencilOp::Keep;
    std::uint32_t write_mask = ~0u;
    bool operator==(const StencilFace&) const = default;
};
/// The stencil test. `func` .. `write_mask` apply to all fragments; with `two_side` (extension
/// two_sided_stencil) they apply to front faces only. They repeat the fields of a face instead of
/// being a member, so that a pass is written as the papers write it.
struct StencilState {
    bool test = false;
    StencilFunc func = StencilFunc::Always;
    int ref = 0;
    std::uint32_t mask = ~0u;
    StencilOp fail = StencilOp::Keep, zfail = StencilOp::Keep, zpass = StencilOp::Keep;
    std::uint32_t write_mask = ~0u;
    bool two_side = false;
    StencilFace back{};
    StencilFace front() const { return {func, ref, mask, fail, zfail, zpass, write_mask}; }
    bool operator==(const StencilState&) const = default;
};
/// Whether no fragment of this side changes a stencil value.
constexpr bool keeps_stencil(const StencilFace& f) {
    return f.write_mask == 0 ||
           (f.fail == StencilOp::Keep && f.zfail == StencilOp::Keep && f.zpass == StencilOp::Keep);
}

/// Comparison and update are switched separately [K2]: `func = Always` compares nothing, `mask =
/// false` updates nothing. As in GL, `test = false` does neither; the depth plane is not read.
struct DepthState {
    bool test = false;
    DepthFunc func = DepthFunc::Less;
    bool mask = true;
    bool operator==(const DepthState&) const = default;
};

/// The combination of the two products in blending. Min and Max combine the colours, without
/// factors.
enum class BlendEquation : std::uint8_t {
    Add,
    Subtract,         ///< extension blend_subtract: source - destination
    ReverseSubtract,  ///< extension blend_subtract: destination - source
    Min,              ///< extension blend_minmax
    Max,              ///< extension blend_minmax
};
/// Extension blend_separate: alpha has factors and an equation of its own.
struct BlendAlphaState {
    bool separate = false;
    BlendFactor src = BlendFactor::One, dst = BlendFactor::Zero;
    BlendEquation equation = BlendEquation::Add;
    bool operator==(const BlendAlphaState&) const = default;
};
struct BlendState {
    bool enable = false;
    BlendFactor src = BlendFactor::One, dst = BlendFactor::Zero;
    BlendEquation equation = BlendEquation::Add;
    vec4 color{0, 0, 0, 0};  ///< of the constant factors
    BlendAlphaState alpha;
    bool operator==(const BlendState&) const = default;
};
/// The factors and the equation of some channels.
struct BlendRule {
    BlendFactor src, dst;
    BlendEquation equation;
};
constexpr BlendRule color_rule(const BlendState& b) { return {b.src, b.dst, b.equation}; }
constexpr BlendRule alpha_rule(const BlendState& b) {
    return b.alpha.separate ? BlendRule{b.alpha.src, b.alpha.dst, b.alpha.equation} : color_rule(b);
}
/// Whether it adds the colours: the blend of the passes of [K3].
constexpr bool adds_colors(const BlendState& b) {
    return b.src == BlendFactor::One && b.dst == BlendFactor::One &&
           b.equation == BlendEquation::Add && !b.alpha.separate;
}

/// glLogicOp's operations in GL's order. Bit 0 of the value is the result's bit if both bits are
/// set; bit 1: only the fragment's; bit 2: only the stored one; bit 3: neither.
enum class LogicOp : std::uint8_t {
    Clear,
    And,
    AndReverse,
    Copy,
    AndInverted,
    Noop,
    Xor,
    Or,
    Nor,
    Equiv,
    Invert,
    OrReverse,
    CopyInverted,
    OrInverted,
    Nand,
    Set
};
/// Extension logic_op: combines the bits of the fragment's colour with those of the plane. If it is
/// enabled, blending is off.
struct LogicOpState {
    bool enable = false;
    LogicOp op = LogicOp::Copy;
    bool operator==(const LogicOpState&) const = default;
};

struct ColorMask {
    bool r = true, g = true, b = true, a = true;
    bool operator==(const ColorMask&) const = default;
};

/// The colour planes that fragments, clears, copies and returns write to. [GL11] 4.2.1
enum class DrawBuffer : std::uint8_t { None, Front, Back, FrontAndBack };
/// The colour plane that copies, read-backs and accumulation read. [GL11] 4.3.2
enum class ReadBuffer : std::uint8_t { Front, Back };

/// The whole state. A machine starts with State{}; SetState replaces all of it.
struct State {
    dmat4 projection{1};    ///< clip_from_eye
    bool normalize = true;  ///< normals have length 1 after the transform; GL's initial value: off
    ViewportState viewport;
    DepthRangeState depth_range;
    std::array<ClipPlane, max_clip_planes> clip_planes{};
    CullState cull;
    PolygonMode polygon_mode = PolygonMode::Fill;
    /// extension two_sided_polygon_mode: back faces have their own mode
    bool two_side_polygon_mode = false;
    PolygonMode back_polygon_mode = PolygonMode::Fill;
    LineStippleState line_stipple;
    PolygonStippleState polygon_stipple;
    PolygonOffsetState polygon_offset;
    JitterState jitter;
    float point_size = 1;  ///< pixels, 1 .. 128; whole pixels unless smooth
    float line_width = 1;  ///< pixels, 1 .. 128; whole pixels unless smooth
    /// Antialiasing, if the profile has coverage_bits: alpha is multiplied by the covered part of
    /// the pixel.
    bool point_smooth = false, line_smooth = false, polygon_smooth = false;
    ShadeModel shade_model = ShadeModel::Smooth;
    ColorSource color_source = ColorSource::Vertex;
    LightingState lighting;
    FogState fog;
    TextureState texture;  ///< how texels are used; the draw names the texture
    ScissorState scissor;
    AlphaState alpha;
    StencilState stencil;
    DepthState depth;
    BlendState blend;
    LogicOpState logic_op;
    ColorMask color_mask;
    DrawBuffer draw_buffer = DrawBuffer::Front;
    ReadBuffer read_buffer = ReadBuffer::Front;
    bool operator==(const State&) const = default;
};
/// Whether a primitive of any kind is antialiased.
constexpr bool antialiases(const State& s) {
    return s.point_smooth || s.line_smooth || s.polygon_smooth;
}

}  // namespace gw
