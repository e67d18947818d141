// Three scenes: components added over a Z prepass, everything in one pass, jittered samples
// accumulated.
#include "tests/exactness/pictures.h"

#include "scene/draw/view.h"
#include "scene/shapes/shapes.h"

namespace gw::exactness {
namespace {

constexpr int width = 200, height = 150;

constexpr PlaneMask color = mask_of(Plane::Color), depth = mask_of(Plane::Depth),
                    stencil = mask_of(Plane::Stencil), accum = mask_of(Plane::Accum);
constexpr BlendState add_to{true, BlendFactor::One, BlendFactor::One};
constexpr DepthState seen{true, DepthFunc::Equal, false};

/// The state that all passes share.
struct Model {
    scene::View view;
    std::vector<MeshRef> meshes;
    std::vector<dmat4> eye_from_object;
    std::vector<Material> materials;
    TextureRef checker, sky;
    LightsRef lights;
};

dmat4 moved(const dmat4& eye_from_world, double x, double y, double z) {
    dmat4 m = eye_from_world;
    m[3] = eye_from_world * dvec4(x, y, z, 1);
    return m;
}

/// 32 x 32 squares of two colours, 5 texels a side, and a ramp in alpha.
TextureRef checker() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) {
            const bool odd = ((x / 5 + y / 5) & 1) != 0;
            for (const int v : {odd ? 250 : 60, odd ? 120 : 200, (x * 7 + y * 3) & 255, x})
                rgba.push_back(static_cast<std::uint8_t>(v));
        }
    return make_texture8("checker", 160, 160, rgba);
}

/// Rings: a sphere map.
TextureRef sky() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const int d = ((x - 32) * (x - 32) + (y - 32) * (y - 32)) / 4;
            for (const int v : {d & 255, (d / 3) & 255, 255 - (d & 127), 255})
                rgba.push_back(static_cast<std::uint8_t>(v));
        }
    return make_texture8("sky", 64, 64, rgba);
}

LightsRef lights(const dmat4& eye_from_world) {
    Light key{.position = vec4(eye_from_world * dvec4(5, 8, 6, 1)), .Ia = vec3(0.1f)};
    key.linear_attenuation = 0.02f;
    Light spot{.position = vec4(eye_from_world * dvec4(-4, 6, 3, 1)), .Id = vec3(0.2f, 0.6f, 1)};
    spot.spot_direction = vec3(eye_from_world * dvec4(4, -5, -3, 0));
    spot.spot_cos_cutoff = 0.8f;
    spot.spot_exponent = 7.5f;
    Light sun{.position = vec4(eye_from_world * dvec4(-1, 1, 0.25, 0)), .Id = vec3(0.3f)};
    return std::make_shared<const std::vector<Light>>(std::vector<Light>{key, spot, sun});
}

void add(Model& m, MeshData mesh, const dvec3& at, const Material& material) {
    m.meshes.push_back(make_mesh(std::move(mesh)));
    m.eye_from_object.push_back(moved(m.view.eye_from_world, at.x, at.y, at.z));
    m.materials.push_back(material);
}

Model model() {
    Model m;
    const scene::Camera camera{
        .eye = {3, 4.5, 9}, .at = {0, 1.2, 0}, .fov = 42, .near_plane = 2, .far_plane = 40};
    m.view = scene::make_view(camera, {}, width, height);
    add(m, scene::make_teapot(5), {0, 0, 0},
        {.Ka = vec3(0.2f), .Kd = {0.7f, 0.5f, 0.3f}, .Ks = vec3(0.5f), .Ns = 22});
    add(m, scene::make_torus_knot(2, 3, 1, 0.25, 60, 9), {-3, 1.5, 1},
        {.Ka = vec3(0.1f),
         .Kd = {0.2f, 0.5f, 0.8f},
         .Ks = vec3(0.8f),
         .Ke = {0.05f, 0, 0},
         .Ns = 61.3f,
         .alpha = 0.75f});
    add(m, scene::make_icosphere(0.9, 3), {2.9, 0.9, 2.2},
        {.Kd = vec3(0.6f), .Ks = vec3(0.4f), .Ns = 5});
    add(m, scene::make_rectangle(30, 30, 12, 12), {0, 0, 0}, {.Kd = vec3(0.9f)});
    m.checker = checker();
    m.sky = sky();
    m.lights = lights(m.view.eye_from_world);
    return m;
}

State base_state(const Model& m) {
    State s;
    s.projection = m.view.clip_from_eye;
    s.color_source = ColorSource::Lighting;
    s.texture = {.min_filter = MinFilter::LinearMipmapLinear};
    return s;
}

enum class Maps { None, Checker, Sky };

/// A pass over the whole model; `keep` selects the terms of the material.
void add_pass(CommandList& list, const Model& m, const char* name, PlaneMask digests,
              const State& state, Maps maps, Material (*keep)(Material)) {
    list.add(BeginPass{name, digests});
    list.add(SetState{state});
    for (std::size_t i = 0; i < m.meshes.size(); ++i) {
        Draw draw{.mesh = m.meshes[i],
                  .eye_from_object = m.eye_from_object[i],
                  .material = keep(m.materials[i])};
        draw.lights = m.lights;
        if (maps == Maps::Checker) draw.map.texture = m.checker;
        if (maps == Maps::Sky) draw.map.texture = m.sky;
        draw.id_base = static_cast<std::uint32_t>(1000 * i);
        list.add(std::move(draw));
    }
}

