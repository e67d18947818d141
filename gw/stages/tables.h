// The tables of the fragment operations, in the specification's polarity.
// docs/manual/fragments.md; docs/manual/texture.md; docs/manual/fog.md. Does not decide when a
// table applies.
#pragma once

#include "gw/base/arithmetic.h"
#include "gw/base/types.h"
#include "gw/state.h"
#include "gw/texture.h"

#include <array>
#include <cstdint>

namespace gw {

/// [GL11] 4.1.3 to 4.1.5: whether `incoming` `func` `stored` is true. Incoming is the fragment's
/// depth or alpha, or the stencil reference; stored is the plane's value, or the alpha reference.
constexpr bool compare(CompareFunc func, std::uint32_t incoming, std::uint32_t stored) {
    switch (func) {
        case CompareFunc::Never: return false;
        case CompareFunc::Less: return incoming < stored;
        case CompareFunc::Equal: return incoming == stored;
        case CompareFunc::LEqual: return incoming <= stored;
        case CompareFunc::Greater: return incoming > stored;
        case CompareFunc::NotEqual: return incoming != stored;
        case CompareFunc::GEqual: return incoming >= stored;
        case CompareFunc::Always: return true;
    }
    return false;
}

/// [GL11] 4.1.4: the new stencil value before the write mask; `max` is 2^stencil_bits - 1.
constexpr std::uint32_t stencil_result(StencilOp op, std::uint32_t stored, std::uint32_t ref,
                                       std::uint32_t max) {
    switch (op) {
        case StencilOp::Keep: return stored;
        case StencilOp::Zero: return 0;
        case StencilOp::Replace: return ref & max;
        case StencilOp::Incr: return stored < max ? stored + 1 : max;
        case StencilOp::Decr: return stored > 0 ? stored - 1 : 0;
        case StencilOp::Invert: return ~stored & max;
        case StencilOp::IncrWrap: return (stored + 1) & max;
        case StencilOp::DecrWrap: return (stored - 1) & max;
    }
    return stored;
}

/// The colours that a blend joins.
struct BlendColors {
    Rgba src, dst, constant;
};

/// [GL11] 4.1.6, tables 4.1 and 4.2: the factor of channel `c` (3 is alpha); `max` is 1.0.
constexpr std::uint32_t blend_factor(BlendFactor factor, const BlendColors& colors, int c,
                                     std::uint32_t max) {
    const auto& [src, dst, constant] = colors;
    const auto i = std::size_t(c);
    switch (factor) {
        case BlendFactor::Zero: return 0;
        case BlendFactor::One: return max;
        case BlendFactor::SrcColor: return src[i];
        case BlendFactor::OneMinusSrcColor: return max - src[i];
        case BlendFactor::DstColor: return dst[i];
        case BlendFactor::OneMinusDstColor: return max - dst[i];
        case BlendFactor::SrcAlpha: return src[3];
        case BlendFactor::OneMinusSrcAlpha: return max - src[3];
        case BlendFactor::DstAlpha: return dst[3];
        case BlendFactor::OneMinusDstAlpha: return max - dst[3];
        case BlendFactor::SrcAlphaSaturate:
            return c == 3 ? max : std::min<std::uint32_t>(src[3], max - dst[3]);
        case BlendFactor::ConstantColor: return constant[i];
        case BlendFactor::OneMinusConstantColor: return max - constant[i];
        case BlendFactor::ConstantAlpha: return constant[3];
        case BlendFactor::OneMinusConstantAlpha: return max - constant[3];
    }
    return 0;
}

/// Two rounded products, combined by the equation and clamped; they fit 16-bit lanes. One, One adds
/// exactly.
constexpr Rgba blend(const BlendState& state, const BlendColors& colors, int bits) {
    const std::uint32_t max = max_of_bits(bits);
    Rgba out{};
    for (int c = 0; c < 4; ++c) {
        const auto i = std::size_t(c);
        const BlendRule rule = c == 3 ? alpha_rule(state) : color_rule(state);
        const std::uint32_t src = colors.src[i], dst = colors.dst[i];
        const std::uint32_t s = mul(src, blend_factor(rule.src, colors, c, max), bits);
        const std::uint32_t d = mul(dst, blend_factor(rule.dst, colors, c, max), bits);
        std::uint32_t v = 0;
        switch (rule.equation) {
            case BlendEquation::Add: v = std::min(max, s + d); break;
            case BlendEquation::Subtract: v = s > d ? s - d : 0; break;
            case BlendEquation::ReverseSubtract: v = d > s ? d - s : 0; break;
            case BlendEquation::Min: v = std::min(src, dst); break;
            case BlendEquation::Max: v = std::max(src, dst); break;
        }
        out[i] = static_cast<std::uint16_t>(v);
    }
    return out;
}

/// [GL11] 4.1.8: all bits of two channels at once; the operation's value is its truth table.
constexpr std::uint16_t logic_result(LogicOp op, unsigned src, unsigned dst, std::uint32_t max) {
    const auto table = unsigned(op);
    unsigned v = 0;
    if (table & 1) v |= src & dst;
    if (table & 2) v |= src & ~dst;
    if (table & 4) v |= ~src & dst;
    if (table & 8) v |= ~src & ~dst;
    return static_cast<std::uint16_t>(v & max);
}
constexpr Rgba logic_result(LogicOp op, const Rgba& src, const Rgba& dst, int bits) {
    Rgba out{};
    for (std::size_t i = 0; i < 4; ++i)
        out[i] = logic_result(op, src[i], dst[i], max_of_bits(bits));
    return out;
}
/// Whether the result depends on the stored colour.
constexpr bool reads_stored(const LogicOpState& s) {
    const auto table = unsigned(s.op);
    return s.enable && ((table ^ table >> 1) & 5) != 0;
}

/// What a texture environment does with a channel.
enum class EnvironmentOp : std::uint8_t { Keep, Replace, Modulate, Decal, Blend, Add };

/// [GL11] tables 3.10 and 3.11, and Add: the colour channels, or alpha. Not of Combine. Channels that a format lacks leave the
/// fragment's as it is. Decal is defined for RGB and RGBA; the others are treated as RGBA.
constexpr EnvironmentOp environment_op(TexEnv mode, TextureFormat format, bool alpha) {
    const bool has_alpha = format != TextureFormat::RGB && format != TextureFormat::Luminance;
    if (!alpha && format == TextureFormat::Alpha) return EnvironmentOp::Keep;
    if (alpha && (!has_alpha || mode == TexEnv::Decal)) return EnvironmentOp::Keep;
    switch (mode) {
        case TexEnv::Modulate: return EnvironmentOp::Modulate;
        case TexEnv::Decal: return EnvironmentOp::Decal;
        case TexEnv::Replace: return EnvironmentOp::Replace;
        case TexEnv::Blend:
        case TexEnv::Add:
        case TexEnv::Combine: break;
    }
    if (alpha && format != TextureFormat::Intensity) return EnvironmentOp::Modulate;
    return mode == TexEnv::Add ? EnvironmentOp::Add : EnvironmentOp::Blend;
}

/// The texels of a pixel, by unit.
struct UnitTexels {
    std::array<Rgba, max_texture_units> texel{};
    std::array<TextureFormat, max_texture_units> format{};
    unsigned on = 0;  ///< bit k: unit k has a texture
    constexpr bool has(std::size_t unit) const { return (on >> unit & 1) != 0; }
    constexpr void set(std::size_t unit, TextureFormat of, const Rgba& value) {
        texel[unit] = value;
        format[unit] = of;
        on |= 1u << unit;
    }
    /// Colours that the format lacks are 0.
    constexpr Rgba argument(std::size_t unit) const {
        if (format[unit] != TextureFormat::Alpha) return texel[unit];
        return {0, 0, 0, texel[unit][3]};
    }
};

/// The colours that TexEnv::Combine joins.
struct CombineInputs {
    const UnitTexels& texels;
    std::size_t unit;
    Rgba constant, primary, previous;

