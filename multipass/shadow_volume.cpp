// Caps and sides.
#include "multipass/shadow_volume.h"

#include "gw/elementary.h"
#include "scene/draw_commands.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

double length(const dvec3& v) { return std::sqrt(dot3(v, v)); }

/// The far cap of a point light is a polyhedron about it whose edges span at most 60 degrees; its faces are
/// nearer to the light than its corners, by a factor of more than 0.8.
constexpr double corner_reach = 1.3;
constexpr int most_splits = 24;

/// Collects the surface's triangles.
struct VolumeBuilder {
    const LightInObject& light;
    bool mirrored = false;
    MeshData data{};

    void triangle(const vec3& a, const vec3& b, const vec3& c) {
        data.positions.insert(data.positions.end(), {a, mirrored ? c : b, mirrored ? b : c});
    }

    /// The point moved away from the light.
    vec3 moved(const vec3& v) const {
        const dvec3 p(v);
        if (light.directional) return vec3(p + light.position * (light.reach - dot3(light.position, p)));
        const dvec3 d = p - light.position;
        const double distance = length(d);
        return distance > 0 ? vec3(light.position + d * (light.reach * corner_reach / distance)) : v;
    }

    /// Whether the light sees a and b under more than 60 degrees.
    bool is_wide(const vec3& a, const vec3& b) const {
        if (light.directional) return false;
        const dvec3 u = dvec3(a) - light.position, v = dvec3(b) - light.position;
        return dot3(u, v) < 0.5 * length(u) * length(v);
    }

    static vec3 middle(const vec3& a, const vec3& b) { return vec3((dvec3(a) + dvec3(b)) * 0.5); }

    /// From the border a to b of the front cap to that of the far cap. A wide border is split, and what opens
    /// between it and its halves is closed.
    void side(const vec3& a, const vec3& b, int splits = most_splits) {
        if (splits > 0 && is_wide(a, b)) {
            const vec3 m = middle(a, b);
            triangle(b, a, m);
            side(a, m, splits - 1);
            side(m, b, splits - 1);
            return;
        }
        const vec3 far_a = moved(a), far_b = moved(b);
        triangle(b, a, far_a);
        triangle(b, far_a, far_b);
    }

    /// The far cap over a, b, c, split as its borders are.
    void far_cap(const vec3& a, const vec3& b, const vec3& c, int splits = most_splits) {
        if (splits > 0 && (is_wide(a, b) || is_wide(b, c) || is_wide(c, a))) {
            if (is_wide(a, b)) return far_halves(a, b, c, splits);
            return is_wide(b, c) ? far_halves(b, c, a, splits) : far_halves(c, a, b, splits);
        }
        triangle(moved(a), moved(c), moved(b));
    }

    void far_halves(const vec3& a, const vec3& b, const vec3& c, int splits) {
        const vec3 m = middle(a, b);
        far_cap(a, m, c, splits - 1);
        far_cap(m, b, c, splits - 1);
    }
};

/// > 0: the light is on the front of the triangle.
double facing(const Topology& t, const std::array<std::uint32_t, 3>& triangle, const LightInObject& light) {
    const dvec3 a(t.points[triangle[0]]), b(t.points[triangle[1]]), c(t.points[triangle[2]]);
    const dvec3 normal = cross3(b - a, c - a);
    return light.directional ? -dot3(normal, light.position) : dot3(normal, light.position - a);
}

/// The part of the sphere about `p` that the triangle covers, with sign. Van Oosterom, Strackee 1983.
double solid_angle(const Topology& t, const std::array<std::uint32_t, 3>& triangle, const dvec3& p) {
    const dvec3 a = dvec3(t.points[triangle[0]]) - p, b = dvec3(t.points[triangle[1]]) - p,
                c = dvec3(t.points[triangle[2]]) - p;
    const double la = length(a), lb = length(b), lc = length(c);
    return 2 * gw::atan2(dot3(a, cross3(b, c)),
                         la * lb * lc + dot3(a, b) * lc + dot3(b, c) * la + dot3(c, a) * lb);
}

