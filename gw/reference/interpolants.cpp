#include "gw/reference/interpolants.h"

#include "gw/stages/fog.h"
#include "gw/stages/raster/points.h"

#include <algorithm>
#include <cmath>

namespace gw::reference {
namespace {

std::array<std::int64_t, 3> gather(std::span<const Corner> corners, const auto& value) {
    std::array<std::int64_t, 3> a{};
    for (std::size_t i = 0; i < corners.size(); ++i) a[i] = value(corners[i]);
    return a;
}

std::vector<double> gather_doubles(std::span<const Corner> corners, const auto& value) {
    std::vector<double> a;
    for (const Corner& c : corners) a.push_back(value(c));
    return a;
}

PerspectiveValue perspective_value(const Numerators& n, const PlaneMaker& plane) {
    return {plane(n.at), n.offset, n.exponent, {}};
}

PlaneSlope slope_of(const PlaneEquation& p, int x, int y) {
    return {static_cast<double>(p.gx), static_cast<double>(p.gy), static_cast<double>(p.at(x, y))};
}

using Channels = std::array<std::int64_t, 4>;

ColorPlanes color_planes(std::span<const Corner> corners, const PlaneMaker& plane,
                         Channels Corner::*color, bool in_perspective, int bits) {
    ColorPlanes planes;
    const auto w = gather_doubles(corners, [](const Corner& c) { return c.window.w; });
    const double max = max_of_bits(bits);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto a = gather(corners, [&](const Corner& c) { return (c.*color)[i]; });
        const auto [low, high] =
            std::minmax_element(a.begin(), a.begin() + std::ptrdiff_t(corners.size()));
        planes.range[i] = {*low, *high};
        if (!in_perspective) {
            planes.plane[i] = plane(a);
            continue;
        }
        const auto fractions =
            gather_doubles(corners, [&](const Corner& c) { return double((c.*color)[i]) / max; });
        planes.numerator[i] = plane(numerators(fractions, w, 0).at);
    }
    return planes;
}

void set_fog(Interpolants& v, std::span<const Corner> corners, const PlaneMaker& plane,
             const Resolved& r) {
    const auto w = gather_doubles(corners, [](const Corner& c) { return c.window.w; });
    if (fog_is_direct(r.state.fog, r.fragment_fog)) {
        const auto f = gather_doubles(corners, [](const Corner& c) { return c.fog; });
        v.fog_coordinate = perspective_value(fog_numerators(f, w), plane);
    } else if (r.fragment_fog) {
        const auto f = gather_doubles(corners, [](const Corner& c) { return std::abs(c.fog); });
        v.fog_coordinate = perspective_value(numerators(f, w, 0, largest_fog_exponent), plane);
    } else {
        v.fog =
            plane(gather(corners, [](const Corner& c) { return std::int64_t(round_even(c.fog)); }));
    }
}

void set_slopes(const Interpolants& values, TextureValues& v) {
    const auto slope = [&](const PlaneEquation& p) {
        return slope_of(p, values.slope_x, values.slope_y);
    };
    v.q_slope = slope(v.q);
    for (PerspectiveValue* const c : {&v.s, &v.t, &v.r}) {
        c->plane_slope = slope(c->plane);
        c->slope = coordinate_slope(c->plane_slope, v.q_slope);
    }
}

void set_texture(Interpolants& values, std::size_t unit, std::span<const Corner> corners,
                 const PlaneMaker& plane, const TextureState& state) {
    TextureValues& v = values.textures[unit];
    const auto w = gather_doubles(corners, [](const Corner& c) { return c.window.w; });
    if (v.projective) {
        std::vector<dvec4> strq;
        for (const Corner& c : corners) strq.push_back(c.texcoord_of(unit));
        const Projective p = projective(strq, w);
        v.q = plane(p.denominator);
        v.s = perspective_value(p.numerator[0], plane);
        v.t = perspective_value(p.numerator[1], plane);
        v.r = perspective_value(p.numerator[2], plane);
    } else {
        const auto along = [&](int c) {
            return gather_doubles(corners,
                                  [&](const Corner& at) { return at.texcoord_of(unit)[c]; });
        };
        v.q = values.q;
        v.s = perspective_value(texture_numerators(along(0), w, repeats(state.wrap_s)), plane);
        v.t = perspective_value(texture_numerators(along(1), w, repeats(state.wrap_t)), plane);
    }
    set_slopes(values, v);
}

}  // namespace

float reciprocal(const PlaneEquation& q, int x, int y) {
    return 1.0f / static_cast<float>(q.at(x, y));
}

float PerspectiveValue::at(int x, int y, float w) const {
    return static_cast<float>(plane.at(x, y)) * w;
}

