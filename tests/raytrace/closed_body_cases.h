// Closed bodies for the tests of paths: sharp and blunt edges, knots, needles, slivers, bodies in
// bodies, and corners at integers.
#pragma once

#include "scene/geometry/transform.h"
#include "scene/shapes/shapes.h"
#include "tests/raytrace/closed_bodies.h"

#include <cstdint>
#include <random>

namespace gw::raytrace {

/// A rock of n x n columns of integer heights: peaks, pits and saddles at integers.
inline MeshData make_rock(std::uint32_t n, std::uint32_t seed) {
    std::mt19937 random(seed);
    MeshData rock;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        rock.indices.insert(rock.indices.end(), {a, b, c});
    };
    for (const bool top : {false, true})
        for (std::uint32_t y = 0; y <= n; ++y)
            for (std::uint32_t x = 0; x <= n; ++x)
                rock.positions.emplace_back(x, y, top ? float(1 + random() % 4) : 0.0f);
    const std::uint32_t row = n + 1, up = row * row;
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = y * row + x, b = a + 1, c = b + row, d = a + row;
            add(a, d, c), add(a, c, b);
            add(a + up, b + up, c + up), add(a + up, c + up, d + up);
        }
    const auto add_wall = [&](std::uint32_t a, std::uint32_t b) {
        add(a, b, b + up), add(a, b + up, a + up);
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        add_wall(i, i + 1), add_wall((i + 1) * row, i * row);
        add_wall(i * row + n, (i + 1) * row + n), add_wall(n * row + i + 1, n * row + i);
    }
    return rock;
}

struct ClosedBodyCase {
    std::string name;
    Bodies bodies;
};

inline std::vector<ClosedBodyCase> closed_body_cases() {
    std::vector<ClosedBodyCase> cases(9);
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
    cases[6].name = "needles";
    cases[6].bodies.add(scene::make_cone(0.02, 3, 24, 1, true));
    cases[6].bodies.add(scene::make_cone(0.001, 3, 24, 1, true), scene::rotation({1, 2, 0}, 80));
    cases[6].bodies.add(scene::make_box({2, 1e-4, 1}, 2), scene::translation({0, -2, 0}));
    cases[7].name = "rims";
    for (const double radius : {1.0, 0.999, 0.01})
        cases[7].bodies.add(scene::make_cylinder(radius, 2 * radius, 48, 1, true),
                            scene::rotation({1, 1, 0}, 70));
    cases[8].name = "rocks";
    cases[8].bodies.add(make_rock(6, 1), scene::translation({-3, -3, 0}));
    cases[8].bodies.add(scene::make_box({2, 2, 2}, 2), scene::translation({0, 0, 8}));
    cases[8].bodies.add(make_rock(3, 2), scene::translation({4, -2, 2}));
    return cases;
}

}  // namespace gw::raytrace
