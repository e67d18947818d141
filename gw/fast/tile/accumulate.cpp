// The accumulation buffer, a block at a time. docs/manual.md, "Accumulation"; scalar twin:
// gw/stages/accumulation.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/tile/accumulate.cpp"
#include <hwy/foreach_target.h>

#include "gw/fast/simd/doubles-inl.h"
#include "gw/fast/simd/lanes-inl.h"
#include "gw/fast/tile/accumulate.h"
#include "gw/stages/accumulation.h"

#include <hwy/highway.h>

#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Any weight, lane by lane.
inline std::uint64_t accumulate_lanes(const AccumulateOp& op, const Profile& profile,
                                      AccumBlock& accum, ColorBlock& color, std::uint32_t mask) {
    const Accumulate& a = *op.accumulate;
    std::uint64_t overflows = 0;
    for (; mask != 0; mask &= mask - 1)
        for (std::size_t c = 0, i = std::size_t(std::countr_zero(mask)); c < 4; ++c) {
            std::int32_t& stored = accum.channel[c][i];
            std::uint16_t& own = color.channel[c][i];
            if (a.op == AccumOp::Return) {
                own = with_written_bits(own, returned(stored, a.value, profile),
                                        op.state.written_bits[c]);
                continue;
            }
            bool overflow = false;
            stored = wrap_accum(accumulated(a.op, stored, own, a.value, profile),
                                profile.accum_bits, overflow);
            overflows += overflow ? 1 : 0;
        }
    return overflows;
}

/// Whether the operation adds integer multiples of colours in less than 32 bits, as the sum of
/// samples does.
inline bool is_whole(const AccumulateOp& op, const Profile& profile) {
    const Accumulate& a = *op.accumulate;
    const bool adds = a.op == AccumOp::Accum || a.op == AccumOp::Load || a.op == AccumOp::Add;
    return adds && profile.accum_bits <= 30 && accum_fraction_bits(profile) == 0 &&
           std::abs(a.value) <= 256 && std::floor(a.value) == a.value;
}

/// All lanes of one channel if is_whole(). Returns the number of overflows.
inline std::uint64_t accumulate_whole(const AccumulateOp& op, int bits, std::int32_t* accum,
                                      const std::uint16_t* color) {
    const I32 d;
    const auto weight = hn::Set(d, std::int32_t(op.accumulate->value));
    const auto most = hn::Set(d, std::int32_t(max_of_bits(op.state.bits)));
    const bool adds_color = op.accumulate->op != AccumOp::Add,
               replaces = op.accumulate->op == AccumOp::Load;
    std::uint64_t overflows = 0;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto own = adds_color ? hn::PromoteTo(d, hn::Load(Half16(), color + i)) : most;
        const auto before = replaces ? hn::Zero(d) : hn::Load(d, accum + i);
        const auto v = hn::Add(before, hn::Mul(own, weight));
        const auto wrapped = hn::ShiftRightSame(hn::ShiftLeftSame(v, 32 - bits), 32 - bits);
        overflows += hn::CountTrue(d, hn::Ne(v, wrapped));
        hn::Store(wrapped, d, accum + i);
    }
    return overflows;
}

#if HWY_HAVE_FLOAT64

using U16ForD64 = hn::Rebind<std::uint16_t, D64>;

/// weighted() of gw/stages/accumulation.h, without its limit, which weights up to 256 never exceed.
inline V64 weighted_lanes(V64 a, double value) { return nearest(hn::Mul(a, all(value))); }

/// wrap_accum(): exact, as integers below 2^52.
inline V64 wrapped_lanes(V64 v, int bits) {
    const auto range = static_cast<double>(std::int64_t{1} << bits);
    const auto turns = hn::Floor(hn::Mul(hn::Add(v, all(range / 2)), all(1 / range)));
    return hn::Sub(v, hn::Mul(turns, all(range)));
}

inline V64 load_color(const std::uint16_t* p) {
    return hn::PromoteTo(D64(), hn::PromoteTo(I32ForD64(), hn::Load(U16ForD64(), p)));
}