Interpolants interpolants(std::span<const Corner> corners, const PlaneMaker& plane,
                          const Resolved& r, const Profile& profile, const TextureUses& textures) {
    Interpolants v;
    v.depth = plane(gather(corners, [](const Corner& c) { return std::int64_t{c.window.z}; }));
    const auto w = gather_doubles(corners, [](const Corner& c) { return c.window.w; });
    v.q = plane(denominators(w));
    v.slope_x = static_cast<int>(v.depth.x0 >> profile.subpixel_bits);
    v.slope_y = static_cast<int>(v.depth.y0 >> profile.subpixel_bits);
    v.perspective_color = profile.perspective_color && r.state.shade_model == ShadeModel::Smooth;
    const auto colors = [&](Channels Corner::*color) {
        return color_planes(corners, plane, color, v.perspective_color, r.bits);
    };
    v.color = colors(&Corner::color);
    if (sums_colors(r.state)) v.secondary = colors(&Corner::secondary);
    if (r.state.fog.enable) set_fog(v, corners, plane, r);
    for (std::size_t unit = 0; unit < textures.size(); ++unit) {
        v.textures[unit].projective = textures[unit] == TextureUse::Projective;
        if (textures[unit] != TextureUse::None)
            set_texture(v, unit, corners, plane, texture_of(r.state, unit));
    }
    return v;
}

void set_sprite(Interpolants& values, std::size_t unit, int size, bool without_t) {
    TextureValues& v = values.textures[unit];
    const auto plane = [&](std::int64_t at, std::int64_t gx, std::int64_t gy) {
        PlaneEquation p = plane_constant(at, values.depth.subpixel_bits);
        p.x0 = values.depth.x0;
        p.y0 = values.depth.y0;
        p.gx = gx;
        p.gy = gy;
        return p;
    };
    const std::int64_t g = sprite_gradient(size), half = sprite_denominator / 2;
    v.q = plane(sprite_denominator, 0, 0);
    v.s = {.plane = plane(half, g, 0)};
    v.t = {.plane = without_t ? plane(0, 0, 0) : plane(half, 0, -g)};
    v.r = {.plane = plane(0, 0, 0)};
    set_slopes(values, v);
}

Interpolants limited_to_pixel(Interpolants v, int x, int y) {
    const auto limit = [&](PlaneEquation& p) {
        p = plane_constant(p.limited_at(x, y), p.subpixel_bits);
    };
    /// A numerator is at most its denominator, as inside.
    const auto limit_over = [&](PlaneEquation& p, const PlaneEquation& q) {
        p = plane_constant(std::min(p.limited_at(x, y), q.at(x, y)), p.subpixel_bits);
    };
    limit(v.depth);
    limit(v.fog);
    limit(v.q);
    limit_over(v.fog_coordinate.plane, v.q);
    for (ColorPlanes* color : {&v.color, &v.secondary}) {
        for (PlaneEquation& c : color->plane) limit(c);
        for (PlaneEquation& c : color->numerator) limit_over(c, v.q);
    }
    for (TextureValues& t : v.textures) {
        limit(t.q);
        for (PerspectiveValue* coordinate : {&t.s, &t.t, &t.r})
            t.projective ? limit(coordinate->plane) : limit_over(coordinate->plane, t.q);
    }
    return v;
}

Interpolants moved(Interpolants v, const JitterState& by) {
    const auto move = [&](PlaneEquation& p) { p = moved(p, by); };
    for (PlaneEquation* const p : {&v.depth, &v.fog, &v.q, &v.fog_coordinate.plane}) move(*p);
    for (ColorPlanes* const color : {&v.color, &v.secondary}) {
        for (PlaneEquation& c : color->plane) move(c);
        for (PlaneEquation& c : color->numerator) move(c);
    }
    for (TextureValues& t : v.textures)
        for (PlaneEquation* const p : {&t.q, &t.s.plane, &t.t.plane, &t.r.plane}) move(*p);
    return v;
}

Rgba color_at(const Interpolants& v, const ColorPlanes& color, int x, int y, int bits) {
    Rgba out;
    const float w = v.perspective_color ? reciprocal(v.q, x, y) : 0;
    for (std::size_t i = 0; i < 4; ++i) {
        std::int64_t c = 0;
        if (v.perspective_color) {
            const float f =
                (static_cast<float>(color.numerator[i].at(x, y)) * w) * float(max_of_bits(bits));
            c = std::clamp(static_cast<std::int64_t>(std::nearbyint(f)), color.range[i][0],
                           color.range[i][1]);
        } else {
            c = color.plane[i].at(x, y);
        }
        out[i] = static_cast<std::uint16_t>(c);
    }
    return out;
}

}  // namespace gw::reference
