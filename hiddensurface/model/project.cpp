// Projects polygons with the machine's own vertex stages, clipping, snap and fans.
#include "hiddensurface/model/polygon.h"

#include "gw/stages/fan.h"
#include "gw/stages/perspective.h"
#include "gw/stages/resolve.h"
#include "gw/stages/vertex.h"
#include "gw/stages/window.h"
#include "hiddensurface/model/normal.h"
#include "scene/draw/draw_commands.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

/// One object before the eye.
struct Placed {
    const scene::Object& object;
    const Profile& profile;
    JitterState jitter;
    Resolved resolved;
    std::vector<Vertex> vertices;
};

Placed place(const scene::Object& object, const scene::View& view, const Profile& profile,
             const JitterState& jitter) {
    State state = scene::view_state(view);
    state.color_source = ColorSource::PolygonId;
    const Draw draw = scene::placed(object, view);
    const VertexProgram program = vertex_program(state, draw, profile);
    Placed placed{object, profile, jitter, resolve(state, profile, view.width, view.height), {}};
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
        const WindowVertex w =
            to_window(v, p.resolved.viewport, p.resolved.state.depth_range, p.profile);
        out.push_back({w.x + p.jitter.x, w.y + p.jitter.y, std::int64_t{w.z}});
    }
    return out;
}

/// Adds the triangles of a clipped triangle's fan that make fragments.
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
        if (p.object.single_sided && area < 0) continue;
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

/// True if every corner turns in the polygon's direction.
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
        const double d =
            -(transform3(dmat3(eye_from_world), polygon.world[i]).z + eye_from_world[3].z);
        polygon.nearest = i == 0 ? d : std::min(polygon.nearest, d);
        polygon.farthest = i == 0 ? d : std::max(polygon.farthest, d);
        sum += d;
    }
    polygon.centroid = sum / double(polygon.world.size());
}

Loop to_loop(std::span<const GridPoint> corners) {
    Loop loop;
    for (const GridPoint& c : corners) loop.push_back(to_dvec3(c));
    return loop;
}

bool in_one_plane(const std::vector<WindowTriangle>& triangles) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const WindowTriangle& t) {
        return std::all_of(t.corners.begin(), t.corners.end(), [&](const GridPoint& p) {
            return is_on_plane(triangles[0].corners, p);
        });
    });
}

/// Sets the plane through the facet's first triangle.
void set_plane(Facet& facet, const WindowTriangle& t) {
    const Loop p = to_loop(t.corners);
    const dvec3 n = face_normal(p[0], p[1], p[2]);
    facet.plane = plane_of(dvec3(n.x / n.z, n.y / n.z, 1), p[0]);
}

/// `outline`: the polygon's own corners on the grid if it is convex, else none.
void set_facets(Polygon& polygon, const Loop& outline) {
    const auto& t = polygon.triangles;
    const bool one = in_one_plane(t);
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (i == 0 || !one) polygon.facets.push_back({.first = i});
        Facet& facet = polygon.facets.back();
        facet.parts.push_back(to_loop(t[i].corners));
        facet.count += 1;
    }
    if (one && polygon.visible() && !outline.empty()) polygon.facets[0].parts = {outline};
    for (Facet& facet : polygon.facets) set_plane(facet, t[facet.first]);
}

/// Positions are float32, so the corners of a plane polygon lie within 1e-6 of its size from its
/// plane.
bool is_plane(const Loop& p) {
    const dvec3 n = polygon_normal(p);
    double off = 0, size = 0;
    for (const dvec3& q : p)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            off = std::max(off, std::abs(dot3(n, q - p[0])));
            size = std::max(size, std::abs(q[int(axis)]));
        }
    return off <= 1e-6 * size * length(n);
}

