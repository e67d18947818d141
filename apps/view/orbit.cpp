#include "apps/view/orbit.h"

#include "gw/base/elementary.h"
#include "scene/draw/view.h"

#include <algorithm>

namespace gw::apps {
namespace {

constexpr double degree = pi / 180;

/// Right, up and back of the picture, in the world.
struct Axes {
    dvec3 right, up, back;
};
Axes axes_of(const scene::Camera& camera) {
    const dmat4 m = scene::look_at(camera.eye, camera.at, camera.up);
    const auto row = [&](int i) { return dvec3(m[0][i], m[1][i], m[2][i]); };
    return {row(0), row(1), row(2)};
}

/// Rodrigues' formula; `axis` has length 1.
dvec3 turned(const dvec3& v, const dvec3& axis, double degrees) {
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

}  // namespace

scene::Camera orbited(scene::Camera camera, double right, double above) {
    const dvec3 pole = normalize(camera.up);
    dvec3 arm = turned(camera.eye - camera.at, pole, right);
    const double sine = std::clamp(dot(normalize(arm), pole), -1.0, 1.0);
    const double height = gw::asin(sine) / degree;
    const double wanted = std::clamp(height + above, -89.0, 89.0);
    const dvec3 side = cross(arm, pole);
    // An eye on the pole has no side: the picture's own takes its place.
    const dvec3 axis = length(side) > 1e-9 * length(arm) ? normalize(side) : axes_of(camera).right;
    arm = turned(arm, axis, wanted - height);
    camera.eye = camera.at + arm;
    return camera;
}

scene::Camera panned(scene::Camera camera, double right, double up) {
    const double distance = length(camera.at - camera.eye);
    const double height =
        camera.ortho_height > 0 ? camera.ortho_height : 2 * distance * tan_degrees(camera.fov / 2);
    const Axes axes = axes_of(camera);
    const dvec3 move = (axes.right * right + axes.up * up) * height;
    camera.eye -= move;
    camera.at -= move;
    return camera;
}

scene::Camera zoomed(scene::Camera camera, double factor) {
    if (camera.ortho_height > 0) {
        camera.ortho_height = std::clamp(camera.ortho_height * factor, 1e-6, 1e12);
        return camera;
    }
    const dvec3 arm = camera.eye - camera.at;
    const double distance = length(arm);
    const double wanted = std::clamp(distance * factor, 1e-6, 1e12);
    camera.eye = camera.at + arm * (wanted / distance);
    return camera;
}

}  // namespace gw::apps
