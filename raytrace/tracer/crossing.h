// Where a ray crosses a triangle, in double. Does not search.
//
// Whether it crosses one is decided without rounding, so for neighbours alike: around a side or a
// corner, a ray crosses what some line crosses. A ray exactly through a side or a corner counts as
// turned towards +x by infinitely little, and by infinitely less towards +y and +z [Edelsbrunner
// and Muecke 1990, Simulation of Simplicity].
#pragma once

#include "raytrace/ray.h"

#include <array>
#include <optional>

namespace gw::raytrace {

struct Crossing {
    double t = 0;       ///< of the plane, also behind the start
    dvec3 normal{0};    ///< counter-clockwise from outside; of any length
    double height = 0;  ///< of the plane above the start, times the normal's length
};

class CrossingTest {
public:
    /// `size`: the largest coordinate of all triangles.
    CrossingTest(const Ray& ray, double size);

    /// None: the ray's line passes by, or is in the triangle's plane.
    std::optional<Crossing> cross(const std::array<dvec3, 3>& corner) const;

private:
    bool goes_through(const std::array<dvec3, 3>& corner) const;
    int exact_side(const dvec3& p, const dvec3& q) const;

    const Ray& ray_;
    double rounding_;  ///< more than that of an edge function
};

}  // namespace gw::raytrace
