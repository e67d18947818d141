// Small scenes as files, for tests of the command.
#pragma once

#include "tests/apps/support/command_test.h"

namespace gw::apps {

/// A folder with quad.obj (a square) and lamps.toml: the square with ambient, diffuse and specular
/// colour under two lamps, an orthographic camera in front; with --size 16x16 the square covers
/// pixels 4 .. 11 each way.
class SceneTest : public CommandTest {
protected:
    SceneTest() {
        write("quad.obj",
              "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n");
        write("lamps.toml", R"([camera]
eye = [0, 0, 5]
ortho = 4
[[light]]
name = "lamp 1"
direction = [0, 0, -1]
Ia = 0.2
Id = 0.5
[[light]]
name = "lamp 2"
direction = [0, 0, -1]
Id = [0.5, 0.25, 0]
[[object]]
file = "quad.obj"
material = {Ka = 1, Kd = 0.5, Ks = 0.25, Ns = 1}
)");
    }
    /// gw render with `arguments` at 16x16.
    Outcome render(std::vector<std::string> arguments, Surroundings surroundings = {}) const {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), {"--size", "16x16"});
        return gw(std::move(arguments), std::move(surroundings));
    }
};

}  // namespace gw::apps
