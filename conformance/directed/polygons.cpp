// Polygons that are concave, touch or cross themselves, or are bent by the snap after a cut.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <algorithm>

namespace gw::conformance {

// Polygons with corners on a coarse grid, so that corners repeat, touch sides and lie on lines.
// They are concave, touch themselves or cross themselves, and are seen along every axis.
namespace {

using Corners = std::vector<dvec2>;

/// A height over each column, there and back: concave, with sides that may touch.
Corners comb(Random& r, int columns) {
    Corners out;
    for (int i = 0; i <= columns; ++i) out.push_back({double(i), double(r.between(0, 3))});
    for (int i = columns; i >= 0; --i) out.push_back({double(i), double(r.between(3, 6))});
    return out;
}

/// A star: each corner has one of a few distances from the middle.
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

/// Random grid points: the polygon nearly always crosses and touches itself.
Corners scribble(Random& r) {
    Corners out;
    const int count = r.between(4, 14), side = r.between(2, 6);
    for (int i = 0; i < count; ++i) {
        const double x = r.between(0, side);
        out.push_back({x, double(r.between(0, side))});
    }
    return out;
}

/// Repeats a corner, or adds a spike or a corner on a side.
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

/// Turns that plane to the window: `axis` towards the eye, 7 units over the window's size.
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
    Script s{r, {r.pick(paper_profiles()), r.between(30, 50), r.between(30, 50)}};
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

// Small triangles cut by six planes on a coarse grid. The snap bends some of the cut polygons so
// much that every fan has a reversed triangle [R6.25] [R6.26]. The stencil counts the coverage.
namespace {

constexpr int window_side = 48;

MeshRef small_triangles(Random& r) {
    MeshData data;
    for (int i = 0; i < 250; ++i) {
        const double x = r.real(0, window_side), y = r.real(0, window_side),
                     size = r.pick({1.0, 2.0, 4.0});
        for (int k = 0; k < 3; ++k) {
            const double dx = r.real(-size, size);
            data.positions.push_back({float(x + dx), float(y + r.real(-size, size)), 0});
        }
    }
    return make_mesh(data);
}

/// A plane for each direction, all near the middle of the window's cells.
void any_planes(Random& r, State& state) {
    for (ClipPlane& p : state.clip_planes) {
        const double a = r.real(-1, 1), b = r.real(-1, 1);
        const double x = r.real(0.2, 0.8) * window_side, y = r.real(0.2, 0.8) * window_side;
        const double sign = a * (window_side / 2.0 - x) + b * (window_side / 2.0 - y) < 0 ? -1 : 1;
        p = {true, sign * dvec4(a, b, 0, -(a * x + b * y))};
    }
}

}  // namespace

Case cut_slivers_case(Random& r) {
    Script s{r, {user_profile(r), window_side, window_side}};
    s.out.profile.subpixel_bits = 1;
    s.frame = {window_side, window_side};
    s.state.projection[0][0] = s.state.projection[1][1] = 2.0 / window_side;
    s.state.projection[3] = {-1, -1, 0, 1};
    s.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    add(s, Clear{all_planes});
    const MeshRef mesh = small_triangles(r);
    for (int i = 0; i < 12; ++i) {
        any_planes(r, s.state);
        draw(s, mesh);
    }
    return s.out;
}

}  // namespace gw::conformance
