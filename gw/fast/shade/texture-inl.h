// Textures on a block of 16 pixels: coordinates and level of detail. docs/manual.md, "Textures";
// scalar twins: gw/stages/texels.cpp, gw/reference/texture_unit.cpp. Does not combine texels with
// the fragment's colour. Included once per Highway target.
#if defined(GW_FAST_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_TEXTURE_INL_H_
#undef GW_FAST_TEXTURE_INL_H_
#else
#define GW_FAST_TEXTURE_INL_H_
#endif

#include "gw/fast/raster/primitive.h"
#include "gw/fast/shade/sampler-inl.h"
#include "gw/fast/simd/doubles-inl.h"
#include "gw/fast/simd/walk-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// The inputs of the texture unit for 16 pixels, which may belong to different primitives: values
/// of planes and their scales.
struct TextureInputs {
    alignas(64) std::uint32_t q[block_pixels], u[block_pixels], v[block_pixels];
    alignas(64) std::int32_t u_exponent[block_pixels],
        v_exponent[block_pixels], u_k[block_pixels], v_k[block_pixels];
    alignas(64) float slope[block_pixels];  ///< rho Q^2 2^16
};

/// The joined slope of a block's rows and columns: JoinedSlopes of gw/stages/perspective.h.
struct BlockSlopes {
    alignas(16) float row[block_side], column[block_side];
};

#if HWY_HAVE_FLOAT64

HWY_INLINE void find_slopes(const CoordinateSlope& u, const CoordinateSlope& v, int dx, int dy,
                            double scale_u, double scale_v, bool exact, BlockSlopes& out) {
    const hn::CappedTag<double, block_side> d;
    const hn::Rebind<float, decltype(d)> f;
    alignas(32) static constexpr double step[block_side] = {0, 1, 2, 3};
    const auto all = [&](double value) { return hn::Set(d, value); };
    const auto joined = [&](auto a, auto b) {
        const auto s = hn::Mul(hn::Abs(a), all(scale_u)), t = hn::Mul(hn::Abs(b), all(scale_v));
        if (!exact) return hn::DemoteTo(f, hn::Max(t, s));
        return hn::DemoteTo(f, hn::Sqrt(hn::Add(hn::Mul(s, s), hn::Mul(t, t))));
    };
    for (std::size_t i = 0; i < block_side; i += hn::Lanes(d)) {
        const auto x = hn::Add(all(dx), hn::Load(d, step + i)),
                   y = hn::Add(all(dy), hn::Load(d, step + i));
        hn::Store(joined(hn::Add(all(u.a), hn::Mul(all(u.k), y)),
                         hn::Add(all(v.a), hn::Mul(all(v.k), y))),
                  f, out.row + i);
        hn::Store(joined(hn::Sub(all(u.b), hn::Mul(all(u.k), x)),
                         hn::Sub(all(v.b), hn::Mul(all(v.k), x))),
                  f, out.column + i);
    }
}

#else

HWY_INLINE void find_slopes(const CoordinateSlope& u, const CoordinateSlope& v, int dx, int dy,
                            double scale_u, double scale_v, bool exact, BlockSlopes& out) {
    const auto joined = [&](double a, double b) {
        const double s = std::abs(a) * scale_u, t = std::abs(b) * scale_v;
        return static_cast<float>(exact ? std::sqrt(s * s + t * t) : std::max(s, t));
    };
    for (int i = 0; i < block_side; ++i) {
        out.row[i] = joined(u.a + double(u.k) * (dy + i), v.a + double(v.k) * (dy + i));
        out.column[i] = joined(u.b - double(u.k) * (dx + i), v.b - double(v.k) * (dx + i));
    }
}

#endif  // HWY_HAVE_FLOAT64

/// The larger slope of each lane's row and column.
HWY_INLINE void spread_slopes(const BlockSlopes& found, float* slope) {
    const hn::CappedTag<float, block_side> f;
    for (std::size_t i = 0; i < block_pixels; i += hn::Lanes(f))
        hn::Store(hn::Max(hn::Set(f, found.row[i / block_side]),
                          hn::Load(f, found.column + i % block_side)),
                  f, slope + i);
}
/// The input of rho: the larger slope of each row and column. docs/manual.md, "Level of detail".
HWY_NOINLINE inline void store_slopes(const Sampler& s, const TexturePlanes& p, const Tile& tile,
                                      int bx, int by, float* slope) {
    BlockSlopes found;
    find_slopes(p.s.slope, p.t.slope, tile.x + bx * block_side - p.slope_x,
                tile.y + by * block_side - p.slope_y,
                power_of_two(p.s.exponent + s.base().log2_width),
                power_of_two(p.t.exponent + s.base().log2_height), s.state.exact_rho, found);
    spread_slopes(found, slope);
}

