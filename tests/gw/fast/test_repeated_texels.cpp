// Texels that the fast machine keeps while the same triangles are drawn again. Whatever changes
// from draw to draw, they are the texels that the reference machine looks up.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <functional>

namespace gw::test {
namespace {

constexpr int width = 128, height = 64;

TextureRef noise(std::uint64_t seed, int side) {
    Random random(seed);
    std::vector<std::uint8_t> texels(std::size_t(4 * side * side));
    for (std::uint8_t& t : texels) t = std::uint8_t(random.between(0, 255));
    return make_texture8("noise", side, side, texels);
}

/// A quad over most of the window with `size` repeats of its texture, and with `color` at one end.
Draw wall(TextureRef texture, float size, vec4 color = vec4(1)) {
    MeshData data =
        mesh_data(Primitive::Quads, {{-9, -3, 50}, {140, 2, 50}, {125, 60, 90}, {3, 66, 90}},
                  {vec4(0.2f, 0.9f, 0.4f, 0.5f), color, vec4(0.8f, 0.3f, 0.7f, 0.4f), vec4(0.1f)});
    data.texcoords = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    Draw draw{.mesh = make_mesh(std::move(data))};
    draw.map.texture = std::move(texture);
    return draw;
}

/// The state of a draw.
State blended(const Workbench& bench) {
    State s = bench.state;
    s.color_source = ColorSource::Vertex;
    s.blend = {true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
    return s;
}

/// The same draw three times: its texels are looked up, kept, used again.
void add_thrice(CommandList& list, const State& state, const Draw& draw) {
    list.add(SetState{state});
    for (int i = 0; i < 3; ++i) list.add(draw);
}

TEST(RepeatedTexels, AreThoseOfTheDrawWhateverElseChanges) {
    Workbench bench(vgx(), width, height);
    const TextureRef first = noise(1, 16), second = noise(2, 16), large = noise(3, 64);
    const State state = blended(bench);
    CommandList list;
    list.add(SetState{state});
    list.add(Clear{.planes = all_planes});
    add_thrice(list, state, wall(first, 3));
    add_thrice(list, state, wall(second, 3));
    add_thrice(list, state, wall(large, 3));
    add_thrice(list, state, wall(first, 2.5f));
    const std::vector<std::function<void(State&)>> changes{
        [](State& s) { s.texture.wrap_s = Wrap::Clamp; },
        [](State& s) { s.texture.wrap_t = Wrap::Clamp; },
        [](State& s) { s.shade_model = ShadeModel::Flat; },
        [](State& s) { s.texture.env = TexEnv::Decal; },
        [](State& s) { s.texture.mag_filter = MagFilter::Nearest; },
        [](State& s) {
            s.texture.min_filter = MinFilter::Nearest;
            s.texture.mag_filter = MagFilter::Nearest;
        },
        [](State& s) {
            s.jitter = {3, 5};
        },
        [](State& s) {
            s.color_mask = {true, false, true, true};
        },
        [](State& s) { s.blend = {}; },
        [](State& s) {
            s.scissor = {true, {9, 9, 50, 7}};
        },
        [](State&) {},
    };
    for (const auto& change : changes) {
        State changed = state;
        change(changed);
        add_thrice(list, changed, wall(first, 3, vec4(1, 0.5f, 0, 0.3f)));
        bench.run(list);
        bench.compare();
        list.commands.clear();
    }
}

TEST(RepeatedTexels, OfMoreWallsThanAreKept) {
    Workbench bench(vgx(), width, height);
    const State state = blended(bench);
    CommandList list;
    list.add(SetState{state});
    std::vector<Draw> walls;
    for (int i = 0; i < 5; ++i) walls.push_back(wall(noise(std::uint64_t(i), 8), float(i + 1)));
    for (int round = 0; round < 4; ++round)
        for (const Draw& draw : walls) {
            list.add(draw);
            if (round % 2 == 1) list.add(draw);
        }
    bench.run(list);
}

TEST(RepeatedTexels, AreNotThoseOfASlotsLastPicture) {
    Workbench bench(vgx(), width, height);
    const State state = blended(bench);
    Draw draw = wall(nullptr, 2);
    draw.map = {.texture = nullptr, .slot = 7};
    CommandList list;
    list.add(SetState{state});
    list.add(Clear{.planes = all_planes, .color = vec4(0.9f, 0.5f, 0.1f, 1)});
    add_thrice(list, state, wall(noise(5, 32), 1));
    for (int i = 0; i < 3; ++i) {
        list.commands.emplace_back(CopyTexture{.slot = 7, .rect = {16 * i, 8, 32, 32}});
        add_thrice(list, state, draw);
    }
    bench.run(list);
}

}  // namespace
}  // namespace gw::test
