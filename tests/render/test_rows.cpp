// Claims: rows that are drawn alone have the bits of the whole picture, for every renderer, in any
// number of parts, with every effect: shadows, layers, tied faces, samples, lens, motion, glare,
// fog, rays, reflection maps.
#include "render/drawing.h"
#include "scene/toml/read_scene.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gw::render {
namespace {

constexpr int width = 26, height = 19;

/// And with small maps of its own.
scene::Scene without_files(scene::Scene scene) {
    for (scene::Material& m : scene.materials)
        for (auto* maps : {&m.map_Ka, &m.map_Kd, &m.map_Ks, &m.map_Ke, &m.refl, &m.refraction}) {
            std::erase_if(*maps, [](const scene::Map& map) { return map.from_scene == 0; });
            for (scene::Map& map : *maps) map.from_scene = 8;
        }
    return scene;
}

Drawing drawing_of(const std::string& name, Request request) {
    request.size = {width, height};
    request.threads = 1;
    scene::SceneFile file = scene::read_scene(GW_SOURCE_DIR "/scenes/" + name + ".toml");
    return make_drawing(request, profile_named(request.profile),
                        {.scene = without_files(std::move(file.scene)), .origin = file.origin});
}

std::vector<Rgba> drawn(const Drawing& drawing, const std::optional<scene::Rows>& rows) {
    const auto machine = make_machine(drawing.request, drawing.profile);
    // Leftovers of another picture must not show.
    CommandList list;
    list.add(BeginPass{.name = "leftovers"});
    list.add(SetState{});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth) |
                                       mask_of(Plane::Stencil) | mask_of(Plane::Accum)),
                   .color = vec4(1),
                   .depth = 0.25,
                   .stencil = 0xa5,
                   .accum = vec4(0.5)});
    machine->execute(list);
    scene::View view = drawing.view();
    view.only_rows = rows;
    draw(drawing, view, *machine);
    return machine->planes().color;
}

/// The rows of `parts` parts, each drawn alone.
std::vector<Rgba> in_parts(const Drawing& drawing, int parts) {
    std::vector<Rgba> color;
    for (int i = 0; i < parts; ++i) {
        const scene::Rows rows{height * i / parts, height * (i + 1) / parts};
        const std::vector<Rgba> all = drawn(drawing, rows);
        color.insert(color.end(), all.begin() + rows.first * width, all.begin() + rows.end * width);
    }
    return color;
}

void expect_equal_parts(const std::string& scene, const Request& request,
                        const std::vector<int>& counts = {3}) {
    const Drawing drawing = drawing_of(scene, request);
    const std::vector<Rgba> whole = drawn(drawing, {});
    for (const int parts : counts)
        EXPECT_TRUE(in_parts(drawing, parts) == whole)
            << scene << ", " << request.renderer << ", " << parts << " parts";
}

}  // namespace

TEST(Rows, OfEveryRendererHaveTheBitsOfTheWholePicture) {
    for (const std::string& renderer : renderer_names())
        expect_equal_parts("panes", {.renderer = renderer, .samples = 2}, {1, 2, 3, 7});
}

TEST(Rows, OfEveryEffectHaveTheBitsOfTheWholePicture) {
    for (const std::string scene : {"rings", "soft", "mirrors", "motion", "focus", "fog", "glare",
                                    "edges", "selective", "water"})
        expect_equal_parts(scene, {});
}

TEST(Rows, OfEveryOptionHaveTheBitsOfTheWholePicture) {
    using scene::Shadow;
    for (const std::string profile : {"vgx", "ideal"}) {
        expect_equal_parts("soft", {.samples = 3, .profile = profile, .weighted = true});
        for (const Shadow shadow : {Shadow::Volume, Shadow::Map, Shadow::None})
            expect_equal_parts("fig9", {.profile = profile, .shadow = shadow, .shadow_maps = true});
        for (const auto translucency :
             {multipass::Translucency::Sorted, multipass::Translucency::Unsorted,
              multipass::Translucency::Layers})
            expect_equal_parts("panes", {.profile = profile, .translucency = translucency});
        expect_equal_parts("mirrors", {.profile = profile, .traced = false});
    }
}

TEST(Rows, HaveTheSameBitsOnBothMachines) {
    for (const std::string& renderer : renderer_names())
        expect_equal_parts("panes", {.renderer = renderer, .machine = "reference"});
}

/// Else the tests above would hold for a picture that is drawn whole in each part.
TEST(Rows, CostTheirShareOfTheRays) {
    raytrace::RayCounts counts;
    Drawing drawing = drawing_of("panes", {.renderer = "raytrace"});
    drawing.counts = &counts;
    drawn(drawing, scene::Rows{3, 7});
    EXPECT_EQ(counts.primary, 4u * width);
}

TEST(Rows, DrawNoFragmentOfOthers) {
    const Drawing drawing = drawing_of("rings", {.renderer = "hardware"});
    const auto fragments = [&](const scene::Rows& rows) {
        const auto machine = make_machine(drawing.request, drawing.profile);
        scene::View view = drawing.view();
        view.only_rows = rows;
        draw(drawing, view, *machine);
        std::uint64_t written = 0;
        for (const PassReport& pass : machine->passes()) written += pass.counters.written;
        return written;
    };
    const std::uint64_t low = fragments({0, 8}), high = fragments({8, height});
    EXPECT_GT(low, 0u);
    EXPECT_GT(high, 0u);
    EXPECT_EQ(low + high, fragments({0, height}));
}

}  // namespace gw::render
