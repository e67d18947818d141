#include "gw/stages/raster/points.h"

#include "gw/base/arithmetic.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>

namespace gw {

float point_size_of(const State& state, const Draw& draw, std::uint32_t index) {
    if (!sizes_points(state)) return state.point_size;
    const PointParameters& p = state.point_parameters;
    const dvec3 at =
        eye_point(transform(draw.eye_from_object, object_position(draw.mesh->data(), index)));
    const double d =
        bounded(std::sqrt((at.x * at.x + at.y * at.y) + at.z * at.z), largest_coordinate);
    const double a = double(p.constant), b = double(p.linear), c = double(p.quadratic);
    const double by = (a + b * d) + c * (d * d);
    const double size = by > 0 ? double(state.point_size) * std::sqrt(1 / by) : double(p.max_size);
    return float(std::min(std::max(size, double(p.min_size)), double(p.max_size)));
}

}  // namespace gw
