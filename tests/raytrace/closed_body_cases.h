// Closed bodies for the tests of paths: sharp and blunt edges, knots, slivers, bodies in bodies.
#pragma once

#include "scene/geometry/transform.h"
#include "scene/shapes/shapes.h"
#include "tests/raytrace/closed_bodies.h"

namespace gw::raytrace {

struct ClosedBodyCase {
    std::string name;
    Bodies bodies;
};

inline std::vector<ClosedBodyCase> closed_body_cases() {
    std::vector<ClosedBodyCase> cases(6);
    cases[0].name = "box";
    cases[0].bodies.add(scene::make_box({2, 1, 1.5}, 3), scene::rotation({1, 2, 3}, 40));
    cases[1].name = "glass";
    cases[1].bodies.add(scene::make_cylinder(1, 2, 40, 4, true), scene::rotation({1, 0, 0}, 20));
    cases[2].name = "torus knot";
    cases[2].bodies.add(scene::make_torus_knot(2, 3, 1, 0.2, 96, 12));
    cases[3].name = "nested";
    for (const double size : {2.0, 1.1, 0.5})
        cases[3].bodies.add(scene::make_box(dvec3(size), 2), scene::rotation({3, 1, 2}, 9 * size));
    cases[3].bodies.add(scene::make_sphere(0.1, 16, 8));
    cases[4].name = "slivers";
    cases[4].bodies.add(scene::make_cone(0.02, 3, 24, 1, true), scene::rotation({1, 1, 0}, 70));
    cases[4].bodies.add(scene::make_box({3, 0.003, 2}, 2), scene::translation({0, -3, 0}));
    cases[5].name = "small beside a far one";
    cases[5].bodies.add(scene::make_icosphere(0.05, 3), scene::translation({9, 7, 8}));
    cases[5].bodies.add(scene::make_torus(0.6, 0.3, 48, 24));
    return cases;
}

}  // namespace gw::raytrace
