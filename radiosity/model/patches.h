// Patches [F2], and the points of a patch on which hemicubes stand. Does not draw.
#pragma once

#include "radiosity/model/pixmap_model.h"

namespace gw::radiosity {

/// Blocks of side x side texels, those with an area.
std::vector<Patch> patches_of(const PixmapModel& model, int side);

/// The position of one hemicube, which represents a part of a patch.
struct ShootPoint {
    dvec3 position{0}, normal{0};
    double share = 0;  ///< of the patch's area; the shares of a patch add up to 1
    /// how far the part reaches: nothing that it sees is nearer than a fraction of this
    double size = 0;
};

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
