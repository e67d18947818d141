#include "gw/stages/textures/layers.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/tables.h"

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

/// The direction of a point of a face, s and t in -1 .. 1 of the face.
dvec3 direction(int face, double s, double t) {
    const FaceRule& rule = face_rules[std::size_t(face)];
    dvec3 d(0);
    d[rule.major] = face % 2 == 0 ? 1 : -1;
    d[rule.s] = rule.s_is_negative ? -s : s;
    d[rule.t] = rule.t_is_negative ? -t : t;
    return d;
}

int face_index(double fraction, int size) {
    return std::min(int(std::floor(fraction * size)), size - 1);
}

/// The texel beyond one edge of a face: that of the neighbour at the edge.
Rgba neighbour(const Texels& texels, const TexelLevel& level, int face, int i, int j) {
    const double n = level.width;
    const FacePoint p = face_point(direction(face, (2 * i + 1 - n) / n, (2 * j + 1 - n) / n));
    return texels.at(level, face_index(p.s, level.width), face_index(p.t, level.width), p.face);
}

/// A texel of a filter that reaches over the edges. A cube has no texel beyond a corner: the mean of
/// the three around it.
Rgba seamless_texel(const Texels& texels, const TexelLevel& level, int face, int i, int j) {
    const int n = level.width;
    const int x = std::clamp(i, 0, n - 1), y = std::clamp(j, 0, n - 1);
    if (x == i && y == j) return texels.at(level, i, j, face);
    if (x == i || y == j) return neighbour(texels, level, face, i, j);
    const Rgba a = texels.at(level, x, y, face), b = neighbour(texels, level, face, i, y),
               c = neighbour(texels, level, face, x, j);
    Rgba out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = static_cast<std::uint16_t>((2 * (a[k] + b[k] + c[k]) + 3) / 6);
    return out;
}

/// Linear (R10.11) of a face, positions u and v.
Rgba seamless_lookup(const Texels& texels, const TexelLevel& level, int face, int u, int v) {
    const int us = u - 128, vs = v - 128, i = us >> 8, j = vs >> 8;
    const auto at = [&](int x, int y) { return seamless_texel(texels, level, face, x, y); };
    const Rgba a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    Rgba out;
    for (std::size_t k = 0; k < 4; ++k)
        out[k] = bilinear(a[k], b[k], c[k], d[k], std::uint32_t(us & 255), std::uint32_t(vs & 255),
                          texels.bits);
    return out;
}

/// The texels of one slice, or the border.
Rgba slice(const Texels& texels, const TexelLevel& level, bool linear, const Addressing& how, int u,
           int v, int layer) {
    if (layer < 0 || layer >= level.layers) return how.border_color;
    return lookup(texels, level, linear, how, u, v, layer);
}

/// Three dimensions: two slices, each as in two.
Rgba volume_lookup(const Texels& texels, const TexelLevel& level, bool linear,
                   const Addressing& how, const std::array<int, 3>& p) {
    const auto at = [&](int layer) { return slice(texels, level, linear, how, p[0], p[1], layer); };
    if (!linear) return at(wrap_index(how.wrap_r, p[2] >> 8, level.layers));
    const int w = clamped_position(how.wrap_r, p[2], level.layers) - 128;
    const auto layer = [&](int k) { return filter_index(how.wrap_r, (w >> 8) + k, level.layers); };
    return between_levels(at(layer(0)), at(layer(1)), std::uint32_t(w & 255));
}

Rgba grey(std::uint32_t v) {
    const auto c = static_cast<std::uint16_t>(v);
    return {c, c, c, c};
}

/// Coordinates v 2^exponent of s, t, r.
struct Point {
    std::array<double, 3> v;
    std::array<int, 3> exponent;

    double value(std::size_t c) const { return std::ldexp(v[c], exponent[c]); }
    int position(std::size_t c, int size, Wrap wrap) const {
        return any_position(v[c], exponent[c], 0, size, wrap);
    }
};

struct Unit {
    const Texels& texels;
    const TextureState& state;
    const ResolvedTexture& resolved;
    Addressing how = addressing(state, texels, resolved.border_color);

    int base() const { return level_range(state, int(texels.levels.size())).base; }
    const TexelLevel& level(int i) const { return texels.levels[std::size_t(i)]; }

    Rgba sample(const Point& at, const FacePoint& on_face, int index, bool linear) const {
        const TexelLevel& l = level(index);
        if (texels.cube) {
            const auto position = [&](double v) { return int(std::floor(v * (256.0 * l.width))); };
            const int u = position(on_face.s), v = position(on_face.t);
            if (linear && state.seamless) return seamless_lookup(texels, l, on_face.face, u, v);
            return lookup(texels, l, linear, how, u, v, on_face.face);
        }
        const std::array<int, 3> p{at.position(0, l.width, how.wrap_s),
                                   at.position(1, l.height, how.wrap_t),
                                   at.position(2, l.layers, how.wrap_r)};
        if (texels.dimensions == 3) return volume_lookup(texels, l, linear, how, p);
        return lookup(texels, l, linear, how, p[0], p[1]);
    }

