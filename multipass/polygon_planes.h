// What the item buffer tells about a pixel: the polygon, and where exactly its ray meets it [K4i].
// Does not draw the item buffer: scene::id_pass does.
#pragma once

#include "multipass/model.h"
#include "scene/draw_commands.h"
#include "scene/view.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace gw::multipass {

/// A point of a surface and the plane of its triangle, world space.
struct SurfacePoint {
    dvec3 p{0};
    dvec3 normal{0};  ///< counter-clockwise from outside; not normalised

    bool operator==(const SurfacePoint&) const = default;
};

/// The triangles of every polygon of a scene. Refers to the model.
class PolygonTable {
public:
    explicit PolygonTable(const Model& model);

    /// Where the ray o + t d meets polygon `id`: of its triangles the one that the ray goes through, or least
    /// misses (a fragment's centre lies in the snapped triangle, which may be a sixteenth of a pixel beside
    /// the true one). None: no polygon has this identifier, or the ray runs along it.
    std::optional<SurfacePoint> meet(std::uint32_t id, const dvec3& o, const dvec3& d) const;

private:
    const Model* model_;
    scene::PolygonIds ids_;
    std::vector<std::vector<std::uint32_t>>
        first_triangle_;  ///< by object, by polygon ordinal; one more at the end
};

/// The ray through a window position: from the near plane to the far plane, t = 0 to 1.
struct PixelRay {
    dvec3 o{0}, d{0};
};
class PixelRays {
public:
    explicit PixelRays(const scene::View& view);
    PixelRay through(double x, double y) const;

private:
    dmat4 world_from_clip_;
    double width_, height_;
};

}  // namespace gw::multipass