/// The polygon's plane pieces in the world. `t`: the triangles that the machine draws, the first of
/// them number `first`. A triangle whose corners are on one line has no plane, but the snap may give
/// it a pixel. So it belongs to the facet before it, or the next.
void set_world_facets(Polygon& polygon, const scene::Object& object, std::span<const Triangle> t,
                      std::uint32_t first) {
    const bool plane = is_plane(polygon.world), convex = is_convex(polygon.world);
    bool has_area = false;  // the last facet
    for (std::uint32_t i = 0; i < t.size(); ++i) {
        Loop part;
        for (const std::uint32_t k : t[i].vertex) part.push_back(world_point(object, k));
        const bool adds_area = polygon_normal(part) != dvec3(0);
        if (i == 0 || (!plane && has_area && adds_area)) {
            polygon.world_facets.push_back({.first = first + i});
            has_area = false;
        }
        WorldFacet& facet = polygon.world_facets.back();
        facet.count += 1;
        if (has_area && !adds_area) continue;
        if (!has_area && adds_area) facet.parts.clear();
        facet.parts.push_back(std::move(part));
        has_area = has_area || adds_area;
    }
    if (plane && convex && !t.empty()) polygon.world_facets[0].parts = {polygon.world};
}

}  // namespace

std::vector<Polygon> project(const scene::Scene& scene, const scene::View& view,
                             const Profile& profile, const JitterState& jitter) {
    std::vector<Polygon> all;
    const scene::PolygonIds ids = scene::polygon_ids(scene);
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const Mesh& mesh = *scene.objects[o].mesh;
        if (mesh.kind() != MeshKind::Triangles) continue;
        const Placed placed = place(scene.objects[o], view, profile, jitter);
        const auto corners = polygon_corners(mesh);
        std::size_t t = 0;
        for (std::uint32_t k = 0; k < mesh.polygon_count(); ++k) {
            Polygon polygon{.id = ids.first[o] - ids.lowest[o] + mesh.polygon_id(k), .object = o};
            const std::size_t first = t;
            for (; t < mesh.triangles().size() && mesh.triangles()[t].polygon == k; ++t)
                add_triangles(placed, mesh.triangles()[t], static_cast<std::uint32_t>(t), polygon);
            for (const std::uint32_t i : corners[k])
                polygon.world.push_back(world_point(placed.object, i));
            set_world_facets(polygon, placed.object, mesh.triangles().subspan(first, t - first),
                             static_cast<std::uint32_t>(first));
            const bool convex = is_convex(polygon.world);
            set_facets(polygon, convex ? to_loop(window_corners(placed, corners[k])) : Loop());
            set_distances(polygon, view.eye_from_world);
            all.push_back(std::move(polygon));
        }
    }
    return all;
}

dvec4 eye_of(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    return camera.ortho_height > 0 ? dvec4(camera.eye - camera.at, 0) : dvec4(camera.eye, 1);
}

dvec4 unit_eye_of(const scene::View& view) {
    const dvec4 eye = eye_of(view);
    const dvec3 direction(eye);
    return eye.w == 0 ? dvec4(direction / std::sqrt(dot3(direction, direction)), 0) : eye;
}

bool is_before(const dvec4& world_plane, const scene::View& view) {
    return dot4(world_plane, eye_of(view)) > 0;
}

dvec4 to_window(const dvec4& world_plane, const scene::View& view, const Profile& profile) {
    const double scale = double(1 << profile.subpixel_bits),
                 depth = max_of_bits(profile.depth_bits);
    dmat4 grid_from_clip(1);
    grid_from_clip[0].x = view.width / 2.0 * scale;
    grid_from_clip[1].y = view.height / 2.0 * scale;
    grid_from_clip[2].z = depth / 2;
    grid_from_clip[3] = dvec4(grid_from_clip[0].x, grid_from_clip[1].y, depth / 2, 1);
    const dmat4 grid_from_world =
        product(grid_from_clip, product(view.clip_from_eye, view.eye_from_world));
    return transform(glm::transpose(glm::inverse(grid_from_world)), world_plane);
}

}  // namespace gw::hiddensurface
