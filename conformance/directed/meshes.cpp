// Meshes of every primitive, over windows of whole and cut blocks.
#include "conformance/cases.h"
#include "conformance/generate/draw.h"
#include "conformance/generate/mesh.h"
#include "conformance/generate/script.h"
#include "conformance/generate/state.h"

namespace gw::conformance {

// Every primitive, with and without indices, identifiers, sizes and each array of values.
namespace {

std::uint32_t polygon_count(Primitive primitive, std::uint32_t corners) {
    switch (primitive) {
        case Primitive::Points: return corners;
        case Primitive::Lines: return corners / 2;
        case Primitive::LineStrip: return corners - 1;
        case Primitive::Triangles: return corners / 3;
        case Primitive::TriangleStrip:
        case Primitive::TriangleFan: return corners - 2;
        case Primitive::Quads: return corners / 4;
        case Primitive::Polygons: return 3;
    }
    return 0;
}

MeshRef any_mesh_of(Random& r, const Frame& f, Primitive primitive) {
    constexpr std::uint32_t corners = 12;  // fits every primitive
    MeshData data{.primitive = primitive};
    const bool indexed = r.chance(50);
    const int positions = indexed ? r.between(4, 9) : int(corners);
    for (int i = 0; i < positions; ++i) {
        const double x = any_coordinate(r, f.width, f.subpixel_bits);
        const double y = any_coordinate(r, f.height, f.subpixel_bits);
        data.positions.push_back(place(f, {x, y, any_z(r, f)}));
    }
    if (indexed)
        for (std::uint32_t i = 0; i < corners; ++i)
            data.indices.push_back(std::uint32_t(r.below(positions)));
    const bool normals = r.chance(50), texcoords = r.chance(50), colors = r.chance(60);
    for (int i = 0; i < positions; ++i) {
        if (normals)
            data.normals.push_back(
                {float(r.real(-1, 1)), float(r.real(-1, 1)), float(r.real(0, 2))});
        if (texcoords) data.texcoords.push_back({float(r.real(-2, 2)), float(r.real(-2, 2))});
        if (colors) data.colors.push_back(any_color(r));
    }
    if (primitive == Primitive::Polygons) data.polygon_sizes = {4, 3, 5};
    if (r.chance(60))
        for (std::uint32_t i = 0; i < polygon_count(primitive, corners); ++i)
            data.polygon_ids.push_back(r.bits(24));
    return make_mesh(data);
}

}  // namespace

Case mesh_case(Random& r) {
    Script s{r, {r.pick(paper_profiles()), r.between(20, 50), r.between(20, 50)}};
    s.frame = any_frame(r, s.out.width, s.out.height, s.out.profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    add(s, Clear{all_planes});
    for (int i = 0; i <= int(Primitive::Polygons); ++i) {
        s.state.color_source = r.any(ColorSource::PolygonId);
        s.state.shade_model = r.any(ShadeModel::Smooth);
        s.state.line_width = r.between(1, 3);
        s.state.point_size = r.between(1, 3);
        draw(s, any_mesh_of(r, s.frame, Primitive(i)), 30);
    }
    draw(s, make_mesh({}));
    return s.out;
}

// A window of 3 x 2 blocks, the last ones cut by its border: every plane differs in every block.
Case blocks_case(Random& r) {
    Script s{r, {reality(), 130, 67}};
    s.frame = flat_frame(r, s.out.width, s.out.height, s.out.profile.subpixel_bits);
    s.state.projection = s.frame.projection;
    s.state.depth.test = true;
    s.state.stencil = {.test = true, .zpass = StencilOp::Incr};
    add(s, Clear{all_planes, {0.25f, 0.5f, 0.75f, 1}, 1, 3});
    for (int i = 0; i < 4; ++i) draw(s, cover_mesh(r, s.frame, {}, r.real(-1, 1)));
    for (int i = 0; i < 6; ++i) draw(s, any_triangles(r, s.frame, {.most = 4}));
    add(s, Accumulate{AccumOp::Load, 1.5f});
    return s.out;
}

}  // namespace gw::conformance
