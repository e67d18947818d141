// Claims: a pixel's history has every fragment that reached it, in order, with the stage that
// killed it, and every command that touched it; maps count the same fragments.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "inspect/compare/compare_machines.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "tests/inspect/same.h"
#include "tests/inspect/three_passes.h"

#include <algorithm>
#include <numeric>

namespace gw::inspect {
namespace {

/// A pixel of depth 5; then fragments that each test kills, and one that passes.
Recording killers() {
    Recording r;
    r.width = r.height = 2;
    CommandList list;
    const auto write = [&](const State& state, Rgba color, std::uint32_t depth) {
        list.add(SetState{state});
        list.add(WritePixels{.rect = {0, 0, 1, 1}, .colors = {color}, .depth = depth});
    };
    list.add(BeginPass{.name = "all"});
    list.add(Clear{.planes = all_planes, .stencil = 3});
    write({.alpha = {.test = true, .func = AlphaFunc::Greater, .ref = 0.5f}}, {1, 1, 1, 100}, 1);
    write(
        {.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 9, .fail = StencilOp::Incr}},
        {2, 2, 2, 2}, 2);
    write({.depth = {.test = true, .func = DepthFunc::Greater}}, {3, 3, 3, 3}, 3);
    write({.blend = {.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One}},
          {4, 4, 4, 4}, 4);
    list.add(Accumulate{AccumOp::Accum, 2});
    list.add(Copy{.plane = Plane::Color, .source = {0, 0, 1, 1}, .x = 1, .y = 1});
    r.lists.push_back(list);
    return r;
}

}  // namespace

TEST(PixelHistory, NamesTheStageThatKilledEachFragment) {
    const auto events = pixel_history(killers(), 0, 0);
    ASSERT_EQ(events.size(), 6u);
    EXPECT_STREQ(events[0].command_name, "Clear");
    EXPECT_EQ(events[0].after.stencil, 3);
    EXPECT_EQ(events[0].after.depth, 0xffffffu);
    EXPECT_EQ(events[1].fate, Fate::AlphaTest);
    EXPECT_EQ(events[2].fate, Fate::StencilTest);
    EXPECT_EQ(events[2].before.stencil, 3);
    EXPECT_EQ(events[2].after.stencil, 4);
    EXPECT_EQ(events[3].fate, Fate::DepthTest);
    EXPECT_EQ(events[4].fate, Fate::Written);
    EXPECT_EQ(events[4].fragment->color, (Rgba{4, 4, 4, 4}));
    EXPECT_EQ(events[4].after.color, (Rgba{4, 4, 4, 4}));
    EXPECT_STREQ(events[5].command_name, "Accumulate");
    EXPECT_EQ(events[5].after.accum, (std::array<std::int32_t, 4>{8, 8, 8, 8}));
}

TEST(PixelHistory, HasCopies) {
    const auto events = pixel_history(killers(), 1, 1);
    ASSERT_EQ(events.size(), 3u);  // cleared, accumulated, copied to
    EXPECT_STREQ(events[2].command_name, "Copy");
    EXPECT_EQ(events[2].after.color, (Rgba{4, 4, 4, 4}));
}

TEST(PixelHistory, EndsWithThePlanesOfTheMachineForEveryPixel) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording recording = recording_of(fuzz::make_case(suite, 5));
        const auto machine = maker_of("fast", 1)(recording);
        Player(recording, *machine).play();
        const Planes& planes = machine->planes();
        for (int y = 0; y < recording.height; y += 7)
            for (int x = 0; x < recording.width; x += 7) {
                const auto events = pixel_history(recording, x, y);
                PixelValues last;
                for (const PixelEvent& e : events) {
                    ASSERT_EQ(e.before, last) << suite.name << " " << x << " " << y;
                    last = e.after;
                }
                const std::size_t i = planes.index(x, y);
                ASSERT_EQ(last, values_at(planes, i)) << suite.name;
            }
    }
}

