// What of a scene stands nearest before the eye, within the picture, and views that spare it. Does
// not draw.
#pragma once

#include "scene/draw/view.h"
#include "scene/scene.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace gw::scene {

struct Nearest {
    std::size_t object = 0;
    double distance = std::numeric_limits<double>::infinity();
};

/// The face, line or point in the view's window that comes nearest to the eye's plane, of those
/// nearer than `limit`, whatever the view's planes are; none: the distance is infinite. Objects that
/// move count where they begin, are and end. Faces whose planes pass the eye within `edge_on` do not
/// count.
Nearest nearest_in(const View& view, const Scene& scene, double limit, double edge_on = 0);

/// The view with near before all that stands in its window, down to a 65536th of far. The camera's
/// fov, ortho_height and planes are those of the matrices. `edge_on` as of nearest_in.
View sparing_near(const View& view, const Scene& scene, double edge_on = 0);

/// For sparing_near of a map around a point, on which surfaces may lie: seen edge-on they hide
/// nothing, and a nearer near plane would cost depth.
double edge_on_in_map(const View& view);

/// The camera's view of a scene whose bounds these are. A fitted near plane (make_view) spares what
/// stands before it, as sparing_near. A fitted far plane lies behind objects that move.
View fitted_view(const Camera& camera, const Scene& scene, const Bounds& bounds, int width,
                 int height);

/// What the near plane of fitted_view still cuts off; none: nothing, or the camera of the scene has
/// a near plane of its own.
std::optional<Nearest> cut_by_near(const Scene& scene, const View& view);

/// "object 'wall' is cut off ...", for renderers with a near plane; empty: nothing is cut off.
std::string near_warning(const Scene& scene, const View& view);

/// The view for rays, which need no near plane: one that cuts nothing off.
View view_for_rays(const Scene& scene, const View& view);

}  // namespace gw::scene
