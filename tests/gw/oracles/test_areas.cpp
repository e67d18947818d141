// The covered area of pixels against areas found in other ways: polygons clipped in rational
// numbers, 64 x 64 samples a pixel, and a disc's integral. docs/manual/rasterization.md,
// "Antialiasing".
#include "gw/profile.h"
#include "gw/stages/area.h"
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gw {
namespace {

using namespace test;

constexpr std::int64_t whole_pixel = std::int64_t{1} << area_bits;

Int gcd_of(Int a, Int b) {
    if (a < 0) a = -a;
    if (b < 0) b = -b;
    while (b != 0) a = std::exchange(b, a % b);
    return a;
}
Rational reduced(Int n, Int d) {
    const Int g = gcd_of(n, d) * (d < 0 ? -1 : 1);
    return {n / g, d / g};
}
Rational operator+(const Rational& a, const Rational& b) {
    return reduced(a.n * b.d + b.n * a.d, a.d * b.d);
}
Rational operator-(const Rational& a, const Rational& b) {
    return reduced(a.n * b.d - b.n * a.d, a.d * b.d);
}
Rational operator*(const Rational& a, const Rational& b) { return reduced(a.n * b.n, a.d * b.d); }
Rational operator/(const Rational& a, const Rational& b) { return reduced(a.n * b.d, a.d * b.n); }

using RationalPoint = std::array<Rational, 2>;

/// What is left of a polygon on one side of an axis-parallel line.
std::vector<RationalPoint> half_of(const std::vector<RationalPoint>& p, std::size_t axis, int at,
                                   int sign) {
    std::vector<RationalPoint> out;
    const auto inside = [&](const RationalPoint& v) {
        return sign * (v[axis] - Rational{at}).n >= 0;
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        const RationalPoint &a = p[i], &b = p[(i + 1) % p.size()];
        if (inside(a)) out.push_back(a);
        if (inside(a) == inside(b)) continue;
        const Rational t = (Rational{at} - a[axis]) / (b[axis] - a[axis]);
        out.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
    return out;
}

/// Twice the exact area of a triangle in a square of `side` units.
Rational twice_area_in_square(const GridTriangle& t, int x, int y, int side) {
    std::vector<RationalPoint> p;
    for (const GridPoint& v : t) p.push_back({Rational{v.x}, Rational{v.y}});
    p = half_of(p, 0, x, 1);
    p = half_of(p, 0, x + side, -1);
    p = half_of(p, 1, y, 1);
    p = half_of(p, 1, y + side, -1);
    Rational sum{0};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const RationalPoint &a = p[i], &b = p[(i + 1) % p.size()];
        sum = sum + (a[0] * b[1] - b[0] * a[1]);
    }
    return sum;
}

GridTriangle any_triangle(Random& random, int units) {
    for (;;) {
        GridTriangle t;
        for (GridPoint& p : t) p = {random.between(0, units), random.between(0, units)};
        if (random.one_in(4)) t[1].y = t[0].y;
        if (random.one_in(4)) t[2].x = t[0].x;
        if (cross(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
        if (cross(t[0], t[1], t[2]) != 0) return t;
    }
}

std::array<ShapePoint, 3> shape_of(const GridTriangle& t, int s) {
    std::array<ShapePoint, 3> out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = {shape_coordinate(t[k].x, s), shape_coordinate(t[k].y, s)};
    return out;
}

// [R9.24]
TEST(AreaOracle, TrianglesAgreeWithClippingInRationals) {
    constexpr int s = 3, unit = 1 << s, pixels = 5;
    Random random(30);
    for (int n = 0; n < 3000; ++n) {
        const GridTriangle t = any_triangle(random, pixels * unit);
        const auto shape = shape_of(t, s);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                const Rational twice = twice_area_in_square(t, x * unit, y * unit, unit);
                // 2^40 twice / (2 unit^2), each of three sides rounded by at most 1/2
                const Int exact = twice.n * (Int{1} << (area_bits - 2 * s - 1));
                const Int error = Int{area_inside(shape, x, y)} * twice.d - exact;
                ASSERT_LE(error < 0 ? -error * 2 : error * 2, 3 * twice.d)
                    << n << " " << x << " " << y;
            }
    }
}

// [R9.23]
TEST(AreaOracle, CoverageIsTheExactAreaRoundedOnce) {
    constexpr int s = 8, unit = 1 << s, pixels = 4;
    Random random(31);
    int partial = 0;
    for (int n = 0; n < 300; ++n) {
        const GridTriangle t = any_triangle(random, pixels * unit);
        Workbench bench(opengl(), pixels, pixels);
        bench.state.polygon_smooth = true;
        std::vector<vec3> corners;
        for (const GridPoint& p : t)
            corners.emplace_back(float(p.x) / unit, float(p.y) / unit, 0.0f);
        bench.draw(Primitive::Triangles, corners);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                const Rational twice = twice_area_in_square(t, x * unit, y * unit, unit);
                // floor(255 area + 1/2)
                const Int d = twice.d * 2 * unit * unit;
                const int exact = int(floor_of(2 * 255 * twice.n + d, 2 * d));
                ASSERT_EQ(bench.color(x, y)[3], exact) << n << " " << x << " " << y;
                partial += exact > 0 && exact < 255;
            }
    }
    EXPECT_GT(partial, 1000);
}

/// Samples of 64 x 64 in pixel (x, y), of shapes on their grid.
double sampled(int x, int y, const auto& inside) {
    int count = 0;
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) count += inside(x + (i + 0.5) / 64, y + (j + 0.5) / 64);
    return count / 4096.0;
}

// [R9.26]
TEST(AreaOracle, LinesAgreeWithSamples) {
    constexpr int s = 8;
    Random random(32);
    double worst = 0;
    for (int n = 0; n < 200; ++n) {
        const auto end = [&] {
            return ShapePoint{random.between(0, 6 << s), random.between(0, 6 << s)};
        };
        const ShapePoint a = end(), b = end();
        if (a == b) continue;
        const float width = float(random.between(100, 500)) / 100;
        const auto rectangle = smooth_line(a, b, width, s).rectangle(0, 1 << 20);
        const double ax = double(a[0]) / 256, ay = double(a[1]) / 256;
        const double dx = double(b[0] - a[0]) / 256, dy = double(b[1] - a[1]) / 256;
        const double length = std::hypot(dx, dy);
        for (int y = -3; y < 9; ++y)
            for (int x = -3; x < 9; ++x) {
                const double samples = sampled(x, y, [&](double px, double py) {
                    const double along = ((px - ax) * dx + (py - ay) * dy) / length;
                    const double across = ((py - ay) * dx - (px - ax) * dy) / length;
                    return along >= 0 && along <= length && std::abs(across) <= width / 2;
                });
                const double area = double(area_inside(rectangle, x, y)) / double(whole_pixel);
                worst = std::max(worst, std::abs(samples - area));
            }
    }
    // Samples move each of two long sides by at most half of 1/64 pixel.
    EXPECT_LT(worst, 1.0 / 64);
}

/// The area of the disc of radius r around the origin with 0 <= x <= w and y at most h: a function
/// whose differences give any rectangle.
double disc_corner(double w, double h, double r) {
    const auto half_chord = [&](double x) { return std::sqrt(std::max(0.0, r * r - x * x)); };
    const auto integral = [&](double x) {  // of half_chord
        x = std::clamp(x, -r, r);
        return (x * half_chord(x) + r * r * std::asin(x / r)) / 2;
    };
    w = std::clamp(w, -r, r);
    h = std::clamp(h, -r, r);
    // x in [-r, w]: min(h, chord) + chord, if h > -chord
    const double c = half_chord(h);
    const auto clipped = [&](double from, double to) {
        return to > from ? integral(to) - integral(from) : 0.0;
    };
    if (h >= 0)
        return 2 * clipped(-r, std::min(w, -c)) + clipped(-c, std::min(w, c)) +
               h * std::max(0.0, std::min(w, c) + c) + 2 * clipped(c, w);
    return clipped(-c, std::min(w, c)) + h * std::max(0.0, std::min(w, c) + c);
}

double disc_area(double cx, double cy, double r, int x, int y) {
    const double x0 = x - cx, y0 = y - cy;
    return disc_corner(x0 + 1, y0 + 1, r) - disc_corner(x0, y0 + 1, r) -
           disc_corner(x0 + 1, y0, r) + disc_corner(x0, y0, r);
}

// [R9.27]
TEST(AreaOracle, DiscsAreWithinABoundOfTheIntegral) {
    Random random(33);
    double worst = 0, sum_error = 0;
    for (int n = 0; n < 300; ++n) {
        const float size = n < 200 ? float(random.between(2048, 16384)) / 2048
                                   : float(random.between(2048, 128 * 2048)) / 2048;
        const ShapePoint c{random.between(0, 4095), random.between(0, 4095)};
        const double r = double(size) / 2, cx = double(c[0]) / 4096, cy = double(c[1]) / 4096;
        const int reach = int(r) + 2;
        const Disc point = disc(c, half_size(size));
        double sum = 0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const double area = double(point.area(x, y)) / double(whole_pixel);
                sum += area;
                worst = std::max(worst, std::abs(area - disc_area(cx, cy, r, x, y)));
            }
        sum_error = std::max(sum_error, std::abs(sum / (r * r * std::acos(-1.0)) - 1));
    }
    RecordProperty("worst", std::to_string(worst));
    RecordProperty("sum_error", std::to_string(sum_error));
    EXPECT_LT(worst, 1.0 / 1000) << worst;
    EXPECT_LT(sum_error, 1.0 / 1000) << sum_error;
}