TEST(PixelHistory, HasBothColourPlanes) {
    Recording r;
    r.profile = opengl();
    r.width = r.height = 2;
    State back;
    back.draw_buffer = DrawBuffer::Back;
    CommandList list;
    list.add(SetState{back});
    list.add(Clear{.planes = mask_of(Plane::Color), .color = vec4(1, 0, 0, 1)});
    list.add(SwapBuffers{});
    r.lists.push_back(list);
    const auto events = pixel_history(r, 1, 1);
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].after.back, (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(events[0].after.color, Rgba{});
    EXPECT_STREQ(events[1].command_name, "SwapBuffers");
    EXPECT_EQ(events[1].after.color, (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(events[1].after.back, Rgba{});
    const auto rows = history_rows(events);
    EXPECT_EQ(rows[0].back(), "back colour");
    EXPECT_EQ(rows[2].back(), "255 0 0 255 > 0 0 0 0");
    EXPECT_EQ(history_rows({events[0]})[0].size(), rows[0].size());
}

TEST(PixelHistory, NumbersDrawsWithinThePassAndPolygonsByTheirIdentifiers) {
    Recording r;
    r.width = r.height = 4;
    CommandList list;
    MeshData square{.primitive = Primitive::Quads,
                    .positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
    square.polygon_ids = {77};
    for (const char* name : {"a", "b"}) {
        list.add(BeginPass{.name = name});
        list.add(Draw{.mesh = make_mesh(square)});
        list.add(Draw{.mesh = make_mesh(square)});
    }
    r.lists.push_back(list);
    const auto events = pixel_history(r, 1, 2);
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[3].pass, 1u);
    EXPECT_EQ(events[3].pass_name, "b");
    EXPECT_EQ(events[3].draw, 1u);
    EXPECT_EQ(events[3].command, 5u);
    EXPECT_EQ(events[3].polygon, 77u);
}

TEST(PixelReport, TableAndJsonAreInPictureCoordinates) {
    const Recording recording = three_passes();
    const auto events = pixel_history(recording, 3, 2);
    const auto rows = history_rows(events);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[2][0], "first");
    EXPECT_EQ(rows[2][5], "written");
    EXPECT_EQ(rows[2][8], "0 0 0 0 > 100 100 100 255");
    EXPECT_EQ(rows[3][11], "0 0 0 0 > 100 100 100 255");
    const auto json = history_json(recording, 3, 2, events);
    EXPECT_EQ(json["y"], 3);
    EXPECT_EQ(json["events"][1]["fate"], "written");
    EXPECT_EQ(json["events"][3]["after"]["stencil"], 1);
}

TEST(PixelReport, HasTheCoverageOfAntialiasedFragmentsOnly) {
    Recording r;
    r.width = r.height = 4;
    r.profile = opengl();
    CommandList list;
    const MeshRef left =
        make_mesh({.primitive = Primitive::Quads,
                   .positions = {{-1, -1, 0}, {0.25f, -1, 0}, {0.25f, 1, 0}, {-1, 1, 0}}});
    State smooth;
    smooth.polygon_smooth = true;
    list.add(SetState{smooth});
    list.add(Draw{.mesh = left});
    r.lists.push_back(list);
    const auto events = pixel_history(r, 2, 1);  // the quad ends at x = 2.5
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].fragment->coverage, 128u);
    const auto rows = history_rows(events);
    EXPECT_EQ(rows[0].back(), "coverage");
    EXPECT_EQ(rows[1].back(), "128");
    EXPECT_EQ(history_json(r, 2, 1, events)["events"][0]["coverage"], 128);
    const auto others = pixel_history(three_passes(), 3, 2);
    EXPECT_NE(history_rows(others)[0].back(), "coverage");
    EXPECT_FALSE(history_json(three_passes(), 3, 2, others)["events"][1].contains("coverage"));
}

