// Outlines of polygons of several triangles: their stipple, and their offset.
#include "conformance/cases.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

#include <utility>

namespace gw::conformance {
namespace {

constexpr int outline_window = 48;

/// A polygon with a crossing or a notch: of its triangles, some are front and some are back faces, or
/// all are one. Its first corner is any.
MeshRef crossed_polygon(Random& r) {
    std::vector<vec3> corners{{4, 5, 0}, {43, 41, 0}, {44, 6, 0}, {5, 42, 0}};
    if (r.chance(40)) corners = {{4, 4, 0}, {44, 5, 0}, {43, 43, 0}, {24, 12, 0}, {5, 44, 0}};
    MeshData data{.primitive = Primitive::Polygons};
    const std::size_t first = std::size_t(r.below(int(corners.size())));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        vec3 p = corners[(first + i) % corners.size()];
        p.x += float(r.real(-3, 3));
        p.y += float(r.real(-3, 3));
        data.positions.push_back(p);
        data.colors.push_back(any_color(r));
    }
    return make_mesh(data);
}

/// [R9.20]
void draw_stippled(Script& s) {
    Random& r = s.random;
    s.state.line_stipple = {true, r.between(2, 5), std::uint16_t(r.pick({0x00FF, 0x0F37, 0x1F03}))};
    s.state.line_width = 2;
    for (int i = 0; i < 6; ++i) {
        s.state.line_smooth = i % 3 == 2;
        s.state.cull = {};
        s.state.two_side_polygon_mode = i % 2 == 1;
        s.state.polygon_mode = s.state.back_polygon_mode = PolygonMode::Line;
        if (s.state.two_side_polygon_mode)
            (i % 4 == 1 ? s.state.polygon_mode : s.state.back_polygon_mode) = PolygonMode::Fill;
        else
            s.state.cull = {i > 0, i == 2 ? Face::Front : Face::Back};
        add(s, Clear{mask_of(Plane::Color), any_color(r)});
        add(s, Draw{.mesh = crossed_polygon(r)});
    }
    s.state = {.projection = s.state.projection};
}

/// [R9.22] A triangle that a plane cuts in pieces whose slopes the snap makes different.
void draw_offset(Script& s) {
    Random& r = s.random;
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    s.state.point_size = 3;
    s.state.line_width = 2;
    for (const bool enable : {false, false, true}) {
        s.state.polygon_offset = {enable, float(r.real(1, 3)), float(r.between(1000, 9000)), true,
                                  true};
        s.state.clip_planes[0] = {true, {1, float(r.real(0.5, 1)), 0, -r.real(20, 30)}};
        MeshData data;
        for (int k = 0; k < 6; ++k) {
            const double x = r.real(2, 10) + 32 * (k % 3 == 1);
            const double y = r.real(2, 10) + 32 * (k % 3 == 2);
            data.positions.push_back({float(x), float(y), float(r.real(-0.5, 0.5))});
        }
        const MeshRef mesh = make_mesh(data);
        for (const PolygonMode mode : {PolygonMode::Line, PolygonMode::Point}) {
            s.state.polygon_mode = mode;
            add(s, Draw{.mesh = mesh});
        }
    }
}

/// [R7.3] Convex polygons, one of whose first corners has no area: no fan.
void draw_straight_corners(Script& s) {
    Random& r = s.random;
    s.state = {.projection = s.state.projection};
    for (const Primitive primitive : {Primitive::Polygons, Primitive::Quads}) {
        MeshData data{.primitive = primitive};
        data.positions = {{4, 4, 0}, {24, 4, 0}, {44, 4, 0}, {24, 44, 0}};
        for (int i = 0; i < 4; ++i) data.colors.push_back(any_color(r));
        add(s, Draw{.mesh = make_mesh(data)});
    }
}

}  // namespace

Case outlines_case(Random& r) {
    Profile profile = opengl_up_to(&Extensions::draw_pixels);
    profile.subpixel_bits = r.between(1, 2);
    Script s = pixel_script(r, profile, outline_window, outline_window);
    draw_stippled(s);
    draw_offset(s);
    draw_straight_corners(s);
    return s.out;
}

}  // namespace gw::conformance
