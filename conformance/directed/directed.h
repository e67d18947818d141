// Lists about one subject that the random suites seldom reach. conformance/suite.cpp names them.
// Shares no seeds with tests/fuzz, so a change here leaves those digests alone.
#pragma once

#include "conformance/generate/case.h"

namespace gw::conformance {

fuzz::Case blocks_case(fuzz::Random& random);
fuzz::Case cut_slivers_case(fuzz::Random& random);
fuzz::Case extreme_lights_case(fuzz::Random& random);
fuzz::Case far_coordinates_case(fuzz::Random& random);
fuzz::Case mesh_case(fuzz::Random& random);
fuzz::Case offset_case(fuzz::Random& random);
fuzz::Case polygons_case(fuzz::Random& random);
fuzz::Case ties_case(fuzz::Random& random);

}  // namespace gw::conformance
