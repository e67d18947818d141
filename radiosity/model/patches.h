// Patches [F2], and the points of a patch on which hemicubes stand. Does not draw.
#pragma once

#include "radiosity/model/pixmap_model.h"

#include <limits>

namespace gw::radiosity {

/// Blocks of side x side texels, those with an area.
std::vector<Patch> patches_of(const PixmapModel& model, int side);

/// The position of one hemicube, which represents a part of a patch.
struct ShootPoint {
    dvec3 position{0}, normal{0};
    double share = 0;  ///< of the patch's area; the shares of a patch add up to 1
    double size = 0;   ///< how far the part reaches
    /// From a surface, front or back, that rises above the point's plane. Only known if it is less
    /// than a part of `size` (nearest_known).
    double nearest = std::numeric_limits<double>::infinity();
};

/// A surface farther from a point than this part of ShootPoint::size is not looked for.
inline constexpr double nearest_known = 1.0 / 16;

/// In parts of the scene's extent: a surface that rises less above a point's plane touches it.
inline constexpr double touching = 1e-6;

struct PointOptions {
    /// A part is divided while it is longer than `nearness` times its distance from the surfaces
    /// that it can see. A surface farther away than the part is long, but low over its plane,
    /// counts by its elevation ...
    double nearness = 1;
    /// ... but not into parts smaller than this many texels, or than this part of a narrow pixmap's
    /// side. Half of that if a plane figure covers texels in part. Parts of a patch that emits are
    /// divided down to `emitter_part` texels.
    double smallest_part = 1, smallest_of_pixmap = 1.0 / 8, emitter_part = 2;
};

/// At most four points for each undivided part. If figures cover it all, they are those of Gauss' rule,
/// exact for cubic integrands; else the middles of the covered quarters.
std::vector<ShootPoint> points_of(const PixmapModel& model, const Patch& patch,
                                  const PointOptions& options = {});

}  // namespace gw::radiosity