    constexpr Rgba of(CombineSource source) const {
        switch (source) {
            case CombineSource::Texture: return texels.argument(unit);
            case CombineSource::Constant: return constant;
            case CombineSource::PrimaryColor: return primary;
            case CombineSource::Previous: return previous;
            case CombineSource::Texture0:
            case CombineSource::Texture1:
            case CombineSource::Texture2:
            case CombineSource::Texture3: break;
        }
        return texels.argument(std::size_t(source) - std::size_t(CombineSource::Texture0));
    }
    constexpr bool has(CombineSource source) const {
        return source < CombineSource::Texture0 ||
               texels.has(std::size_t(source) - std::size_t(CombineSource::Texture0));
    }
    /// Whether the units of all arguments that the function has are on.
    constexpr bool has_arguments(const CombineState& s) const {
        const bool second = s.func != CombineFunc::Replace,
                   third = s.func == CombineFunc::Interpolate;
        return has(s.source0) && (!second || has(s.source1)) && (!third || has(s.source2));
    }
};

constexpr std::int64_t combine_argument(const Rgba& v, CombineOperand operand, std::size_t c,
                                        std::int64_t max) {
    switch (operand) {
        case CombineOperand::Color: return v[c];
        case CombineOperand::OneMinusColor: return max - v[c];
        case CombineOperand::Alpha: return v[3];
        case CombineOperand::OneMinusAlpha: break;
    }
    return max - v[3];
}

/// Four times the dot product of two arguments, each less a half: to nearest.
constexpr std::int64_t combine_dot(const CombineState& s, const CombineInputs& in, int bits) {
    const std::int64_t max = max_of_bits(bits), half = std::int64_t{1} << (bits - 1);
    std::int64_t sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
        sum += (combine_argument(in.of(s.source0), s.operand0, c, max) - half) *
               (combine_argument(in.of(s.source1), s.operand1, c, max) - half);
    return sum > 0 ? (8 * sum + max) / (2 * max) : 0;
}

/// The function of channel c, not yet scaled and clamped. Each product is rounded once.
constexpr std::int64_t combine_channel(const CombineState& s, const CombineInputs& in,
                                       std::size_t c, int bits) {
    const std::int64_t max = max_of_bits(bits);
    const std::int64_t a = combine_argument(in.of(s.source0), s.operand0, c, max),
                       b = combine_argument(in.of(s.source1), s.operand1, c, max);
    const auto product = [&](std::int64_t x, std::int64_t y) {
        return std::int64_t{mul(std::uint32_t(x), std::uint32_t(y), bits)};
    };
    switch (s.func) {
        case CombineFunc::Replace: return a;
        case CombineFunc::Modulate: return product(a, b);
        case CombineFunc::Add: return a + b;
        case CombineFunc::AddSigned: return a + b - (std::int64_t{1} << (bits - 1));
        case CombineFunc::Interpolate: {
            const std::int64_t weight = combine_argument(in.of(s.source2), s.operand2, c, max);
            return product(a, weight) + product(b, max - weight);
        }
        case CombineFunc::Subtract: return a - b;
        case CombineFunc::Dot3Rgb:
        case CombineFunc::Dot3Rgba: break;
    }
    return combine_dot(s, in, bits);
}

/// A unit that reads one that is off leaves the colour as it is.
constexpr Rgba combine(const TextureState& s, const CombineInputs& in, int bits) {
    const bool joins_alpha = s.combine_rgb.func == CombineFunc::Dot3Rgba;
    if (!in.has_arguments(s.combine_rgb) || !(joins_alpha || in.has_arguments(s.combine_alpha)))
        return in.previous;
    const std::int64_t max = max_of_bits(bits);
    Rgba out{};
    for (std::size_t c = 0; c < 4; ++c) {
        const bool own = c == 3 && !joins_alpha;
        const CombineState& by = own ? s.combine_alpha : s.combine_rgb;
        const std::int64_t v = by.scale * combine_channel(by, in, c, bits);
        out[c] = static_cast<std::uint16_t>(v < 0 ? 0 : v < max ? v : max);
    }
    return out;
}

/// `f` of the fragment, `t` of the texture, `env` constant.
constexpr Rgba texture_environment(const TextureState& s, TextureFormat format, const Rgba& f,
                                   const Rgba& t, const Rgba& env, int bits) {
    if (s.env == TexEnv::Combine) {
        UnitTexels texels;
        texels.set(0, format, t);
        return combine(s, {texels, 0, env, f, f}, bits);
    }
    const std::uint32_t max = max_of_bits(bits);
    Rgba out = f;
    for (std::size_t i = 0; i < 4; ++i) {
        std::uint32_t v = f[i];
        switch (environment_op(s.env, format, i == 3)) {
            case EnvironmentOp::Keep: break;
            case EnvironmentOp::Replace: v = t[i]; break;
            case EnvironmentOp::Modulate: v = mul(f[i], t[i], bits); break;
            case EnvironmentOp::Decal:
                v = mul(f[i], max - t[3], bits) + mul(t[i], t[3], bits);
                break;
            case EnvironmentOp::Blend:
                v = mul(f[i], max - t[i], bits) + mul(env[i], t[i], bits);
                break;
            case EnvironmentOp::Add: v = std::min<std::uint32_t>(max, f[i] + t[i]); break;
        }
        out[i] = static_cast<std::uint16_t>(v);
    }
    return out;
}

/// The environment of one of several units; `primary` is the fragment's colour before all.
constexpr Rgba unit_environment(const TextureState& s, const UnitTexels& texels, std::size_t unit,
                                const Rgba& primary, const Rgba& f, const Rgba& env, int bits) {
    if (s.env == TexEnv::Combine) return combine(s, {texels, unit, env, primary, f}, bits);
    return texture_environment(s, texels.format[unit], f, texels.texel[unit], env, bits);
}

/// The secondary colour added to R, G, B, clamped.
constexpr Rgba sum_of_colors(const Rgba& color, const Rgba& secondary, int bits) {
    const std::uint32_t max = max_of_bits(bits);
    Rgba out = color;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = static_cast<std::uint16_t>(
            std::min<std::uint32_t>(max, std::uint32_t{color[i]} + secondary[i]));
    return out;
}

/// Blends R, G, B with the fog's colour by factor `f`. A pass in black fog plus a pass of fogged
/// black is exactly fog in one pass [K3.5].
constexpr Rgba apply_fog(const Rgba& color, std::uint32_t f, const Rgba& fog, int bits) {
    const std::uint32_t max = max_of_bits(bits);
    Rgba out = color;
    for (std::size_t i = 0; i < 3; ++i)
        out[i] = static_cast<std::uint16_t>(mul(f, color[i], bits) + mul(max - f, fog[i], bits));
    return out;
}

/// The texels that a filter looks up for one value.
constexpr int texel_count(MinFilter filter) {
    switch (filter) {
        case MinFilter::Nearest: return 1;
        case MinFilter::Linear: return 4;
        case MinFilter::NearestMipmapNearest: return 1;
        case MinFilter::LinearMipmapNearest: return 4;
        case MinFilter::NearestMipmapLinear: return 2;
        case MinFilter::LinearMipmapLinear: return 8;
    }
    return 1;
}
/// Three dimensions have two slices for each filter.
constexpr int look_ups(MinFilter filter, int dimensions) {
    const int count = texel_count(filter);
    return dimensions == 3 && (count == 4 || count == 8) ? 2 * count : count;
}

}  // namespace gw
