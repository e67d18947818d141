// Colours and texels of a primitive's pixels with outer centres: planes limited to the values at the
// corners (R9.28), or at the first covered sample (R17.8). Scalar twin:
// gw/reference/interpolants.cpp. Does not test. Included once per Highway target.
#if defined(GW_FAST_OUTER_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GW_FAST_OUTER_PIXELS_INL_H_
#undef GW_FAST_OUTER_PIXELS_INL_H_
#else
#define GW_FAST_OUTER_PIXELS_INL_H_
#endif

#include "gw/fast/raster/outer_frame.h"
#include "gw/fast/shade/batch-inl.h"
#include "gw/stages/raster/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace gw::fast::HWY_NAMESPACE {

/// Lanes of a block, by sample.
using SampleLanes = std::array<std::uint32_t, max_samples>;

/// The colour of a pixel, the lane of `mask`, at the place of a frame.
HWY_NOINLINE inline const ColorBlock& outer_color(const TileDraw& draw,
                                                  const SetupPrimitive& primitive,
                                                  const PrimitiveFrame& at, int bx, int by,
                                                  std::uint32_t mask, ShadeInputs& in) {
    ColorPlanes color;
    make_color_planes(draw, primitive, at, color);
    wide_colors(color, *draw.op, bx, by, mask, in);
    if (draw.op->sums_colors) {
        ColorPlanes secondary;
        make_secondary_planes(draw, primitive, at, secondary);
        interpolated_color(secondary, draw.op->state.bits, bx, by, mask, in.secondary);
    }
    if (draw.op->direct_fog)
        find_given_fog_lanes(given_fog(draw, primitive, at), draw, bx, by, mask, in.fog);
    if (draw.op->texels) {
        TexturePlanes texture;
        make_texture_planes(draw, primitive, at, texture);
        look_up(texture, draw, bx, by, mask, in);
    }
    return shaded(draw, in.texels[0], in);
}

/// Copies one lane of a block.
HWY_INLINE void copy_lane(const ColorBlock& from, int lane, ColorBlock& to) {
    for (std::size_t c = 0; c < 4; ++c) to.channel[c][lane] = from.channel[c][lane];
}

/// Values at outer centres: planes are limited.
class OuterCenters {
public:
    static constexpr bool are_limited = true;

    OuterCenters(const BatchPlanes& planes, std::size_t) : draw_(planes.draw) {}
    HWY_INLINE std::int64_t value(const TilePlane& p, const PlaneLimits& limits, int i, int j,
                                  int) const {
        return limits.at(p, i, j);
    }
    HWY_INLINE PrimitiveFrame frame(const PrimitiveFrame& f, int bx, int by, int lane) const {
        return outer_frame(draw_, f, bx, by, lane);
    }

private:
    const TileDraw& draw_;
};

/// Values at the first covered samples.
class FirstSamples {
public:
    static constexpr bool are_limited = false;

    FirstSamples(const BatchPlanes& planes, std::size_t i)
        : draw_(planes.draw),
          s_(planes.corners.s),
          ax_(static_cast<std::int64_t>(planes.corners.ax[i])),
          ay_(static_cast<std::int64_t>(planes.corners.ay[i])) {
        for (int k = 0; k < draw_.op->state.samples; ++k)
            shift_[std::size_t(k)] = sample_shift(draw_.op->state.samples, k, s_);
    }
    /// The samples that the primitive covers in the next block.
    HWY_INLINE void aim(const SampleLanes& covered, std::uint32_t lanes) {
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            std::uint8_t k = 0;
            while (!(covered[k] >> lane & 1)) ++k;
            first_[lane] = k;
        }
    }
    HWY_INLINE int first(int lane) const { return first_[lane]; }
    /// R9.8 modulo 2^(64 - s), as the plane of the tile.
    HWY_INLINE std::int64_t value(const TilePlane& p, const PlaneLimits&, int i, int j,
                                  int lane) const {
        const auto u = [](std::int64_t v) { return static_cast<std::uint64_t>(v); };
        const JitterState& shift = shift_[first_[lane]];
        const std::uint64_t one = std::uint64_t{1} << s_;
        const std::uint64_t below = (u(p.gx) * u(ax_) + u(p.gy) * u(ay_)) & (one - 1);
        const std::uint64_t moved = below - u(p.gx) * u(shift.x) - u(p.gy) * u(shift.y);
        const std::uint64_t v =
            p.c + u(p.gx) * u(i) + u(p.gy) * u(j) + u(static_cast<std::int64_t>(moved) >> s_);
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(v >> 16));
    }
    HWY_INLINE PrimitiveFrame frame(const PrimitiveFrame& f, int bx, int by, int lane) const {
        return frame_at_sample(draw_, f, first(lane), bx, by, lane);
    }

