// Hundreds of tiny draws: whatever the machine shares between them, and however a list is cut, the
// bits are those of the reference machine.
#include "tests/gw/random.h"
#include "tests/gw/workbench.h"

#include <memory>

namespace gw {
namespace {

using test::Random;

constexpr int side = 128;

/// Meshes, textures, lights and states that draws choose from.
class ManyDraws {
public:
    explicit ManyDraws(std::uint64_t seed)
        : random_(seed), projection_(test::window_projection(vgx(), side, side)) {
        for (int i = 0; i < 12; ++i) meshes_.push_back(mesh());
        for (int i = 0; i < 6; ++i) textures_.push_back(texture());
        for (int i = 0; i < 3; ++i) lights_.push_back(lights());
        for (int i = 0; i < 6; ++i) states_.push_back(state());
        for (int i = 0; i < 40; ++i) parts_.push_back(draw());
    }

    /// Passes over the same parts, whole or in pieces, with anything between them.
    CommandList list(int passes) {
        CommandList out;
        out.add(BeginPass{"many draws"});
        out.add(SetState{states_[0]});
        out.add(Clear{.planes = all_planes, .color = vec4(0.1f, 0.2f, 0.3f, 1)});
        for (int i = 0; i < passes; ++i) add_pass(out);
        return out;
    }
    bool one_in(int n) { return random_.one_in(n); }

private:
    float number(int low, int high) { return float(random_.between(8 * low, 8 * high)) / 8; }

    MeshRef mesh() {
        MeshData data{.primitive = Primitive::Triangles};
        if (random_.one_in(6)) data.primitive = Primitive::Lines;
        const bool large = random_.one_in(8), flat = random_.one_in(2);
        const vec4 color{random_.fraction(), random_.fraction(), random_.fraction(), 1};
        for (std::int64_t i = 0, n = 6 * random_.between(1, large ? 120 : 6); i < n; ++i) {
            data.positions.push_back(
                {number(0, 24), number(0, 24), float(random_.between(0, 1 << 22))});
            data.colors.push_back(flat ? color
                                       : vec4(random_.fraction(), random_.fraction(), 0.5f, 1));
            data.normals.push_back({number(-2, 2), number(-2, 2), 1});
            data.texcoords.push_back({number(-1, 2), number(-1, 2)});
        }
        return make_mesh(std::move(data));
    }
    TextureRef texture() {
        std::vector<std::uint8_t> rgba(4 * 8 * 8);
        for (std::uint8_t& v : rgba) v = std::uint8_t(random_.next());
        return make_texture8("noise", 8, 8, rgba);
    }
    LightsRef lights() {
        Light light{.position =
                        vec4(number(-3, 3), number(-3, 3), 4, float(random_.between(0, 1)))};
        light.Ia = vec3(0.25f);
        if (random_.one_in(3)) light.Id = light.Is = vec3(0);
        return std::make_shared<const std::vector<Light>>(std::vector<Light>{light});
    }
    State state() {
        State s;
        s.projection = projection_;
        s.depth = {true, random_.one_in(2) ? DepthFunc::Less : DepthFunc::LEqual, true};
        s.color_source = random_.one_in(3)   ? ColorSource::Vertex
                         : random_.one_in(3) ? ColorSource::PolygonId
                                             : ColorSource::Lighting;
        if (random_.one_in(3)) s.color_mask = {false, false, false, false};
        if (random_.one_in(3)) s.depth = {true, DepthFunc::Equal, false};
        if (random_.one_in(3)) s.blend = {true, BlendFactor::One, BlendFactor::One};
        if (random_.one_in(4)) s.stencil = {.test = true, .zpass = StencilOp::Incr};
        if (random_.one_in(4)) s.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 1};
        if (random_.one_in(4)) s.shade_model = ShadeModel::Flat;
        if (random_.one_in(4)) s.lighting.two_side = true;
        if (random_.one_in(4)) s.cull.enable = true;
        if (random_.one_in(4)) s.jitter = {3, -2};
        if (random_.one_in(4)) s.scissor = {true, {9, 17, 83, 70}};
        if (random_.one_in(4)) s.alpha = {true, AlphaFunc::Greater, 0.25f};
        if (random_.one_in(5)) s.texture.gen = TexGen::SphereMap;
        if (random_.one_in(6)) s.polygon_mode = PolygonMode::Line;
        if (random_.one_in(5)) s.clip_planes[2] = {true, {1, 0.25, 0, -50}};
        if (random_.one_in(4))
            s.fog = {.enable = true, .mode = FogMode::Linear, .start = 0, .end = -1e6f};
        return s;
    }
    Draw draw() {
        Draw d{.mesh = meshes_[random_.next() % meshes_.size()]};
        d.eye_from_object[3] = {double(number(-8, side)), double(number(-8, side)), 0, 1};
        vary(d);
        return d;
    }
    void vary(Draw& d) {
        d.material.Kd = vec3(random_.fraction());
        d.material.Ks = vec3(float(random_.between(0, 1)));
        d.lights = random_.one_in(4) ? nullptr : lights_[random_.next() % lights_.size()];
        d.map.texture = random_.one_in(2) ? nullptr : textures_[random_.next() % textures_.size()];
        d.id_base = std::uint32_t(random_.next() % 1000);
    }
    void add_pass(CommandList& out) {
        const int interruptions = int(random_.between(0, 3)) * int(random_.between(0, 12));
        const bool varies = random_.one_in(2), textured = random_.one_in(2);
        out.add(SetState{states_[random_.next() % states_.size()]});
        for (std::size_t i = random_.next() % 5; i < parts_.size(); ++i) {
            Draw d = parts_[i];
            if (varies) vary(d);
            if (!textured) d.map = {};
            if (random_.one_in(300)) d.mesh = mesh();
            out.add(d);
            if (interruptions != 0 && random_.one_in(40 / interruptions + 1)) interrupt(out);
        }
    }
    void interrupt(CommandList& out) {
        switch (random_.between(0, 6)) {
            case 0: out.add(BeginPass{"another"}); break;
            case 1: out.add(SetState{states_[random_.next() % states_.size()]}); break;
            case 2: out.add(SetState{state()}); break;
            case 3: out.add(Clear{.planes = mask_of(Plane::Depth)}); break;
            case 4:
                out.add(Read{std::uint32_t(random_.between(0, 1)), Plane::Color, {5, 6, 70, 80}});
                break;
            case 5: textures_[random_.next() % textures_.size()] = texture(); break;
            case 6: parts_[random_.next() % parts_.size()] = draw(); break;
        }
    }

