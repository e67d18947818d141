// Takes lines from the world to the window grid without the snap, for algorithms that decide in the
// scene. Does not hide anything.
#pragma once

#include "hiddensurface/interface/line_algorithm.h"

namespace gw::hiddensurface {

/// The world plane (n, d) of the view's near plane: n.p + d > 0 beyond it.
dvec4 near_plane_of(const scene::View& view);

/// A line from the world to the window.
class WorldLines {
public:
    explicit WorldLines(const Input& input);

    /// p -> q with its visible parts (linear in the world), clipped to the near and far planes. None:
    /// the line is outside the planes, or seen end on.
    std::optional<Line> to_window(std::uint32_t id, const dvec3& p, const dvec3& q,
                                  const std::vector<Part>& visible) const;

    /// A point beyond the near plane.
    dvec3 on_grid(const dvec3& p) const;

private:
    dvec3 on_grid(const dvec4& clip) const;

    dmat4 clip_from_world_;
    dvec3 scale_;
};

}  // namespace gw::hiddensurface