private:
    const TileDraw& draw_;
    int s_;
    std::int64_t ax_, ay_;  ///< from corner 0 to the centre of its pixel
    std::array<JitterState, max_samples> shift_;
    std::array<std::uint8_t, block_pixels> first_{};
};

/// Primitive i of a batch at `Places`. The batch's planes serve where they can; if not, scalar code
/// makes planes.
template <class Places>
class OuterPixels {
public:
    HWY_INLINE static bool applies_to(const BatchPlanes& planes, std::size_t i) {
        return OuterColors::applies_to(*planes.draw.op, *planes.corners.primitive[i]);
    }

    HWY_NOINLINE OuterPixels(BatchPlanes& planes, std::size_t i, std::uint32_t ordinal)
        : places(planes, i),
          draw_(planes.draw),
          primitive_(*planes.corners.primitive[i]),
          ordinal_(ordinal),
          color_(planes.scratch.color[i]),
          texture_(planes.scratch.texture[i]) {
        planes.make();
        if (planes.narrow || !color_.perspective || !serve(color_))
            scalar_colors_.emplace(draw_, primitive_, frame());
        if (!draw_.op->texels) return;
        if (!serve_textures()) scalar_textures_.emplace(draw_, primitive_, frame());
    }

    Places places;

    /// The colours of the pixels of `outer`, and of those of `inner`, which have no outer centres.
    /// Not for limited places.
    HWY_NOINLINE const ColorBlock& color_of(BatchPlanes& planes, std::size_t i, int bx, int by,
                                            std::uint32_t inner, std::uint32_t outer) {
        ShadeInputs& in = planes.in;
        planes.evaluate(i, bx, by, inner);
        planes.flat_in = batch_capacity;  // its lanes do not stay
        if (draw_.op->texels)
            for_each_unit(*draw_.op, texture_,
                          [&](std::size_t number, const UnitOp& unit, const TexturePlanes& of) {
                              values_of(of, texture_of(draw_.op->state.state, number), unit, bx, by,
                                        values_[number]);
                          });
        put(bx, by, outer, in, inner);
        return shaded(draw_, in.texels[0], in);
    }

    /// Puts the colours and the texels of the pixels of `lanes` into the inputs of shading. Looks up
    /// the lanes of `inner` too.
    HWY_NOINLINE void put(int bx, int by, std::uint32_t lanes, ShadeInputs& in,
                          std::uint32_t inner = 0) {
        const bool looks_up = draw_.op->texels != nullptr;
        for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
            const int lane = std::countr_zero(rest);
            const Rgba color = color_at(bx, by, lane);
            for (std::size_t c = 0; c < 4; ++c) in.color.channel[c][lane] = color[c];
            if (!looks_up) continue;
            if (scalar_textures_)
                look_up_one(bx, by, lane, in);
            else
                put_values(bx, by, lane);
        }
        if (looks_up && !scalar_textures_)
            look_up(texture_, values_, draw_, bx, by, lanes | inner, in);
    }

