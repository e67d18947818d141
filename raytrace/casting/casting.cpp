#include "raytrace/casting/casting.h"

#include "raytrace/casting/cast_methods.h"

namespace gw::raytrace {

std::unique_ptr<RayCaster> make_caster(CastMethod method, const std::vector<CastShape>& shapes,
                                       InsideTest test) {
    const Asker asker(shapes, test);
    switch (method) {
        case CastMethod::BruteForce: return cast_by_brute_force(asker);
        case CastMethod::BoundingVolumes: return cast_by_volumes(asker);
        case CastMethod::Hierarchy: return cast_by_hierarchy(asker);
        case CastMethod::Grid: return cast_by_grid(asker);
    }
    return nullptr;
}

}  // namespace gw::raytrace
