// Claim: gw view warns of a scene as gw render does.
#include "apps/view/viewed_scene.h"
#include "test_paths.h"
#include "tests/apps/scene_files.h"

#include <fmt/format.h>

#include <array>

namespace gw::apps {
namespace {

/// An outline of 50 corners on each of four lines.
std::string plate() {
    constexpr std::array<dvec2, 5> at{{{0, 0}, {4, 0.3}, {4.5, 3}, {1, 4}, {0, 0}}};
    std::string vertices, face = "f";
    for (int k = 0; k < 200; ++k) {
        const std::size_t line = std::size_t(k / 50);
        const dvec2 p = at[line] + (at[line + 1] - at[line]) * (k % 50 / 50.0);
        vertices += fmt::format("v {} {} 0\n", p.x, p.y);
        face += fmt::format(" {}", k + 1);
    }
    return vertices + face + "\n";
}

}  // namespace

class ViewedSceneTest : public SceneTest {};

TEST_F(ViewedSceneTest, HasTheWarningsOfTheCommand) {
    write("plate.obj", plate());
    PictureOptions options;
    options.scene = in("plate.obj");
    options.size = {320, 240};
    Session session;
    testing::internal::CaptureStderr();
    static_cast<void>(load_viewed_scene(options, in("."), session));
    const std::string said = testing::internal::GetCapturedStderr();
    const Outcome drawn = gw({"render", "plate.obj", "-o", "drawn.png", "--size", "320x240"});
    for (const std::string& warnings : {said, drawn.err})
        EXPECT_NE(warnings.find("200 corners"), std::string::npos) << warnings;
}

}  // namespace gw::apps
