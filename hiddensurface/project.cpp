// The machine's own vertex stages, clipping, snap and fans, used as it uses them.
#include "hiddensurface/polygon.h"

#include "gw/fan.h"
#include "gw/perspective.h"
#include "gw/resolve.h"
#include "gw/vertex.h"
#include "gw/window.h"
#include "hiddensurface/normal.h"
#include "scene/draw_commands.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {

namespace {

/// One object before the eye.
struct Placed {
    const scene::Object& object;
    const Profile& profile;
    Resolved resolved;
    std::vector<Vertex> vertices;
};

Placed place(const scene::Object& object, const scene::View& view, const Profile& profile) {
    State state = scene::view_state(view);
    state.color_source = ColorSource::PolygonId;
    const Draw draw = scene::placed(object, view);
    const VertexProgram program = vertex_program(state, draw, profile);
    Placed placed{object, profile, resolve(state, profile, view.width, view.height), {}};
    for (std::uint32_t i = 0; i < object.mesh->vertex_count(); ++i)
        placed.vertices.push_back(run_vertex(program, i));
    return placed;
}

/// Clipped and snapped.
std::vector<GridPoint> window_corners(const Placed& p, std::span<const std::uint32_t> corners) {
    std::vector<Vertex> vertices;
    for (const std::uint32_t i : corners) vertices.push_back(p.vertices[i]);
    std::vector<GridPoint> out;
    for (const Vertex& v : clip(std::move(vertices), p.resolved.viewport).vertices) {
        const WindowVertex w = to_window(v, p.resolved.viewport, p.resolved.state.depth_range, p.profile);
        out.push_back({w.x, w.y, std::int64_t{w.z}});
    }
    return out;
}

/// The fan of a clipped triangle: the pieces that make fragments.
void add_triangles(const Placed& p, const Triangle& t, std::uint32_t ordinal, Polygon& polygon) {
    const std::vector<GridPoint> corners = window_corners(p, t.vertex);
    if (corners.empty()) return;
    std::vector<SnappedPoint> points;
    for (const GridPoint& c : corners) points.push_back({c.x, c.y});
    const Fan fan = fan_of(points);
    const std::size_t n = corners.size();
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const std::size_t i = fan.first, j = (fan.first + k) % n, l = (fan.first + k + 1) % n;
        const std::int64_t area = area2(points[i], points[j], points[l]);
        if (area == 0 || (area > 0) != (fan.area2 > 0)) continue;
        const std::array<GridPoint, 3> piece{corners[i], corners[j], corners[l]};
        polygon.triangles.push_back(
            {piece, depth_plane(piece, p.profile.subpixel_bits, p.profile.depth_bits), ordinal});
    }
}

/// The corners of every polygon of a mesh, in the order of their ordinals.
std::vector<std::vector<std::uint32_t>> polygon_corners(const Mesh& mesh) {
    const MeshData& data = mesh.data();
    const auto index = [&](std::size_t i) {
        return data.indices.empty() ? static_cast<std::uint32_t>(i) : data.indices[i];
    };
    std::vector<std::vector<std::uint32_t>> polygons(mesh.polygon_count());
    const bool loops = data.primitive == Primitive::Polygons || data.primitive == Primitive::Quads;
    if (!loops) {
        for (const Triangle& t : mesh.triangles())
            polygons[t.polygon].assign(t.vertex.begin(), t.vertex.end());
        return polygons;
    }
    const std::size_t all = data.indices.empty() ? data.positions.size() : data.indices.size();
    std::size_t next = 0;
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        const std::size_t size = data.primitive == Primitive::Quads ? 4
                                 : data.polygon_sizes.empty()       ? all
                                                                    : data.polygon_sizes[k];
        for (std::size_t i = 0; i < size; ++i) polygons[k].push_back(index(next++));
    }
    return polygons;
}

/// Every corner turns the way the polygon does.
bool is_convex(const Loop& p) {
    const dvec3 n = polygon_normal(p);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec3 turn = face_normal(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]);
        if (dot3(turn, n) < 0) return false;
    }
    return true;
}

dvec3 world_point(const scene::Object& object, std::uint32_t i) {
    const dvec3 p(object.mesh->data().positions[i]);
    return transform3(dmat3(object.world_from_object), p) + dvec3(object.world_from_object[3]);
}

