// Depths: polygon offset, and gradients half-way between two integers.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Polygon offset: slopes from flat to slivers', factors and units of every size and sign.
Case offset_case(Random& r) {
    Script s{r, {r.chance(50) ? reality() : ideal(), r.between(20, 40), r.between(20, 40)}};
    s.frame = any_frame(r, s.out.width, s.out.height, s.out.profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    add(s, Clear{all_planes});
    for (int i = 0; i < 8; ++i) {
        s.state.depth = {.test = true, .func = DepthFunc::Always};
        const float factor = r.pick({0.0f, 1.0f, -1.5f, 1e-3f, 3e38f, 0.3f});
        s.state.polygon_offset = {true, factor, r.pick({0.0f, 1.0f, -4.0f, 2.5f, 1e30f, 70000.0f})};
        s.state.polygon_mode = r.chance(80) ? PolygonMode::Fill : r.any(PolygonMode::Line);
        draw(s, any_mesh(r, s.frame, {.most = 5}));
    }
    return s.out;
}

// Triangles of the area 2^20 / 2 sub-pixel units whose gradients are half-way between two integers,
// for about half of all values [R9.6].
namespace {

/// Corners (0, 0), (1025, 1), (-1, 1023) in units of 1/8 pixel, moved by whole pixels.
MeshRef triangle(Random& r) {
    MeshData data;
    const double x = r.between(-8, 8), y = r.between(-24, 8);
    for (const dvec2& corner : {dvec2(0, 0), dvec2(1025, 1), dvec2(-1, 1023)}) {
        const double z = r.real(-1, 1);
        data.positions.push_back({float(x + corner.x / 8), float(y + corner.y / 8), float(z)});
        data.colors.push_back(any_color(r));
    }
    return make_mesh(data);
}

}  // namespace

Case ties_case(Random& r) {
    Script s{r, {r.chance(50) ? vgx() : reality(), 64, 32}};
    s.frame = {s.out.width, s.out.height};
    s.state.projection[0][0] = 2.0 / s.out.width;
    s.state.projection[1][1] = 2.0 / s.out.height;
    s.state.projection[3] = {-1, -1, 0, 1};
    s.state.depth = {.test = true, .func = DepthFunc::Always};
    add(s, Clear{all_planes});
    for (int i = 0; i < 8; ++i) draw(s, triangle(r));
    return s.out;
}

}  // namespace gw::conformance
