// Accumulation against exact integers: every colour with weights of every size, ties, wrapping,
// return. docs/manual/pixels.md, "Accumulation".
#include "tests/gw/oracles/exact.h"
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <algorithm>
#include <bit>

namespace gw {
namespace {

using namespace test;

/// A float32 as mantissa * 2^exponent, exactly.
struct Binary {
    std::int64_t mantissa = 0;
    int exponent = 0;
};
Binary exact(float v) {
    const auto bits = std::bit_cast<std::uint32_t>(v);
    const int e = int(bits >> 23 & 255);
    const std::int64_t m = (bits & 0x7FFFFF) | (e == 0 ? 0 : 0x800000);
    return {bits >> 31 ? -m : m, (e == 0 ? 1 : e) - 150};
}

/// Nearest integer to a v 2^shift, ties to even, clamped to 2^40.
std::int64_t product(std::int64_t a, float v, int shift = 0) {
    Binary b = exact(v);
    b.exponent += shift;
    if (b.exponent < -100) return 0;  // below half a unit: |a| < 2^32, |mantissa| < 2^24
    const Int limit = Int{1} << 40, p = Int{a} * b.mantissa;
    const Int rounded =
        b.exponent >= 0 ? p * (Int{1} << b.exponent) : nearest_even(p, Int{1} << -b.exponent);
    return std::int64_t(std::clamp(rounded, -limit, limit));
}

std::int64_t wrapped(std::int64_t v, int bits) {
    const std::int64_t span = std::int64_t{1} << bits;
    return std::int64_t(floor_of(Int{v} + span / 2, span)) * -span + v;
}

std::vector<float> weights() {
    std::vector<float> w{0,      -0.0f,  1,         -1,         0.5f,       -0.5f,
                         0.25f,  1.5f,   2,         1 / 3.0f,   -1 / 3.0f,  1 / 255.0f,
                         1e-45f, 1e-30f, 1.0e-3f,   0.9999999f, 1.0000001f, 127.5f,
                         -129,   4096,   1 / 16.0f, 1 / 64.0f};
    Random random(3);
    for (int i = 0; i < 40; ++i) w.push_back((random.fraction() - 0.5f) * 8);
    return w;
}

TEST(ExhaustiveAccumulation, EveryColourAndManyWeightsOnEveryProfile) {
    std::vector<Profile> all = profiles();
    all.push_back({.name = "ten", .color_bits = 10, .accum_bits = 17});
    for (const Profile& profile : all)
        for (const float w : weights()) {
            Workbench bench(profile, 64, 4);  // whole blocks of the fast machine
            std::vector<Rgba> row;
            const std::uint32_t top = (1u << profile.color_bits) - 1;
            for (std::uint32_t x = 0; x < 256; ++x) {
                const auto c = std::uint16_t(x * top / 255);
                row.push_back({c, std::uint16_t(top - c), std::uint16_t(x), std::uint16_t(c ^ 1)});
            }
            bench.run(WritePixels{{0, 0, 64, 4}, Plane::Color, row, {}, 0});
            std::uint64_t overflows = 0;
            const auto wrap = [&](std::int64_t v) {
                const std::int64_t out = wrapped(v, profile.accum_bits);
                overflows += out != v;
                return out;
            };
            std::vector<std::array<std::int64_t, 4>> value(256);
            const auto step = [&](AccumOp op, float v, const auto& change) {
                bench.run(Accumulate{op, v});
                for (std::size_t x = 0; x < 256; ++x)
                    for (std::size_t c = 0; c < 4; ++c) {
                        value[x][c] = wrap(change(value[x][c], row[x][c]));
                        ASSERT_EQ(bench.accum(int(x) % 64, int(x) / 64)[c], value[x][c])
                            << profile.name << " op " << int(op) << " weight " << v << " x " << x;
                    }
            };
            const int f = profile.name == "opengl" ? 16 : 0;  // fraction bits
            step(AccumOp::Load, w, [&](std::int64_t, int c) { return product(c, w, f); });
            step(AccumOp::Accum, w, [&](std::int64_t a, int c) { return a + product(c, w, f); });
            step(AccumOp::Accum, 1, [&](std::int64_t a, int c) { return a + product(c, 1, f); });
            step(AccumOp::Add, w / 2,
                 [&](std::int64_t a, int) { return a + product(top, w / 2, f); });
            step(AccumOp::Mult, w, [&](std::int64_t a, int) { return product(a, w); });
            step(AccumOp::Mult, 1 / 3.0f,
                 [&](std::int64_t a, int) { return product(a, 1 / 3.0f); });
            EXPECT_EQ(bench.take_counters().accum_overflows, overflows);
            bench.run(Accumulate{AccumOp::Return, 0.75f});
            for (std::size_t x = 0; x < 256; ++x)
                for (std::size_t c = 0; c < 4; ++c)
                    ASSERT_EQ(bench.color(int(x) % 64, int(x) / 64)[c],
                              std::clamp<std::int64_t>(product(value[x][c], 0.75f, -f), 0, top));
        }
}

TEST(ExhaustiveAccumulation, TiesGoToEven) {
    Workbench bench(vgx(), 256, 1);
    std::vector<Rgba> row;
    for (int x = 0; x < 256; ++x) row.push_back({std::uint16_t(x), 0, 0, 0});
    bench.run(WritePixels{{0, 0, 256, 1}, Plane::Color, row, {}, 0});
    bench.run(Accumulate{AccumOp::Load, 0.5f});
    for (int x = 0; x < 256; ++x)
        EXPECT_EQ(bench.accum(x, 0)[0], x % 2 == 0 ? x / 2 : (x + 1) / 4 * 2) << x;
}

TEST(ExhaustiveAccumulation, OnVgx128PassesOfWhiteFitAnd129Overflow) {
    Workbench bench(vgx(), 1, 1);
    bench.clear(all_planes, vec4(1));
    for (int pass = 1; pass <= 129; ++pass) {
        bench.run(Accumulate{AccumOp::Accum, 1});
        EXPECT_EQ(bench.take_counters().accum_overflows, pass == 129 ? 4u : 0u);
        EXPECT_EQ(bench.accum(0, 0)[0], pass == 129 ? 129 * 255 - 65536 : pass * 255);
    }
}

TEST(ExhaustiveAccumulation, SumsOf32BitsOverflowToo) {
    Workbench bench(ideal(), 4, 4);
    bench.clear(all_planes, vec4(1));
    bench.run(Accumulate{AccumOp::Load, 256});
    bench.run(Accumulate{AccumOp::Mult, 128});
    EXPECT_EQ(bench.accum(3, 3)[1], 65535 * 32768);
    EXPECT_EQ(bench.take_counters().accum_overflows, 0u);
    bench.run(Accumulate{AccumOp::Accum, 1});
    EXPECT_EQ(bench.accum(3, 3)[1], std::int64_t{65535} * 32769 - (std::int64_t{1} << 32));
    EXPECT_EQ(bench.take_counters().accum_overflows, 64u);
}

TEST(ExhaustiveAccumulation, OneReturnRoundsOnceManyWeightedPassesRoundOften) {
    // 16 pictures of 8: their sum returned with 1/16 is exact. Accum with 1/16 rounds 0.5 to 0 each
    // time.
    Workbench once(vgx(), 1, 1), often(vgx(), 1, 1);
    for (Workbench* bench : {&once, &often}) bench->write({0, 0, 1, 1}, {8, 8, 8, 8});
    for (int i = 0; i < 16; ++i) {
        once.run(Accumulate{AccumOp::Accum, 1});
        often.run(Accumulate{AccumOp::Accum, 1 / 16.0f});
    }
    once.run(Accumulate{AccumOp::Return, 1 / 16.0f});
    often.run(Accumulate{AccumOp::Return, 1});
    EXPECT_EQ(once.color(0, 0)[0], 8);
    EXPECT_EQ(often.color(0, 0)[0], 0);
}

}  // namespace
}  // namespace gw