/// Puts the lanes of `mask`, which one primitive covers, into the inputs.
HWY_NOINLINE inline void texture_inputs(const Sampler& s, const TexturePlanes& p, const Tile& tile,
                                        int bx, int by, std::uint32_t mask, TextureInputs& out) {
    const D32 d;
    const I32 i32;
    const F32 f;
    alignas(64) float slope[block_pixels] = {};
    if (needs_rho(s.state)) store_slopes(s, p, tile, bx, by, slope);
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const Pixels at = pixels_of(bx, by, i);
        const auto lanes = lanes_of(d, mask, i);
        const auto signed_lanes = hn::RebindMask(i32, lanes);
        store_lanes(wide_plane(p.q, at), lanes, d, out.q + i);
        store_lanes(wide_plane(p.s.plane, at), lanes, d, out.u + i);
        store_lanes(wide_plane(p.t.plane, at), lanes, d, out.v + i);
        store_lanes(hn::Set(i32, p.s.exponent), signed_lanes, i32, out.u_exponent + i);
        store_lanes(hn::Set(i32, p.t.exponent), signed_lanes, i32, out.v_exponent + i);
        store_lanes(hn::Set(i32, p.s.k), signed_lanes, i32, out.u_k + i);
        store_lanes(hn::Set(i32, p.t.k), signed_lanes, i32, out.v_k + i);
        store_lanes(hn::Load(f, slope + i), hn::RebindMask(f, lanes), f, out.slope + i);
    }
}

/// choose_level() of gw/stages/texels.h, lane by lane.
struct LevelLanes {
    hn::Mask<I32> magnify;
    VI level, next;
    V32 weight;
};

HWY_INLINE LevelLanes choose_levels(const TextureState& state, LevelRange levels, VF rho) {
    const I32 i;
    const auto bits = hn::BitCast(i, rho);
    const bool later = state.mag_filter == MagFilter::Linear &&
                       (state.min_filter == MinFilter::NearestMipmapNearest ||
                        state.min_filter == MinFilter::NearestMipmapLinear);
    const auto base = hn::Set(i, levels.base), last = hn::Set(i, levels.last);
    LevelLanes out{hn::Not(hn::Gt(bits, hn::Set(i, later ? 0x3FB504F3 : 0x3F800000))), base, base,
                   hn::Zero(D32())};
    const auto level_from = [&](int origin) {
        return hn::Add(base, hn::ShiftRight<23>(hn::Sub(bits, hn::Set(i, origin))));
    };
    switch (state.min_filter) {
        case MinFilter::Nearest:
        case MinFilter::Linear: break;
        case MinFilter::NearestMipmapNearest:
        case MinFilter::LinearMipmapNearest:
            out.level = hn::Min(hn::Max(level_from(0x3F3504F4), base), last);
            break;
        case MinFilter::NearestMipmapLinear:
        case MinFilter::LinearMipmapLinear: {
            const auto level = level_from(0x3F800000);
            const auto inside = hn::Lt(level, last);
            const auto mantissa = hn::And(hn::ShiftRight<15>(bits), hn::Set(i, 255));
            const auto weight = hn::GatherIndex(D32(), mantissa_levels().data(), mantissa);
            out.level = hn::Min(hn::Max(level, base), last);
            out.weight = hn::IfThenElseZero(hn::RebindMask(D32(), inside), weight);
            break;
        }
    }
    out.level = hn::IfThenElse(out.magnify, base, out.level);
    out.weight = hn::IfThenZeroElse(hn::RebindMask(D32(), out.magnify), out.weight);
    out.next = hn::Min(hn::Add(out.level, hn::Set(i, 1)), last);
    return out;
}

/// The lanes' texels, each at its level. Magnified and minified lanes have their own filters.
template <class Found, class From>
HWY_INLINE Found sample_level(const From& s, const Coordinates& at, VI index,
                              hn::Mask<I32> magnify) {
    const bool small = is_linear(s.state, false), large = is_linear(s.state, true);
    const typename From::Level level = s.level(index);
    if (hn::AllTrue(I32(), magnify)) return s.template lookup<Found>(at, level, large);
    const Found out = s.template lookup<Found>(at, level, small);
    if (small == large || hn::AllFalse(I32(), magnify)) return out;
    return chosen(hn::RebindMask(D32(), magnify), s.template lookup<Found>(at, level, large), out);
}

HWY_INLINE VF rho_lanes(VF slope, VF w) {
    return hn::Mul(hn::Mul(slope, hn::Mul(w, w)), hn::Set(F32(), 1.0f / 65536));
}

/// The divisions of the texture unit. They depend on pixels and planes, but not on texels.
HWY_NOINLINE inline void divide_block(const Sampler& s, const TextureInputs& in,
                                      TextureLanes& out) {
    const D32 u;
    const I32 d;
    const F32 f;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        const auto w = hn::Div(hn::Set(f, 1.0f), to_floats(hn::Load(u, in.q + i)));
        const auto over = [&](const std::uint32_t* p, const std::int32_t* exponent) {
            const auto biased = hn::Add(hn::Load(d, exponent + i), hn::Set(d, 127));
            return hn::Mul(hn::Mul(to_floats(hn::Load(u, p + i)), w),
                           hn::BitCast(f, hn::ShiftLeft<23>(biased)));
        };
        hn::Store(over(in.u, in.u_exponent), f, out.u + i);
        hn::Store(over(in.v, in.v_exponent), f, out.v + i);
        hn::Store(hn::Load(d, in.u_k + i), d, out.u_k + i);
        hn::Store(hn::Load(d, in.v_k + i), d, out.v_k + i);
        if (!needs_rho(s.state)) continue;
        hn::Store(rho_lanes(hn::Load(f, in.slope + i), w), f, out.rho + i);
    }
}

