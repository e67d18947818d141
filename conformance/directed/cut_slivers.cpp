// Small triangles cut by six planes on a coarse grid: the snap bends some of the pieces' polygons so
// much that every fan of them has a piece turned over [R6.25] [R6.26]. The stencil plane counts.
#include "conformance/directed/directed.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/profile.h"
#include "conformance/generate/script.h"

namespace gw::conformance {

using namespace fuzz;

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
