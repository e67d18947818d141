// [L9]: whether a ray crosses a triangle is decided without rounding, compared with integers.
#include "gw/base/arithmetic.h"
#include "gw/base/types.h"
#include "raytrace/tracer/crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace gw::raytrace {
namespace {

using Wide = int128;
using Integers = std::array<std::int64_t, 3>;

Integers difference(const Integers& a, const Integers& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Wide volume(const Integers& a, const Integers& b, const Integers& c) {
    Wide sum = 0;
    for (std::size_t x = 0; x < 3; ++x) {
        const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
        sum += (Wide(a[x]) * b[y] - Wide(a[y]) * b[x]) * c[z];
    }
    return sum;
}

/// Of the ray turned by infinitely little.
int side(const Integers& a, const Integers& b, const Integers& direction) {
    for (const Integers& d : {direction, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
        if (const Wide v = volume(a, b, d); v != 0) return v > 0 ? 1 : -1;
    return 0;
}

dvec3 as_vector(const Integers& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

struct Case {
    Integers origin{}, direction{};
    std::array<Integers, 3> corner{};
};

/// Few values, so that rays often go through corners and sides; or many, so that products round.
Case random_case(std::mt19937_64& random) {
    const int bits = random() % 2 == 0 ? 2 : 30;
    const auto point = [&] {
        Integers p;
        for (std::int64_t& x : p) x = std::int64_t(random() >> (63 - bits)) - (1LL << bits);
        return p;
    };
    Case c{point(), point(), {point(), point(), point()}};
    const auto aim = random() % 4;
    if (aim < 2) c.direction = difference(c.corner[0], c.origin);
    if (aim == 1)  // at the middle of a side, twice as far
        for (std::size_t k = 0; k < 3; ++k)
            c.direction[k] = c.corner[0][k] + c.corner[1][k] - 2 * c.origin[k];
    if (random() % 4 == 0) c.direction[random() % 3] += 1;
    if (c.direction == Integers{}) c.direction = {1, 2, 3};
    return c;
}

TEST(Crossing, IsDecidedAsInIntegers) {
    std::mt19937_64 random(1);
    int crossed = 0, rare = 0;
    for (int i = 0; i < 200'000; ++i) {
        const Case c = random_case(random);
        const Ray ray{as_vector(c.origin), as_vector(c.direction)};
        const Integers p = difference(c.corner[0], c.origin), q = difference(c.corner[1], c.origin),
                       r = difference(c.corner[2], c.origin);
        const Integers e = difference(c.corner[1], c.corner[0]),
                       f = difference(c.corner[2], c.corner[0]);
        const Wide slope = volume(e, f, c.direction), height = volume(e, f, p);
        const int u = side(q, r, c.direction), v = side(r, p, c.direction),
                  w = side(p, q, c.direction);
        const bool expected = u != 0 && u == v && v == w && slope != 0;
        const auto at =
            CrossingTest(ray, 0x1p31)
                .cross({as_vector(c.corner[0]), as_vector(c.corner[1]), as_vector(c.corner[2])});
        ASSERT_EQ(at.has_value(), expected) << "case " << i;
        crossed += expected;
        rare += expected && (volume(q, r, c.direction) == 0 || volume(r, p, c.direction) == 0 ||
                             volume(p, q, c.direction) == 0);
        if (!at) continue;
        const double t = double(height) / double(slope);
        const double largest = 4 * std::max({length(ray.origin), length(as_vector(c.corner[0])),
                                             length(as_vector(c.corner[1]))});
        EXPECT_LE(std::abs(at->t - t) * length(ray.direction), largest * 0x1p-40) << "case " << i;
    }
    EXPECT_GT(crossed, 20'000);
    EXPECT_GT(rare, 2'000) << "through a corner or a side";
}

/// A ray almost in the triangle's plane, to a point inside it that is one direction away.
TEST(Crossing, OfAGrazingRayIsWhereItShouldBe) {
    std::mt19937_64 random(2);
    const auto vector = [&](int most) {
        const auto number = [&] { return double(int(random() % (2 * most + 1)) - most); };
        return dvec3(number(), number(), number());
    };
    int crossed = 0;
    for (int i = 0; i < 20'000; ++i) {
        const dvec3 corner = vector(1 << 20), e = vector(1 << 16), f = vector(1 << 16);
        const dvec3 direction = 64.0 * (e - 2.0 * f) + vector(2);
        const Ray ray{corner + e + f - direction, direction};
        const auto at =
            CrossingTest(ray, 0x1p31).cross({corner, corner + 3.0 * e, corner + 3.0 * f});
        if (!at) continue;  // exactly in the plane
        ++crossed;
        EXPECT_NEAR(at->t, 1, 0x1p-45) << "case " << i;
    }
    EXPECT_GT(crossed, 19'000);
}

/// Of the four triangles around a corner a line crosses one.
TEST(Crossing, AroundACornerIsOne) {
    const dvec3 tip(1, 2, 3);
    const std::array<dvec3, 4> around{dvec3(4, 2, 1), dvec3(1, 5, 2), dvec3(-3, 2, 0),
                                      dvec3(1, -2, 2)};
    for (int x = -20; x <= 20; ++x)
        for (int y = -20; y <= 20; ++y) {
            const Ray ray{dvec3(x, y, 50), tip - dvec3(x, y, 50)};
            int crossed = 0;
            for (std::size_t i = 0; i < 4; ++i)
                crossed +=
                    CrossingTest(ray, 5).cross({tip, around[i], around[(i + 1) % 4]}).has_value();
            EXPECT_EQ(crossed, 1) << x << ", " << y;
        }
}

}  // namespace
}  // namespace gw::raytrace
