#include "gl/draw/submit.h"

#include "gl/context/context.h"
#include "gl/draw/machine_state.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// The values of vertices that a draw with this state uses.
struct Used {
    bool colors = false, normals = false, texcoords = false, materials = false;
};

Used used_values(const State& s) {
    const bool lit = s.lighting.enable;
    const bool textured = s.texture.enable[0] || s.texture.enable[1];
    bool sphere_map = false, given = false;
    for (const TexGenState& gen : s.texture.gen) {
        sphere_map |= gen.enable && gen.mode == GL_SPHERE_MAP;
        given |= !gen.enable;
    }
    return {.colors = !lit || s.lighting.color_material,
            .normals = lit || (textured && sphere_map),
            .texcoords = textured && given,
            .materials = lit};
}

/// Whether all vertices have the first one's value.
template <class Value>
bool all_equal(const std::vector<AssembledVertex>& vertices, Value value) {
    const auto& first = value(vertices.front());
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const AssembledVertex& v) { return value(v) == first; });
}

template <class T, class Value>
void collect(std::vector<T>& out, const std::vector<AssembledVertex>& vertices, Value value) {
    out.reserve(vertices.size());
    for (const AssembledVertex& v : vertices) out.push_back(value(v));
}

void add_positions(MeshData& data, const std::vector<AssembledVertex>& vertices) {
    collect(data.positions, vertices, [](const auto& v) { return vec3(v.position); });
    const auto w = [](const AssembledVertex& v) { return v.position.w; };
    if (vertices.front().position.w != 1 || !all_equal(vertices, w)) collect(data.w, vertices, w);
}

void add_texcoords(MeshData& data, const std::vector<AssembledVertex>& vertices) {
    const auto rq = [](const AssembledVertex& v) { return vec2(v.texcoord.z, v.texcoord.w); };
    collect(data.texcoords, vertices, [](const auto& v) { return vec2(v.texcoord); });
    if (rq(vertices.front()) != vec2(0, 1) || !all_equal(vertices, rq))
        collect(data.texcoords_rq, vertices, rq);
}

/// The values that vary become arrays of the mesh, the others the draw's current values.
void add_values(MeshData& data, const Assembler& a, const Used& used) {
    const std::vector<AssembledVertex>& vertices = a.vertices;
    const auto color = [](const AssembledVertex& v) { return v.color; };
    const auto normal = [](const AssembledVertex& v) { return v.normal; };
    const auto texcoord = [](const AssembledVertex& v) { return v.texcoord; };
    if (used.colors && !all_equal(vertices, color)) collect(data.colors, vertices, color);
    if (used.normals && !all_equal(vertices, normal)) collect(data.normals, vertices, normal);
    if (used.texcoords && !all_equal(vertices, texcoord)) add_texcoords(data, vertices);
    if (used.materials && a.materials.size() > 1) {
        data.materials = a.materials;
        collect(data.material_indices, vertices, [](const auto& v) { return v.material(); });
    }
}

MeshData mesh_data(const Assembler& a, const Used& used) {
    MeshData data{.primitive = a.primitive};
    add_positions(data, a.vertices);
    add_values(data, a, used);
    data.indices = a.indices;
    data.polygon_sizes = a.polygon_sizes;
    if (a.has_hidden_edges && a.primitive >= Primitive::Triangles)
        collect(data.edge_flags, a.vertices, [](const auto& v) { return std::uint8_t(v.edge()); });
    return data;
}

std::shared_ptr<const CurrentValues> current_values(const AssembledVertex& v) {
    const CurrentValues values{v.color, v.normal, v.texcoord};
    if (values == CurrentValues{}) return nullptr;
    return std::make_shared<const CurrentValues>(values);
}

/// The enabled texture; two dimensions come before one. [GL11] 3.8.10
TextureRef enabled_texture(Context& c) {
    const auto& enable = c.state.texture.enable;
    if (!enable[0] && !enable[1]) return nullptr;
    const std::size_t target = enable[1] ? 1 : 0;
    return machine_texture(*c.textures.bound[target], target);
}

Draw draw_of(Context& c, const Assembler& a) {
    Draw draw;
    draw.mesh = make_mesh(mesh_data(a, used_values(c.state)));
    draw.eye_from_object = c.matrices.modelview.top();
    draw.material = a.materials.front().front;
    if (c.state.lighting.two_side)
        draw.back_material = std::make_shared<const gw::Material>(a.materials.front().back);
    draw.current = current_values(a.vertices.front());
    draw.lights = c.machine_state.lights;
    draw.map.texture = enabled_texture(c);
    return draw;
}

bool is_empty(const gw::ViewportState& v) { return v.width == 0 || v.height == 0; }

}  // namespace

void begin_change(Context& c) {
    flush_mesh(c);
    c.machine_state.changed = true;
}

FaceMaterials face_materials(const Context& c) {
    return {machine_material(c.state.lighting.material[0]),
            machine_material(c.state.lighting.material[1])};
}

void update_machine_state(Context& c) {
    if (!c.machine_state.changed) return;
    c.machine_state.state = machine_state(c);
    c.machine_state.lights = machine_lights(c.state.lighting);
    c.machine_state.changed = false;
}

Draw point_draw(Context& c, const vec4& position) {
    const CurrentState& now = c.state.current;
    Assembler a;
    a.vertices.push_back({position, now.color, now.texcoord, now.normal, 1});
    a.materials.push_back(face_materials(c));
    return draw_of(c, a);
}

bool submit_state(Context& c) {
    if (c.drawable == nullptr) return false;
    update_machine_state(c);
    c.drawable->set_state(c.machine_state.state);
    return true;
}

void submit_mesh(Context& c) {
    update_machine_state(c);
    if (is_empty(c.machine_state.state.viewport)) return;
    Draw draw = draw_of(c, c.assembler);
    if (c.selection.mode != GL_RENDER) return report(c, draw);
    if (!submit_state(c)) return;
    c.drawable->add(std::move(draw));
}

}  // namespace gw::gl
