// Draws of one geometry set under many states: texture coordinates, fog and colours at their vertices
// are those of their own state. The reference machine shares nothing. Does not measure the savings.
#include "tests/gw/workbench.h"

#include <functional>

namespace gw::test {
namespace {

/// A triangle in a place of its own, one that ends outside the window now and then.
MeshRef triangle(int i) {
    const auto x = float(i % 8 * 9 - 4), y = float(i / 8 % 8 * 9 - 4);
    MeshData data = mesh_data(Primitive::Triangles, {{x, y, 9}, {x + 8, y, 9}, {x, y + 8, 30}});
    data.normals.assign(3, vec3(0.6f, 0, 0.8f));
    data.texcoords = {{0, 0}, {3, 0}, {0, 2}};
    return make_mesh(std::move(data));
}

struct Values {
    const char* name;
    std::function<void(State&, int)> set;
};

/// Values that each change what the vertices have.
const std::vector<Values> all_values{
    {"texture.matrix", [](State& s, int i) { s.texture.matrix[3].x = i / 16.0; }},
    {"texture.coordinates",
     [](State& s, int i) {
         s.texture.gen = TexGen::PerCoordinate;
         s.texture.coordinates[0] = {CoordinateMode::ObjectLinear, {0.125, 0, 0, i / 16.0}};
     }},
    {"fog.density",
     [](State& s, int i) {
         s.fog = {.enable = true, .mode = FogMode::Exp, .density = (i + 1) / 40.0f};
     }},
    {"lighting.model_ambient",
     [](State& s, int i) {
         s.color_source = ColorSource::Lighting;
         s.lighting.model_ambient = vec4(float(i) / 64);
     }},
    {"lighting.two_side",
     [](State& s, int i) {
         s.color_source = ColorSource::Lighting;
         s.lighting.two_side = i % 3 == 0;
     }},
};

Draw draw_of(const MeshRef& mesh) {
    static const TextureRef texture = make_texture8(
        "four", 2, 2,
        std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 99, 199, 255});
    static const auto lights = std::make_shared<const std::vector<Light>>(
        1, Light{.position = {9, 9, 40, 1}, .Ia = vec3(0.5f)});
    Draw draw{.mesh = mesh, .material = {.Ka = vec3(0.9f, 0.5f, 0.1f)}, .lights = lights};
    draw.map.texture = texture;
    return draw;
}

/// Draws 64 triangles in `passes` rounds, or each triangle's rounds one after the other.
void check(const Values& values, const Profile& profile, int passes, bool each_at_once) {
    std::vector<MeshRef> meshes;
    for (int i = 0; i < 64; ++i) meshes.push_back(triangle(i));
    Workbench bench(profile);
    bench.clear();
    bench.state.blend = {.enable = true, .src = BlendFactor::One, .dst = BlendFactor::One};
    CommandList list;
    for (int i = 0; i < 64 * passes; ++i) {
        const int pass = each_at_once ? i % passes : i / 64,
                  mesh = each_at_once ? i / passes : i % 64;
        State state = bench.state;
        values.set(state, mesh % 20 + 3 * pass);
        list.add(SetState{state});
        list.add(draw_of(meshes[std::size_t(mesh)]));
    }
    SCOPED_TRACE(values.name);
    bench.run(list);
    bench.compare();
}

TEST(ValuesOfStates, AreThoseOfEachDraw) {
    for (const Profile& profile : {vgx(), opengl()})
        for (const Values& values : all_values) check(values, profile, 1, false);
}

TEST(ValuesOfStates, AreThoseOfEachRound) {
    for (const Profile& profile : {vgx(), opengl()})
        for (const Values& values : all_values)
            for (const bool each_at_once : {false, true}) check(values, profile, 11, each_at_once);
}

}  // namespace
}  // namespace gw::test
