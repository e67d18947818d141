// Perspective values of random triangles: the manual's sequence of operations, written again here,
// gives the picture's bits and stays within the manual's bound of the exact quotient.
// docs/manual/rasterization.md, "Perspective".
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

using namespace test;

constexpr int size = 32, log2_texels = 12;
constexpr std::int64_t one = 256;  // units of a pixel on `ideal`
constexpr double unit = 1073741824.0;

struct Case {
    GridTriangle grid;
    std::array<double, 3> w{}, s{};
    std::array<std::int64_t, 3> red{};
};

/// w has at most 10 bits times 2^0 .. 2^8 and corners lie on the grid. So x w is exact in float32,
/// and the snap is exact.
Case random_case(Random& random) {
    Case c;
    const int repeats = 1 << random.between(0, 3);
    for (std::size_t i = 0; i < 3; ++i) {
        c.grid[i] = {random.between(0, size * one), random.between(0, size * one)};
        c.w[i] = std::ldexp(double(random.between(16, 1023)), int(random.between(0, 6)) - 4);
        c.s[i] = double(random.fraction()) * repeats;
        c.red[i] = random.between(0, 65535);
    }
    return c;
}

Draw draw_of(const Case& c) {
    MeshData data;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto ndc = [](std::int64_t v) { return double(v) / (size / 2 * one) - 1; };
        data.positions.push_back(
            {float(ndc(c.grid[i].x) * c.w[i]), float(ndc(c.grid[i].y) * c.w[i]), float(c.w[i])});
        data.texcoords.push_back({float(c.s[i]), 0});
        data.colors.push_back({float(double(c.red[i]) / 65535), 0, 0, 1});
    }
    return Draw{.mesh = make_mesh(std::move(data))};
}

/// Clip coordinates (x, y, 0, z).
dmat4 w_is_z() {
    dmat4 m{1};
    m[2] = {0, 0, 0, 1};
    m[3] = {0, 0, 0, 0};
    return m;
}

/// The manual's Q, and U of a value: at the corners, at a pixel, and u in float32.
struct Quotient {
    const Case& c;
    std::array<std::int64_t, 3> q{}, u{};
    int exponent = 0;

    Quotient(const Case& given, const std::array<double, 3>& v) : c(given) {
        const double w_min = *std::min_element(c.w.begin(), c.w.end());
        while (std::ldexp(1.0, exponent) < *std::max_element(v.begin(), v.end())) ++exponent;
        for (std::size_t i = 0; i < 3; ++i) {
            q[i] = std::max<std::int64_t>(1, std::llrint(unit * (w_min / c.w[i])));
            u[i] = std::llrint((unit * std::ldexp(v[i], -exponent)) * (w_min / c.w[i]));
        }
    }
    float at(const GridPoint& p) const {
        const float reciprocal = 1.0f / float(manual_value(c.grid, q, p, 8));
        return float(manual_value(c.grid, u, p, 8)) * reciprocal;
    }
};

/// The value and w / w_min at the pixel, exact but for the last bits of a long double.
struct Exact {
    long double value = 0, ratio = 1;
};
Exact exact_quotient(const Case& c, const std::array<double, 3>& v, const GridPoint& p) {
    long double above = 0, below = 0, area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const long double b = (long double)cross(p, c.grid[(i + 1) % 3], c.grid[(i + 2) % 3]);
        above += b * v[i] / c.w[i];
        below += b / c.w[i];
        area += b;
    }
    return {above / below, area / below / *std::min_element(c.w.begin(), c.w.end())};
}

/// The manual's bound on |u - exact|, both in units of 2^e.
long double bound(long double ratio) { return 0x1p-22L + 2.52L * ratio * 0x1p-30L; }

struct Worst {
    long pixels = 0;
    double of_bound = 0, error = 0;
    void add(long double difference, long double allowed) {
        ++pixels;
        error = std::max(error, double(difference));
        of_bound = std::max(of_bound, double(difference / allowed));
    }
};

void for_covered(const Case& c, const auto& each) {
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const GridPoint p{x * one + one / 2, y * one + one / 2};
            if (covers(c.grid, p)) each(x, y, p);
        }
}

/// Texel i is 16 i: a texture in which bilinear filtering shows 16ths of a texel.
TextureRef ramp() {
    std::vector<std::uint16_t> texels;
    for (int i = 0; i < 1 << log2_texels; ++i)
        texels.insert(texels.end(), 4, std::uint16_t(16 * i));
    return make_texture("ramp", 1 << log2_texels, 1, texels);
}

