// A camera and its window: world to eye, eye to clip, rays through pixels. All in double, without
// libm. Does not draw.
// Eye space: the eye at 0, looking along -z, y up. Clip space: GL's, -w <= x, y, z <= w.
#pragma once

#include "gw/base/types.h"
#include "gw/state.h"
#include "scene/scene.h"

#include <array>
#include <optional>

namespace gw::scene {

/// Rows of a picture, from the bottom: first .. end - 1.
struct Rows {
    int first = 0, end = 0;
    int count() const { return end - first; }
    bool contains(int y) const { return first <= y && y < end; }
    bool operator==(const Rows&) const = default;
};

/// The projection of a scene into a window of width x height pixels. `camera` has its near and far
/// plane filled in.
struct View {
    Camera camera;
    int width = 0, height = 0;
    dmat4 eye_from_world{1};
    dmat4 clip_from_eye{1};
    /// Only these rows are wanted: pixels of others may have any value. None: all.
    std::optional<Rows> only_rows{};

    Rows rows() const { return only_rows.value_or(Rows{0, height}); }
    /// The place of pixel x, y in rows from the bottom.
    std::size_t index(int x, int y) const { return pixel_index(x, y, width); }
};

/// The camera's view. A near or far plane of 0 is fitted to `bounds`, a little nearer and farther
/// than anything in it; near is never less than a 4096th of far. Throws Error if eye and at are one
/// point, or the window has no pixels.
View make_view(const Camera& camera, const Bounds& bounds, int width, int height);

/// The same for a scene's own camera (which it must have: see add_defaults) and bounds.
View make_view(const Scene& scene, int width, int height);

/// Six views from `center` along +x, -x, +y, -y, +z, -z, size x size pixels each, whose frusta meet
/// exactly: 90 degrees, matrices of 0, 1 and -1 (and near and far). Up is +y, but -z and +z for +y
/// and -y. Used by hemicubes, shadows of point lights and reflection maps.
std::array<View, 6> cube_views(const dvec3& center, double near_plane, double far_plane, int size);

/// The view with other near and far planes; left, right, bottom and top stay.
View with_planes(View view, double near_plane, double far_plane);

/// Smallest and largest distance of a box from the eye, along the line of sight.
struct DepthInterval {
    double nearest = 0, farthest = 0;
};
DepthInterval depth_interval(const Bounds& bounds, const dmat4& eye_from_world);

/// A distance from p beyond all of the box: the sum of those along the axes.
double reach_around(const dvec3& p, const Bounds& box);

/// Whether `up` is parallel to the view but for rounding, or 0.
bool is_along(const dvec3& view, const dvec3& up);

/// World to eye: `eye` at 0, `at` on -z, `up` in the upper half of the yz plane. An up parallel to the
/// line of sight is replaced by an axis that is not.
dmat4 look_at(const dvec3& eye, const dvec3& at, const dvec3& up);

/// Eye to clip for the frustum whose near rectangle is left .. right, bottom .. top (glFrustum).
dmat4 frustum(double left, double right, double bottom, double top, double near_plane,
              double far_plane);
/// Eye to clip for a box (glOrtho).
dmat4 ortho(double left, double right, double bottom, double top, double near_plane,
            double far_plane);

/// A ray through a pixel in world space, from the near plane (t = 0) to the far plane (t = 1).
struct PixelRay {
    dvec3 o{0}, d{0};
};

class PixelRays {
public:
    explicit PixelRays(const View& view);

    /// Through a window position: pixel (i, j) has its centre at (i + 1/2, j + 1/2).
    PixelRay through(double x, double y) const;

private:
    dmat4 world_from_clip_;
    double width_, height_;
};

/// The point of a pixel, from its corner, through which its ray of a jittered picture passes. The
/// machine moves the scene by the jitter, so the ray moves the opposite way.
dvec2 place_in_pixel(const JitterState& jitter, int subpixel_bits);

}  // namespace gw::scene
