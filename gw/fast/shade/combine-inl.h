// TexEnv::Combine for a block of 16 pixels. docs/manual/texture.md, "Combining"; scalar twin: combine() of
// gw/stages/tables.h. Included once per Highway target.
#if defined(GW_FAST_COMBINE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_COMBINE_INL_H_
#undef GW_FAST_COMBINE_INL_H_
#else
#define GW_FAST_COMBINE_INL_H_
#endif

#include "gw/fast/frame/frame.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/stages/tables.h"

#include <array>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The colours that a unit joins.
struct CombineBlocks {
    std::array<const ColorBlock*, max_texture_units> texel{};  ///< null: the unit is off
    std::array<TextureFormat, max_texture_units> format{};
    std::size_t unit = 0;
    Rgba constant{};
    const ColorBlock *primary = nullptr, *previous = nullptr;
    int bits = 8;

    using I = hn::Vec<I32>;

    HWY_INLINE I channel(const ColorBlock& block, std::size_t c, std::size_t i) const {
        return hn::BitCast(I32(), load_channel(block.channel[c] + i));
    }
    /// Colours that the format lacks are 0.
    HWY_INLINE I of_unit(std::size_t k, std::size_t c, std::size_t i) const {
        if (c < 3 && format[k] == TextureFormat::Alpha) return hn::Zero(I32());
        return channel(*texel[k], c, i);
    }
    HWY_INLINE I of(CombineSource source, std::size_t c, std::size_t i) const {
        switch (source) {
            case CombineSource::Texture: return of_unit(unit, c, i);
            case CombineSource::Constant: return hn::Set(I32(), constant[c]);
            case CombineSource::PrimaryColor: return channel(*primary, c, i);
            case CombineSource::Previous: return channel(*previous, c, i);
            case CombineSource::Texture0:
            case CombineSource::Texture1:
            case CombineSource::Texture2:
            case CombineSource::Texture3: break;
        }
        return of_unit(std::size_t(source) - std::size_t(CombineSource::Texture0), c, i);
    }
    HWY_INLINE I one() const { return hn::Set(I32(), int(max_of_bits(bits))); }
    HWY_INLINE I argument(CombineSource source, CombineOperand operand, std::size_t c,
                          std::size_t i) const {
        const bool is_alpha =
            operand == CombineOperand::Alpha || operand == CombineOperand::OneMinusAlpha;
        const I v = of(source, is_alpha ? 3 : c, i);
        const bool is_rest =
            operand == CombineOperand::OneMinusColor || operand == CombineOperand::OneMinusAlpha;
        return is_rest ? hn::Sub(one(), v) : v;
    }
    HWY_INLINE I product(I x, I y) const {
        return hn::BitCast(I32(), mul_lanes(hn::BitCast(D32(), x), hn::BitCast(D32(), y), bits));
    }
    /// Four times the dot product; of a negative one no more than 0. Its numbers of 8 bits are exact in
    /// floats.
    HWY_INLINE I dot(const CombineState& s, std::size_t i) const {
        const I32 d;
        const I half = hn::Set(d, 1 << (bits - 1));
        I sum = hn::Zero(d);
        for (std::size_t c = 0; c < 3; ++c)
            sum = hn::Add(sum, hn::Mul(hn::Sub(argument(s.source0, s.operand0, c, i), half),
                                       hn::Sub(argument(s.source1, s.operand1, c, i), half)));
        const I scaled = hn::Add(hn::ShiftLeft<3>(sum), one());
        const F32 f;
        return hn::ConvertTo(
            d, hn::Div(hn::ConvertTo(f, scaled), hn::ConvertTo(f, hn::ShiftLeft<1>(one()))));
    }
    HWY_INLINE I function(const CombineState& s, std::size_t c, std::size_t i) const {
        if (s.func == CombineFunc::Dot3Rgb || s.func == CombineFunc::Dot3Rgba) return dot(s, i);
        const I a = argument(s.source0, s.operand0, c, i);
        if (s.func == CombineFunc::Replace) return a;
        const I b = argument(s.source1, s.operand1, c, i);
        switch (s.func) {
            case CombineFunc::Modulate: return product(a, b);
            case CombineFunc::Add: return hn::Add(a, b);
            case CombineFunc::Subtract: return hn::Sub(a, b);
            case CombineFunc::AddSigned:
                return hn::Sub(hn::Add(a, b), hn::Set(I32(), 1 << (bits - 1)));
            default: break;
        }
        const I weight = argument(s.source2, s.operand2, c, i);
        return hn::Add(product(a, weight), product(b, hn::Sub(one(), weight)));
    }
};

/// Whether combine_lanes() can: sums of dot products need more than 8 bits' room.
HWY_INLINE bool combines_lanes(const TextureState& s, int bits) {
    const auto is_dot = [](CombineFunc f) {
        return f == CombineFunc::Dot3Rgb || f == CombineFunc::Dot3Rgba;
    };
    return bits <= 8 || !(is_dot(s.combine_rgb.func) || is_dot(s.combine_alpha.func));
}

/// A unit that reads one that is off leaves the colour as it is. `out` may be the previous colour.
HWY_NOINLINE inline void combine_lanes(const TextureState& s, const CombineBlocks& in,
                                       ColorBlock& out) {
    UnitTexels units;
    for (std::size_t k = 0; k < max_texture_units; ++k)
        if (in.texel[k]) units.on |= 1u << k;
    const CombineInputs inputs{units, in.unit, {}, {}, {}};
    const bool joins_alpha = s.combine_rgb.func == CombineFunc::Dot3Rgba;
    if (!inputs.has_arguments(s.combine_rgb) ||
        !(joins_alpha || inputs.has_arguments(s.combine_alpha))) {
        if (in.previous != &out) out = *in.previous;
        return;
    }
    const I32 d;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        hn::Vec<I32> made[4];
        for (std::size_t c = 0; c < 4; ++c) {
            const CombineState& by = c == 3 && !joins_alpha ? s.combine_alpha : s.combine_rgb;
            const auto v = hn::Mul(in.function(by, c, i), hn::Set(d, by.scale));
            made[c] = hn::Max(hn::Zero(d), hn::Min(v, in.one()));
        }
        for (std::size_t c = 0; c < 4; ++c)
            store16(hn::BitCast(D32(), made[c]), out.channel[c] + i);
    }
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