    Random random_;
    dmat4 projection_;
    std::vector<MeshRef> meshes_;
    std::vector<TextureRef> textures_;
    std::vector<LightsRef> lights_;
    std::vector<State> states_;
    std::vector<Draw> parts_;
};

TEST(ManyDraws, HaveTheBitsOfTheReference) {
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        test::Workbench bench(vgx(), side, side);
        ManyDraws many(seed);
        for (int i = 0; i < 3; ++i) {
            bench.run(many.list(5));
            bench.planes();
        }
    }
}

TEST(ManyDraws, DrawTheSameWhereverTheListIsCut) {
    for (std::uint64_t seed = 100; seed < 112; ++seed) {
        SCOPED_TRACE(seed);
        ManyDraws many(seed);
        const CommandList list = many.list(6);
        const auto whole = make_fast(vgx(), side, side, {.threads = 2}),
                   pieces = make_fast(vgx(), side, side, {.threads = 1, .log2_tile = 4});
        whole->execute(list);
        CommandList piece;
        for (const Command& command : list.commands) {
            piece.add(command);
            if (!many.one_in(9)) continue;
            pieces->execute(piece);
            piece.commands.clear();
        }
        pieces->execute(piece);
        EXPECT_TRUE(whole->planes() == pieces->planes());
        EXPECT_TRUE(whole->passes() == pieces->passes());
        EXPECT_TRUE(whole->readbacks() == pieces->readbacks());
    }
}

TEST(ManyDraws, KeepNoMeshAndNoTextureAlive) {
    const auto machine = make_fast(vgx(), side, side, {.threads = 1});
    std::weak_ptr<const Mesh> mesh;
    std::weak_ptr<const Texture> texture;
    {
        ManyDraws many(5);
        const CommandList list = many.list(3);
        for (const Command& command : list.commands)
            if (const Draw* draw = std::get_if<Draw>(&command)) {
                mesh = draw->mesh;
                if (draw->map.texture) texture = draw->map.texture;
            }
        machine->execute(list);
    }
    EXPECT_TRUE(mesh.expired());
    EXPECT_TRUE(texture.expired());
}

}  // namespace
}  // namespace gw
