// The catalogue against the paper's tuples [K3p], and the passes as text.
#include "multipass/passes/catalogue.h"

#include "gw/describe/enumerators.h"
#include "multipass/passes/passes.h"
#include "multipass/passes/tokens.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace gw::multipass {
namespace {

TEST(Catalogue, ReadsAsThePaperWritesIt) {
    EXPECT_EQ(to_string(ambient_pass.material), "(Ka=object, Kd=0, Ks=0, Ke=0, Map=ambient map)");
    EXPECT_EQ(to_string(diffuse_pass.material), "(Ka=0, Kd=object, Ks=0, Ke=0, Map=diffuse map)");
    EXPECT_EQ(to_string(specular_pass.material), "(Ka=0, Kd=0, Ks=object, Ke=0, Map=specular map)");
    EXPECT_EQ(to_string(reflection_pass.material),
              "(Ka=0, Kd=0, Ks=0, Ke=object Ks, Map=reflection map)");
    EXPECT_EQ(to_string(PassMaterial{.Ke = 1, .Map = reflection_map}),
              "(Ka=0, Kd=0, Ks=0, Ke=1, Map=reflection map)");
    EXPECT_EQ(to_string(PassMaterial{.Ke = {0.5f, 0.25f, 0}}),
              "(Ka=0, Kd=0, Ks=0, Ke=(0.5, 0.25, 0), Map=none)");
}

TEST(Catalogue, ShadowSuppressesDiffuseAndSpecularOnly) {
    for (const Pass& pass : {ambient_pass, reflection_pass, refraction_pass, emission_pass})
        EXPECT_FALSE(pass.stencil.test) << pass.name.view();
    for (const Pass& pass : {diffuse_pass, specular_pass})
        EXPECT_EQ(pass.stencil, outside_shadow) << pass.name.view();
}

TEST(Catalogue, PrintsTestsBlendingAndLights) {
    EXPECT_EQ(
        to_string(diffuse_pass),
        "diffuse     (Ka=0, Kd=object, Ks=0, Ke=0, Map=diffuse map); lights each; depth Equal, no update; "
        "stencil Equal 0; blend One One");
    EXPECT_EQ(
        to_string(depth_pass),
        "depth       (Ka=0, Kd=0, Ks=0, Ke=0, Map=none); depth Less, update; clear color, depth, stencil; no "
        "colour");
}

TEST(Catalogue, PrintsConstantFactorsEquationAndColor) {
    Pass pass = depth_pass;
    pass.blend = {.enable = true, .src = BlendFactor::ConstantColor};
    EXPECT_NE(to_string(pass).find("; blend ConstantColor Zero; "), std::string::npos)
        << to_string(pass);
    pass.blend.equation = BlendEquation::Max;
    pass.blend.color = {0.5f, 0, 0, 1};
    EXPECT_NE(to_string(pass).find("; blend ConstantColor Zero, Max, color (0.5, 0, 0, 1); "),
              std::string::npos)
        << to_string(pass);
}

TEST(Words, AreAllThereAndDifferent) {
    const auto check = []<typename Table>(Table table) {
        using Enum = std::remove_const_t<decltype(table[0].first)>;
        EXPECT_EQ(table.size(), count_of<Enum>) << type_name<Enum>;
        for (const auto& word : table) EXPECT_FALSE(word.second.empty());
        for (const auto& a : table)
            for (const auto& b : table) EXPECT_EQ(a.first == b.first, a.second == b.second);
    };
    check(tokens(CompareFunc{}));
    check(tokens(StencilOp{}));
    check(tokens(BlendFactor{}));
    check(tokens(BlendEquation{}));
    check(tokens(PassMap{}));
    check(tokens(PassLights{}));
    check(tokens(PassObjects{}));
    check(tokens(PassFog{}));
    check(tokens(PassAction{}));
}

}  // namespace
}  // namespace gw::multipass
