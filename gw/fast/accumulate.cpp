// The accumulation buffer, a block at a time. docs/manual.md, "Accumulation"; scalar twin: gw/accumulation.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gw/fast/accumulate.cpp"
#include <hwy/foreach_target.h>

#include "gw/accumulation.h"
#include "gw/fast/doubles-inl.h"
#include "gw/fast/kernels.h"

#include <hwy/highway.h>

#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

inline std::array<bool, 4> writable(const AccumulateOp& op) {
    const ColorMask& m = op.state.state.color_mask;
    return {m.r, m.g, m.b, m.a};
}

/// Any weight, lane by lane.
inline std::uint64_t accumulate_lanes(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                                      ColorBlock& color, std::uint32_t mask) {
    const Accumulate& a = *op.accumulate;
    const std::array<bool, 4> channel = writable(op);
    std::uint64_t overflows = 0;
    for (; mask != 0; mask &= mask - 1)
        for (std::size_t c = 0, i = std::size_t(std::countr_zero(mask)); c < 4; ++c) {
            std::int32_t& stored = accum.channel[c][i];
            std::uint16_t& own = color.channel[c][i];
            if (a.op == AccumOp::Return) {
                if (channel[c]) own = returned(stored, a.value, op.state.bits);
                continue;
            }
            bool overflow = false;
            stored = wrap_accum(accumulated(a.op, stored, own, a.value, op.state.bits), profile.accum_bits,
                                overflow);
            overflows += overflow ? 1 : 0;
        }
    return overflows;
}

#if HWY_HAVE_FLOAT64

using U16ForD64 = hn::Rebind<std::uint16_t, D64>;

/// weighted() of gw/accumulation.h: with weights up to 256 nothing comes near its limit.
inline V64 weighted_lanes(V64 a, double value) { return nearest(hn::Mul(a, all(value))); }

/// wrap_accum(): exact, as integers below 2^52.
inline V64 wrapped_lanes(V64 v, int bits) {
    const double range = std::ldexp(1.0, bits);
    const auto turns = hn::Floor(hn::Mul(hn::Add(v, all(range / 2)), all(1 / range)));
    return hn::Sub(v, hn::Mul(turns, all(range)));
}

inline V64 load_color(const std::uint16_t* p) {
    return hn::PromoteTo(D64(), hn::PromoteTo(I32ForD64(), hn::Load(U16ForD64(), p)));
}

inline V64 accumulated_lanes(const AccumulateOp& op, V64 stored, const std::uint16_t* color) {
    const double value = op.accumulate->value;
    switch (op.accumulate->op) {
        case AccumOp::Accum: return hn::Add(stored, weighted_lanes(load_color(color), value));
        case AccumOp::Load: return weighted_lanes(load_color(color), value);
        case AccumOp::Add: return hn::Add(stored, weighted_lanes(all(max_of_bits(op.state.bits)), value));
        case AccumOp::Mult: return weighted_lanes(stored, value);
        case AccumOp::Return: break;
    }
    return stored;
}

/// All lanes of one channel; how many overflowed.
inline std::uint64_t accumulate_channel(const AccumulateOp& op, int bits, std::int32_t* accum,
                                        const std::uint16_t* color) {
    const I32ForD64 i32;
    std::uint64_t overflows = 0;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(i32)) {
        const auto stored = hn::PromoteTo(D64(), hn::Load(i32, accum + i));
        const auto v = accumulated_lanes(op, stored, color + i), wrapped = wrapped_lanes(v, bits);
        overflows += hn::CountTrue(D64(), hn::Ne(v, wrapped));
        hn::Store(hn::DemoteTo(i32, wrapped), i32, accum + i);
    }
    return overflows;
}

inline void return_channel(const AccumulateOp& op, const std::int32_t* accum, std::uint16_t* color) {
    const I32ForD64 i32;
    const auto zero = hn::Zero(D64()), most = all(max_of_bits(op.state.bits));
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(i32)) {
        const auto v = weighted_lanes(hn::PromoteTo(D64(), hn::Load(i32, accum + i)), op.accumulate->value);
        const auto clamped = hn::DemoteTo(i32, hn::Max(zero, hn::Min(v, most)));
        hn::Store(hn::DemoteTo(U16ForD64(), clamped), U16ForD64(), color + i);
    }
}

std::uint64_t accumulate_all(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                             ColorBlock& color, std::uint32_t mask) {
    if (mask != 0xFFFF || !(std::abs(op.accumulate->value) <= 256))
        return accumulate_lanes(op, profile, accum, color, mask);
    const std::array<bool, 4> channel = writable(op);
    std::uint64_t overflows = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        if (op.accumulate->op != AccumOp::Return)
            overflows += accumulate_channel(op, profile.accum_bits, accum.channel[c], color.channel[c]);
        else if (channel[c])
            return_channel(op, accum.channel[c], color.channel[c]);
    }
    return overflows;
}

#else  // no vectors of doubles here

std::uint64_t accumulate_all(const AccumulateOp& op, const Profile& profile, AccumBlock& accum,
                             ColorBlock& color, std::uint32_t mask) {
    return accumulate_lanes(op, profile, accum, color, mask);
}

#endif

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