Material whole(Material k) { return k; }
Material nothing(Material k) { return k.Ka = k.Kd = k.Ks = k.Ke = vec3(0), k; }
Material ambient(Material k) { return k.Kd = k.Ks = k.Ke = vec3(0), k; }
Material diffuse(Material k) { return k.Ka = k.Ks = k.Ke = vec3(0), k; }
Material specular(Material k) { return k.Ka = k.Kd = k.Ke = vec3(0), k; }
Material reflection(Material k) { return k.Ke = k.Ks, k.Ka = k.Kd = k.Ks = vec3(0), k; }

void add_clear(CommandList& list) {
    list.add(BeginPass{"clear", all_planes});
    list.add(Clear{.planes = all_planes, .color = {0.1f, 0.15f, 0.2f, 0}, .depth = 1});
}

/// A shadow volume counted in the stencil as in GL 1.1: Incr for front faces, Decr for back faces.
void add_shadow(CommandList& list, const Model& m, State state) {
    state.color_mask = {false, false, false, false};
    state.depth = {true, DepthFunc::Less, false};
    list.add(BeginPass{"shadow", stencil});
    for (const StencilOp op : {StencilOp::Incr, StencilOp::Decr}) {
        state.cull = {true, op == StencilOp::Incr ? Face::Back : Face::Front};
        state.stencil = {.test = true, .zpass = op};
        list.add(SetState{state});
        list.add(Draw{.mesh = make_mesh(scene::make_box({2.5, 3, 7}, 1)),
                      .eye_from_object = moved(m.view.eye_from_world, -1, 0.5, 1)});
    }
}

CommandList components(const Model& m) {
    CommandList list;
    add_clear(list);
    State s = base_state(m);
    s.depth.test = true;
    s.color_mask = {false, false, false, false};
    add_pass(list, m, "depth", depth, s, Maps::None, nothing);
    add_shadow(list, m, s);
    s.depth = seen;
    s.color_mask = {};
    s.blend = add_to;
    add_pass(list, m, "ambient", color, s, Maps::Checker, ambient);
    s.stencil = {.test = true, .func = StencilFunc::Equal, .ref = 0};
    add_pass(list, m, "diffuse", color, s, Maps::Checker, diffuse);
    s.lighting.local_viewer = true;
    add_pass(list, m, "specular", color, s, Maps::None, specular);
    s.stencil = {};
    s.texture.gen = TexGen::SphereMap;
    add_pass(list, m, "reflection", color, s, Maps::Sky, reflection);
    s.texture.gen = TexGen::RefractionMap;
    s.texture.eta = 0.75;
    s.fog = {
        .enable = true, .mode = FogMode::Exp2, .density = 0.08f, .color = {0.3f, 0.3f, 0.35f, 1}};
    add_pass(list, m, "refraction in fog", color, s, Maps::Sky, reflection);
    list.add(BeginPass{"copy", color | depth});
    list.add(Copy{Plane::Color, {10, 10, 60, 50}, 37, 31});
    list.add(CopyTexture{0, Plane::Color, {64, 8, 64, 128}});
    s = {};
    s.alpha = {true, AlphaFunc::Greater, 0.1f};
    list.add(SetState{s});
    list.add(Draw{
        .mesh = make_mesh(
            {.primitive = Primitive::Quads,
             .positions = {{-0.9f, 0.2f, 0}, {-0.1f, 0.3f, 0}, {-0.2f, 0.9f, 0}, {-0.8f, 0.8f, 0}},
             .texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}),
        .map = {nullptr, 0}});
    return list;
}

CommandList hardware(const Model& m) {
    CommandList list;
    add_clear(list);
    State s = base_state(m);
    s.depth.test = true;
    s.fog = {.enable = true,
             .mode = FogMode::Linear,
             .start = 4,
             .end = 30,
             .color = {0.5f, 0.5f, 0.6f, 1}};
    add_pass(list, m, "hardware", color | depth, s, Maps::Checker, whole);
    s.polygon_mode = PolygonMode::Line;
    s.fog = {};
    s.blend = {true, BlendFactor::SrcAlpha, BlendFactor::OneMinusSrcAlpha};
    s.shade_model = ShadeModel::Flat;
    add_pass(list, m, "wireframe", color | depth, s, Maps::None, whole);
    s.polygon_mode = PolygonMode::Point;
    s.point_size = 3;
    add_pass(list, m, "points", color | depth, s, Maps::None, whole);
    s = base_state(m);
    s.color_source = ColorSource::PolygonId;
    s.depth = {true, DepthFunc::LEqual, true};
    add_pass(list, m, "identifiers", color | depth, s, Maps::None, whole);
    return list;
}

CommandList samples(const Model& m, const Profile& profile) {
    CommandList list;
    add_clear(list);
    constexpr int count = 4;
    for (int i = 0; i < count; ++i) {
        State s = base_state(m);
        const int unit = (1 << profile.subpixel_bits) / count;
        s.jitter = {unit * ((2 * i) % count) - unit, unit * i - 2 * unit};
        s.depth.test = true;
        list.add(SetState{s});
        list.add(Clear{.planes = color | depth});
        add_pass(list, m, "sample", color | accum, s, Maps::Checker, whole);
        list.add(Accumulate{i == 0 ? AccumOp::Load : AccumOp::Accum, 1});
    }
    list.add(BeginPass{"return", color | accum});
    list.add(Accumulate{AccumOp::Return, 1.0f / count});
    return list;
}

}  // namespace

std::vector<Picture> pictures() {
    const Model m = model();
    std::vector<Picture> out;
    for (const Profile& p : paper_profiles()) {
        out.push_back({"components-" + p.name, p, width, height, components(m)});
        out.push_back({"hardware-" + p.name, p, width, height, hardware(m)});
        out.push_back({"samples-" + p.name, p, width, height, samples(m, p)});
    }
    return out;
}

}  // namespace gw::exactness