/// The depth that a pixel of a surface holds before a command.
std::uint32_t depth_before(std::size_t command, const std::vector<PixelEvent>& history) {
    std::uint32_t depth = 0;
    for (const PixelEvent& e : history)
        if (e.command < command) depth = e.after.depth;
    return depth;
}

std::size_t times_made(const Recording& recording, std::uint32_t surface) {
    std::size_t times = 0;
    for (const CommandList& list : recording.lists)
        for (const Command& command : list.commands)
            if (const auto* made = std::get_if<MakeSurface>(&command))
                times += made->number == surface;
    return times;
}

const fuzz::Suite& surfaces_suite() {
    return *std::ranges::find(fuzz::suites(), "surfaces", &fuzz::Suite::name);
}

struct Compared {
    std::size_t checked = 0, dark = 0;
};

/// Holds the comparisons that read a surface against what the history of its pixel says.
void check_comparisons(const Recording& recording, const PixelEvent& e, Compared& counts) {
    for (std::size_t k = 0; k < e.comparisons.size(); ++k) {
        const DepthComparison& c = e.comparisons[k];
        const std::uint32_t read = e.compared_surfaces[k];
        if (read == 0 || times_made(recording, read) > 1) continue;
        const Surface from = surfaces_of(recording).at(read);
        if (c.i < 0 || c.j < 0 || c.i >= from.width || c.j >= from.height) continue;
        EXPECT_EQ(c.stored, depth_before(e.command, pixel_history(recording, c.i, c.j, read)));
        ++counts.checked;
        counts.dark += !c.passes;
    }
}

TEST(PixelHistory, NamesTheDepthOfTheSurfaceThatShadesAFragment) {
    Compared counts;
    for (std::uint64_t seed = 0; seed < 90; ++seed) {
        const Recording recording = recording_of(fuzz::make_case(surfaces_suite(), seed));
        for (const auto& [number, size] : surfaces_of(recording))
            for (int i = 1; i < 4; ++i)
                for (const PixelEvent& e :
                     pixel_history(recording, size.width * i / 4, size.height * i / 4, number))
                    check_comparisons(recording, e, counts);
    }
    EXPECT_GT(counts.checked, 20u);
    EXPECT_GT(counts.dark, 0u);
    EXPECT_LT(counts.dark, counts.checked);
}

TEST(FragmentMaps, CountWhatTheMachineCounts) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording recording = recording_of(fuzz::make_case(suite, 6));
        const auto surfaces = surfaces_of(recording);
        const bool has_samples =
            std::ranges::any_of(surfaces, [](const auto& s) { return s.second.samples > 1; });
        const auto reports = reports_of(recording, maker_of("fast", 1));
        const auto sum = [](const std::vector<std::uint32_t>& map) {
            return std::accumulate(map.begin(), map.end(), std::uint64_t{0});
        };
        for (std::size_t pass = 0; pass < reports.size(); ++pass) {
            const Counters& counters = reports[pass].counters;
            Counters counted;
            for (const auto& [number, size] : surfaces) {
                const FragmentMaps maps = fragment_maps(recording, pass, number);
                counted.fragments += sum(maps.made);
                counted.written += sum(maps.written);
                counted.alpha_killed += sum(maps.alpha_killed);
                counted.stencil_killed += sum(maps.stencil_killed);
                counted.depth_killed += sum(maps.depth_killed);
            }
            if (!has_samples) {
                EXPECT_EQ(counted.fragments, counters.fragments) << suite.name;
            }
            EXPECT_EQ(counted.written, counters.written) << suite.name;
            EXPECT_EQ(counted.alpha_killed, counters.alpha_killed);
            EXPECT_EQ(counted.stencil_killed, counters.stencil_killed);
            EXPECT_EQ(counted.depth_killed, counters.depth_killed);
        }
    }
}

}  // namespace gw::inspect
