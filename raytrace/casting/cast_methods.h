// The methods of casting.h and the parts that they share: the box around a shape, the test of one
// shape, the nearest hit so far. Does not choose among them.
#pragma once

#include "raytrace/casting/casting.h"
#include "raytrace/casting/intersect.h"

#include <optional>

namespace gw::raytrace {

Box box_of(const CastShape& shape);

/// Tests shapes one at a time. Refers to them.
class ShapeTester {
public:
    ShapeTester(const std::vector<CastShape>& shapes, InsideTest test)
        : shapes_(shapes), test_(test) {}

    /// Counts the test; `nearest` becomes the shape's hit if that is nearer, or as near and
    /// earlier.
    void test(const Ray& ray, std::size_t shape, std::optional<CastHit>& nearest,
              CastCounts& counts) const;

    const std::vector<CastShape>& shapes() const { return shapes_; }

private:
    const std::vector<CastShape>& shapes_;
    InsideTest test_;
};

/// Every shape is tested [L9].
std::unique_ptr<RayCaster> cast_by_brute_force(const ShapeTester& tester);
std::unique_ptr<RayCaster> cast_by_volumes(const ShapeTester& tester);
std::unique_ptr<RayCaster> cast_by_hierarchy(const ShapeTester& tester);
std::unique_ptr<RayCaster> cast_by_grid(const ShapeTester& tester);

}  // namespace gw::raytrace
