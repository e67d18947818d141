// The methods of casting.h, one file each: cast_by_grid.cpp and its siblings. Does not choose among them.
#pragma once

#include "raytrace/casting/shape_tester.h"

namespace gw::raytrace {

std::unique_ptr<RayCaster> cast_by_brute_force(const Asker& asker);
std::unique_ptr<RayCaster> cast_by_volumes(const Asker& asker);
std::unique_ptr<RayCaster> cast_by_hierarchy(const Asker& asker);
std::unique_ptr<RayCaster> cast_by_grid(const Asker& asker);

}  // namespace gw::raytrace
