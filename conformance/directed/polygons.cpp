// Polygons of few places, so that corners repeat, touch sides and lie on lines: simple concave ones,
// such that touch themselves, and such that cross themselves, seen along every axis.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <algorithm>

namespace gw::conformance {

using namespace fuzz;

namespace {

using Corners = std::vector<dvec2>;

/// A height over each column, along and back: concave, sides that may touch.
Corners comb(Random& r, int columns) {
    Corners out;
    for (int i = 0; i <= columns; ++i) out.push_back({double(i), double(r.between(0, 3))});
    for (int i = columns; i >= 0; --i) out.push_back({double(i), double(r.between(3, 6))});
    return out;
}

/// Around the middle, at one of few distances each: a star.
Corners star(Random& r, int count) {
    static const std::vector<dvec2> directions{
        {3, 0},  {2, 1},   {2, 2},   {1, 2},   {0, 3},  {-1, 2}, {-2, 2}, {-3, 1},
        {-3, 0}, {-2, -1}, {-2, -2}, {-1, -3}, {0, -3}, {1, -2}, {2, -2}, {2, -1}};
    Corners out;
    for (int i = 0; i < count; ++i) {
        const double size = r.pick({0.5, 1.0, 1.0, 0.25});
        const dvec2 d = directions[std::size_t(i * 16 / count)];
        out.push_back({3 + d.x * size, 3 + d.y * size});
    }
    return out;
}

/// Any places of a grid: crosses itself nearly always, and touches itself.
Corners scribble(Random& r) {
    Corners out;
    const int count = r.between(4, 14), side = r.between(2, 6);
    for (int i = 0; i < count; ++i) {
        const double x = r.between(0, side);
        out.push_back({x, double(r.between(0, side))});
    }
    return out;
}

/// A corner again, a spike, or a corner on a side.
void disturb(Random& r, Corners& c) {
    const auto at = std::size_t(r.below(int(c.size())));
    const dvec2 a = c[at], b = c[(at + 1) % c.size()];
    const auto place = c.begin() + std::ptrdiff_t(at) + 1;
    switch (r.below(4)) {
        case 0: c.insert(place, a); break;
        case 1: c.insert(place, {dvec2((a.x + b.x) / 2, (a.y + b.y) / 2), a}); break;
        case 2: c.insert(place, dvec2((a.x + b.x) / 2, (a.y + b.y) / 2)); break;
        case 3: c.insert(place, {c[std::size_t(r.below(int(c.size())))], a}); break;
    }
}

Corners any_corners(Random& r) {
    const int kind = r.below(10);
    Corners c = kind < 3   ? comb(r, r.between(2, 6))
                : kind < 6 ? star(r, r.between(5, 16))
                           : scribble(r);
    for (int i = r.below(3); i > 0; --i) disturb(r, c);
    if (r.chance(40)) std::reverse(c.begin(), c.end());
    return c;
}

/// Object space: the grid on the two axes beside `axis`, the third one sloping or 0.
vec3 in_space(const dvec2& c, int axis, double slope) {
    vec3 out;
    out[(axis + 1) % 3] = float(c.x);
    out[(axis + 2) % 3] = float(c.y);
    out[axis] = float(slope * c.x);
    return out;
}

/// That plane before the window: `axis` towards the eye, 6 units over the window's size.
dmat4 facing(int axis, int width, int height) {
    dmat4 m(0);
    m[(axis + 1) % 3][0] = width / 7.0;
    m[(axis + 2) % 3][1] = height / 7.0;
    m[axis][2] = 0.125;
    m[3] = {width / 14.0, height / 14.0, 0, 1};
    return m;
}

MeshRef any_polygons(Random& r, int axis) {
    MeshData data{.primitive = Primitive::Polygons};
    const int count = r.between(1, 3);
    for (int i = 0; i < count; ++i) {
        const Corners corners = any_corners(r);
        const double slope = r.pick({0.0, 0.0, 0.5, -0.25});
        for (const dvec2& c : corners) data.positions.push_back(in_space(c, axis, slope));
        data.polygon_sizes.push_back(std::uint32_t(corners.size()));
        data.polygon_ids.push_back(r.bits(20));
    }
    for (std::size_t i = 0; i < data.positions.size(); ++i) {
        data.colors.push_back(any_color(r));
        data.colors.back().w = 1;
    }
    return make_mesh(data);
}

}  // namespace

Case polygons_case(Random& r) {
    Script s{r, {r.pick(profiles()), r.between(30, 50), r.between(30, 50)}};
    s.frame = {s.out.width, s.out.height};
    s.state.projection[0][0] = 2.0 / s.out.width;
    s.state.projection[1][1] = 2.0 / s.out.height;
    s.state.projection[3] = {-1, -1, 0, 1};
    add(s, Clear{all_planes});
    for (int i = 0; i < 6; ++i) {
        const int axis = r.below(3);
        s.frame.eye_from_object = facing(axis, s.out.width, s.out.height);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.polygon_mode = r.chance(60) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        s.state.cull = any_cull(r);
        s.state.color_source = r.chance(80) ? ColorSource::Vertex : ColorSource::PolygonId;
        s.state.blend = {true, BlendFactor::One, r.pick({BlendFactor::One, BlendFactor::Zero})};
        draw(s, any_polygons(r, axis));
    }
    return s.out;
}

}  // namespace gw::conformance