/// Whether a closed surface winds about the light: then it has no side that is away from it.
bool surrounds(const Topology& t, const LightInObject& light) {
    if (light.directional) return false;
    double sum = 0;
    for (const auto& triangle : t.triangles) sum += solid_angle(t, triangle, light.position);
    return std::abs(sum) > 2 * pi;
}

/// By triangle: 1 in the front cap as it is, -1 turned over, 0 not.
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
        for (const Topology::Side& side : t.sides[i]) net[side.edge] += side.forward ? part[i] : -part[i];
    return net;
}

dvec3 corner(const scene::Bounds& b, int i) {
    return {i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z};
}

double depth(const dmat4& eye_from_world, const dvec3& p) {
    return -(transform3(dmat3(eye_from_world), p).z + eye_from_world[3].z);
}

}  // namespace

LightInObject light_in_object(const scene::Light& light, const dmat4& world_from_object,
                              const scene::Bounds& bounds) {
    const dmat4 object_from_world = glm::inverse(world_from_object);
    LightInObject out{.directional = light.kind == scene::LightKind::Directional};
    if (out.directional) {
        const dvec3 way = transform3(dmat3(object_from_world), dvec3(light.direction));
        out.position = way / length(way);
    } else {
        out.position =
            transform3(dmat3(object_from_world), dvec3(light.position)) + dvec3(object_from_world[3]);
    }
    for (int i = 0; i < 8; ++i) {
        const dvec3 p = transform3(dmat3(object_from_world), corner(bounds, i)) + dvec3(object_from_world[3]);
        const double r = out.directional ? dot3(out.position, p) : length(p - out.position);
        out.reach = i == 0 ? r : std::max(out.reach, r);
    }
    // A little further than everything.
    const dvec3 diagonal = transform3(dmat3(object_from_world), bounds.high - bounds.low);
    out.reach += 0.01 * length(diagonal);
    return out;
}

MeshRef shadow_volume(const Topology& t, const LightInObject& light, bool mirrored) {
    const std::vector<int> part = front_cap(t, light);
    VolumeBuilder volume{light, mirrored};
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (part[i] == 0) continue;
        const vec3 &a = t.points[t.triangles[i][0]], &b = t.points[t.triangles[i][part[i] > 0 ? 1 : 2]],
                   &c = t.points[t.triangles[i][part[i] > 0 ? 2 : 1]];
        volume.triangle(a, b, c);
        volume.far_cap(a, b, c);
    }
    const std::vector<int> net = border(t, part);
    for (std::size_t e = 0; e < net.size(); ++e)
        for (int n = std::abs(net[e]); n > 0; --n)
            net[e] > 0 ? volume.side(t.points[t.edges[e].from], t.points[t.edges[e].to])
                       : volume.side(t.points[t.edges[e].to], t.points[t.edges[e].from]);
    return volume.data.positions.empty() ? nullptr : make_mesh(std::move(volume.data));
}

std::vector<MeshRef> shadow_volumes(const Model& model, const std::vector<Topology>& topologies,
                                    std::size_t light) {
    const scene::Bounds bounds = scene::bounds(*model.scene);
    std::vector<MeshRef> volumes(model.parts.size());
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        if (model.parts[i].translucent || !model.parts[i].object->casts_shadow) continue;
        const dmat4& placement = model.parts[i].object->world_from_object;
        volumes[i] =
            shadow_volume(topologies[i], light_in_object(model.scene->lights[light], placement, bounds),
                          glm::determinant(dmat3(placement)) < 0);
    }
    return volumes;
}

scene::View enclosing(scene::View view, const Model& model, const std::vector<MeshRef>& volumes) {
    double farthest = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        if (!volumes[i]) continue;
        const dmat4 eye_from_object = scene::placed(*model.parts[i].object, view).eye_from_object;
        for (const vec3& p : volumes[i]->data().positions)
            farthest = std::max(farthest, depth(eye_from_object, dvec3(p)));
    }
    if (farthest < view.camera.far_plane) return view;
    return scene::with_planes(view, view.camera.near_plane, farthest * 1.001);
}

}  // namespace gw::multipass
