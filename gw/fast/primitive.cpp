// Set-up of a primitive's planes from its vertices' values.
#include "gw/fast/primitive.h"

#include "gw/arithmetic.h"
#include "gw/fog.h"

#include <algorithm>
#include <cmath>

namespace gw::fast {
namespace {

using Values = std::array<std::int64_t, 3>;

struct Maker {
    const TileDraw& draw;
    const SetupPrimitive& primitive;
    const PrimitiveFrame& frame;
    PrimitivePlanes& out;

    const DrawOp& op() const { return *draw.op; }
    const State& state() const { return op().state.state; }
    std::size_t corners() const {
        return primitive.kind == MeshKind::Triangles ? 3 : primitive.kind == MeshKind::Lines ? 2 : 1;
    }
    /// One value per corner.
    template <typename T>
    std::array<T, 3> gather(const auto& value) const {
        std::array<T, 3> a{};
        for (std::size_t i = 0; i < corners(); ++i) a[i] = value(primitive.vertex[i]);
        return a;
    }
    std::array<double, 3> w() const {
        return gather<double>([&](std::uint32_t v) { return op().set->w[v]; });
    }
    std::span<const double> used(const std::array<double, 3>& a) const {
        return std::span(a).first(corners());
    }

    void depth() {
        const Values z = gather<std::int64_t>([&](std::uint32_t v) { return std::int64_t{op().set->z[v]}; });
        out.depth = frame.plane(z);
        const PolygonOffsetState& offset = state().polygon_offset;
        out.depth_offset = 0;
        if (!offset.enable || primitive.kind != MeshKind::Triangles) return;
        const double limit = double(max_of_bits(draw.profile->depth_bits)) + 1;
        const auto g = frame.exact_gradients(z);
        const auto steep = [](int128 v) { return v < 0 ? -v : v; };
        const double m = double(std::min(std::max(steep(g[0]), steep(g[1])), int128{1} << 62));
        out.depth_offset = to_integer(
            round_even(double(offset.factor) * m / 65536) + round_even(offset.units), -limit, limit);
    }

    void id_color() {
        const Draw& d = *op().draw;
        const std::uint32_t id = (d.id_base + d.mesh->polygon_id(primitive.polygon)) >> d.id_shift;
        const std::uint32_t value[4] = {id & 255, (id >> 8) & 255, (id >> 16) & 255,
                                        max_of_bits(op().state.bits)};
        for (std::size_t c = 0; c < 4; ++c) constant_color(c, value[c]);
    }
    void constant_color(std::size_t c, std::uint32_t v) { out.color[c] = PrimitiveFrame::constant(v); }

    void color() {
        out.perspective_color = false;
        if (state().color_source == ColorSource::PolygonId) return id_color();
        const ShadedVertices& shaded = *op().shaded;
        const std::vector<Rgba>& from = primitive.front || shaded.back.empty() ? shaded.front : shaded.back;
        if (state().shade_model == ShadeModel::Flat) {
            for (std::size_t c = 0; c < 4; ++c) constant_color(c, from[primitive.provoking][c]);
            return;
        }
        out.perspective_color = op().perspective_color;
        for (std::size_t c = 0; c < 4; ++c) {
            const Values a = gather<std::int64_t>([&](std::uint32_t v) { return std::int64_t{from[v][c]}; });
            if (out.perspective_color)
                perspective(c, a);
            else
                out.color[c] = frame.plane(a);
        }
    }
    void perspective(std::size_t c, const Values& a) {
        const double max = max_of_bits(op().state.bits);
        std::array<double, 3> fractions{};
        for (std::size_t i = 0; i < corners(); ++i) fractions[i] = double(a[i]) / max;
        const auto [low, high] = std::minmax_element(a.begin(), a.begin() + std::ptrdiff_t(corners()));
        out.color_low[c] = std::uint32_t(*low), out.color_high[c] = std::uint32_t(*high);
        out.color[c] = frame.plane(numerators(used(fractions), used(w()), 0).at);
    }

