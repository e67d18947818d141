#include "gw/fast/raster/primitive.h"

#include "gw/base/arithmetic.h"
#include "gw/command_list.h"
#include "gw/fast/plan/draw_op.h"
#include "gw/fast/plan/texels.h"
#include "gw/fast/plan/tile_draw.h"
#include "gw/fast/raster/setup.h"
#include "gw/fast/vertices/vertex_values.h"
#include "gw/stages/fog.h"
#include "gw/stages/polygon_offset.h"
#include "gw/stages/raster/points.h"
#include "gw/stages/resolve.h"
#include "gw/stages/texels.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::fast {
namespace {

using Values = std::array<std::int64_t, 3>;

struct Maker {
    const TileDraw& draw;
    const SetupPrimitive& primitive;
    const PrimitiveFrame& frame;
    std::span<OuterCoordinates> limits{};  ///< by unit, made with the texture planes; empty: not
    mutable std::optional<TilePlane> made_denominator{};

    const DrawOp& op() const { return *draw.op; }
    const State& state() const { return op().state.state; }
    std::size_t corners() const {
        return primitive.kind == MeshKind::Triangles ? 3
               : primitive.kind == MeshKind::Lines   ? 2
                                                     : 1;
    }
    /// One value per corner.
    template <typename T>
    std::array<T, 3> gather(const auto& value) const {
        return {value(primitive.vertex[0]), value(primitive.vertex[1]), value(primitive.vertex[2])};
    }
    std::array<double, 3> w() const {
        return gather<double>([&](std::uint32_t v) { return op().set->w[v]; });
    }
    std::span<const double> used(const std::array<double, 3>& a) const {
        return std::span(a).first(corners());
    }

    const TilePlane& denominator() const {
        if (!made_denominator) made_denominator = frame.plane(denominators(used(w())));
        return *made_denominator;
    }

    /// The plane of a numerator; at an outer centre it is at most the denominator.
    TilePlane numerator(const Values& a) const {
        TilePlane p = frame.plane(a);
        if (frame.outer) p.c = std::min(p.c, denominator().c);
        return p;
    }

    /// The gradients before they wrap.
    std::array<int128, 2> exact(const TilePlane& p, const Values& a) const {
        if (p.sliver) return frame.exact_gradients(a);
        return {p.gx, p.gy};
    }

    void constant(ColorPlanes& out, const Rgba& color) const {
        for (std::size_t c = 0; c < 4; ++c) out.color[c] = PrimitiveFrame::constant(color[c]);
    }
    void color(ColorPlanes& out) const {
        out.perspective = false;
        if (state().color_source == ColorSource::PolygonId)
            return constant(out, id_color(draw, primitive));
        const std::vector<Rgba>& from = op().colors->of(primitive);
        if (state().shade_model == ShadeModel::Flat)
            return constant(out, from[primitive.provoking]);
        out.perspective = op().perspective_color;
        for (std::size_t c = 0; c < 4; ++c) {
            const Values a =
                gather<std::int64_t>([&](std::uint32_t v) { return std::int64_t{from[v][c]}; });
            if (out.perspective)
                perspective(out, c, a);
            else
                out.color[c] = frame.plane(a);
        }
    }
    /// The least and the greatest of a channel's values.
    template <class Colors>
    void keep_range(Colors& out, std::size_t c, const Values& a) const {
        const auto [low, high] =
            std::minmax_element(a.begin(), a.begin() + std::ptrdiff_t(corners()));
        out.low[c] = std::uint16_t(*low);
        out.high[c] = std::uint16_t(*high);
    }
    Values color_numerators(const Values& a) const {
        const double max = max_of_bits(op().state.bits);
        std::array<double, 3> fractions{};
        for (std::size_t i = 0; i < corners(); ++i) fractions[i] = double(a[i]) / max;
        return numerators(used(fractions), used(w()), 0).at;
    }
    void perspective(ColorPlanes& out, std::size_t c, const Values& a) const {
        keep_range(out, c, a);
        out.color[c] = numerator(color_numerators(a));
    }

