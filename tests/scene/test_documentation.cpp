// Claims: the example of docs/scenes.md is a scene, and the page names every shape with its parameters and
// defaults.
#include <gtest/gtest.h>

#include "folder.h"
#include "scene/number.h"
#include "scene/shape_table.h"
#include "scene/text_file.h"

namespace gw::scene {

namespace {

const std::string page = read_text(GW_SOURCE_DIR "/docs/scenes.md");

std::string example() {
    const std::size_t begin = page.find("```toml\n") + 8;
    return page.substr(begin, page.find("```", begin) - begin);
}

}  // namespace

TEST(ScenesPage, HasAnExampleThatWorks) {
    Folder folder;
    const SceneFile file = read_scene(folder.write("example.toml", example()));
    EXPECT_EQ(file.scene.objects.size(), 2u);
    EXPECT_EQ(file.scene.lights.size(), 1u);
    EXPECT_EQ(file.scene.materials.at(1).name, "red");
    EXPECT_TRUE(file.warnings.empty());
}

TEST(ScenesPage, NamesEveryShapeAndParameter) {
    for (const Shape& shape : shapes()) {
        const std::size_t name = page.find("`" + shape.name + "`", page.find("### Shapes"));
        ASSERT_NE(name, page.npos) << shape.name;
        const std::string row = page.substr(name, page.find('\n', name) - name);
        for (const ShapeParameter& p : shape.parameters) {
            const std::string value = p.integer && p.low == 0 && p.high == 1
                                          ? (p.value != 0 ? "true" : "false")
                                          : number_text(p.value);
            EXPECT_NE(row.find("`" + p.name + "` " + value), row.npos) << shape.name << " " << p.name;
        }
    }
}

}  // namespace gw::scene
