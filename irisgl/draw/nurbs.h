// B-splines, rational or not, and the part of a surface that trimming curves leave. Draws nothing.
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace gw::irisgl {

/// Up to 4 coordinates, then the weight: 1 if the type has none. Coordinates are multiplied by it.
using ControlPoint = std::array<double, 5>;

struct NurbsCurve {
    std::size_t order = 2;
    std::vector<double> knots;          ///< order more than there are control points
    std::vector<ControlPoint> control;  ///< at least `order`
    double first() const { return knots[order - 1]; }
    double last() const { return knots[control.size()]; }
};

struct NurbsSurface {
    std::size_t s_order = 2, t_order = 2;
    std::vector<double> s_knots, t_knots;
    std::vector<ControlPoint> control;  ///< t varies fastest
    std::size_t s_count() const { return s_knots.size() - s_order; }
    std::size_t t_count() const { return t_knots.size() - t_order; }
    dvec2 first() const { return {s_knots[s_order - 1], t_knots[t_order - 1]}; }
    dvec2 last() const { return {s_knots[s_count()], t_knots[t_count()]}; }
};

/// The four coordinates at a parameter, divided by the weight.
dvec4 point_of(const NurbsCurve& curve, double u);
struct SurfacePoint {
    dvec4 p, ds, dt;
};
SurfacePoint point_of(const NurbsSurface& surface, double s, double t);

/// From the first to the last parameter: `steps` steps between unequal knots.
std::vector<double> parameters(const std::vector<double>& knots, std::size_t order,
                               std::size_t steps);

/// Closed loops in the plane of the parameters. What is on the left of their lines stays.
using TrimLoops = std::vector<std::vector<dvec2>>;
/// Convex polygons that cover what stays of the rectangle of the grid s x t. None: all stays.
std::vector<std::vector<dvec2>> trimmed(const std::vector<double>& s, const std::vector<double>& t,
                                        const TrimLoops& loops);

}  // namespace gw::irisgl