    void outer(OuterColors& out) const {
        const std::vector<Rgba>& from = op().colors->of(primitive);
        out.constant = state().shade_model == ShadeModel::Flat;
        if (out.constant) return void(out.low = from[primitive.provoking]);
        out.one = float(max_of_bits(op().state.bits));
        out.perspective = op().perspective_color;
        if (out.perspective) out.q = frame.limited_of(denominators(used(w())));
        for (std::size_t c = 0; c < 4; ++c) {
            const Values a =
                gather<std::int64_t>([&](std::uint32_t v) { return std::int64_t{from[v][c]}; });
            keep_range(out, c, a);
            out.color[c] = frame.limited_of(out.perspective ? color_numerators(a) : a);
        }
    }

    void fog(ColorPlanes& out) const {
        auto f = gather<double>([&](std::uint32_t v) { return op().fog->value[v]; });
        if (!op().fog_table) {
            out.fog = frame.plane({std::int64_t(round_even(f[0])), std::int64_t(round_even(f[1])),
                                   std::int64_t(round_even(f[2]))});
            return;
        }
        for (double& coordinate : f) coordinate = std::abs(coordinate);
        const Numerators n = numerators(used(f), used(w()), 0, largest_fog_exponent);
        out.fog = numerator(n.at);
        out.fog_scale = float(std::ldexp(1.0, n.exponent + fog_table_log2(op().state.bits) + 8));
    }

    GivenFog given_fog() const {
        const auto f = gather<double>([&](std::uint32_t v) { return op().fog->value[v]; });
        const Numerators n = fog_numerators(used(f), used(w()));
        return {numerator(n.at), denominator(), n.offset, n.exponent};
    }
    void secondary(ColorPlanes& out) const {
        const std::vector<Rgba>& from = op().colors->secondary_of(primitive);
        const bool flat = state().shade_model == ShadeModel::Flat;
        out.perspective = draw.profile->perspective_color && !flat;
        if (out.perspective) out.q = denominator();
        for (std::size_t c = 0; c < 3; ++c) {
            const Values a = gather<std::int64_t>([&](std::uint32_t v) {
                return std::int64_t{from[flat ? primitive.provoking : v][c]};
            });
            if (out.perspective)
                perspective(out, c, a);
            else
                out.color[c] = frame.plane(a);
        }
    }

    static TexturePlane texture_plane(const TilePlane& plane, const Numerators& n, Wrap wrap) {
        return {plane, n.exponent, std::int32_t(added_part(n.offset, wrap)), {}};
    }
    Numerators coordinate(const VertexTexcoords& of, int c, Wrap wrap) const {
        const auto s = gather<double>([&](std::uint32_t v) { return of.strq[v][c]; });
        return texture_numerators(used(s), used(w()), repeats(wrap));
    }

    void texture(TexturePlanes& out) const {
        if (!op().units) return texture(out, 0, {op().texels, op().texcoords, op().projective});
        out.more.resize(max_texture_units - 1);
        for (std::size_t unit = 0; unit < max_texture_units; ++unit)
            if ((*op().units)[unit].texels)
                texture(unit == 0 ? out : out.more[unit - 1], unit, (*op().units)[unit]);
    }

    /// s and t from 0 to 1, t downwards, or 0.
    void sprite(TexturePlanes& out, const UnitOp& unit, bool without_t) const {
        const std::int64_t g = sprite_gradient(whole_size(frame.point_size)),
                           half = sprite_denominator / 2;
        out.q = PrimitiveFrame::constant(sprite_denominator);
        out.s = {.plane = frame.sprite_plane(half, g, 0)};
        out.t = {.plane =
                     without_t ? PrimitiveFrame::constant(0) : frame.sprite_plane(half, 0, -g)};
        out.r = {.plane = PrimitiveFrame::constant(0)};
        const Values at{half, half, half}, zero{}, q{sprite_denominator};
        slopes(out, q, at, without_t ? zero : at);
        if (unit.texels->texels.with_r) {
            out.q_slope = slope_of(out.q, q);
            out.s.plane_slope = slope_of(out.s.plane, at);
            out.t.plane_slope = slope_of(out.t.plane, without_t ? zero : at);
            out.r.plane_slope = slope_of(out.r.plane, zero);
        }
        if (!frame.at_place) return;
        out.s.plane = frame.sprite_plane_at_place(half, g, 0);
        if (!without_t) out.t.plane = frame.sprite_plane_at_place(half, 0, -g);
    }