/// Counter-clockwise triangles that share sides and fill a square, on the grid of 2^-8 pixel.
std::vector<GridTriangle> any_partition(Random& random, int units) {
    std::vector<GridTriangle> all{{GridPoint{0, 0}, {units, 0}, {units, units}},
                                  {GridPoint{0, 0}, {units, units}, {0, units}}};
    for (int n = 0; n < 12; ++n) {
        const std::size_t i = std::size_t(random.between(0, int(all.size()) - 1));
        const GridTriangle t = all[i];
        const std::int64_t a = random.between(1, 6), b = random.between(1, 6),
                           c = random.between(1, 6);
        const GridPoint p{(a * t[0].x + b * t[1].x + c * t[2].x) / (a + b + c),
                          (a * t[0].y + b * t[1].y + c * t[2].y) / (a + b + c)};
        const std::array<GridTriangle, 3> parts{
            GridTriangle{t[0], t[1], p}, {t[1], t[2], p}, {t[2], t[0], p}};
        if (std::any_of(parts.begin(), parts.end(),
                        [](const GridTriangle& g) { return cross(g[0], g[1], g[2]) <= 0; }))
            continue;
        all[i] = parts[0];
        all.insert(all.end(), parts.begin() + 1, parts.end());
    }
    return all;
}

