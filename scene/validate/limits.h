// The limits of a scene's numbers: readers of files bind keys by these tables, and check.h checks
// scenes that code has built. Rules that join several values are in rules.h.
#pragma once

#include "gw/base/types.h"
#include "scene/scene.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

namespace gw::scene {

/// Numbers that a value may have, ends included.
struct Range {
    double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
    /// Not a number is outside every range. A float32 may be the nearest to an end.
    template <class Number>
    bool contains(Number value) const {
        constexpr bool single = std::is_same_v<Number, float>;
        return double(value) >= (single ? nearest_float(low) : low) &&
               double(value) <= (single ? nearest_float(high) : high);
    }

private:
    static double nearest_float(double end) {
        constexpr double most = std::numeric_limits<float>::max();
        return double(float(std::clamp(end, -most, most)));
    }
};
/// "a number from 0 to 1"
std::string range_text(std::string_view what, Range range);

inline constexpr Range not_negative{0, std::numeric_limits<double>::max()};
/// Coordinates far beyond any scene; products of three still fit a double, squares a float32.
inline constexpr Range placeable{-1e18, 1e18};
inline constexpr Range distances{0, 1e18};
/// For one object's pixmap, and for the scene's without a size.
inline constexpr Range pixmap_sides{1, 4096}, texels_per_unit{1e-9, 1e9};

/// A value's name in files, and as a member.
struct FieldName {
    const char *file, *member;
    FieldName(const char* both) : file(both), member(both) {}
    FieldName(const char* in_file, const char* as_member) : file(in_file), member(as_member) {}
};

// Each calls visit.number(name, member, range) for numbers, visit.place(name, member) for points
// and directions in the world, visit.color(name, member) for colours, which are not negative.

template <class Camera, class Visit>
void visit_camera(Camera& camera, const Visit& visit) {
    visit.place("eye", camera.eye);
    visit.place("at", camera.at);
    visit.place("up", camera.up);
    visit.number("fov", camera.fov, {0.1, 179});
    visit.number({"near", "near_plane"}, camera.near_plane, distances);
    visit.number({"far", "far_plane"}, camera.far_plane, distances);
    visit.number({"ortho", "ortho_height"}, camera.ortho_height, distances);
    visit.number("aperture", camera.aperture, distances);
    visit.number("focus", camera.focus, distances);
}

template <class Fog, class Visit>
void visit_fog(Fog& fog, const Visit& visit) {
    visit.color("color", fog.color);
    visit.number("density", fog.density, not_negative);
    visit.number("start", fog.start, distances);
    visit.number("end", fog.end, distances);
}

template <class Light, class Visit>
void visit_light(Light& light, const Visit& visit) {
    visit.place("position", light.position);
    visit.place("direction", light.direction);
    visit.color("Ia", light.Ia);
    visit.color("Id", light.Id);
    visit.number({"cone", "cone_angle"}, light.cone_angle, {0, 90});
    visit.number({"exponent", "spot_exponent"}, light.spot_exponent, {0, 128});
}

template <class AreaLight, class Visit>
void visit_area(AreaLight& area, const Visit& visit) {
    visit.place("u", area.u);
    visit.place("v", area.v);
    visit.number("samples", area.samples, {1, 4096});
}

template <class Material, class Visit>
void visit_material(Material& material, const Visit& visit) {
    visit.color("Ka", material.Ka);
    visit.color("Kd", material.Kd);
    visit.color("Ks", material.Ks);
    visit.color("Ke", material.Ke);
    visit.color("Tf", material.Tf);
    visit.number("Ns", material.Ns, {0, 10000});
    visit.number("Ni", material.Ni, {0.01, 100});
    visit.number("d", material.d, {0, 1});
    visit.number("illum", material.illum, {0, 10});
}

template <class Glare, class Visit>
void visit_glare(Glare& glare, const Visit& visit) {
    visit.number("radius", glare.radius, {1e-9, 1e9});
    visit.number("strength", glare.strength, not_negative);
    visit.number("rays", glare.rays, {0, 64});
    visit.number("samples", glare.samples, {1, 4096});
}

}  // namespace gw::scene
