#include "bench/draws/field.h"

#include <memory>

namespace gw::draws {

std::vector<Quad> quads(int count) {
    std::uint32_t seed = 1991;
    const auto random = [&](int below) {
        seed = seed * 1664525 + 1013904223;
        return int((seed >> 8) % std::uint32_t(below));
    };
    std::vector<Quad> out;
    for (int i = 0; i < count; ++i)
        out.push_back({float(random(width - quad_side)), float(random(height - quad_side)),
                       float(random(2000)) / 1000 - 1,
                       vec3(random(256), random(256), random(256)) / 255.0f});
    return out;
}

const char* name_of(Own own) {
    switch (own) {
        case Own::Nothing: return "a draw each";
        case Own::Matrix: return "own matrix";
        case Own::Material: return "own material";
        case Own::State: return "own state";
        case Own::Texture: return "1,000 textures";
        case Own::All: return "matrix, material, state";
    }
    return "";
}

DepthFunc depth_func_of(int state) { return state & 1 ? DepthFunc::LEqual : DepthFunc::Less; }
bool blends(int state) { return (state & 2) != 0; }
bool has_depth_mask(int state) { return (state & 4) == 0; }

std::vector<std::uint8_t> texels_of(int texture) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < texture_side * texture_side; ++i)
        for (const int v : {texture * 7 + i * 3, texture / 4 + i, 255 - i, 255})
            rgba.push_back(std::uint8_t(v & 255));
    return rgba;
}

Light lamp() {
    return {.position = {0, 0, 1, 0}, .Ia = vec3(0.2f), .Id = vec3(0.8f), .Is = vec3(0)};
}

Ours::Ours(int count)
    : quads_(quads(count)),
      lights_(std::make_shared<const std::vector<Light>>(std::vector<Light>{lamp()})),
      shared_(quad_mesh({0, 0, 0, vec3(1, 0.5f, 0.25f)}, Own::Nothing, 0)) {
    for (int i = 0; i < texture_count; ++i)
        textures_.push_back(make_texture8("tile", texture_side, texture_side, texels_of(i)));
}

State Ours::view() const {
    State s;
    s.projection[0][0] = 2.0 / width;
    s.projection[1][1] = 2.0 / height;
    s.projection[3] = {-1, -1, 0, 1};
    s.depth = {true, DepthFunc::Less, true};
    return s;
}

MeshRef Ours::quad_mesh(const Quad& q, Own own, double shift) const {
    MeshData data{.primitive = Primitive::Quads};
    const float x = float(q.x + shift), side = float(quad_side);
    for (const vec2& corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
        data.positions.push_back({x + side * corner.x, q.y + side * corner.y, q.z});
        data.colors.push_back({q.color.x, q.color.y, q.color.z, 1});
        if (is_textured(own)) data.texcoords.push_back(corner);
        if (has_own_material(own)) data.normals.push_back({0, 0, 1});
    }
    return make_mesh(std::move(data));
}

CommandList Ours::draws(Own own, double shift) const {
    CommandList list;
    State state = view();
    if (has_own_material(own)) state.color_source = ColorSource::Lighting;
    list.add(SetState{state});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth))});
    for (std::size_t i = 0; i < quads_.size(); ++i) {
        const Quad& q = quads_[i];
        if (has_own_state(own)) {
            const int number = int(i % state_count);
            state.depth = {true, depth_func_of(number), has_depth_mask(number)};
            state.blend = {blends(number), BlendFactor::One, BlendFactor::One};
            list.add(SetState{state});
        }
        Draw draw;
        if (has_own_matrix(own)) {
            draw.mesh = shared_;
            draw.eye_from_object[3] = {double(q.x) + shift, double(q.y), double(q.z), 1};
        } else {
            draw.mesh = quad_mesh(q, own, shift);
        }
        if (has_own_material(own)) {
            draw.material.Ka = draw.material.Kd = q.color;
            draw.lights = lights_;
        }
        if (is_textured(own)) draw.map.texture = textures_[i % texture_count];
        list.commands.emplace_back(std::move(draw));
    }
    return list;
}

CommandList Ours::merged(double shift) const {
    MeshData data{.primitive = Primitive::Quads};
    for (const Quad& q : quads_) {
        const MeshRef one = quad_mesh(q, Own::Nothing, shift);
        const MeshData& from = one->data();
        data.positions.insert(data.positions.end(), from.positions.begin(), from.positions.end());
        data.colors.insert(data.colors.end(), from.colors.begin(), from.colors.end());
    }
    CommandList list;
    list.add(SetState{view()});
    list.add(Clear{.planes = PlaneMask(mask_of(Plane::Color) | mask_of(Plane::Depth))});
    list.add(Draw{.mesh = make_mesh(std::move(data))});
    return list;
}

}  // namespace gw::draws
