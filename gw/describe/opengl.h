// OpenGL's number of each of the state's words, and the extension that brings the word. A line for
// each enumerator, in order: one that is missing does not compile. Does not need OpenGL's headers.
#pragma once

#include "gw/command_list.h"
#include "gw/describe/enumerators.h"
#include "gw/profile.h"

#include <array>
#include <cstdint>
#include <optional>

namespace gw {

template <class Enum>
struct OpenglWord {
    Enum word;
    std::uint32_t number;
    bool Extensions::*extension = nullptr;
};
template <class Enum>
inline constexpr OpenglWord<Enum> opengl_words[] = {};

template <>
inline constexpr OpenglWord<CompareFunc> opengl_words<CompareFunc>[] = {
    {CompareFunc::Never, 0x0200},     // GL_NEVER
    {CompareFunc::Less, 0x0201},      // GL_LESS
    {CompareFunc::Equal, 0x0202},     // GL_EQUAL
    {CompareFunc::LEqual, 0x0203},    // GL_LEQUAL
    {CompareFunc::Greater, 0x0204},   // GL_GREATER
    {CompareFunc::NotEqual, 0x0205},  // GL_NOTEQUAL
    {CompareFunc::GEqual, 0x0206},    // GL_GEQUAL
    {CompareFunc::Always, 0x0207},    // GL_ALWAYS
};
template <>
inline constexpr OpenglWord<StencilOp> opengl_words<StencilOp>[] = {
    {StencilOp::Keep, 0x1E00},                                 // GL_KEEP
    {StencilOp::Zero, 0},                                      // GL_ZERO
    {StencilOp::Replace, 0x1E01},                              // GL_REPLACE
    {StencilOp::Incr, 0x1E02},                                 // GL_INCR
    {StencilOp::Decr, 0x1E03},                                 // GL_DECR
    {StencilOp::Invert, 0x150A},                               // GL_INVERT
    {StencilOp::IncrWrap, 0x8507, &Extensions::stencil_wrap},  // GL_INCR_WRAP
    {StencilOp::DecrWrap, 0x8508, &Extensions::stencil_wrap},  // GL_DECR_WRAP
};
template <>
inline constexpr OpenglWord<BlendFactor> opengl_words<BlendFactor>[] = {
    {BlendFactor::Zero, 0},                   // GL_ZERO
    {BlendFactor::One, 1},                    // GL_ONE
    {BlendFactor::SrcColor, 0x0300},          // GL_SRC_COLOR
    {BlendFactor::OneMinusSrcColor, 0x0301},  // GL_ONE_MINUS_SRC_COLOR
    {BlendFactor::DstColor, 0x0306},          // GL_DST_COLOR
    {BlendFactor::OneMinusDstColor, 0x0307},  // GL_ONE_MINUS_DST_COLOR
    {BlendFactor::SrcAlpha, 0x0302},          // GL_SRC_ALPHA
    {BlendFactor::OneMinusSrcAlpha, 0x0303},  // GL_ONE_MINUS_SRC_ALPHA
    {BlendFactor::DstAlpha, 0x0304},          // GL_DST_ALPHA
    {BlendFactor::OneMinusDstAlpha, 0x0305},  // GL_ONE_MINUS_DST_ALPHA
    {BlendFactor::SrcAlphaSaturate, 0x0308},  // GL_SRC_ALPHA_SATURATE
    // GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA
    {BlendFactor::ConstantColor, 0x8001, &Extensions::blend_color},
    {BlendFactor::OneMinusConstantColor, 0x8002, &Extensions::blend_color},
    {BlendFactor::ConstantAlpha, 0x8003, &Extensions::blend_color},
    {BlendFactor::OneMinusConstantAlpha, 0x8004, &Extensions::blend_color},
};
template <>
inline constexpr OpenglWord<BlendEquation> opengl_words<BlendEquation>[] = {
    // GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX
    {BlendEquation::Add, 0x8006},
    {BlendEquation::Subtract, 0x800A, &Extensions::blend_subtract},
    {BlendEquation::ReverseSubtract, 0x800B, &Extensions::blend_subtract},
    {BlendEquation::Min, 0x8007, &Extensions::blend_minmax},
    {BlendEquation::Max, 0x8008, &Extensions::blend_minmax},
};
template <>
inline constexpr OpenglWord<LogicOp> opengl_words<LogicOp>[] = {
    {LogicOp::Clear, 0x1500},         // GL_CLEAR
    {LogicOp::And, 0x1501},           // GL_AND
    {LogicOp::AndReverse, 0x1502},    // GL_AND_REVERSE
    {LogicOp::Copy, 0x1503},          // GL_COPY
    {LogicOp::AndInverted, 0x1504},   // GL_AND_INVERTED
    {LogicOp::Noop, 0x1505},          // GL_NOOP
    {LogicOp::Xor, 0x1506},           // GL_XOR
    {LogicOp::Or, 0x1507},            // GL_OR
    {LogicOp::Nor, 0x1508},           // GL_NOR
    {LogicOp::Equiv, 0x1509},         // GL_EQUIV
    {LogicOp::Invert, 0x150A},        // GL_INVERT
    {LogicOp::OrReverse, 0x150B},     // GL_OR_REVERSE
    {LogicOp::CopyInverted, 0x150C},  // GL_COPY_INVERTED
    {LogicOp::OrInverted, 0x150D},    // GL_OR_INVERTED
    {LogicOp::Nand, 0x150E},          // GL_NAND
    {LogicOp::Set, 0x150F},           // GL_SET
};
template <>
inline constexpr OpenglWord<ClipOrigin> opengl_words<ClipOrigin>[] = {
    {ClipOrigin::LowerLeft, 0x8CA1},                             // GL_LOWER_LEFT
    {ClipOrigin::UpperLeft, 0x8CA2, &Extensions::clip_control},  // GL_UPPER_LEFT
};
template <>
inline constexpr OpenglWord<ClipDepth> opengl_words<ClipDepth>[] = {
    {ClipDepth::NegativeOneToOne, 0x935E},                      // GL_NEGATIVE_ONE_TO_ONE
    {ClipDepth::ZeroToOne, 0x935F, &Extensions::clip_control},  // GL_ZERO_TO_ONE
};
template <>
inline constexpr OpenglWord<Face> opengl_words<Face>[] = {
    {Face::Front, 0x0404},         // GL_FRONT
    {Face::Back, 0x0405},          // GL_BACK
    {Face::FrontAndBack, 0x0408},  // GL_FRONT_AND_BACK
};
template <>
inline constexpr OpenglWord<Winding> opengl_words<Winding>[] = {
    {Winding::CW, 0x0900},   // GL_CW
    {Winding::CCW, 0x0901},  // GL_CCW
};
template <>
inline constexpr OpenglWord<PolygonMode> opengl_words<PolygonMode>[] = {
    {PolygonMode::Point, 0x1B00},  // GL_POINT
    {PolygonMode::Line, 0x1B01},   // GL_LINE
    {PolygonMode::Fill, 0x1B02},   // GL_FILL
};
template <>
inline constexpr OpenglWord<ShadeModel> opengl_words<ShadeModel>[] = {
    {ShadeModel::Flat, 0x1D00},    // GL_FLAT
    {ShadeModel::Smooth, 0x1D01},  // GL_SMOOTH
};
template <>
inline constexpr OpenglWord<ColorMaterial> opengl_words<ColorMaterial>[] = {
    {ColorMaterial::Emission, 0x1600},           // GL_EMISSION
    {ColorMaterial::Ambient, 0x1200},            // GL_AMBIENT
    {ColorMaterial::Diffuse, 0x1201},            // GL_DIFFUSE
    {ColorMaterial::Specular, 0x1202},           // GL_SPECULAR
    {ColorMaterial::AmbientAndDiffuse, 0x1602},  // GL_AMBIENT_AND_DIFFUSE
};
template <>
inline constexpr OpenglWord<FogMode> opengl_words<FogMode>[] = {
    {FogMode::Linear, 0x2601},  // GL_LINEAR
    {FogMode::Exp, 0x0800},     // GL_EXP
    {FogMode::Exp2, 0x0801},    // GL_EXP2
};
template <>
inline constexpr OpenglWord<FogSource> opengl_words<FogSource>[] = {
    {FogSource::Depth, 0x8452},                                    // GL_FRAGMENT_DEPTH
    {FogSource::Coordinate, 0x8451, &Extensions::fog_coordinate},  // GL_FOG_COORDINATE
};
template <>
inline constexpr OpenglWord<MinFilter> opengl_words<MinFilter>[] = {
    {MinFilter::Nearest, 0x2600},               // GL_NEAREST
    {MinFilter::Linear, 0x2601},                // GL_LINEAR
    {MinFilter::NearestMipmapNearest, 0x2700},  // GL_NEAREST_MIPMAP_NEAREST
    {MinFilter::LinearMipmapNearest, 0x2701},   // GL_LINEAR_MIPMAP_NEAREST
    {MinFilter::NearestMipmapLinear, 0x2702},   // GL_NEAREST_MIPMAP_LINEAR
    {MinFilter::LinearMipmapLinear, 0x2703},    // GL_LINEAR_MIPMAP_LINEAR
};
template <>
inline constexpr OpenglWord<MagFilter> opengl_words<MagFilter>[] = {
    {MagFilter::Nearest, 0x2600},  // GL_NEAREST
    {MagFilter::Linear, 0x2601},   // GL_LINEAR
};
/// Our Clamp has no border colour: it is OpenGL 1.2's clamp to edge.
template <>
inline constexpr OpenglWord<Wrap> opengl_words<Wrap>[] = {
    {Wrap::Repeat, 0x2901},                                      // GL_REPEAT
    {Wrap::Clamp, 0x812F},                                       // GL_CLAMP_TO_EDGE
    {Wrap::BorderClamp, 0x2900, &Extensions::texture_border},    // GL_CLAMP
    {Wrap::ClampToBorder, 0x812D, &Extensions::texture_wraps},   // GL_CLAMP_TO_BORDER
    {Wrap::MirroredRepeat, 0x8370, &Extensions::texture_wraps},  // GL_MIRRORED_REPEAT
};
template <>
inline constexpr OpenglWord<TexEnv> opengl_words<TexEnv>[] = {
    {TexEnv::Modulate, 0x2100},                               // GL_MODULATE
    {TexEnv::Decal, 0x2101},                                  // GL_DECAL
    {TexEnv::Blend, 0x0BE2},                                  // GL_BLEND
    {TexEnv::Replace, 0x1E01},                                // GL_REPLACE
    {TexEnv::Add, 0x0104, &Extensions::texture_combine},      // GL_ADD
    {TexEnv::Combine, 0x8570, &Extensions::texture_combine},  // GL_COMBINE
};
template <>
inline constexpr OpenglWord<CombineFunc> opengl_words<CombineFunc>[] = {
    {CombineFunc::Replace, 0x1E01},      // GL_REPLACE
    {CombineFunc::Modulate, 0x2100},     // GL_MODULATE
    {CombineFunc::Add, 0x0104},          // GL_ADD
    {CombineFunc::AddSigned, 0x8574},    // GL_ADD_SIGNED
    {CombineFunc::Interpolate, 0x8575},  // GL_INTERPOLATE
    {CombineFunc::Subtract, 0x84E7},     // GL_SUBTRACT
    {CombineFunc::Dot3Rgb, 0x86AE},      // GL_DOT3_RGB
    {CombineFunc::Dot3Rgba, 0x86AF},     // GL_DOT3_RGBA
};
template <>
inline constexpr OpenglWord<CombineSource> opengl_words<CombineSource>[] = {
    {CombineSource::Texture, 0x1702},       // GL_TEXTURE
    {CombineSource::Constant, 0x8576},      // GL_CONSTANT
    {CombineSource::PrimaryColor, 0x8577},  // GL_PRIMARY_COLOR
    {CombineSource::Previous, 0x8578},      // GL_PREVIOUS
    // GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE3
    {CombineSource::Texture0, 0x84C0, &Extensions::texture_units},
    {CombineSource::Texture1, 0x84C1, &Extensions::texture_units},
    {CombineSource::Texture2, 0x84C2, &Extensions::texture_units},
    {CombineSource::Texture3, 0x84C3, &Extensions::texture_units},
};
template <>
inline constexpr OpenglWord<CombineOperand> opengl_words<CombineOperand>[] = {
    {CombineOperand::Color, 0x0300},          // GL_SRC_COLOR
    {CombineOperand::OneMinusColor, 0x0301},  // GL_ONE_MINUS_SRC_COLOR
    {CombineOperand::Alpha, 0x0302},          // GL_SRC_ALPHA
    {CombineOperand::OneMinusAlpha, 0x0303},  // GL_ONE_MINUS_SRC_ALPHA
};
template <>
inline constexpr OpenglWord<AccumOp> opengl_words<AccumOp>[] = {
    {AccumOp::Accum, 0x0100},   // GL_ACCUM
    {AccumOp::Load, 0x0101},    // GL_LOAD
    {AccumOp::Add, 0x0104},     // GL_ADD
    {AccumOp::Mult, 0x0103},    // GL_MULT
    {AccumOp::Return, 0x0102},  // GL_RETURN
};

/// Whether the table has every enumerator at its place.
template <class Enum>
constexpr bool has_all_words() {
    std::size_t i = 0;
    for (const OpenglWord<Enum>& w : opengl_words<Enum>)
        if (std::size_t(w.word) != i++) return false;
    return i == count_of<Enum>;
}
template <class Enum>
constexpr const OpenglWord<Enum>& opengl_word(Enum value) {
    static_assert(has_all_words<Enum>());
    return opengl_words<Enum>[std::size_t(value)];
}

template <class Enum>
constexpr std::optional<Enum> from_opengl(std::uint32_t number) {
    static_assert(has_all_words<Enum>());
    for (const OpenglWord<Enum>& w : opengl_words<Enum>)
        if (w.number == number) return w.word;
    return {};
}

template <class Enum>
constexpr bool has_word(const Extensions& extensions, Enum value) {
    const auto extension = opengl_word(value).extension;
    return extension == nullptr || extensions.*extension;
}

/// [GL11] tables 4.1 and 4.2: each colour is a factor of one side only. Extension blend_square:
/// of both.
constexpr bool is_source(BlendFactor f) {
    return f != BlendFactor::SrcColor && f != BlendFactor::OneMinusSrcColor;
}
constexpr bool is_destination(BlendFactor f) {
    return f != BlendFactor::DstColor && f != BlendFactor::OneMinusDstColor &&
           f != BlendFactor::SrcAlphaSaturate;
}

}  // namespace gw
