// Projects the vertices of a geometry set's parts, in order. Small meshes under one transform are
// projected together. Does not make primitives.
#pragma once

#include "gw/fast/vertices/geometry_scratch.h"
#include "gw/fast/vertices/project.h"

#include <cstddef>
#include <span>

namespace gw::fast {

struct PartProjector {
    GeometrySet& set;
    Projection projection;  ///< of the part added last
    GeometryScratch& scratch;
    const Outcode* outcode = nullptr;  ///< by vertex of the part added last
    std::size_t part = 0;              ///< the next one
    std::size_t end = 0;               ///< of the parts that use the transform
    bool together = false;  ///< they are in the scratch vectors, the next one at `vertex`
    std::size_t vertex = 0;

    /// Appends the vertices of the next part to the set's arrays.
    void add();

private:
    void use_transform();
    void project_part();
    void project_together();
    void take_vertices(std::size_t count);
};

}  // namespace gw::fast