    void fog() {
        const auto f = gather<double>([&](std::uint32_t v) { return op().shaded->fog[v]; });
        if (!op().fog_table) {
            out.fog = frame.plane({std::int64_t(round_even(f[0])), std::int64_t(round_even(f[1])),
                                   std::int64_t(round_even(f[2]))});
            return;
        }
        const Numerators n = numerators(used(f), used(w()), 0, largest_fog_exponent);
        out.fog = frame.plane(n.at);
        out.fog_scale = float(std::ldexp(1.0, n.exponent + fog_table_log2(op().state.bits) + 8));
    }

    static double integer_part(std::span<const double> s, Wrap wrap) {
        const double k = std::floor(*std::min_element(s.begin(), s.end()));
        return wrap == Wrap::Repeat ? k : std::clamp(k, -1024.0, 1023.0);
    }

    TexturePlane texture_plane(const Numerators& n, Wrap wrap, int log2_size) const {
        TexturePlane t{frame.plane(n.at),
                       float(std::ldexp(1.0, n.exponent + log2_size + 8)),
                       0,
                       n.exponent,
                       n.offset,
                       {}};
        if (wrap == Wrap::Clamp) t.offset = std::int32_t(n.offset) * (1 << (log2_size + 8));
        return t;
    }

    void texture() {
        const TextureState& ts = state().texture;
        const TexelLevel& level = op().texels->texels.levels[0];
        out.projective = ts.gen == TexGen::EyeLinear;
        out.texture_by_pixel = out.projective || ts.shadow_compare || needs_rho(ts);
        Numerators s, t;
        Values q;
        if (out.projective) {
            const auto strq = gather<dvec4>([&](std::uint32_t v) { return op().shaded->texcoord[v]; });
            const Projective p = projective(std::span(strq).first(corners()), used(w()));
            q = p.denominator;
            s = p.numerator[0], t = p.numerator[1];
            out.r = texture_plane(p.numerator[2], Wrap::Repeat, 0);
        } else {
            const auto x = gather<double>([&](std::uint32_t v) { return op().shaded->texcoord[v].x; });
            const auto y = gather<double>([&](std::uint32_t v) { return op().shaded->texcoord[v].y; });
            q = denominators(used(w()));
            s = numerators(used(x), used(w()), integer_part(used(x), ts.wrap_s));
            t = numerators(used(y), used(w()), integer_part(used(y), ts.wrap_t));
        }
        out.texture_q = frame.plane(q);
        out.s = texture_plane(s, ts.wrap_s, level.log2_width);
        out.t = texture_plane(t, ts.wrap_t, level.log2_height);
        if (needs_rho(ts)) slopes(q, s.at, t.at);
    }

    /// The exact value of a plane at the pixel of its base vertex, and its gradients before they wrap.
    PlaneSlope slope_of(const Values& a) const {
        PlaneSlope p;
        const auto g = frame.exact_gradients(a);
        const int128 step = (g[0] * frame.ax + g[1] * frame.ay) >> frame.s;
        p.gx = double(g[0]), p.gy = double(g[1]);
        p.value = double(std::int64_t(((int128{a[frame.base]} << 16) + (1 << 15) + step) >> 16));
        return p;
    }
    void slopes(const Values& q, const Values& s, const Values& t) {
        out.slope_x = draw.tile.x - int(frame.to_x), out.slope_y = draw.tile.y - int(frame.to_y);
        const PlaneSlope base = slope_of(q);
        out.s.slope = coordinate_slope(slope_of(s), base);
        out.t.slope = coordinate_slope(slope_of(t), base);
    }
};

}  // namespace

void make_planes(const TileDraw& draw, const SetupPrimitive& primitive, const PrimitiveFrame& frame,
                 PrimitivePlanes& out) {
    const DrawOp& op = *draw.op;
    Maker make{draw, primitive, frame, out};
    out.front = primitive.front != 0;
    make.depth();
    if (!op.needs_color) return;
    make.color();
    const bool exact_id = op.state.state.color_source == ColorSource::PolygonId;
    const bool fogged = op.state.state.fog.enable && !exact_id;
    if (out.perspective_color || op.texels || (fogged && op.fog_table))
        out.q = frame.plane(denominators(make.used(make.w())));
    if (fogged) make.fog();
    if (op.texels) make.texture();
}

}  // namespace gw::fast