/// The weight of a colour, `scaled`, has R13.19's fraction bits.
inline V64 accumulated_lanes(const AccumulateOp& op, double scaled, V64 stored,
                             const std::uint16_t* color) {
    switch (op.accumulate->op) {
        case AccumOp::Accum: return hn::Add(stored, weighted_lanes(load_color(color), scaled));
        case AccumOp::Load: return weighted_lanes(load_color(color), scaled);
        case AccumOp::Add:
            return hn::Add(stored, weighted_lanes(all(max_of_bits(op.state.bits)), scaled));
        case AccumOp::Mult: return weighted_lanes(stored, double(op.accumulate->value));
        case AccumOp::Return: break;
    }
    return stored;
}

/// All lanes of one channel. Returns the number of overflows.
inline std::uint64_t accumulate_channel(const AccumulateOp& op, const Profile& profile,
                                        std::int32_t* accum, const std::uint16_t* color) {
    const I32ForD64 i32;
    const double scaled = std::ldexp(double(op.accumulate->value), accum_fraction_bits(profile));
    std::uint64_t overflows = 0;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(i32)) {
        const auto stored = hn::PromoteTo(D64(), hn::Load(i32, accum + i));
        const auto v = accumulated_lanes(op, scaled, stored, color + i);
        const auto wrapped = wrapped_lanes(v, profile.accum_bits);
        overflows += hn::CountTrue(D64(), hn::Ne(v, wrapped));
        hn::Store(hn::DemoteTo(i32, wrapped), i32, accum + i);
    }
    return overflows;
}

inline void return_channel(const AccumulateOp& op, const Profile& profile,
                           const std::int32_t* accum, std::uint16_t* color) {
    const I32ForD64 i32;
    const double scaled = std::ldexp(double(op.accumulate->value), -accum_fraction_bits(profile));
    const auto zero = hn::Zero(D64()), most = all(max_of_bits(op.state.bits));
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(i32)) {
        const auto v = weighted_lanes(hn::PromoteTo(D64(), hn::Load(i32, accum + i)), scaled);
        const auto clamped = hn::DemoteTo(i32, hn::Max(zero, hn::Min(v, most)));
        hn::Store(hn::DemoteTo(U16ForD64(), clamped), U16ForD64(), color + i);
    }
}

/// Any weight, all lanes at once if the products are exact.
inline std::uint64_t accumulate_any(const AccumulateOp& op, const Profile& profile,
                                    AccumBlock& accum, ColorBlock& color, std::uint32_t mask) {
    if (mask != 0xFFFF || !(std::abs(op.accumulate->value) <= 256) || op.state.writes_part_bits)
        return accumulate_lanes(op, profile, accum, color, mask);
    std::uint64_t overflows = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        if (op.accumulate->op != AccumOp::Return)
            overflows += accumulate_channel(op, profile, accum.channel[c], color.channel[c]);
        else if (op.state.written_bits[c] != 0)
            return_channel(op, profile, accum.channel[c], color.channel[c]);
    }
    return overflows;
}

#else  // no vectors of doubles here

inline std::uint64_t accumulate_any(const AccumulateOp& op, const Profile& profile,
                                    AccumBlock& accum, ColorBlock& color, std::uint32_t mask) {
    return accumulate_lanes(op, profile, accum, color, mask);
}

#endif

std::uint64_t accumulate_all(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                             ColorBlock& color, std::uint32_t mask) {
    if (mask != 0xFFFF || !is_whole(op, profile))
        return accumulate_any(op, profile, accum, color, mask);
    std::uint64_t overflows = 0;
    for (std::size_t c = 0; c < 4; ++c)
        overflows += accumulate_whole(op, profile.accum_bits, accum.channel[c], color.channel[c]);
    return overflows;
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gw::fast {

HWY_EXPORT(accumulate_all);

std::uint64_t accumulate_block(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                               ColorBlock& color, std::uint32_t mask) {
    return HWY_DYNAMIC_DISPATCH(accumulate_all)(op, profile, accum, color, mask);
}

}  // namespace gw::fast
#endif  // HWY_ONCE
