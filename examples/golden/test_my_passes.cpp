// A list of passes of one's own, as a scene's TOML has it, held to a golden pass by pass.
#include <inspect/testing/expect_passes.h>
#include <multipass/frame/driver.h>
#include <multipass/passes/pass_toml.h>
#include <scene/toml/read_scene.h>

#include <gtest/gtest.h>

using namespace gw::testing;

TEST(MyPasses, DrawTheBoxAsTheGoldenSays) {
    const gw::scene::SceneFile file = gw::scene::read_scene("my_passes.toml");
    const gw::multipass::PassList passes = gw::multipass::read_passes(file.passes);
    const gw::scene::View view = gw::scene::make_view(file.scene, 64, 48);
    const gw::CommandList list =
        gw::multipass::frame_list(file.scene, view, passes, file.scene.background);
    EXPECT_PASSES_EQ(recording_of(list, gw::vgx(), 64, 48), "goldens/my_passes.json");
}
