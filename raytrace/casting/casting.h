// Ray casting as it is taught [L9, L12]: the nearest of all intersections, by brute force or by one
// of the lecture's accelerations. Every intersection test is counted. In double, one ray at a time,
// to be read and compared; hierarchy.h is the fast one. Does not shade.
#pragma once

#include "raytrace/casting/intersect.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace gw::raytrace {

/// A polygon, or a sphere, world space, of an object.
struct CastShape {
    std::variant<PlanePolygon, Sphere> shape;
    std::size_t object = 0;
};

/// All polygons of a scene as their meshes have them: quads as quads, concave ones whole. A mesh
/// becomes a sphere if its vertices lie on one around its origin and have its normals, as those of
/// the shapes `sphere` and `icosphere`. It must be scaled the same in all directions.
std::vector<CastShape> cast_shapes(const scene::Scene& scene);

/// How the nearest shape is found.
///   BruteForce        every shape is tested
///   BoundingVolumes   a box around every object; its shapes are tested if the ray meets the box
///   Hierarchy         boxes in boxes, halved at the middle of the longest side
///   Grid              a voxel grid; voxels are walked along the ray (Amanatides, Woo 1987)
enum class CastMethod { BruteForce, BoundingVolumes, Hierarchy, Grid };

struct CastCounts {
    std::uint64_t rays = 0;
    std::uint64_t shapes = 0;  ///< intersection tests with polygons and spheres
    std::uint64_t boxes = 0;   ///< tests with bounding volumes
    std::uint64_t voxels = 0;  ///< walked through

    std::uint64_t all() const { return shapes + boxes + voxels; }
    void add(const CastCounts& c) {
        rays += c.rays;
        shapes += c.shapes;
        boxes += c.boxes;
        voxels += c.voxels;
    }
    bool operator==(const CastCounts&) const = default;
};

struct CastHit {
    std::size_t shape = 0;
    double t = 0;
    bool operator==(const CastHit&) const = default;
};

/// A box or voxel that a search looked into, and how many shapes it tested there.
struct CastVisit {
    Box box;
    std::size_t shapes = 0;
};

class RayCaster {
public:
    virtual ~RayCaster() = default;
    /// Of shapes equally near the first. Any number of threads may call it.
    std::optional<CastHit> nearest(const Ray& ray, CastCounts& counts) const {
        return search(ray, counts, nullptr);
    }
    /// What `nearest` looks into for this ray, in its order: none by brute force.
    std::vector<CastVisit> visits(const Ray& ray) const {
        CastCounts counts;
        std::vector<CastVisit> visits;
        (void)search(ray, counts, &visits);
        return visits;
    }

private:
    /// Adds to `visits` unless it is null.
    virtual std::optional<CastHit> search(const Ray& ray, CastCounts& counts,
                                          std::vector<CastVisit>* visits) const = 0;
};

/// Refers to the shapes, which must outlive it.
std::unique_ptr<RayCaster> make_caster(CastMethod method, const std::vector<CastShape>& shapes,
                                       InsideTest test = InsideTest::Crossings);

}  // namespace gw::raytrace
