// A camera's matrices: GL's, by sums, products and quotients in double only.
#include "scene/draw/view.h"

#include "gw/base/elementary.h"
#include "gw/error.h"
#include "gw/stages/vertex.h"
#include "scene/draw/nearest.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gw::scene {
namespace {

/// Depth has few bits: near is at least this part of far.
constexpr double least_near = 1.0 / 4096;
/// Fitted planes leave this part of the scene's depth free on both sides.
constexpr double depth_margin = 1.0 / 64;

/// An axis that is not parallel to `forward`.
dvec3 any_up(const dvec3& forward) {
    return std::abs(forward.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, forward.y > 0 ? 1 : -1);
}

/// Fills in the planes that are 0.
void fit_planes(Camera& camera, const Bounds& bounds, const dmat4& eye_from_world) {
    const bool fit_near = camera.near_plane <= 0, fit_far = camera.far_plane <= 0;
    if (!fit_near && !fit_far) return;
    const dvec3 line = camera.at - camera.eye;
    const double reach = length(line);
    auto [nearest, farthest] =
        bounds.empty ? DepthInterval{reach, reach} : depth_interval(bounds, eye_from_world);
    if (farthest <= 0) nearest = farthest = reach;  // all behind the eye: any planes do
    const double margin = std::max((farthest - nearest) * depth_margin, farthest * 1e-3);
    if (fit_far) camera.far_plane = std::max(farthest + margin, camera.near_plane * 2);
    if (fit_near) camera.near_plane = std::max(nearest - margin, camera.far_plane * least_near);
    // A far plane that was given may lie before everything.
    if (camera.near_plane >= camera.far_plane) camera.near_plane = camera.far_plane * least_near;
}

dmat4 projection(const Camera& camera, double aspect) {
    if (camera.ortho_height > 0) {
        const double y = camera.ortho_height / 2, x = y * aspect;
        return ortho(-x, x, -y, y, camera.near_plane, camera.far_plane);
    }
    const double y = tan_degrees(camera.fov / 2) * camera.near_plane, x = y * aspect;
    return frustum(-x, x, -y, y, camera.near_plane, camera.far_plane);
}

}  // namespace

DepthInterval depth_interval(const Bounds& bounds, const dmat4& eye_from_world) {
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (int i = 0; i < 8; ++i) {
        const dvec3 p = corner(bounds, i);
        const double distance = -(transform3(dmat3(eye_from_world), p).z + eye_from_world[3].z);
        nearest = std::min(nearest, distance);
        farthest = std::max(farthest, distance);
    }
    return {nearest, farthest};
}

double reach_around(const dvec3& p, const Bounds& box) {
    double reach = 0;
    for (int k = 0; k < 3; ++k)
        reach += std::max(std::abs(box.low[k] - p[k]), std::abs(box.high[k] - p[k]));
    return reach;
}

bool is_along(const dvec3& view, const dvec3& up) {
    const dvec3 forward = normalized(view);
    return !(length(cross3(forward, up)) > 1e-9 * length(up));
}

dmat4 look_at(const dvec3& eye, const dvec3& at, const dvec3& up) {
    const dvec3 forward = normalized(at - eye);
    const dvec3 right = normalized(cross3(forward, is_along(forward, up) ? any_up(forward) : up));
    const dvec3 above = cross3(right, forward);
    dmat4 m(1);
    for (int k = 0; k < 3; ++k) m[k] = dvec4(right[k], above[k], -forward[k], 0);
    m[3] = dvec4(-dot3(right, eye), -dot3(above, eye), dot3(forward, eye), 1);
    return m;
}

dmat4 frustum(double left, double right, double bottom, double top, double near_plane,
              double far_plane) {
    dmat4 m(0);
    m[0].x = 2 * near_plane / (right - left);
    m[1].y = 2 * near_plane / (top - bottom);
    m[2] = dvec4((right + left) / (right - left), (top + bottom) / (top - bottom),
                 -(far_plane + near_plane) / (far_plane - near_plane), -1);
    m[3].z = -2 * far_plane * near_plane / (far_plane - near_plane);
    return m;
}

dmat4 ortho(double left, double right, double bottom, double top, double near_plane,
            double far_plane) {
    dmat4 m(1);
    m[0].x = 2 / (right - left);
    m[1].y = 2 / (top - bottom);
    m[2].z = -2 / (far_plane - near_plane);
    m[3] = dvec4(-(right + left) / (right - left), -(top + bottom) / (top - bottom),
                 -(far_plane + near_plane) / (far_plane - near_plane), 1);
    return m;
}

View make_view(const Camera& camera, const Bounds& bounds, int width, int height) {
    if (width < 1 || height < 1) throw Error("a view needs a window of at least 1x1 pixels");
    if (camera.eye == camera.at)
        throw Error("camera: eye and at are the same point; expected two points");
    View view{.camera = camera, .width = width, .height = height};
    view.eye_from_world = look_at(camera.eye, camera.at, camera.up);
    fit_planes(view.camera, bounds, view.eye_from_world);
    view.clip_from_eye = projection(view.camera, double(width) / height);
    return view;
}

View make_view(const Scene& scene, int width, int height) {
    if (!scene.camera) throw Error("scene '" + scene.name + "' has no camera");
    return fitted_view(*scene.camera, scene, bounds(scene), width, height);
}

View with_planes(View view, double near_plane, double far_plane) {
    view.camera.near_plane = near_plane;
    view.camera.far_plane = far_plane;
    const bool perspective = view.clip_from_eye[2].w != 0;
    const dmat4 depth = perspective ? frustum(-1, 1, -1, 1, near_plane, far_plane)
                                    : ortho(-1, 1, -1, 1, near_plane, far_plane);
    view.clip_from_eye[2].z = depth[2].z;
    view.clip_from_eye[3].z = depth[3].z;
    return view;
}

std::array<View, 6> cube_views(const dvec3& center, double near_plane, double far_plane, int size) {
    static constexpr double axes[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                          {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    std::array<View, 6> views;
    for (std::size_t face = 0; face < 6; ++face) {
        const dvec3 forward(axes[face][0], axes[face][1], axes[face][2]);
        const dvec3 up = forward.y == 0 ? dvec3(0, 1, 0) : dvec3(0, 0, -forward.y);
        View& view = views[face];
        view.camera = {.eye = center,
                       .at = center + forward,
                       .up = up,
                       .fov = 90,
                       .near_plane = near_plane,
                       .far_plane = far_plane};
        view.width = view.height = size;
        // Rotation first: center + forward may round.
        view.eye_from_world = look_at(dvec3(0), forward, up);
        view.eye_from_world[3] = dvec4(-transform3(dmat3(view.eye_from_world), center), 1);
        view.clip_from_eye =
            frustum(-near_plane, near_plane, -near_plane, near_plane, near_plane, far_plane);
    }
    return views;
}

PixelRays::PixelRays(const View& view)
    : world_from_clip_(glm::inverse(view.clip_from_eye * view.eye_from_world)),
      width_(view.width),
      height_(view.height) {}

PixelRay PixelRays::through(double x, double y) const {
    const auto at = [&](double z) {
        const dvec4 p = world_from_clip_ * dvec4(2 * x / width_ - 1, 2 * y / height_ - 1, z, 1);
        return dvec3(p) / p.w;
    };
    const dvec3 o = at(-1);
    return {o, at(1) - o};
}

dvec2 place_in_pixel(const JitterState& jitter, int subpixel_bits) {
    const double unit = std::ldexp(1.0, -subpixel_bits);
    return {0.5 - jitter.x * unit, 0.5 - jitter.y * unit};
}

}  // namespace gw::scene
