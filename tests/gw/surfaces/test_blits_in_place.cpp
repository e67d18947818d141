// Blits that leave pixels where they are, which the fast machine copies tile by tile. [R16.7], [R16.9],
// [R17.6]. Against the reference machine.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <array>
#include <vector>

namespace gw {
namespace {

/// Surfaces of several sizes and samples beside a window with two colour planes.
class Blits {
public:
    explicit Blits(std::uint64_t seed)
        : random_(seed),
          sides_{{side(), side()}},
          bench_(make_reference(opengl(), side_of(0), side_of(1)),
                 make_fast(opengl(), side_of(0), side_of(1),
                           {.threads = 1, .log2_tile = int(random_.between(4, 6))})) {
        bench_.state.projection = dmat4(1);
        made_.push_back({side_of(0), side_of(1), all_planes});
        for (std::uint32_t number = 1; number <= 4; ++number) {
            const int samples = std::array{0, 0, 0, 2, 4, 8}[std::size_t(random_.between(0, 5))];
            const PlaneMask planes =
                random_.between(0, 3) == 0 ? PlaneMask(random_.between(1, 7)) : surface_planes;
            // Sides as the window's, so that whole tiles are copied, or others.
            const bool as_window = random_.between(0, 1) == 0;
            made_.push_back({as_window ? side_of(0) : side(), as_window ? side_of(1) : side(),
                             planes, 0, samples});
            bench_.run(MakeSurface{number, made_.back()});
        }
    }
    void run_one() {
        const auto number = std::uint32_t(random_.between(0, 4));
        bench_.run(UseSurface{number});
        set_state();
        switch (random_.between(0, 3)) {
            case 0: return clear();
            case 1: return draw();
        }
        blit(number);
    }
    /// All that surfaces have, in the window.
    void show() {
        bench_.state.scissor = {};
        bench_.state.draw_buffer = DrawBuffer::Front;
        bench_.run(UseSurface{0});
        for (std::uint32_t number = 1; number <= 4; ++number) {
            const Rect all{0, 0, made_[number].width, made_[number].height};
            bench_.run(Blit{.from_surface = number, .planes = 7, .source = all, .target = all});
            bench_.compare();
        }
    }

private:
    int side() { return int(random_.between(1, 90)); }
    int side_of(std::size_t i) const { return sides_[i]; }
    bool chance(int percent) { return random_.between(1, 100) <= percent; }
    Rect any_rect(int low, int high) {
        const auto at = [&] { return int(random_.between(low, high)); };
        return {at(), at(), int(random_.between(0, 100)), int(random_.between(0, 100))};
    }
    void set_state() {
        State& s = bench_.state;
        s.scissor = {chance(30), any_rect(0, 40)};
        s.draw_buffer = std::array{DrawBuffer::Front, DrawBuffer::Back, DrawBuffer::Back,
                                   DrawBuffer::FrontAndBack,
                                   DrawBuffer::None}[std::size_t(random_.between(0, 4))];
        s.read_buffer = chance(50) ? ReadBuffer::Front : ReadBuffer::Back;
        s.multisample.enable = chance(70);
        s.depth = {.test = chance(70), .func = chance(50) ? DepthFunc::LEqual : DepthFunc::Always};
        s.stencil = {.test = chance(40)};
        s.stencil.zpass = StencilOp::Replace;
        s.stencil.ref = int(random_.between(0, 255));
    }
    void clear() {
        const auto channel = [&] { return float(random_.between(0, 255)) / 255; };
        bench_.run(Clear{PlaneMask(random_.between(1, 15)),
                         {channel(), channel(), channel(), channel()},
                         double(random_.between(0, 16)) / 16,
                         int(random_.between(0, 255))});
    }
    /// Triangles, also so large and without colours that whole blocks have the depths of one plane.
    void draw() {
        bench_.state.color_mask = chance(50) ? ColorMask{} : ColorMask{false, false, false, false};
        bench_.state.stencil.test = bench_.state.stencil.test && chance(50);
        const float size = chance(30) ? 1 : 8;
        const auto at = [&] { return float(random_.between(-24, 24)) / 16; };
        MeshData data{.primitive = Primitive::Triangles};
        for (int i = 0; i < 6; ++i) {
            data.positions.push_back({size * at(), size * at(), at() / 2});
            data.colors.push_back({std::abs(at()) / 2, std::abs(at()) / 2, 1, 0.5f});
        }
        bench_.draw(std::move(data));
    }
    void blit(std::uint32_t number) {
        const auto from = std::uint32_t(random_.between(0, 4));
        const int samples = made_[number].samples, other = made_[from].samples;
        if (samples > 0 && other > 0 && samples != other) return;
        const Rect rect =
            chance(60) ? Rect{0, 0, made_[from].width, made_[from].height} : any_rect(-10, 60);
        bench_.run(Blit{.from_surface = from,
                        .planes = PlaneMask(chance(60) ? 7 : random_.between(0, 7)),
                        .source = rect,
                        .target = rect,
                        .filter = chance(50) ? MagFilter::Nearest : MagFilter::Linear});
    }

    test::Random random_;
    std::array<int, 2> sides_;
    test::Workbench bench_;
    std::vector<Surface> made_;
};

TEST(BlitsInPlace, AreThoseOfTheReferenceMachine) {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        Blits blits(seed);
        for (int i = 0; i < 25; ++i) blits.run_one();
        blits.show();
        if (testing::Test::HasFailure()) return;
    }
}

/// One depth for a block that had those of a plane, and the reverse.
TEST(BlitsInPlace, ReplaceDepthsOfOneKindByAnother) {
    test::Workbench bench(opengl(), 64, 64);
    bench.state.projection = dmat4(1);
    bench.state.depth = {.test = true, .func = DepthFunc::LEqual};
    bench.state.color_mask = {false, false, false, false};
    constexpr Rect all{0, 0, 64, 64};
    constexpr PlaneMask depth = mask_of(Plane::Depth);
    bench.run(MakeSurface{1, {64, 64, surface_planes}});
    bench.run(MakeSurface{2, {64, 64, surface_planes}});
    bench.run(UseSurface{1});
    bench.clear(depth, vec4(0), 0.5);
    bench.run(UseSurface{2});
    bench.clear(depth);
    bench.draw(Primitive::Triangles, {{-9, -9, -0.5f}, {9, -9, 0.5f}, {0, 9, 0}});
    bench.run(UseSurface{0});
    bench.clear(depth);
    bench.draw(Primitive::Triangles, {{-9, -9, 0}, {9, -9, 0.5f}, {0, 9, 0.25f}});
    for (const std::uint32_t from : {1u, 2u, 1u}) {
        bench.run(Blit{.from_surface = from, .planes = depth, .source = all, .target = all});
        if (from == 2) bench.draw(Primitive::Triangles, {{-9, -9, 0}, {9, -9, 0.5f}, {0, 9, 0}});
        bench.run(Blit{.from_surface = from, .planes = depth, .source = all, .target = all});
    }
    EXPECT_EQ(bench.depth(9, 9), 0x800000u);
}

}  // namespace
}  // namespace gw
