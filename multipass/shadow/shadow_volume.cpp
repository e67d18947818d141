#include "multipass/shadow/shadow_volume.h"

#include "gw/base/elementary.h"
#include "gw/stages/clip.h"
#include "gw/stages/vertex.h"
#include "scene/draw/draw_commands.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gw::multipass {
namespace {

constexpr int most_splits = 24;

/// Grows one of the two meshes. Each point of the topology becomes at most two of its vertices: one
/// in place, one moved away from the light.
class VolumeBuilder {
public:
    VolumeBuilder(const Topology& topology, const LightInObject& light, const FarCap& far,
                  bool mirrored)
        : topology_(topology),
          light_(light),
          far_(far),
          mirrored_(mirrored),
          ends_(topology.points.size()) {}

    /// Corners of the topology's triangle, or of its other side.
    void cap(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const End& ea = end(a);
        const End& eb = end(b);
        const End& ec = end(c);
        triangle(ea.near_vertex, eb.near_vertex, ec.near_vertex);
        far_cap(ea, eb, ec, most_splits);
    }
    /// The front cap's border runs from a to b.
    void side(std::uint32_t a, std::uint32_t b) {
        const End& from = end(a);
        side(from, end(b), most_splits);
    }

    MeshRef mesh() { return data_.indices.empty() ? nullptr : make_mesh(std::move(data_)); }

private:
    static constexpr std::uint32_t none = ~0u;
    struct End {
        vec3 p{0};
        std::uint32_t near_vertex = none, far_vertex = none;
    };

