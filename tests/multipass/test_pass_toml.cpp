// Pass lists as TOML: what is written is read again, what is wrong says where and what was
// expected.
#include "multipass/passes/pass_toml.h"

#include "gw/error.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/catalogue.h"
#include "scene/toml/read_scene.h"
#include "tests/multipass/scenes.h"

#include <gtest/gtest.h>
#include "tests/temporary_folder.h"

namespace gw::multipass {
namespace {

class PassToml : public testing::Test {
protected:
    PassList read(const std::string& text) const {
        return read_passes(
            scene::read_scene(folder_.write("s.toml", "[[object]]\nshape = 'box'\n" + text))
                .passes);
    }
    /// The message without the folder.
    std::string fault(const std::string& text) const {
        try {
            read(text);
        } catch (const Error& error) {
            return std::string(error.what()).substr(folder_.path().string().size() + 1);
        }
        return "no error";
    }
    /// A list of one pass with these lines, the first of which is line 6.
    std::string fault_of_pass(const std::string& lines) const {
        return fault("[[pass]]\nname = 'p'\nclear = ['color', 'depth', 'stencil']\n" + lines +
                     "\n");
    }

private:
    TemporaryFolder folder_;
};

/// A scene for each list that passes_for makes.
std::vector<scene::Scene> all_kinds() {
    scene::Scene plain = two_squares(), fog = plain, panes = plain, all = plain;
    fog.fog = scene::Fog{};
    panes.materials[0].d = 0.5f;
    all.fog = scene::Fog{};
    all.materials[0].d = 0.5f;
    all.background = vec3(0.5f);
    all.reflection_in_shadow = false;
    all.lights[0].shadow = scene::Shadow::Volume;
    all.objects[1].glare = scene::Glare{};
    return {plain, fog, panes, all};
}

TEST_F(PassToml, OfEveryBuiltInListReadsTheSameList) {
    for (const scene::Scene& s : all_kinds())
        for (const Renderer renderer : {Renderer::Hardware, Renderer::Multipass})
            for (const Translucency t : {Translucency::Sorted, Translucency::Layers}) {
                const PassList list = passes_for(s, renderer, t);
                EXPECT_EQ(read(to_toml(list)), list) << to_toml(list);
            }
}

TEST_F(PassToml, OfEveryFieldReadsTheSamePass) {
    Pass pass = diffuse_pass;
    pass.name = "a \"quoted\" name\\";
    pass.clear = picture;
    pass.material.Ka = {0.1f, 1.0f / 3, 5e-30f};
    pass.material.Ke = object_Tf;
    pass.stencil = {.test = true,
                    .func = StencilFunc::GEqual,
                    .ref = 3,
                    .mask = 7,
                    .fail = StencilOp::Zero,
                    .zfail = StencilOp::Invert,
                    .zpass = StencilOp::DecrWrap,
                    .write_mask = 0x80,
                    .two_side = true,
                    .back = {.func = StencilFunc::Never, .ref = 2, .mask = 1}};
    pass.blend = {.enable = true,
                  .src = BlendFactor::SrcAlphaSaturate,
                  .dst = BlendFactor::OneMinusConstantAlpha,
                  .equation = BlendEquation::ReverseSubtract,
                  .color = {0.25f, 0.5f, 1.0f / 3, 1},
                  .alpha = {true, BlendFactor::DstAlpha, BlendFactor::One, BlendEquation::Max}};
    pass.color = false;
    pass.fog = PassFog::Black;
    pass.objects = PassObjects::Named;
    pass.names = {"box"};
    EXPECT_EQ(read(to_toml({pass})), PassList{pass}) << to_toml({pass});
}

TEST_F(PassToml, ReadsAsThePaperAndTheCatalogueWriteIt) {
    const std::string text = to_toml({diffuse_pass});
    EXPECT_EQ(
        text,
        "[[pass]]\nname = \"diffuse\"\nKa = 0\nKd = \"object\"\nKs = 0\nKe = 0\nMap = \"diffuse map\"\n"
        "depth = {func = \"Equal\", mask = false}\nstencil = {func = \"Equal\", ref = 0}\n"
        "blend = {src = \"One\", dst = \"One\"}\nlights = \"each\"\n");
}

TEST_F(PassToml, FaultsNameTheLineAndWhatWasExpected) {
    EXPECT_EQ(fault_of_pass("Kd = 'objct'"),
              "s.toml:6: pass.Kd is 'objct'; expected 'object', 'object Ks' or 'object Tf'");
    EXPECT_EQ(fault_of_pass("Ka = [1, 2]"),
              "s.toml:6: pass.Ka has 2 elements; expected an array of 3 numbers");
    EXPECT_EQ(
        fault_of_pass("Ka = true"),
        "s.toml:6: pass.Ka is true; expected 'object', 'object Ks', 'object Tf', a number or an array of "
        "3 numbers");
    EXPECT_EQ(fault_of_pass("\nkd = 1"),
              "s.toml:7: unknown key 'kd' in pass; the nearest known is 'Kd'");
    EXPECT_EQ(
        fault_of_pass("depth = {func = 'Les'}"),
        "s.toml:6: pass.depth.func is 'Les'; expected 'Never', 'Less', 'Equal', 'LEqual', 'Greater', "
        "'NotEqual', 'GEqual' or 'Always'; the nearest is 'Less'");
    EXPECT_EQ(fault_of_pass("stencil = {reff = 1}"),
              "s.toml:6: unknown key 'reff' in pass.stencil; the nearest known is 'ref'");
    EXPECT_EQ(fault_of_pass("stencil = {ref = 256}"),
              "s.toml:6: pass.stencil.ref is 256; expected a whole number from 0 to 255");
    EXPECT_NE(fault_of_pass("blend = {src = 'SrcColor'}").find("the nearest is 'DstColor'"),
              std::string::npos)
        << "a colour is a factor of the other side only";
    EXPECT_EQ(fault_of_pass("blend = {color = [0, 0, 0]}"),
              "s.toml:6: pass.blend.color has 3 elements; expected an array of 4 numbers");
    EXPECT_EQ(fault_of_pass("objects = ['bx']"),
              "s.toml:6: unknown object 'bx'; the nearest known is 'box'");
    EXPECT_EQ(fault("[[pass]]\nname = ''\n"), "s.toml:4: pass.name has 0 bytes; expected 1 to 31");
    EXPECT_EQ(fault("pass = 3\n").substr(0, 9), "s.toml:3:");
}

TEST_F(PassToml, ListsThatCannotDrawAreRefused) {
    EXPECT_EQ(fault("[[pass]]\nclear = ['color', 'depth', 'stencil']\n"),
              "s.toml:3: pass has no name; expected one");
    EXPECT_EQ(
        fault("[[pass]]\nname = 'p'\n"),
        "s.toml:3: the first pass does not clear all planes; expected clear = ['color', 'depth', "
        "'stencil']");
    EXPECT_EQ(
        fault_of_pass("Kd = 'object'"),
        "s.toml:3: pass 'p' reflects light (Ka, Kd, Ks) but has none; expected lights = 'each', 'first' or "
        "'all'");
    EXPECT_EQ(fault_of_pass("[[pass]]\nname = 's'\naction = 'shadow'"),
              "s.toml:6: a shadow pass has no light; expected lights = 'each' or 'first'");
    EXPECT_EQ(fault_of_pass("[[pass]]\nname = 's'\naction = 'add'\nKe = 1"),
              "s.toml:8: a pass of action 'add' draws nothing; expected name and lights only");
    const std::string layer =
        "[[pass]]\nname = 'l'\nobjects = 'translucent'\ndepth = {func = 'Equal', mask = false}\n";
    EXPECT_EQ(fault_of_pass(layer + layer), "no error");
    EXPECT_EQ(fault_of_pass(layer + "[[pass]]\nname = 'between'\n" + layer).substr(0, 38),
              "s.toml:15: pass 'l' draws translucent ");
}

TEST_F(PassToml, DrawsWhatItSays) {
    // One pass with a fixed colour over the named square, a mirror of full strength as the paper's
    // Ke = 1.
    scene::Scene s = two_squares();
    s.materials[1].refl = {plain_map(0, 200, 0)};
    const PassList list = read(
        "[[object]]\nshape = 'box'\nname = 'left'\n"
        "[[pass]]\nname = 'depth'\nclear = ['color', 'depth', 'stencil']\ndepth = {}\ncolor = false\n"
        "[[pass]]\nname = 'red'\nKe = [1, 0, 0]\nobjects = ['left']\n"
        "depth = {func = 'Equal', mask = false}\nblend = {src = 'One', dst = 'One'}\n"
        "[[pass]]\nname = 'mirror'\nKe = 1\nMap = 'reflection map'\n"
        "depth = {func = 'Equal', mask = false}\nblend = {src = 'One', dst = 'One'}\n");
    constexpr int size = 16;
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size), {.pass_list = list});
    const auto& color = machine->planes().color;
    EXPECT_EQ(color[size / 2 * size + 2], (Rgba{255, 0, 0, 255}));
    EXPECT_EQ(color[size / 2 * size + 13], (Rgba{0, 200, 0, 255}));
}

TEST(OwnStencil, IsNotClearedByTheCountOfWinners) {
    // The left square leaves 1 in the stencil while Z is found; light is added there only.
    const scene::Scene s = two_squares();
    Pass mark = depth_pass, add_there = emission_pass;
    mark.objects = PassObjects::Named;
    mark.names = {"left"};
    mark.stencil = {
        .test = true, .func = StencilFunc::Always, .ref = 1, .zpass = StencilOp::Replace};
    Pass rest = depth_pass;
    rest.clear = 0;
    add_there.material.Ke = 1;
    add_there.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 1};
    constexpr int size = 16;
    const auto machine = make_reference(vgx(), size, size);
    render(*machine, s, scene::make_view(s, size, size),
           {.pass_list = PassList{mark, rest, add_there}});
    EXPECT_EQ(machine->planes().color[size / 2 * size + 2], (Rgba{255, 255, 255, 255}));
    EXPECT_EQ(machine->planes().color[size / 2 * size + 13], (Rgba{0, 0, 0, 255}));
}

}  // namespace
}  // namespace gw::multipass
