// Claims: the examples of docs/scenes.md and docs/passes.md are scenes, and the page names every
// shape with its parameters and defaults.
#include <gtest/gtest.h>

#include "scene/text/number.h"
#include "scene/text/text_file.h"
#include "scene/toml/shape_table.h"
#include "test_paths.h"
#include "tests/scene/folder.h"

namespace gw::scene {
namespace {

const std::string page = read_text(GW_SOURCE_DIR "/docs/scenes.md");

/// The first block of TOML after `heading`.
std::string example(const std::string& text, const std::string& heading) {
    const std::size_t begin = text.find("```toml\n", text.find(heading)) + 8;
    return text.substr(begin, text.find("```", begin) - begin);
}

}  // namespace

TEST(ScenesPage, HasAnExampleThatWorks) {
    Folder folder;
    const SceneFile file = read_scene(folder.write("example.toml", example(page, "## An example")));
    EXPECT_EQ(file.scene.objects.size(), 2u);
    EXPECT_EQ(file.scene.lights.size(), 1u);
    EXPECT_EQ(file.scene.materials.at(1).name, "red");
    EXPECT_TRUE(file.warnings.empty());
}

TEST(ScenesPage, HasAnExampleOfEffectsThatWorks) {
    Folder folder;
    const SceneFile file = read_scene(folder.write("effects.toml", example(page, "### Effects")));
    const Scene& s = file.scene;
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_TRUE(s.fog && s.camera->aperture > 0);
    EXPECT_EQ(s.lights.at(0).area.shape, AreaLight::Shape::Disc);
    EXPECT_EQ(s.lights.at(1).only.size(), 2u);
    EXPECT_TRUE(s.objects.at(4).glare && s.objects.at(3).move != dvec3(0));
}

TEST(PassesPage, HasAListThatIsRead) {
    Folder folder;
    const std::string passes = read_text(GW_SOURCE_DIR "/docs/passes.md");
    const auto file = folder.write("own.toml", example(passes, "## A list of one's own"));
    EXPECT_EQ(read_scene(file).passes.size(), 3u);
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
            EXPECT_NE(row.find("`" + p.name + "` " + value), row.npos)
                << shape.name << " " << p.name;
        }
    }
}

}  // namespace gw::scene
