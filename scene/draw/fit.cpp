#include "scene/draw/fit.h"

#include "gw/base/elementary.h"
#include "scene/draw/view.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

/// Direction from the centre of a bare model to the eye.
constexpr double seen_from[3] = {0.4, 0.35, 1};
constexpr double fit_margin = 1.05;

/// Distance of the eye from the centre at which the point `p_eye` (relative to the centre, eye
/// axes) just touches the border of the window. By similar triangles: no angle is measured.
double distance_for(const dvec3& p, double slope_x, double slope_y) {
    return p.z + std::max(std::abs(p.x) / slope_x, std::abs(p.y) / slope_y);
}

bool emits(const Material& m) { return m.Ke != vec3(0) || !m.map_Ke.empty(); }

}  // namespace

Camera fit_camera(const Bounds& bounds, int width, int height) {
    Camera camera;
    const dvec3 center = bounds.empty ? dvec3(0) : (bounds.low + bounds.high) * 0.5;
    const dvec3 half = bounds.empty ? dvec3(1) : (bounds.high - bounds.low) * 0.5;
    const dvec3 toward(seen_from[0], seen_from[1], seen_from[2]);
    const dmat3 eye_from_world(look_at(toward, dvec3(0), camera.up));
    const double slope_y = tan_degrees(camera.fov / 2), slope_x = slope_y * width / height;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 p_eye = transform3(eye_from_world, corner({.low = -half, .high = half}, i));
        distance = std::max(distance, distance_for(p_eye, slope_x, slope_y));
    }
    if (distance == 0) distance = 1;  // a single point
    camera.at = center;
    camera.eye = center + toward * (fit_margin * distance / length(toward));
    return camera;
}

Light default_light(const Camera& camera) {
    const dmat4 eye_from_world = look_at(camera.eye, camera.at, camera.up);
    const dvec3 travels_eye(0.4, -0.6, -1);
    Light light;
    light.name = default_light_name;
    for (int k = 0; k < 3; ++k)  // the inverse of a rotation is its transpose
        light.direction[k] = static_cast<float>(dot3(dvec3(eye_from_world[k]), travels_eye));
    light.Ia = vec3(0.25f);
    light.Id = vec3(0.8f);
    return light;
}

bool glows(const Scene& scene) { return std::ranges::any_of(scene.materials, emits); }

void add_defaults(Scene& scene, int width, int height) {
    if (!scene.camera) scene.camera = fit_camera(bounds(scene), width, height);
    if (scene.lights.empty() && !glows(scene)) scene.lights.push_back(default_light(*scene.camera));
}

Camera override_camera(Camera camera, const CameraOverrides& overrides) {
    if (overrides.eye) camera.eye = *overrides.eye;
    if (overrides.at) camera.at = *overrides.at;
    if (overrides.up) camera.up = *overrides.up;
    if (overrides.fov) camera.fov = *overrides.fov;
    return camera;
}

Camera turntable(Camera camera, double degrees) {
    const double turn = std::fmod(degrees, 360);
    if (turn == 0) return camera;
    const double c = cos_degrees(turn), s = sin_degrees(turn);
    const dvec3 axis = camera.up / length(camera.up);
    // Rodrigues: v cos + (axis x v) sin + axis (axis . v) (1 - cos).
    const dvec3 v = camera.eye - camera.at;
    camera.eye = camera.at + v * c + cross3(axis, v) * s + axis * (dot3(axis, v) * (1 - c));
    return camera;
}

}  // namespace gw::scene
