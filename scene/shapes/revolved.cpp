// Shapes of revolution: a profile each.
#include "gw/base/elementary.h"
#include "scene/shapes/grid.h"
#include "scene/shapes/lathe.h"
#include "scene/shapes/shapes.h"

namespace gw::scene {
namespace {

// A straight profile from a to b in `steps` steps.
std::vector<ProfilePoint> straight(dvec2 a, dvec2 b, int steps) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        profile.push_back({a * (1 - t) + b * t, {b.y - a.y, a.x - b.x}, t});
    }
    return profile;
}

void lay_flat(MeshData& disc, double radius) {
    for (std::size_t i = 0; i < disc.positions.size(); ++i) {
        const dvec3 p = dvec3(disc.positions[i]) / (2 * radius);
        disc.texcoords[i] = vec2(dvec2(0.5 + p.x, disc.normals[i].y > 0 ? 0.5 - p.z : 0.5 + p.z));
    }
}

MeshData cap(double radius, double y, bool up, int slices, int rings) {
    const dvec2 middle{0, y}, border{radius, y};
    MeshData disc =
        revolve(up ? straight(border, middle, rings) : straight(middle, border, rings), slices);
    lay_flat(disc, radius);
    return disc;
}

}  // namespace

MeshData make_sphere(double radius, int slices, int stacks) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= stacks; ++i) {
        const double degrees = 180.0 * i / stacks - 90;
        const dvec2 normal{cos_degrees(degrees), sin_degrees(degrees)};
        profile.push_back({radius * normal, normal, static_cast<double>(i) / stacks});
    }
    return revolve(profile, slices);
}

MeshData make_torus(double radius, double tube, int segments, int sides) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= sides; ++i) {
        const double degrees = 360.0 * (i % sides) / sides;  // the last point is the first
        const dvec2 normal{cos_degrees(degrees), sin_degrees(degrees)};
        profile.push_back(
            {dvec2(radius, 0) + tube * normal, normal, static_cast<double>(i) / sides});
    }
    return revolve(profile, segments);
}

MeshData make_disc(double radius, int slices, int rings) {
    return cap(radius, 0, true, slices, rings);
}

MeshData make_cylinder(double radius, double height, int slices, int stacks, bool capped) {
    MeshData mesh = revolve(straight({radius, -height / 2}, {radius, height / 2}, stacks), slices);
    if (capped) append(mesh, cap(radius, -height / 2, false, slices, 1));
    if (capped) append(mesh, cap(radius, height / 2, true, slices, 1));
    return mesh;
}

MeshData make_cone(double radius, double height, int slices, int stacks, bool capped) {
    MeshData mesh = revolve(straight({radius, -height / 2}, {0, height / 2}, stacks), slices);
    if (capped) append(mesh, cap(radius, -height / 2, false, slices, 1));
    return mesh;
}

}  // namespace gw::scene