    std::uint32_t vertex(const vec3& p) {
        data_.positions.push_back(p);
        return static_cast<std::uint32_t>(data_.positions.size() - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        data_.indices.insert(data_.indices.end(), {a, mirrored_ ? c : b, mirrored_ ? b : c});
    }

    const End& end(std::uint32_t point) {
        End& e = ends_[point];
        if (e.near_vertex != none) return e;
        e.p = topology_.points[point];
        e.near_vertex = vertex(e.p);
        e.far_vertex = vertex(far_.moved[point]);
        return e;
    }
    /// The midpoint of a wide edge, extruded by the light's full reach.
    End middle(const End& a, const End& b) {
        End m{.p = vec3((dvec3(a.p) + dvec3(b.p)) * 0.5)};
        m.far_vertex = vertex(moved_by_reach(light_, dvec3(m.p)));
        return m;
    }
    bool is_wide(const End& a, const End& b) const {
        return multipass::is_wide(light_, dvec3(a.p), dvec3(b.p));
    }

    /// Joins the border to that of the far cap. A wide border is split; a triangle closes the gap
    /// between it and its halves.
    void side(const End& a, const End& b, int splits) {
        if (splits > 0 && is_wide(a, b)) {
            End m = middle(a, b);
            m.near_vertex = vertex(m.p);
            triangle(b.near_vertex, a.near_vertex, m.near_vertex);
            side(a, m, splits - 1);
            side(m, b, splits - 1);
            return;
        }
        triangle(b.near_vertex, a.near_vertex, a.far_vertex);
        triangle(b.near_vertex, a.far_vertex, b.far_vertex);
    }

    /// The far cap over a, b, c, split as its borders are.
    void far_cap(const End& a, const End& b, const End& c, int splits) {
        if (splits > 0 && (is_wide(a, b) || is_wide(b, c) || is_wide(c, a))) {
            if (is_wide(a, b)) return far_halves(a, b, c, splits);
            return is_wide(b, c) ? far_halves(b, c, a, splits) : far_halves(c, a, b, splits);
        }
        triangle(a.far_vertex, c.far_vertex, b.far_vertex);
    }
    void far_halves(const End& a, const End& b, const End& c, int splits) {
        const End m = middle(a, b);
        far_cap(a, m, c, splits - 1);
        far_cap(m, b, c, splits - 1);
    }

    const Topology& topology_;
    const LightInObject& light_;
    const FarCap& far_;
    bool mirrored_;
    std::vector<End> ends_;  ///< by point of the topology; without vertices those not met yet
    MeshData data_{};
};

/// > 0: the light is on the front side of the triangle.
double facing(const Topology& t, const std::array<std::uint32_t, 3>& triangle,
              const LightInObject& light) {
    const dvec3 a(t.points[triangle[0]]), b(t.points[triangle[1]]), c(t.points[triangle[2]]);
    const dvec3 normal = cross3(b - a, c - a);
    return light.directional ? -dot3(normal, light.position) : dot3(normal, light.position - a);
}

/// The part of the sphere about `p` that the triangle covers, with sign. Van Oosterom, Strackee
/// 1983.
double solid_angle(const Topology& t, const std::array<std::uint32_t, 3>& triangle,
                   const dvec3& p) {
    const dvec3 a = dvec3(t.points[triangle[0]]) - p, b = dvec3(t.points[triangle[1]]) - p,
                c = dvec3(t.points[triangle[2]]) - p;
    const double la = length(a), lb = length(b), lc = length(c);
    return 2 * gw::atan2(dot3(a, cross3(b, c)),
                         la * lb * lc + dot3(a, b) * lc + dot3(b, c) * la + dot3(c, a) * lb);
}

/// Whether p is in the box around the points.
bool is_among(const std::vector<vec3>& points, const dvec3& p) {
    for (int k = 0; k < 3; ++k) {
        const auto [low, high] =
            std::minmax_element(points.begin(), points.end(),
                                [k](const vec3& a, const vec3& b) { return a[k] < b[k]; });
        if (low == points.end() || p[k] < double((*low)[k]) || p[k] > double((*high)[k]))
            return false;
    }
    return true;
}

/// Whether a closed surface winds about the light: then no side of it is away from the light.
bool surrounds(const Topology& t, const LightInObject& light) {
    if (light.directional || !is_among(t.points, light.position)) return false;
    double sum = 0;
    for (const auto& triangle : t.triangles) sum += solid_angle(t, triangle, light.position);
    return std::abs(sum) > 2 * pi;
}

/// By triangle: 1 in the front cap, -1 in it turned over, 0 not in it.
std::vector<int> front_cap(const Topology& t, const LightInObject& light) {
    std::vector<int> part(t.triangles.size());
    const bool front_only = t.closed && !surrounds(t, light);
    for (std::size_t i = 0; i < part.size(); ++i) {
        const double f = facing(t, t.triangles[i], light);
        part[i] = f > 0 ? 1 : f < 0 && !front_only ? -1 : 0;
    }
    return part;
}

/// By edge: how often the front cap's border runs along it, forwards less backwards.
std::vector<int> border(const Topology& t, const std::vector<int>& part) {
    std::vector<int> net(t.edges.size());
    for (std::size_t i = 0; i < part.size(); ++i)
        for (const Topology::Side& side : t.sides[i])
            net[side.edge] += side.forward ? part[i] : -part[i];
    return net;
}

/// The corners of a view's near rectangle, in order, a twentieth wider on every side: snapping
/// moves a vertex by less.
std::array<dvec3, 4> near_rectangle(const dmat4& eye_from_object, const scene::View& view) {
    const dmat4 object_from_clip = glm::inverse(view.clip_from_eye * eye_from_object);
    const auto at = [&](double x, double y) {
        const dvec4 p = object_from_clip * dvec4(1.1 * x, 1.1 * y, -1, 1);
        return dvec3(p) / p.w;
    };
    return {at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)};
}

/// Whether `holds` is true of a box's corners; of no box it is.
template <class Holds>
bool all_corners(const scene::Bounds& box, const Holds& holds) {
    for (int i = 0; i < 8; ++i)
        if (!box.empty && !holds(corner(box, i))) return false;
    return true;
}

/// Whether a point lies between the near and the far plane and in the guard band. If it holds for
/// the corners of a box, it holds for all points in it.
bool is_uncut(const dvec3& p, const dmat4& clip_from_object, const scene::View& view) {
    const auto in_band = [](double ndc, int size) {
        constexpr int slack = 8;  // for jitter and snapping
        const double pixel = (ndc + 1) / 2 * size;
        return pixel > guard_low + slack && pixel < guard_high - slack;
    };
    const dvec4 c = transform(clip_from_object, dvec4(p, 1));
    return c.w > 0 && c.z > -c.w && c.z < c.w && in_band(c.x / c.w, view.width) &&
           in_band(c.y / c.w, view.height);
}

/// Whether neither the near or far plane nor the guard band cuts the surface.
bool is_whole(const ShadowVolume& volume, const dmat4& clip_from_object, const scene::View& view) {
    const auto uncut = [&](const dvec3& p) { return is_uncut(p, clip_from_object, view); };
    if (all_corners(volume.box, uncut)) return true;
    for (const MeshRef& mesh : {volume.caps, volume.sides}) {
        if (!mesh) continue;
        const auto& positions = mesh->data().positions;
        if (!std::all_of(positions.begin(), positions.end(),
                         [&](const vec3& p) { return uncut(dvec3(p)); }))
            return false;
    }
    return true;
}

/// Whether no part of the far cap is between a point of the rectangle and one of the scene. So it
/// is if each of its triangles is beyond a wall that neither point is beyond, or moved by the
/// light's reach, which exceeds both.
bool is_before_far_cap(const ShadowVolume& volume, const std::array<dvec3, 4>& rectangle) {
    const LightInObject& light = volume.light;
    unsigned passed = 0;
    bool reached = false;
    for (const dvec3& p : rectangle) {
        passed |= walls_before(light, p);
        reached |= !((light.directional ? dot3(light.position, p) : length(p - light.position)) <
                     light.reach);
    }
    for (unsigned walls = 0; walls < volume.far_walls.size(); ++walls)
        if (volume.far_walls[walls] && (walls & ~passed) == 0 && (walls != 0 || reached))
            return false;
    return true;
}

double depth(const dmat4& eye_from_world, const dvec3& p) {
    return -(transform3(dmat3(eye_from_world), p).z + eye_from_world[3].z);
}

}  // namespace

