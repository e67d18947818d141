// Lists about one subject that the random suites reach seldom. conformance/suite.cpp names them.
// Does not share seeds with tests/fuzz: its digests stay.
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
