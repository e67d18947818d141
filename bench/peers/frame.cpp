// The geometry of the workloads.
#include "bench/peers/frame.h"

#include "gw/texture.h"
#include "scene/draw/draw_commands.h"
#include "scene/draw/fit.h"
#include "scene/draw/view.h"
#include "scene/toml/read_scene.h"

#include <array>
#include <cmath>

namespace gw::peers {
namespace {

/// Blocks of two tones with grain, so that bilinear filtering matters everywhere.
TextureRef checks(const char* name, int side) {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int tone = ((x / 16 + y / 16) % 2 ? 150 : 220) + (x * 7 + y * 13) % 32;
            for (const int v : {tone, tone - 20, tone - 40, 128}) rgba.push_back(std::uint8_t(v));
        }
    return make_texture8(name, side, side, rgba);
}

MeshRef window_quad() {
    MeshData data;
    data.primitive = Primitive::Quads;
    data.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    data.normals.assign(4, vec3(0, 0, 1));
    data.texcoords = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    data.colors.assign(4, vec4(0.01f, 0.02f, 0.03f, 0.5f));
    return make_mesh(std::move(data));
}

/// A box's corners by bits x, y, z, and its faces counter-clockwise seen from outside.
constexpr std::array<std::array<std::uint32_t, 4>, 6> box_faces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

/// Long thin boxes across the view, as shadow volumes are: 13 x 13 of them, 12 triangles each.
MeshRef volume_boxes() {
    MeshData data;
    data.primitive = Primitive::Quads;
    for (int j = 0; j < 13; ++j)
        for (int i = 0; i < 13; ++i) {
            const auto first = std::uint32_t(data.positions.size());
            const vec3 low(-3.9f + 0.6f * float(i), -2.6f + 0.4f * float(j),
                           -12.0f + 0.1f * float(i));
            for (std::uint32_t c = 0; c < 8; ++c)
                data.positions.push_back(
                    low + vec3(c & 1 ? 0.25f : 0, c & 2 ? 0.15f : 0, c & 4 ? 7.0f : 0));
            for (const auto& face : box_faces)
                for (const std::uint32_t corner : face) data.indices.push_back(first + corner);
        }
    return make_mesh(std::move(data));
}

std::vector<Light> four_lights() {
    std::vector<Light> lights;
    for (const vec3& at : {vec3(-3, 3, -2), vec3(3, 3, -2), vec3(-2, 4, -8), vec3(2, 4, -8)}) {
        Light light;
        light.position = vec4(at, 1);
        light.Ia = vec3(0.1f), light.Id = vec3(0.5f), light.Is = vec3(0.5f);
        lights.push_back(light);
    }
    return lights;
}

State window_state(int width, int height) {
    State s;
    s.viewport = {0, 0, width, height};
    return s;
}

}  // namespace

Frame scene_frame(const char* path, int width, int height) {
    Frame f{.width = width, .height = height};
    scene::Scene scene = scene::read_scene(path).scene;
    scene::add_defaults(scene, f.width, f.height);
    const scene::View view = scene::make_view(scene, f.width, f.height);
    f.view = scene::view_state(view);
    f.view.lighting.two_side = false;
    f.view.cull.enable = true;
    for (const scene::Object& object : scene.objects) {
        const Draw draw = scene::placed(object, view);
        f.scene.push_back({draw.mesh, draw.eye_from_object,
                           scene::machine_material(scene.materials[object.material])});
    }
    f.volumes.mesh = volume_boxes();
    f.texture = checks("checks", 256);
    f.sphere_map = checks("sphere map", 256);
    f.lights = four_lights();
    return f;
}

Frame fill_frame() {
    Frame f;
    f.width = f.height = 1024;
    f.view = window_state(f.width, f.height);
    f.quad.mesh = window_quad();
    f.texture = checks("checks", 256);
    return f;
}

}  // namespace gw::peers