    void texture(TexturePlanes& out, std::size_t number, const UnitOp& unit) const {
        out.has_limits = false;
        if (primitive.kind == MeshKind::Points && is_sprite(state(), number))
            return sprite(out, unit, is_one_dimensional(*op().draws[0], number));
        const TextureState& ts = texture_of(state(), number);
        Numerators s, t, r;
        Values q;
        if (unit.projective) {
            const auto strq =
                gather<dvec4>([&](std::uint32_t v) { return unit.texcoords->strq[v]; });
            const Projective p = projective(std::span(strq).first(corners()), used(w()));
            q = p.denominator;
            s = p.numerator[0];
            t = p.numerator[1];
            r = p.numerator[2];
            out.r = texture_plane(frame.plane(r.at), r, Wrap::Repeat);
        } else {
            q = denominators(used(w()));
            s = coordinate(*unit.texcoords, 0, ts.wrap_s);
            t = coordinate(*unit.texcoords, 1, ts.wrap_t);
            out.r = {};
        }
        out.q = frame.plane(q);
        const auto plane = [&](const Numerators& n) {
            return unit.projective ? frame.plane(n.at) : numerator(n.at);
        };
        out.s = texture_plane(plane(s), s, ts.wrap_s);
        out.t = texture_plane(plane(t), t, ts.wrap_t);
        if (!limits.empty())
            limits[number] = {frame.limited_of(q), frame.limited_of(s.at), frame.limited_of(t.at),
                              frame.limited_of(r.at), !unit.projective};
        if (!needs_rho(ts)) return;
        slopes(out, q, s.at, t.at);
        if (!unit.texels->texels.with_r) return;
        out.q_slope = slope_of(out.q, q);
        out.s.plane_slope = slope_of(out.s.plane, s.at);
        out.t.plane_slope = slope_of(out.t.plane, t.at);
        out.r.plane_slope = slope_of(out.r.plane, r.at);
    }

    /// The exact value of a plane at the pixel of its base vertex, and its gradients before they
    /// wrap.
    PlaneSlope slope_of(const TilePlane& p, const Values& a) const {
        const auto g = exact(p, a);
        const int128 step = (g[0] * frame.ax + g[1] * frame.ay) >> frame.s;
        return {double(g[0]), double(g[1]),
                double(std::int64_t(((int128{a[frame.base]} << 16) + (1 << 15) + step) >> 16))};
    }
    void slopes(TexturePlanes& out, const Values& q, const Values& s, const Values& t) const {
        out.slope_x = draw.tile.x - int(frame.to_x);
        out.slope_y = draw.tile.y - int(frame.to_y);
        const PlaneSlope base = slope_of(out.q, q);
        out.s.slope = coordinate_slope(slope_of(out.s.plane, s), base);
        out.t.slope = coordinate_slope(slope_of(out.t.plane, t), base);
    }
};

}  // namespace

DepthPlane depth_plane(const TileDraw& draw, const SetupPrimitive& primitive,
                       const PrimitiveFrame& frame) {
    const Maker make{draw, primitive, frame};
    const Values z = make.gather<std::int64_t>(
        [&](std::uint32_t v) { return std::int64_t{draw.op->set->at[v].z}; });
    DepthPlane out{frame.plane(z), 0};
    const PolygonOffsetState& offset = make.state().polygon_offset;
    const GeometrySet& set = *draw.op->set;
    if (primitive.kind != MeshKind::Triangles) {
        const auto slope =
            set.outline_slope.find(std::uint32_t(&primitive - set.primitives.data()));
        if (slope != set.outline_slope.end())
            out.offset = depth_offset(offset, slope->second, draw.profile->depth_bits);
        return out;
    }
    if (!offset.enable) return out;
    const auto g = make.exact(out.plane, z);
    out.offset = depth_offset(offset, offset_slope(g[0], g[1]), draw.profile->depth_bits);
    return out;
}

