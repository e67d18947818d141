#include "my_renderer.h"

namespace my_renderer {

namespace {

/// Four faces, each with its own normal.
gw::MeshRef pyramid_mesh() {
    const gw::vec3 top{0, 0.75f, 0};
    const gw::vec3 base[4]{{-1, -0.75f, 1}, {1, -0.75f, 1}, {1, -0.75f, -1}, {-1, -0.75f, -1}};
    gw::MeshData data;
    for (int side = 0; side < 4; ++side) {
        const gw::vec3 a = base[side], b = base[(side + 1) % 4];
        data.positions.insert(data.positions.end(), {a, b, top});
        data.normals.insert(data.normals.end(), 3, glm::cross(b - a, top - a));
    }
    return gw::make_mesh(std::move(data));
}

/// The eye is 4 before the origin; exact, whatever the turn.
gw::dmat4 eye_from_object(int turn) {
    const int cosine[4]{1, 0, -1, 0}, sine[4]{0, 1, 0, -1};
    const int quarter = turn / 90 % 4;
    gw::dmat4 m{1};
    m[0] = {cosine[quarter], 0, -sine[quarter], 0};
    m[2] = {sine[quarter], 0, cosine[quarter], 0};
    m[3] = {0, 0, -4, 1};
    return m;
}

/// Near plane 2, far plane 6, a field of 2 x 2 at the near plane's distance.
gw::dmat4 projection() {
    gw::dmat4 m{0};
    m[0][0] = m[1][1] = 2;
    m[2] = {0, 0, -2, -1};
    m[3] = {0, 0, -6, 0};
    return m;
}

}  // namespace

gw::CommandList pyramid(int turn) {
    gw::Light lamp;  // goes with the eye
    lamp.position = {1, 2, 2, 0};
    lamp.Ia = {1, 1, 1};
    gw::Draw draw{.mesh = pyramid_mesh(), .eye_from_object = eye_from_object(turn)};
    draw.lights = std::make_shared<const std::vector<gw::Light>>(1, lamp);

    gw::State state;
    state.projection = projection();
    state.color_source = gw::ColorSource::Lighting;
    state.depth.test = true;

    gw::CommandList list;
    list.add(gw::BeginPass{"ambient"});
    list.add(gw::Clear{.planes = gw::all_planes});
    list.add(gw::SetState{state});
    draw.material = {.Ka = gw::vec3(0.25f), .Kd = gw::vec3(0)};
    list.add(draw);

    list.add(gw::BeginPass{"diffuse"});
    state.depth = {.test = true, .func = gw::DepthFunc::Equal, .mask = false};
    state.blend = {.enable = true, .src = gw::BlendFactor::One, .dst = gw::BlendFactor::One};
    list.add(gw::SetState{state});
    draw.material = {.Ka = gw::vec3(0), .Kd = {0.75f, 0.5f, 0.25f}};
    list.add(draw);
    return list;
}

}  // namespace my_renderer