ShadowVolume shadow_volume(const Topology& t, const LightInObject& light, bool mirrored) {
    const std::vector<int> part = front_cap(t, light);
    const FarCap far = far_cap(t, light, part);
    ShadowVolume volume{.light = light, .far_walls = far.walls};
    VolumeBuilder caps(t, light, far, mirrored);
    for (std::size_t i = 0; i < part.size(); ++i) {
        const auto& [a, b, c] = t.triangles[i];
        if (part[i] > 0) caps.cap(a, b, c);
        if (part[i] < 0) caps.cap(a, c, b);
    }
    VolumeBuilder sides(t, light, far, mirrored);
    const std::vector<int> net = border(t, part);
    for (std::size_t e = 0; e < net.size(); ++e)
        for (int n = std::abs(net[e]); n > 0; --n)
            net[e] > 0 ? sides.side(t.edges[e].from, t.edges[e].to)
                       : sides.side(t.edges[e].to, t.edges[e].from);
    volume.caps = caps.mesh();
    volume.sides = sides.mesh();
    for (const MeshRef& mesh : {volume.caps, volume.sides})
        if (mesh)
            for (const vec3& p : mesh->data().positions) scene::extend(volume.box, dvec3(p));
    return volume;
}

std::vector<ShadowVolume> shadow_volumes(const PassModel& model,
                                         const std::vector<TopologyRef>& topologies,
                                         std::size_t light) {
    const scene::Bounds bounds = scene::bounds(*model.scene);
    std::vector<ShadowVolume> volumes(model.parts.size());
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        if (model.parts[i].translucent || !model.parts[i].object->casts_shadow) continue;
        const dmat4& placement = model.parts[i].object->world_from_object;
        volumes[i] = shadow_volume(*topologies[i],
                                   light_in_object(model.scene->lights[light], placement, bounds),
                                   glm::determinant(dmat3(placement)) < 0);
    }
    return volumes;
}

scene::View enclosing(scene::View view, const PassModel& model,
                      const std::vector<ShadowVolume>& volumes) {
    double farthest = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const dmat4 eye_from_object = scene::placed(*model.parts[i].object, view).eye_from_object;
        const auto is_near = [&](const dvec3& p) {
            return depth(eye_from_object, p) < (1 - 1e-9) * view.camera.far_plane;
        };
        if (all_corners(volumes[i].box, is_near)) continue;
        for (const MeshRef& mesh : {volumes[i].caps, volumes[i].sides})
            if (mesh)
                for (const vec3& p : mesh->data().positions)
                    farthest = std::max(farthest, depth(eye_from_object, dvec3(p)));
    }
    if (farthest < view.camera.far_plane) return view;
    return scene::with_planes(view, view.camera.near_plane, farthest * 1.001);
}

bool is_outside(const ShadowVolume& volume, const dmat4& eye_from_object, const scene::View& view) {
    if (!is_before_far_cap(volume, near_rectangle(eye_from_object, view))) return false;
    return is_whole(volume, product(view.clip_from_eye, eye_from_object), view);
}

}  // namespace gw::multipass
