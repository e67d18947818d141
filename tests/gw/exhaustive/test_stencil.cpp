// Every value of the stencil operations and masks, and the comparisons at their borders.
// docs/manual/fragments.md, "Alpha, stencil and depth tests".
#include "gw/stages/tables.h"
#include "tests/gw/exhaustive/stencil_row.h"

namespace gw {
namespace {

using namespace test;

// [R12.6]
TEST(ExhaustiveStencil, TheTableForEveryOperationValueAndReference) {
    for (int bits = 1; bits <= 8; ++bits)
        for (const StencilOp op : ops)
            for (int stored = 0; stored < 1 << bits; ++stored)
                for (int ref = 0; ref < 256; ++ref)
                    ASSERT_EQ(int(stencil_result(op, std::uint32_t(stored), std::uint32_t(ref),
                                                 (1u << bits) - 1)),
                              operated(op, stored, ref, 1 << bits))
                        << bits << " bits, op " << int(op) << ", stored " << stored << ", ref "
                        << ref;
}

TEST(ExhaustiveStencil, EveryOperationValueMaskAndSomeReferencesThroughTheMachine) {
    // Only Replace depends on the reference: it draws all references, the others two.
    Row row;
    for (const StencilOp op : ops)
        for (int mask = 0; mask < 256; ++mask)
            for (int ref = 0; ref < 256; ref += op == StencilOp::Replace ? 1 : 255) {
                row.bench.state.stencil = {
                    .test = true, .ref = ref, .zpass = op, .write_mask = std::uint32_t(mask)};
                row.fill();
                row.bench.write(row.rect, {});
                for (int stored = 0; stored < 256; ++stored)
                    ASSERT_EQ(row.at(stored), masked(stored, operated(op, stored, ref, 256), mask))
                        << "op " << int(op) << ", mask " << mask << ", ref " << ref;
            }
}

// [R12.5]
TEST(ExhaustiveStencil, TheComparisonPutsTheReferenceFirst) {
    // [GL11] 4.1.4: passes where (ref & mask) func (stored & mask).
    const auto passes = [](StencilFunc func, int ref, int stored) {
        const int sign = (ref > stored) - (ref < stored);
        switch (func) {
            case StencilFunc::Never: return false;
            case StencilFunc::Less: return sign == -1;
            case StencilFunc::Equal: return sign == 0;
            case StencilFunc::LEqual: return sign != 1;
            case StencilFunc::Greater: return sign == 1;
            case StencilFunc::NotEqual: return sign != 0;
            case StencilFunc::GEqual: return sign != -1;
            case StencilFunc::Always: return true;
        }
        return false;
    };
    Row row;
    for (int func = 0; func < 8; ++func)
        for (const int mask : {0, 1, 0x0F, 0x80, 0xF0, 0xFF})
            for (int ref = 0; ref < 256; ref += 3) {
                // Passing fragments count up, failing ones down: neighbours 1 apart in both
                // directions.
                row.bench.state.stencil = {.test = true,
                                           .func = StencilFunc(func),
                                           .ref = ref,
                                           .mask = std::uint32_t(mask),
                                           .fail = StencilOp::DecrWrap,
                                           .zpass = StencilOp::IncrWrap};
                row.fill();
                row.bench.write(row.rect, {});
                for (int stored = 0; stored < 256; ++stored)
                    ASSERT_EQ(row.at(stored),
                              (stored +
                               (passes(StencilFunc(func), ref & mask, stored & mask) ? 1 : 255)) %
                                  256)
                        << "func " << func << ", mask " << mask << ", ref " << ref << ", stored "
                        << stored;
            }
}

TEST(ExhaustiveStencil, EachFateHasItsOperation) {
    Row row;
    row.bench.state.stencil = {.test = true,
                               .func = StencilFunc::GEqual,
                               .ref = 100,
                               .fail = StencilOp::Zero,
                               .zfail = StencilOp::Replace,
                               .zpass = StencilOp::Invert};
    row.fill();
    row.bench.clear(mask_of(Plane::Depth), vec4(0), 0.5);
    row.bench.state.depth = {.test = true, .func = DepthFunc::Less, .mask = false};
    row.bench.write({0, 0, 50, 1}, {}, 0xFFFFFFFF);  // behind: zfail
    row.bench.write({50, 0, 206, 1}, {}, 5);         // in front: zpass, or fail above 100
    for (int x = 0; x < 256; ++x) EXPECT_EQ(row.at(x), x < 50 ? 100 : x <= 100 ? 255 - x : 0) << x;
}

// [R12.8]
TEST(ExhaustiveStencil, TwoSidesHaveTheirOwnState) {
    Workbench bench(ideal(), 8, 8);
    bench.state.stencil = {.test = true, .zpass = StencilOp::IncrWrap, .two_side = true};
    bench.state.stencil.back.zpass = StencilOp::DecrWrap;
    const std::vector<vec3> front{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}},
        back{{0, 0, 0}, {8, 8, 0}, {0, 8, 0}};
    bench.draw(Primitive::Triangles, front);
    bench.draw(Primitive::Triangles, {back[0], back[2], back[1]});
    EXPECT_EQ(bench.stencil(6, 1), 1);
    EXPECT_EQ(bench.stencil(1, 6), 255);
}

TEST(ExhaustiveStencil, NarrowStencilsSaturateAtTheirOwnLimit) {
    for (int bits = 1; bits <= 8; ++bits) {
        Profile profile = ideal();
        profile.stencil_bits = bits;
        Workbench bench(profile, 4, 4);
        bench.state.stencil = {.test = true, .zpass = StencilOp::Incr};
        for (int i = 0; i < 300; ++i) bench.write({1, 1, 1, 1}, {});
        EXPECT_EQ(bench.stencil(1, 1), (1 << bits) - 1);
        bench.state.stencil.zpass = StencilOp::Replace;
        bench.state.stencil.ref = 0x7FFFFFFF;
        bench.write({2, 2, 1, 1}, {});
        EXPECT_EQ(bench.stencil(2, 2), (1 << bits) - 1);
    }
}

/// Whether `incoming func stored`, from the sign of the difference.
bool holds(CompareFunc func, std::int64_t incoming, std::int64_t stored) {
    const std::int64_t d = incoming - stored;
    const bool less = d<0, equal = d == 0, greater = d> 0;
    const bool table[] = {
        false, less, equal, less || equal, greater, less || greater, greater || equal, true};
    return table[int(func)];
}

// [R12.4] [R12.9]
TEST(ExhaustiveCompare, DepthAtItsBorders) {
    for (const Profile& profile : profiles()) {
        const auto top = std::uint32_t((1ull << profile.depth_bits) - 1), half = top / 2;
        const std::vector<std::uint32_t> values{0,        1,       2,        255,      256,
                                                half - 1, half,    half + 1, half + 2, top - 256,
                                                top - 2,  top - 1, top};
        for (int func = 0; func < 8; ++func)
            for (const std::uint32_t incoming : values) {
                Workbench bench(profile, 16, 1);
                std::vector<std::uint32_t> row = values;
                row.resize(16);
                bench.run(WritePixels{{0, 0, 16, 1}, Plane::Depth, {}, row, 0});
                bench.state.depth = {.test = true, .func = DepthFunc(func)};
                bench.write({0, 0, 16, 1}, {1, 2, 3, 4}, incoming);
                for (int x = 0; x < 16; ++x) {
                    const bool passes = holds(DepthFunc(func), incoming, row[std::size_t(x)]);
                    EXPECT_EQ(bench.color(x, 0)[0], passes ? 1 : 0);
                    EXPECT_EQ(bench.depth(x, 0), passes ? incoming : row[std::size_t(x)]);
                }
            }
    }
}

// [R12.4]
TEST(ExhaustiveCompare, AlphaForEveryValueAndReferenceOf8Bits) {
    Workbench bench(vgx(), 256, 1);
    std::vector<Rgba> row;
    for (int x = 0; x < 256; ++x) row.push_back({1, 1, 1, std::uint16_t(x)});
    for (int func = 0; func < 8; ++func)
        for (int ref = 0; ref < 256; ++ref) {
            bench.state.alpha = {};
            bench.write({0, 0, 256, 1}, {});
            bench.state.alpha = {true, AlphaFunc(func), float(ref) / 255};
            bench.run(WritePixels{{0, 0, 256, 1}, Plane::Color, row, {}, 0});
            for (int x = 0; x < 256; ++x)
                ASSERT_EQ(bench.color(x, 0)[0], holds(AlphaFunc(func), x, ref) ? 1 : 0)
                    << "func " << func << ", alpha " << x << ", ref " << ref;
        }
}

}  // namespace
}  // namespace gw