// [R9.24]
TEST(AreaOracle, TrianglesThatShareSidesFillEachPixelExactly) {
    constexpr int s = 8, pixels = 4;
    Random random(34);
    for (int n = 0; n < 200; ++n) {
        const auto triangles = any_partition(random, pixels << s);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) {
                std::int64_t sum = 0;
                for (const GridTriangle& t : triangles) sum += area_inside(shape_of(t, s), x, y);
                ASSERT_EQ(sum, whole_pixel) << n << " " << x << " " << y;
            }
    }
}

// [R9.23]
TEST(AreaOracle, CoveragesOfSharedPixelsAddUpToWithinTheirRounding) {
    constexpr int s = 8, pixels = 4, unit = 1 << s;
    Random random(35);
    for (int n = 0; n < 60; ++n) {
        const auto triangles = any_partition(random, pixels << s);
        Profile profile = opengl();
        profile.color_bits = 16;
        Workbench bench(profile, pixels, pixels);
        bench.state.polygon_smooth = true;
        bench.state.blend = {.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
        // Alpha 257 of 65535: as many as 255 fragments can be added.
        const vec4 faint(0, 0, 0, 257.0f / 65535);
        for (const GridTriangle& t : triangles) {
            std::vector<vec3> corners;
            for (const GridPoint& p : t)
                corners.emplace_back(float(p.x) / unit, float(p.y) / unit, 0.0f);
            bench.draw(Primitive::Triangles, corners, {faint, faint, faint});
        }
        const int rounding = int(triangles.size());
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x)
                ASSERT_NEAR(bench.color(x, y)[3], 257, rounding) << n << " " << x << " " << y;
    }
}

// [R9.25]
TEST(AreaOracle, APolygonsCoverageDoesNotDependOnItsTriangles) {
    Random random(36);
    for (int n = 0; n < 60; ++n) {
        // A star of 5 to 9 corners around (4, 4), concave in general.
        const int corners = int(random.between(5, 9));
        std::vector<vec3> star;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::acos(-1.0) * k / corners,
                         r = double(random.between(64, 1000)) / 256;
            star.emplace_back(float(std::floor(256 * (4 + r * std::cos(angle))) / 256),
                              float(std::floor(256 * (4 + r * std::sin(angle))) / 256), 0.0f);
        }
        std::vector<Rgba> first;
        for (int turn = 0; turn < corners; ++turn) {
            Workbench bench(opengl(), 8, 8);
            bench.state.polygon_smooth = true;
            bench.state.shade_model = ShadeModel::Flat;
            bench.draw(Primitive::Polygons, star);
            if (turn == 0) first = bench.planes().color;
            ASSERT_EQ(bench.planes().color, first) << n << " " << turn;
            std::rotate(star.begin(), star.begin() + 1, star.end());
        }
    }
}

}  // namespace
}  // namespace gw
