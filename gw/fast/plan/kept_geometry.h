// Geometry sets that outlive their segment: the lists of a frame (depth and winners, then the
// passes; an item buffer) and frames of one view draw the same geometry again. Does not keep meshes
// alive.
#pragma once

#include "gw/fast/vertices/geometry.h"

#include <deque>
#include <memory>
#include <vector>

namespace gw::fast {

class KeptGeometry {
public:
    /// Gives each set that has nothing but its key and what its draws ask for (lists, jitter) what
    /// was made for that key; the others get the memory of what is left.
    void give(std::deque<GeometrySet>& sets);
    /// Keeps the sets of a segment in place of those before, where it has any.
    void keep(std::deque<GeometrySet> sets);

private:
    struct Kept {
        GeometrySet set;  ///< its key without the mesh
        const Mesh* address = nullptr;
        std::weak_ptr<const Mesh> mesh;
    };
    Kept* find(const GeometrySet& wanted);

    std::vector<Kept> kept_;
    std::size_t next_ = 0;  ///< where the search begins: lists repeat in order
};

}  // namespace gw::fast