void set_distances(Polygon& polygon, const dmat4& eye_from_world) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.world.size(); ++i) {
        const double d = -(transform3(dmat3(eye_from_world), polygon.world[i]).z + eye_from_world[3].z);
        polygon.nearest = i == 0 ? d : std::min(polygon.nearest, d);
        polygon.farthest = i == 0 ? d : std::max(polygon.farthest, d);
        sum += d;
    }
    polygon.centroid = sum / double(polygon.world.size());
}

/// The window plane of all parts together: the normal is the sum of theirs, the point their mean corner.
void set_plane(Polygon& polygon) {
    dvec3 n(0), sum(0);
    double corners = 0;
    for (const Loop& part : polygon.parts) {
        n += polygon_normal(part);
        for (const dvec3& p : part) sum += p;
        corners += double(part.size());
    }
    polygon.plane = plane_of(n.z < 0 ? -n : n, sum / corners);
    polygon.tolerance = 1e-3 * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    double bent = 0;
    for (const Loop& part : polygon.parts)
        for (const dvec3& p : part) bent = std::max(bent, std::abs(side(polygon.plane, p)));
    polygon.tolerance += bent;
}

Loop to_loop(const std::vector<GridPoint>& corners) {
    Loop loop;
    for (const GridPoint& c : corners) loop.push_back(to_dvec3(c));
    return loop;
}

/// Corners, and of a concave polygon the triangles, in the world and in the window.
void set_outline(Polygon& polygon, const Placed& p, const std::vector<std::uint32_t>& corners,
                 std::span<const Triangle> triangles) {
    for (const std::uint32_t i : corners) polygon.world.push_back(world_point(p.object, i));
    const bool convex = is_convex(polygon.world);
    if (convex) polygon.world_parts = {polygon.world};
    if (convex && polygon.visible()) polygon.parts = {to_loop(window_corners(p, corners))};
    if (convex) return;
    for (const Triangle& t : triangles) {
        Loop part;
        for (const std::uint32_t i : t.vertex) part.push_back(world_point(p.object, i));
        polygon.world_parts.push_back(part);
    }
    for (const WindowTriangle& t : polygon.triangles)
        polygon.parts.push_back(to_loop({t.corners.begin(), t.corners.end()}));
}

}  // namespace

std::vector<Polygon> project(const scene::Scene& scene, const scene::View& view, const Profile& profile) {
    std::vector<Polygon> all;
    const scene::PolygonIds ids = scene::polygon_ids(scene);
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Mesh& mesh = *scene.objects[o].mesh;
        if (mesh.kind() != MeshKind::Triangles) continue;
        const Placed placed = place(scene.objects[o], view, profile);
        const auto corners = polygon_corners(mesh);
        std::size_t t = 0;
        for (std::uint32_t k = 0; k < mesh.polygon_count(); ++k) {
            Polygon polygon{.id = ids.first[o] - ids.lowest[o] + mesh.polygon_id(k), .object = o};
            const std::size_t first = t;
            for (; t < mesh.triangles().size() && mesh.triangles()[t].polygon == k; ++t)
                add_triangles(placed, mesh.triangles()[t], static_cast<std::uint32_t>(t), polygon);
            set_outline(polygon, placed, corners[k], mesh.triangles().subspan(first, t - first));
            set_distances(polygon, view.eye_from_world);
            if (polygon.visible()) set_plane(polygon);
            all.push_back(std::move(polygon));
        }
    }
    return all;
}

dvec4 to_window(const dvec4& world_plane, const scene::View& view, const Profile& profile) {
    const double scale = double(1 << profile.subpixel_bits), depth = max_of_bits(profile.depth_bits);
    dmat4 grid_from_clip(1);
    grid_from_clip[0].x = view.width / 2.0 * scale;
    grid_from_clip[1].y = view.height / 2.0 * scale;
    grid_from_clip[2].z = depth / 2;
    grid_from_clip[3] = dvec4(grid_from_clip[0].x, grid_from_clip[1].y, depth / 2, 1);
    const dmat4 grid_from_world = product(grid_from_clip, product(view.clip_from_eye, view.eye_from_world));
    return transform(glm::transpose(glm::inverse(grid_from_world)), world_plane);
}

}  // namespace gw::hiddensurface