    /// r against the depth of the nearest texel.
    Rgba compared(const Point& at) const {
        const int bits = texels.depth_bits;
        const TexelLevel& l = level(base());
        const std::uint32_t stored =
            nearest_depth(texels, l, how, at.position(0, l.width, how.wrap_s) >> 8,
                          at.position(1, l.height, how.wrap_t) >> 8, state.border_color.x);
        const auto incoming = static_cast<std::uint32_t>(to_integer(
            std::floor(std::ldexp(at.v[2], at.exponent[2] + bits)), 0, max_of_bits(bits)));
        const std::uint32_t one = max_of_bits(texels.bits);
        return completed(texels.format,
                         grey(compare(state.compare_func, incoming, stored) ? one : 0),
                         static_cast<std::uint16_t>(one));
    }

    /// The joined slopes in texels of the base level, times the square of the denominator.
    double slope(const PixelCoordinates& at) const {
        const TexelLevel& l = level(base());
        const std::array<int, 3> sides{l.width, l.height, l.layers};
        JoinedSlopes joined{state.exact_rho};
        for (std::size_t c = 0; c < std::size_t(texels.dimensions == 3 ? 3 : 2); ++c) {
            const PixelCoordinate& own = at.at[c];
            joined.add(coordinate_slope(own.slope, at.q_slope), at.dx, at.dy,
                       std::ldexp(double(sides[c]), own.exponent));
        }
        return joined.value();
    }
    double face_slope(const PixelCoordinates& at, const FaceRule& rule) const {
        const PixelCoordinate& major = at.at[std::size_t(rule.major)];
        JoinedSlopes joined{state.exact_rho};
        for (const int c : {rule.s, rule.t}) {
            const PixelCoordinate& own = at.at[std::size_t(c)];
            joined.add(coordinate_slope(own.slope, major.slope), at.dx, at.dy,
                       std::ldexp(double(level(base()).width), own.exponent - major.exponent - 1));
        }
        return joined.value();
    }
    float rho(const PixelCoordinates& at, const FacePoint& on_face) const {
        const FaceRule& rule = face_rules[std::size_t(on_face.face)];
        const std::int64_t q = texels.cube ? std::abs(at.at[std::size_t(rule.major)].u) : at.q;
        if (q == 0) return 0;
        const float w = 1.0f / static_cast<float>(q);
        const double most = texels.cube ? face_slope(at, rule) : slope(at);
        const float found = (static_cast<float>(most) * (w * w)) * (1.0f / 65536);
        return std::min(std::max(found * resolved.rho_scale, resolved.least_rho),
                        resolved.greatest_rho);
    }
};

FacePoint point_on_face(const Texels& texels, const Point& at) {
    return texels.cube ? face_point({at.value(0), at.value(1), at.value(2)}) : FacePoint{};
}

}  // namespace

FacePoint face_point(const dvec3& d) {
    FacePoint out{.face = face_of(d.x, d.y, d.z)};
    const FaceRule& rule = face_rules[std::size_t(out.face)];
    const double major = std::abs(d[rule.major]);
    if (!(major > 0)) return out;
    const auto coordinate = [&](int c, bool is_negative) {
        return ((is_negative ? -d[c] : d[c]) / major + 1) / 2;
    };
    out.s = coordinate(rule.s, rule.s_is_negative);
    out.t = coordinate(rule.t, rule.t_is_negative);
    return out;
}

Rgba face_texel(const Texels& texels, const TexelLevel& level, bool seamless, int face, int i,
                int j) {
    if (seamless) return seamless_texel(texels, level, face, i, j);
    return filter_texel(texels, level, {Wrap::Clamp, Wrap::Clamp}, i, j, face);
}

Rgba texel_with_r(const Texels& texels, const TextureState& state, const ResolvedTexture& resolved,
                  const PixelCoordinates& at) {
    if (at.q < 1) return grey(max_of_bits(texels.bits));
    const Unit unit{texels, state, resolved};
    Point point;
    for (std::size_t c = 0; c < 3; ++c) {
        point.v[c] = double(at.at[c].u) / double(at.q);
        point.exponent[c] = at.at[c].exponent;
    }
    if (state.shadow_compare) return unit.compared(point);
    const FacePoint on_face = point_on_face(texels, point);
    LevelChoice choice{.magnify = true, .level = unit.base()};
    if (needs_rho(state))
        choice = choose_level(state, unit.rho(at, on_face), int(texels.levels.size()));
    const auto sample = [&](int level) {
        return unit.sample(point, on_face, level, is_linear(state, choice.magnify));
    };
    if (choice.weight == 0) return sample(choice.level);
    return between_levels(sample(choice.level), sample(choice.next), choice.weight);
}

Rgba texel_in_place(const Texels& texels, const TextureState& state,
                    const ResolvedTexture& resolved, const vec4& strq) {
    const double q = strq.w;
    if (q <= 0) return grey(max_of_bits(texels.bits));
    const Unit unit{texels, state, resolved};
    const Point point{{strq.x / q, strq.y / q, strq.z / q}, {0, 0, 0}};
    if (state.shadow_compare) return unit.compared(point);
    return unit.sample(point, point_on_face(texels, point), unit.base(), is_linear(state, true));
}

}  // namespace gw
