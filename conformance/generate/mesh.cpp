// Places window positions, then connects them to a primitive, then adds attributes.
#include "conformance/generate/mesh.h"

#include "conformance/generate/state.h"

#include <algorithm>

namespace gw::conformance {
namespace {

using Points = std::vector<dvec3>;  ///< window positions, as place() takes them

dvec3 any_point(Random& r, const Frame& f, double z) {
    return {any_coordinate(r, f.width, f.subpixel_bits),
            any_coordinate(r, f.height, f.subpixel_bits), z};
}

/// The depths of a primitive: one for all vertices, or one for each.
struct Depths {
    bool flat = false;
    double z = 0;
    double next(Random& r, const Frame& f) const { return flat ? z : any_z(r, f); }
};
Depths any_depths(Random& r, const Frame& f, const MeshWish& wish) {
    const bool flat = wish.flat_depth || r.chance(35);
    return {flat, any_z(r, f)};
}

void add_loose(Random& r, const Frame& f, const Depths& z, Points& out) {
    for (int i = 0; i < 3; ++i) out.push_back(any_point(r, f, z.next(r, f)));
}

/// Within a few pixels: most triangles of real meshes.
void add_small(Random& r, const Frame& f, const Depths& z, Points& out) {
    const dvec3 at = any_point(r, f, 0);
    const int units = 1 << f.subpixel_bits, reach = r.chance(50) ? units : 4 * units;
    for (int i = 0; i < 3; ++i) {
        const double dx = double(r.between(-reach, reach)) / units;
        const double dy = double(r.between(-reach, reach)) / units;
        out.push_back({at.x + dx, at.y + dy, z.next(r, f)});
    }
}

/// Two vertices anywhere, the third about a sub-pixel beside the line between them.
void add_sliver(Random& r, const Frame& f, const Depths& z, Points& out) {
    const dvec3 a = any_point(r, f, z.next(r, f)), b = any_point(r, f, z.next(r, f));
    const double t = r.pick({0.5, 0.25, 1.0, 0.125, 2.0}), unit = 1.0 / (1 << f.subpixel_bits);
    const dvec3 beside{a.x + t * (b.x - a.x) + unit * r.between(-2, 2),
                       a.y + t * (b.y - a.y) + unit * r.between(-2, 2), z.next(r, f)};
    out.insert(out.end(), {a, b, beside});
}

/// A vertex on a pixel centre and two close by: the steepest gradients.
void add_needle(Random& r, const Frame& f, const Depths& z, Points& out) {
    const double unit = 1.0 / (1 << f.subpixel_bits);
    const dvec3 a{r.below(f.width) + 0.5, r.below(f.height) + 0.5, z.next(r, f)};
    const int length = r.between(1, 4000);
    const dvec3 b{a.x + length + unit, a.y + length * r.between(-1, 1), z.next(r, f)};
    const dvec3 c{a.x + length, b.y + unit * r.between(-1, 1), z.next(r, f)};
    out.insert(out.end(), {a, b, c});
}

void add_degenerate(Random& r, const Frame& f, const Depths& z, Points& out) {
    const dvec3 a = any_point(r, f, z.next(r, f)), b = any_point(r, f, z.next(r, f));
    out.insert(out.end(), {a, b, r.chance(50) ? a : b});
}

void add_triangle(Random& r, const Frame& f, const MeshWish& wish, Points& out) {
    const Depths z = any_depths(r, f, wish);
    const int kind = r.below(100);
    if (kind < 45) return add_loose(r, f, z, out);
    if (kind < 80) return add_small(r, f, z, out);
    if (kind < 91) return add_sliver(r, f, z, out);
    if (kind < 96) return add_needle(r, f, z, out);
    add_degenerate(r, f, z, out);
}

vec3 any_normal(Random& r) {
    const int kind = r.below(20);
    if (kind == 0) return vec3(0);
    if (kind < 6)
        return {float(r.between(-1, 1)), float(r.between(-1, 1)), float(r.between(-1, 1))};
    const float size = kind == 6 ? 1e-30f : kind == 7 ? 1e30f : 1;
    return vec3{float(r.real(-1, 1)), float(r.real(-1, 1)), float(r.real(-0.2, 1))} * size;
}

/// The range of a mesh's coordinates: on texels, over repeats, far out, constant.
struct Spread {
    int kind = 0;
    double scale = 1, shift = 0;
};
Spread any_spread(Random& r) {
    Spread s{r.below(10)};
    s.scale = r.pick({1.0, 1.0, 1.0, 4.0, 0.125, 37.5, 900.0});
    s.shift = r.chance(50) ? 0 : r.between(-5, 5) / 4.0;
    if (r.chance(4)) s.shift = r.scaled(-1, 1, 8, 40);
    if (r.chance(4)) s.scale = r.scaled(-1, 1, 8, 40);
    return s;
}
float any_texcoord(Random& r, const Spread& s) {
    if (s.kind == 0) return float(s.shift);
    const double v = s.kind < 5   ? r.between(-16, 32) / 16.0
                     : s.kind < 8 ? r.real(0, 1)
                                  : r.real(-2, 2);
    return float(v * s.scale + s.shift);
}

/// Fills the vertex arrays that `wish` names.
void add_attributes(Random& r, const MeshWish& wish, MeshData& data) {
    const std::size_t n = data.positions.size();
    if (wish.normals)
        for (std::size_t i = 0; i < n; ++i) data.normals.push_back(any_normal(r));
    if (wish.texcoords) {
        const Spread s = any_spread(r), t = any_spread(r);
        for (std::size_t i = 0; i < n; ++i)
            data.texcoords.push_back({any_texcoord(r, s), any_texcoord(r, t)});
    }
    if (wish.colors && r.chance(95)) {
        const vec4 all = any_color(r);
        const bool constant = r.chance(15);
        for (std::size_t i = 0; i < n; ++i) data.colors.push_back(constant ? all : any_color(r));
    }
}

MeshData finished(Random& r, const Frame& f, const MeshWish& wish, Primitive primitive,
                  const Points& points) {
    MeshData data{.primitive = primitive};
    for (const dvec3& p : points) data.positions.push_back(place(f, p));
    add_attributes(r, wish, data);
    return data;
}

/// A few triangles, some of them repeated with their vertices rotated or reversed.
MeshData soup(Random& r, const Frame& f, const MeshWish& wish) {
    Points points;
    const int count = r.between(1, std::max(1, wish.most));
    for (int i = 0; i < count; ++i) {
        if (i > 0 && r.chance(15)) {
            const auto first = points.end() - 3;
            const Points again{first[1], first[0], first[2]};
            points.insert(points.end(), again.begin(), again.end());
        } else {
            add_triangle(r, f, wish, points);
        }
    }
    return finished(r, f, wish, Primitive::Triangles, points);
}

/// A height field from above with displaced vertices, whose triangles share all edges.
MeshData grid(Random& r, const Frame& f, const MeshWish& wish) {
    const int side = r.between(1, wish.most >= 8 ? 4 : 2);
    const Depths z = any_depths(r, f, wish);
    const double jumble = r.pick({0.0, 0.0, 0.3, 2.0});
    Points points;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double x = (i + jumble * r.real(-1, 1)) * f.width / side;
            const double y = (j + jumble * r.real(-1, 1)) * f.height / side;
            points.push_back({x, y, z.next(r, f)});
        }
    MeshData data = finished(r, f, wish, Primitive::Triangles, points);
    const auto at = [side](int i, int j) { return static_cast<std::uint32_t>(j * (side + 1) + i); };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            data.indices.insert(data.indices.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                                     at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    return data;
}

/// Strips, fans, quads, polygons of any points.
MeshData chain(Random& r, const Frame& f, const MeshWish& wish) {
    const Primitive primitive = r.pick(
        {Primitive::TriangleStrip, Primitive::TriangleFan, Primitive::Quads, Primitive::Polygons});
    const int most = std::min(wish.most, 8);
    const int count =
        primitive == Primitive::Quads ? 4 * r.between(1, 1 + most / 2) : 3 + r.below(most);
    const Depths z = any_depths(r, f, wish);
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(any_point(r, f, z.next(r, f)));
    return finished(r, f, wish, primitive, points);
}

}  // namespace

MeshRef any_triangles(Random& r, const Frame& f, const MeshWish& wish) {
    const int kind = r.below(100);
    return make_mesh(kind < 60   ? soup(r, f, wish)
                     : kind < 78 ? grid(r, f, wish)
                                 : chain(r, f, wish));
}

MeshRef any_lines(Random& r, const Frame& f, const MeshWish& wish) {
    Points points;
    const int count = r.between(1, wish.most);
    for (int i = 0; i < count; ++i) {
        const Depths z = any_depths(r, f, wish);
        const dvec3 a = any_point(r, f, z.next(r, f));
        dvec3 b = any_point(r, f, z.next(r, f));
        if (r.chance(30)) b = dvec3{a.x + r.between(-3, 3), a.y + r.between(-3, 3), b.z};
        points.insert(points.end(), {a, b});
    }
    return make_mesh(
        finished(r, f, wish, r.pick({Primitive::Lines, Primitive::LineStrip}), points));
}

MeshRef any_points(Random& r, const Frame& f, const MeshWish& wish) {
    Points points;
    const int count = r.between(1, 2 * wish.most);
    for (int i = 0; i < count; ++i) points.push_back(any_point(r, f, any_z(r, f)));
    return make_mesh(finished(r, f, wish, Primitive::Points, points));
}

MeshRef any_mesh(Random& r, const Frame& f, const MeshWish& wish) {
    const int kind = r.below(100);
    if (kind < 86) return any_triangles(r, f, wish);
    return kind < 95 ? any_lines(r, f, wish) : any_points(r, f, wish);
}

MeshRef cover_mesh(Random& r, const Frame& f, const MeshWish& wish, double z) {
    const double low = r.pick({0.0, -0.5, -3.0, 0.5, 1.0}), x = f.width - low, y = f.height - low;
    const Points points{{low, low, z}, {x, low, z}, {x, y, z}, {low, y, z}};
    return make_mesh(finished(r, f, wish, Primitive::Quads, points));
}

MeshData rectangle(float left, float bottom, float right, float top) {
    return {.primitive = Primitive::Quads,
            .positions = {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}}};
}

MeshRef same_faces(Random& r, const Mesh& mesh) {
    MeshData data = mesh.data();
    if (mesh.kind() != MeshKind::Triangles) return make_mesh(data);
    data.primitive = Primitive::Triangles;
    data.indices.clear();
    data.polygon_sizes.clear();
    data.polygon_ids.clear();
    for (const Triangle& t : mesh.triangles()) {
        std::array<std::uint32_t, 3> v = t.vertex;
        std::rotate(v.begin(), v.begin() + r.below(3), v.end());
        if (r.chance(30)) std::swap(v[0], v[1]);
        data.indices.insert(data.indices.end(), v.begin(), v.end());
    }
    return make_mesh(data);
}

}  // namespace gw::conformance
