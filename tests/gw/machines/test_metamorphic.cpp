// The result does not depend on cuts of a list, the order of draws that do not meet, state that is
// switched off, threads or tiles. Lists are those of gw-fuzz. Does not compare the two machines:
// test_fuzz.cpp does.
#include "conformance/generate/draw.h"
#include "conformance/generate/state.h"
#include "tests/fuzz/run.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::fuzz {
namespace {

std::unique_ptr<Machine> run(const Case& c, const CommandList& list, int variant = 0) {
    auto machine = machine_named("fast")(c, variant);
    machine->execute(list);
    return machine;
}

/// Empty if the machines agree.
std::string difference(Machine& a, Machine& b) {
    const auto d = first_difference(a, b);
    return d ? d->what + ": " + d->a + ", " + d->b : "";
}

const Suite& suite_named(std::string_view name) {
    return *std::find_if(suites().begin(), suites().end(),
                         [&](const Suite& s) { return name == s.name; });
}

// [R1.2] [R1.8] [R14.5]
TEST(Metamorphic, AListMayBeCutAnywhere) {
    for (const char* name : {"multipass", "everything", "coincident", "jitter"})
        for (std::uint64_t i = 0; i < 4; ++i) {
            const Case c = make_case(suite_named(name), 100000 + i);
            const auto whole = run(c, c.list);
            for (std::size_t cut = 1; cut < c.list.commands.size(); ++cut) {
                const auto cut_machine = run(c, part_of(c.list, 0, cut));
                cut_machine->execute(part_of(c.list, cut, c.list.commands.size() - cut));
                ASSERT_EQ(difference(*whole, *cut_machine), "")
                    << name << " " << i << " cut before " << cut;
            }
        }
}

// [R1.2]
TEST(Metamorphic, ThreadsAndTilesDoNotMatter) {
    for (const Suite& suite : suites())
        for (std::uint64_t i = 0; i < 4; ++i) {
            const Case c = make_case(suite, 200000 + i);
            const auto one = run(c, c.list);
            for (int variant = 1; variant < 8; ++variant)
                ASSERT_EQ(difference(*one, *run(c, c.list, variant)), "") << suite.name << " " << i;
        }
}

/// The lists above end before a second thread wakes up. This one has thousands of tiles a thread.
TEST(Metamorphic, ThreadsShareALargePicture) {
    Random r(1);
    Case c{.width = 1500, .height = 1100};
    State state;
    state.depth.test = true;
    state.stencil = {.test = true, .zfail = StencilOp::Incr, .zpass = StencilOp::Invert};
    c.list.add(Clear{.planes = all_planes, .depth = 1});
    for (int i = 0; i < 12; ++i) {
        MeshData data;
        for (int k = 0; k < 30; ++k) {
            const auto x = static_cast<float>(r.real(-1.2, 1.2)),
                       y = static_cast<float>(r.real(-1.2, 1.2));
            data.positions.push_back({x, y, static_cast<float>(r.real(-1, 1))});
            data.colors.push_back(any_color(r));
        }
        state.blend = any_blend(r);
        c.list.add(SetState{state});
        c.list.add(Draw{.mesh = make_mesh(std::move(data))});
    }
    const auto one = run(c, c.list);
    for (int variant = 1; variant < 8; ++variant)
        EXPECT_EQ(difference(*one, *run(c, c.list, variant)), "") << "variant " << variant;
}

/// Triangles inside a cell of 8 x 8 pixels.
MeshRef cell_mesh(Random& r, int column, int row, int cells) {
    MeshData data;
    for (int i = 0; i < 6; ++i) {
        const auto x = static_cast<float>((column + r.real(0, 1)) * 2 / cells - 1);
        const auto y = static_cast<float>((row + r.real(0, 1)) * 2 / cells - 1);
        data.positions.push_back({x, y, static_cast<float>(r.real(-1, 1))});
        data.colors.push_back(any_color(r));
    }
    return make_mesh(std::move(data));
}

TEST(Metamorphic, DrawsThatDoNotMeetMayChangePlaces) {
    constexpr int cells = 9;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random r(seed);
        Case c{.profile = r.pick(paper_profiles()), .width = 8 * cells, .height = 8 * cells};
        State state;
        state.depth.test = true;
        state.blend = any_blend(r);
        std::vector<Command> draws;
        for (int i = 0; i < cells * cells; ++i)
            draws.push_back(Draw{.mesh = cell_mesh(r, i % cells, i / cells, cells)});
        const auto list_of = [&] {
            CommandList list;
            list.add(Clear{.planes = all_planes, .color = {0.25f, 0.5f, 0.75f, 0.5f}});
            list.add(SetState{state});
            for (const Command& draw : draws) list.add(draw);
            return list;
        };
        const auto in_order = run(c, list_of());
        for (std::size_t i = draws.size(); i-- > 1;)
            std::swap(draws[i], draws[std::size_t(r.below(int(i) + 1))]);
        EXPECT_EQ(difference(*in_order, *run(c, list_of())), "") << "seed " << seed;
        EXPECT_GT(in_order->passes().front().counters.written, 500u);
    }
}

/// Changes only fields that are switched off or do not concern triangles.
void disturb_unused(Random& r, const Case& where, State& s) {
    const Profile& p = where.profile;
    const bool lights = s.color_source == ColorSource::Lighting;
    if (!s.cull.enable) s.cull.face = r.any(Face::FrontAndBack);
    if (!s.polygon_offset.enable) s.polygon_offset = {false, 3, -7};
    if (!s.fog.enable) {
        s.fog = any_fog(r, 1);
        s.fog.enable = false;
    }
    if (!s.scissor.test) {
        s.scissor = any_scissor(r, where.width, where.height);
        s.scissor.test = false;
    }
    if (!s.alpha.test) s.alpha = {false, r.any(AlphaFunc::Always), any_fraction(r)};
    // Clears go through the write mask also when the test is off.
    const std::uint32_t write_mask = s.stencil.write_mask;
    if (!s.stencil.test) {
        s.stencil = any_stencil(r, p);
        s.stencil.test = false;
        s.stencil.write_mask = write_mask;
    }
    if (!s.depth.test) s.depth.func = r.any(DepthFunc::Always);
    if (!s.blend.enable) {
        s.blend = any_blend(r);
        s.blend.enable = false;
    }
    if (!lights) {
        s.lighting = any_lighting(r);
        s.lighting.two_side = false;
    }
    for (ClipPlane& plane : s.clip_planes)
        if (!plane.enable) plane.plane = {1, 2, 3, 4};
}

TEST(Metamorphic, StateThatIsSwitchedOffDoesNotMatter) {
    for (const Suite& suite : suites())
        for (std::uint64_t i = 0; i < 10; ++i) {
            const Case c = make_case(suite, 300000 + i);
            CommandList disturbed = c.list;
            Random r(i);
            for (Command& command : disturbed.commands)
                if (auto* set = std::get_if<SetState>(&command))
                    disturb_unused(r, c, set->state.edit());
            ASSERT_EQ(difference(*run(c, c.list), *run(c, disturbed)), "")
                << suite.name << " " << i;
        }
}

}  // namespace
}  // namespace gw::fuzz