/// The same for the lanes of `mask`, which one primitive covers: reciprocals(i) of the denominators
/// of lanes i .., numerators(p.s, i) and (p.t, i).
template <class Reciprocals, class Numerators>
HWY_INLINE void divide_lanes(const Sampler& s, const TexturePlanes& p, const Tile& tile, int bx,
                             int by, std::uint32_t mask, const Reciprocals& reciprocals,
                             const Numerators& numerators, TextureLanes& out) {
    const I32 d;
    const F32 f;
    alignas(64) float slope[block_pixels] = {};
    if (needs_rho(s.state)) store_slopes(s, p, tile, bx, by, slope);
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        if (!has_part(mask, i / lanes32)) continue;
        const auto w = reciprocals(i);
        const auto over = [&](const TexturePlane& t) {
            return hn::Mul(hn::Mul(to_floats(numerators(t, i)), w),
                           hn::Set(f, static_cast<float>(power_of_two(t.exponent))));
        };
        hn::Store(over(p.s), f, out.u + i);
        hn::Store(over(p.t), f, out.v + i);
        hn::Store(hn::Set(d, p.s.k), d, out.u_k + i);
        hn::Store(hn::Set(d, p.t.k), d, out.v_k + i);
        if (needs_rho(s.state)) hn::Store(rho_lanes(hn::Load(f, slope + i), w), f, out.rho + i);
    }
}
HWY_NOINLINE inline void divide_block(const Sampler& s, const TexturePlanes& p, const Tile& tile,
                                      int bx, int by, std::uint32_t mask, TextureLanes& out) {
    const auto at = [&](std::size_t i) { return pixels_of(bx, by, i); };
    divide_lanes(
        s, p, tile, bx, by, mask, [&](std::size_t i) { return reciprocal_lanes(p.q, at(i)); },
        [&](const TexturePlane& t, std::size_t i) { return wide_plane(t.plane, at(i)); }, out);
}
/// Of these values of the planes.
HWY_NOINLINE inline void divide_block(const Sampler& s, const TexturePlanes& p,
                                      const TexelValues& values, const Tile& tile, int bx, int by,
                                      std::uint32_t mask, TextureLanes& out) {
    const auto load = [](const std::int32_t* v, std::size_t i) {
        return hn::BitCast(D32(), hn::Load(I32(), v + i));
    };
    divide_lanes(
        s, p, tile, bx, by, mask,
        [&](std::size_t i) { return hn::Div(hn::Set(F32(), 1.0f), to_floats(load(values.q, i))); },
        [&](const TexturePlane& t, std::size_t i) {
            return load(&t == &p.s ? values.s : values.t, i);
        },
        out);
}

/// Coordinates of 16 lanes, as in TextureLanes.
struct LaneCoordinates {
    const float *u, *v, *rho;
    const std::int32_t *u_k, *v_k;
};
/// From a Sampler, or what stands for one.
template <class Found, class From>
HWY_INLINE Found sample(const From& s, const Coordinates& at, const float* rho) {
    if (!needs_rho(s.state))
        return s.template lookup<Found>(at, s.base_level(),
                                        s.state.mag_filter == MagFilter::Linear);
    const I32 d;
    const LevelLanes l = choose_levels(s.state, s.levels(), hn::Load(F32(), rho));
    const Found found = sample_level<Found>(s, at, l.level, l.magnify);
    const auto mixed = hn::Gt(hn::BitCast(d, l.weight), hn::Zero(d));
    if (hn::AllFalse(d, mixed)) return found;
    return between_levels(found, sample_level<Found>(s, at, l.next, l.magnify), l.weight);
}

/// The texels of the lanes of `mask`; others may get arbitrary texels.
HWY_NOINLINE inline void sample_lanes(const Sampler& s, const LaneCoordinates& in,
                                      std::uint32_t mask, ColorBlock& out) {
    const I32 d;
    const F32 f;
    for (std::size_t i = 0; i < block_pixels; i += lanes32) {
        if (!has_part(mask, i / lanes32)) continue;
        const Coordinates at{hn::Load(f, in.u + i), hn::Load(f, in.v + i), hn::Load(d, in.u_k + i),
                             hn::Load(d, in.v_k + i)};
        const TexelLanes texel = s.has_bytes() ? sample<TexelWords>(s, at, in.rho + i).channels()
                                               : sample<TexelLanes>(s, at, in.rho + i);
        for (std::size_t k = 0; k < 4; ++k) store16(texel.channel[k], out.channel[k] + i);
    }
}
HWY_INLINE void sample_block(const Sampler& s, const TextureLanes& in, std::uint32_t mask,
                             ColorBlock& out) {
    sample_lanes(s, {in.u, in.v, in.rho, in.u_k, in.v_k}, mask, out);
}

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