void make_color_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                       const PrimitiveFrame& frame, ColorPlanes& out) {
    const Maker make{draw, primitive, frame};
    out.has_limits = false;
    make.color(out);
    if (make.state().color_source == ColorSource::PolygonId) return;
    if (out.perspective || draw.op->fog_table) out.q = make.denominator();
    if (make.state().fog.enable) make.fog(out);
}

bool OuterColors::applies_to(const DrawOp& op, const SetupPrimitive& primitive) {
    return op.colors && !op.fog && !has_rare_values(op) &&
           (!op.texels || primitive.kind == MeshKind::Triangles);
}

OuterColors::OuterColors(const TileDraw& draw, const SetupPrimitive& primitive,
                         const PrimitiveFrame& frame) {
    Maker{draw, primitive, frame}.outer(*this);
}

Rgba OuterColors::at(const PrimitiveFrame& frame) const {
    if (constant) return low;
    const std::int64_t x = frame.place_x, y = frame.place_y;
    Rgba out;
    const std::int64_t denominator = perspective ? q.at(x, y) : 0;
    const float w = perspective ? 1.0f / float(denominator) : 0;
    for (std::size_t c = 0; c < 4; ++c) {
        std::int64_t v = color[c].at(x, y);
        if (frame.outer && perspective) v = std::min(v, denominator);
        if (perspective)
            v = std::clamp<std::int64_t>(std::int64_t(std::nearbyint((float(v) * w) * one)), low[c],
                                         high[c]);
        out[c] = std::uint16_t(v);
    }
    return out;
}

OuterTextures::OuterTextures(const TileDraw& draw, const SetupPrimitive& primitive,
                             const PrimitiveFrame& frame) {
    if (draw.op->texels) Maker{draw, primitive, frame, units_}.texture(planes_);
}

const TexturePlanes& OuterTextures::at(const PrimitiveFrame& frame) {
    const auto move = [&](const LimitedPlane& limited, TilePlane& plane) {
        plane = PrimitiveFrame::constant(limited.at(frame.place_x, frame.place_y));
    };
    for (std::size_t unit = 0; unit < 1 + planes_.more.size(); ++unit) {
        TexturePlanes& p = unit == 0 ? planes_ : planes_.more[unit - 1];
        const OuterCoordinates& of = units_[unit];
        move(of.q, p.q);
        move(of.s, p.s.plane);
        move(of.t, p.t.plane);
        move(of.r, p.r.plane);
        if (!of.below_q) continue;
        p.s.plane.c = std::min(p.s.plane.c, p.q.c);
        p.t.plane.c = std::min(p.t.plane.c, p.q.c);
    }
    return planes_;
}

void make_secondary_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                           const PrimitiveFrame& frame, ColorPlanes& out) {
    Maker{draw, primitive, frame}.secondary(out);
}
GivenFog given_fog(const TileDraw& draw, const SetupPrimitive& primitive,
                   const PrimitiveFrame& frame) {
    return Maker{draw, primitive, frame}.given_fog();
}

namespace {

const Draw& draw_of(const DrawOp& op, const SetupPrimitive& primitive) {
    return *op.draws[primitive.part - op.group->first_part];
}

}  // namespace

float point_size_of(const TileDraw& draw, const SetupPrimitive& primitive) {
    const DrawOp& op = *draw.op;
    return gw::point_size_of(op.state.state, draw_of(op, primitive),
                             primitive.vertex[0] - op.set->parts[primitive.part].vertex);
}

Rgba id_color(const TileDraw& draw, const SetupPrimitive& primitive) {
    const DrawOp& op = *draw.op;
    const Draw& d = draw_of(op, primitive);
    const std::uint32_t id = (d.id_base + d.mesh->polygon_id(primitive.polygon)) >> d.id_shift;
    return {std::uint16_t(id & 255), std::uint16_t(id >> 8 & 255), std::uint16_t(id >> 16 & 255),
            std::uint16_t(max_of_bits(op.state.bits))};
}

void make_texture_planes(const TileDraw& draw, const SetupPrimitive& primitive,
                         const PrimitiveFrame& frame, TexturePlanes& out) {
    Maker{draw, primitive, frame}.texture(out);
}

}  // namespace gw::fast
