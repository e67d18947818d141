// The points of a patch on which hemicubes stand [F2.2p]. Does not draw.
#pragma once

#include "radiosity/model/near_parts.h"
#include "radiosity/model/patches.h"

#include <limits>

namespace gw::radiosity {

inline constexpr std::uint32_t no_part = 0xffffffff;

/// The position of one hemicube, which represents a part of a patch.
struct ShootPoint {
    dvec3 position{0}, normal{0};
    double share = 0;  ///< of the patch's area; the shares of a patch add up to 1
    double size = 0;   ///< how far the part reaches
    /// From a surface, front or back, that rises above the point's plane. Only known if it is less
    /// than a part of `size` (nearest_known).
    double nearest = std::numeric_limits<double>::infinity();
    /// of Shooting::near_parts: the part that the point stands for; none: no_part
    std::uint32_t near_part = no_part;
    double farthest = 0;  ///< a surface that it may see, if that is beyond the scene's extent
    int quarter = 0;      ///< of the patch: 1 has the higher u, 2 the higher v, 3 both
};

/// A surface farther from a point than this part of ShootPoint::size is not looked for.
inline constexpr double nearest_known = 1.0 / 16;

struct PointOptions {
    /// A part is divided while it is longer than `nearness` times its distance from the surfaces
    /// that it can see. A surface farther away than the part is long, but low over its plane,
    /// counts by its elevation ...
    double nearness = 1;
    /// ... but not into parts smaller than this many texels, or than this part of a narrow pixmap's
    /// side. Half of that if a plane figure covers texels in part. Parts of a patch that emits are
    /// divided down to `emitter_part` texels.
    double smallest_part = 1, smallest_of_pixmap = 1.0 / 8, emitter_part = 2;
    /// Whether a part that is near only to surfaces that nothing hides from it is left whole.
    bool near_parts = true;
};

/// All that a patch's form factors are found from.
struct Shooting {
    std::vector<ShootPoint> points;
    /// Their texels are left out by the points: they are in closed form.
    std::vector<NearPart> near_parts;
    /// Whether the patch has quarters of texels, all covered: they may send different light.
    bool has_quarters = false;
};

/// At most four points for each undivided part. If figures cover it all, they are those of Gauss' rule,
/// exact for cubic integrands; else the middles of the covered quarters.
Shooting shooting_of(const PixmapModel& model, const Patch& patch,
                     const PointOptions& options = {});
std::vector<ShootPoint> points_of(const PixmapModel& model, const Patch& patch,
                                  const PointOptions& options = {});

}  // namespace gw::radiosity