private:
    /// A pixel next to the primitive, evaluated in 64 bits, does not wrap.
    HWY_INLINE static bool is_flat_enough(const TilePlane& p) {
        constexpr std::int64_t limit = std::int64_t{1} << 52;
        return !p.sliver && std::abs(p.gx) < limit && std::abs(p.gy) < limit;
    }
    HWY_INLINE bool serve(const ColorPlanes& p) const {
        if (!Places::are_limited) return primitive_.kind == MeshKind::Triangles;
        bool flat = is_flat_enough(p.q);
        for (std::size_t c = 0; c < 4; ++c)
            flat = flat && (p.low[c] == p.high[c] || is_flat_enough(p.color[c]));
        return p.has_limits && flat;
    }
    HWY_INLINE static bool serve(const TexturePlanes& p) {
        return p.has_limits && is_flat_enough(p.q) && is_flat_enough(p.s.plane) &&
               is_flat_enough(p.t.plane) && is_flat_enough(p.r.plane);
    }
    HWY_INLINE static const TexturePlanes& of_unit(const TexturePlanes& planes, std::size_t unit) {
        return unit == 0 ? planes : planes.more[unit - 1];
    }
    HWY_INLINE bool is_on(std::size_t unit) const {
        return draw_.op->units ? (*draw_.op->units)[unit].texels != nullptr : unit == 0;
    }
    HWY_INLINE bool is_projective(std::size_t unit) const {
        return draw_.op->units ? (*draw_.op->units)[unit].projective : draw_.op->projective;
    }
    HWY_INLINE bool serve_textures() const {
        bool all = true;
        for (std::size_t unit = 0; Places::are_limited && unit < max_texture_units; ++unit)
            all = all && (!is_on(unit) || serve(of_unit(texture_, unit)));
        return all;
    }
    HWY_NOINLINE const PrimitiveFrame& frame() {
        if (!frame_) frame_ = frame_of(draw_, ordinal_);
        return *frame_;
    }
    HWY_INLINE Rgba color_at(int bx, int by, int lane) {
        if (scalar_colors_) return scalar_colors_->at(places.frame(frame(), bx, by, lane));
        const int i = bx * block_side + lane % block_side, j = by * block_side + lane / block_side;
        const std::int64_t q = places.value(color_.q, color_.q_limits, i, j, lane);
        const float w = 1.0f / static_cast<float>(q),
                    one = static_cast<float>(max_of_bits(draw_.op->state.bits));
        Rgba out = color_.low;
        for (std::size_t c = 0; c < 4; ++c) {
            if (color_.low[c] == color_.high[c]) continue;
            std::int64_t v = places.value(color_.color[c], color_.limits[c], i, j, lane);
            if (Places::are_limited) v = std::min(v, q);
            out[c] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(
                static_cast<std::int64_t>(std::nearbyint((static_cast<float>(v) * w) * one)),
                color_.low[c], color_.high[c]));
        }
        return out;
    }
    /// Of planes made for the pixel.
    HWY_NOINLINE void look_up_one(int bx, int by, int lane, ShadeInputs& in) {
        const TexturePlanes& planes = scalar_textures_->at(places.frame(frame(), bx, by, lane));
        if (textures_by_pixel(*draw_.op)) return look_up(planes, draw_, bx, by, 1u << lane, in);
        ShadeInputs one;
        look_up(planes, draw_, bx, by, 1u << lane, one);
        copy_lane(one.texels[0], lane, in.texels[0]);
    }
    /// The values of the batch's planes.
    HWY_INLINE void put_values(int bx, int by, int lane) {
        const int i = bx * block_side + lane % block_side, j = by * block_side + lane / block_side;
        for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
            if (!is_on(unit)) continue;
            const TexturePlanes& from = of_unit(texture_, unit);
            TexelValues& to = values_[unit];
            const std::int64_t q = places.value(from.q, from.q_limits, i, j, lane);
            const auto value = [&](const TexturePlane& p) {
                const std::int64_t v = places.value(p.plane, p.limits, i, j, lane);
                return static_cast<std::int32_t>(
                    Places::are_limited && !is_projective(unit) ? std::min(v, q) : v);
            };
            to.q[lane] = static_cast<std::int32_t>(q);
            to.s[lane] = value(from.s);
            to.t[lane] = value(from.t);
            to.r[lane] = value(from.r);
        }
    }

    const TileDraw& draw_;
    const SetupPrimitive& primitive_;
    const std::uint32_t ordinal_;
    const ColorPlanes& color_;
    const TexturePlanes& texture_;
    std::optional<PrimitiveFrame> frame_;
    std::optional<OuterColors> scalar_colors_;
    std::optional<OuterTextures> scalar_textures_;
    UnitValues values_{};
};

}  // namespace gw::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard per target
