// The pipeline's state: OpenGL 1.1's words and initial values. One struct per group, plain data.
// docs/vocabulary.md gives IRIS GL's words. Does not compute anything.
#pragma once

#include "gw/base/types.h"
#include "gw/texture_state.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace gw {

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

/// Extension clip_control: the row of the window where y = -1 is, and the range of z / w in the
/// view volume.
enum class ClipOrigin : std::uint8_t { LowerLeft, UpperLeft };
enum class ClipDepth : std::uint8_t { NegativeOneToOne, ZeroToOne };
struct ClipControlState {
    ClipOrigin origin = ClipOrigin::LowerLeft;
    ClipDepth depth = ClipDepth::NegativeOneToOne;
    bool operator==(const ClipControlState&) const = default;
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

/// Extension point_parameters: a point's size is point_size / sqrt(constant + linear d + quadratic
/// d^2), d its distance from the eye, within min_size .. max_size pixels.
struct PointParameters {
    float constant = 1, linear = 0, quadratic = 0;
    float min_size = 1, max_size = 128;
    bool operator==(const PointParameters&) const = default;
};

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
    /// extension secondary_color: highlights are a colour of their own, added after texture
    bool separate_specular = false;
    bool operator==(const LightingState&) const = default;
};

enum class FogMode : std::uint8_t { Linear, Exp, Exp2 };
enum class FogCoordinate : std::uint8_t { Profile, Vertex, Fragment };
/// The distance of fog.
enum class FogSource : std::uint8_t {
    Depth,       ///< in front of the eye
    Coordinate,  ///< extension fog_coordinate: the vertex's fog coordinate, of any sign
};
struct FogState {
    bool enable = false;
    FogMode mode = FogMode::Exp;
    float density = 1, start = 0, end = 1;  ///< in eye units
    vec4 color{0, 0, 0, 0};
    FogCoordinate coordinate = FogCoordinate::Profile;
    FogSource source = FogSource::Depth;
    bool operator==(const FogState&) const = default;
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

/// Extension multisample: the samples of a fragment, on surfaces that have samples.
struct MultisampleState {
    bool enable = true;  ///< each sample has a place of its own; else all are at the centre
    bool alpha_to_coverage = false;  ///< alpha says how many samples stay
    bool alpha_to_one = false;       ///< alpha is one after that
    bool coverage_test = false;  ///< only this part of the samples stays, or, inverted, the others:
    float coverage = 1;          ///< clamped to [0, 1]
    bool invert = false;
    bool operator==(const MultisampleState&) const = default;
};

struct ColorMask {
    bool r = true, g = true, b = true, a = true;
    bool operator==(const ColorMask&) const = default;
};
/// The bits of a channel that are written, if the colour mask has the channel. Bits above color_bits
/// have no effect.
struct ColorMaskBits {
    std::uint16_t r = 0xFFFF, g = 0xFFFF, b = 0xFFFF, a = 0xFFFF;
    bool operator==(const ColorMaskBits&) const = default;
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
    ClipControlState clip_control;
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
    PointParameters point_parameters;
    /// Extension point_sprite: points are squares; TextureState::coord_replace
    bool point_sprite = false;
    float line_width = 1;        ///< pixels, 1 .. 128; whole pixels unless smooth
    bool diamond_lines = false;  ///< lines without antialiasing have OpenGL's pixels. [GL11] 3.4.1
    /// Antialiasing, if the profile has coverage_bits: alpha is multiplied by the covered part of
    /// the pixel.
    bool point_smooth = false, line_smooth = false, polygon_smooth = false;
    ShadeModel shade_model = ShadeModel::Smooth;
    ColorSource color_source = ColorSource::Vertex;
    LightingState lighting;
    bool color_sum = false;  ///< extension secondary_color: of ColorSource::Vertex
    FogState fog;
    TextureState texture;  ///< how texels are used; the draw names the texture
    MoreTextures more_textures;
    ScissorState scissor;
    AlphaState alpha;
    StencilState stencil;
    DepthState depth;
    BlendState blend;
    LogicOpState logic_op;
    ColorMask color_mask;
    ColorMaskBits color_mask_bits;
    MultisampleState multisample;
    DrawBuffer draw_buffer = DrawBuffer::Front;
    ReadBuffer read_buffer = ReadBuffer::Front;
    bool operator==(const State&) const = default;
};
/// Whether fragments add their secondary colour after texture.
constexpr bool sums_colors(const State& s) {
    return s.color_source == ColorSource::Lighting
               ? s.lighting.separate_specular
               : s.color_sum && s.color_source == ColorSource::Vertex;
}
/// How a unit uses its texels.
const TextureState& texture_of(const State& state, std::size_t unit);

/// Whether a primitive of any kind is antialiased.
constexpr bool antialiases(const State& s) {
    return s.point_smooth || s.line_smooth || s.polygon_smooth;
}

}  // namespace gw
