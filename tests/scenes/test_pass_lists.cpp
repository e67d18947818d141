// The built-in list of every scene, written as [[pass]] and read again as the scene's own, draws
// the same bits in every plane on every profile.
#include "image/textures.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/pass_toml.h"
#include "scene/draw/fit.h"
#include "scene/toml/read_scene.h"

#include <gtest/gtest.h>
#include "test_paths.h"
#include "tests/temporary_folder.h"

#include <algorithm>
#include <filesystem>

namespace gw::multipass {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(GW_SOURCE_DIR) / "scenes";
constexpr int width = 64, height = 48;

std::vector<std::string> files() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

/// A scene of one box with this list of passes.
std::string with_passes(const std::string& passes) {
    return "[[object]]\nshape = 'box'\n" + passes;
}

PassList read_again(const PassList& list) {
    const TemporaryFolder here;
    return read_passes(
        scene::read_scene(here.write("list.toml", with_passes(to_toml(list)))).passes);
}

std::vector<Digest> draw(const scene::Scene& s, const Profile& profile, const PassList& list) {
    const auto machine = make_fast(profile, width, height, {});
    render(*machine, s, scene::make_view(s, width, height), {.pass_list = list});
    std::vector<Digest> digests;
    for (const Plane plane : every_plane) digests.push_back(digest(machine->planes(), plane));
    return digests;
}

class PassLists : public testing::TestWithParam<std::string> {};

TEST_P(PassLists, ReadAgainDrawTheSameBits) {
    scene::Scene s = scene::read_scene(folder / GetParam()).scene;
    image::load_textures(s);
    scene::add_defaults(s, width, height);
    // A scene of hundreds of pictures needs no more of them to show a difference.
    for (scene::Light& light : s.lights) light.area.samples = std::min(light.area.samples, 2);
    for (scene::Material& material : s.materials)
        for (auto* maps : {&material.refl, &material.refraction})
            for (scene::Map& map : *maps) map.from_scene = std::min(map.from_scene, 8);
    for (scene::Object& object : s.objects)
        if (object.glare) object.glare->samples = 2;
    for (const Profile& profile : paper_profiles())
        for (const Renderer renderer : {Renderer::Multipass, Renderer::Hardware}) {
            if (renderer == Renderer::Hardware && int(s.lights.size()) > profile.max_lights)
                continue;
            const PassList list = passes_for(s, renderer);
            EXPECT_EQ(draw(s, profile, read_again(list)), draw(s, profile, list)) << profile.name;
        }
}

INSTANTIATE_TEST_SUITE_P(All, PassLists, testing::ValuesIn(files()), [](const auto& test) {
    return test.param.substr(0, test.param.find('.'));
});

}  // namespace
}  // namespace gw::multipass