/// Bilinear on one row, 16 bits.
int texel_at(std::int64_t position) {
    const std::int64_t p = position - 128, mask = (1 << log2_texels) - 1;
    const std::int64_t a = 16 * ((p >> 8) & mask), b = 16 * (((p >> 8) + 1) & mask),
                       weight = p & 255;
    return int(((a * (256 - weight) + b * weight) * 256 + 32768) >> 16);
}

// [R9.15]
TEST(PerspectiveOracle, TextureCoordinates) {
    const TextureRef texture = ramp();
    Worst worst;
    for (int i = 0; i < 1500 && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        Random random(std::uint64_t(i) + 7000);
        Case c = random_case(random);
        Workbench bench(ideal(), size, size);
        bench.state.projection = w_is_z();
        bench.state.texture.env = TexEnv::Replace;
        Draw draw = draw_of(c);
        draw.map.texture = texture;
        bench.draw(draw);
        const double k = std::floor(*std::min_element(c.s.begin(), c.s.end()));
        for (double& s : c.s) s -= k;
        const Quotient quotient(c, c.s);
        for_covered(c, [&](int x, int y, const GridPoint& p) {
            const float u = quotient.at(p);
            const auto position = std::int64_t(std::ldexp(u, quotient.exponent + log2_texels + 8));
            EXPECT_EQ(int(bench.color(x, y)[0]), texel_at(position)) << x << " " << y;
            const Exact exact = exact_quotient(c, c.s, p);
            worst.add(std::abs((long double)u - std::ldexp(exact.value, -quotient.exponent)),
                      bound(exact.ratio));
        });
    }
    EXPECT_GT(worst.pixels, 50000);
    EXPECT_LE(worst.of_bound, 1);
    EXPECT_GT(worst.of_bound, 0.1) << "the bound says nothing";
    RecordProperty("largest_error", (testing::Message() << worst.error).GetString());
    RecordProperty("of_bound", (testing::Message() << worst.of_bound).GetString());
}

// [R9.19] [R10.27]
TEST(PerspectiveOracle, WideTextureCoordinates) {
    constexpr int texels = 1 << log2_texels;
    const TextureRef texture = ramp();
    long telling = 0;
    for (int i = 0; i < 400 && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        Random random(std::uint64_t(i) + 9000);
        Case c = random_case(random);
        const int exponent = 11 + i % 10;
        c.s = {0, std::ldexp(1.0, exponent) - 0.5, std::ldexp(double(random.fraction()), exponent)};
        Workbench bench(ideal(), size, size);
        bench.state.projection = w_is_z();
        bench.state.texture.env = TexEnv::Replace;
        bench.state.texture.min_filter = MinFilter::Nearest;
        bench.state.texture.mag_filter = MagFilter::Nearest;
        Draw draw = draw_of(c);
        draw.map.texture = texture;
        bench.draw(draw);
        for_covered(c, [&](int x, int y, const GridPoint& p) {
            const Exact exact = exact_quotient(c, c.s, p);
            long double off = exact.value * texels - bench.color(x, y)[0] / 16 - 0.5L;
            off -= texels * std::round(off / texels);
            const long double error =
                2.52L * exact.ratio * std::ldexp(1.0L, exponent - 30) * texels;
            EXPECT_LE(std::abs(off), 0.5L + error) << x << " " << y;
            telling += error < 100 ? 1 : 0;
        });
    }
    EXPECT_GT(telling, 5000);
}

// [R9.10] [R9.16]
TEST(PerspectiveOracle, GouraudOnIdeal) {
    Worst worst;
    for (int i = 0; i < 1500 && !HasFailure(); ++i) {
        SCOPED_TRACE(i);
        Random random(std::uint64_t(i) + 17000);
        const Case c = random_case(random);
        Workbench bench(ideal(), size, size);
        bench.state.projection = w_is_z();
        bench.draw(draw_of(c));
        std::array<double, 3> fraction{};
        for (std::size_t k = 0; k < 3; ++k) fraction[k] = double(c.red[k]) / 65535;
        const Quotient quotient(c, fraction);
        const auto ends = std::minmax_element(c.red.begin(), c.red.end());
        for_covered(c, [&](int x, int y, const GridPoint& p) {
            const std::int64_t red = std::clamp<std::int64_t>(
                std::llrint(quotient.at(p) * 65535.0f), *ends.first, *ends.second);
            EXPECT_EQ(std::int64_t{bench.color(x, y)[0]}, red) << x << " " << y;
            const Exact exact = exact_quotient(c, fraction, p);
            worst.add(std::abs((long double)red - exact.value * 65535),
                      0.5L + 65535 * (bound(exact.ratio) + 0x1p-24L));
        });
    }
    EXPECT_GT(worst.pixels, 50000);
    EXPECT_LE(worst.of_bound, 1);
    RecordProperty("largest_error", (testing::Message() << worst.error).GetString());
}

}  // namespace
}  // namespace gw
