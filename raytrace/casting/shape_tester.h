// What all methods of casting share: the box around a shape, asking one shape, keeping the nearest.
// Does not choose whom to ask.
#pragma once

#include "raytrace/casting/box.h"
#include "raytrace/casting/casting.h"

#include <optional>

namespace gw::raytrace {

Box box_of(const CastShape& shape);

/// Refers to the shapes.
class Asker {
public:
    Asker(const std::vector<CastShape>& shapes, InsideTest test) : shapes_(shapes), test_(test) {}

    /// Counts the test; `nearest` becomes the shape's hit where that is nearer, or as near and
    /// earlier.
    void ask(const Ray& ray, std::size_t shape, std::optional<CastHit>& nearest,
             CastCounts& counts) const;

    const std::vector<CastShape>& shapes() const { return shapes_; }

private:
    const std::vector<CastShape>& shapes_;
    InsideTest test_;
};

}  // namespace gw::raytrace
