#include "gl/assemble/mesh.h"

#include <algorithm>
#include <utility>

namespace gw::gl {

namespace {

/// Whether all vertices have the first one's value.
template <class Value>
bool all_equal(const std::vector<AssembledVertex>& vertices, Value value) {
    const auto& first = value(vertices.front());
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](const AssembledVertex& v) { return value(v) == first; });
}

template <class T, class Value>
void collect(std::vector<T>& out, const std::vector<AssembledVertex>& vertices, Value value) {
    out.resize(vertices.size());
    std::transform(vertices.begin(), vertices.end(), out.begin(), value);
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

/// Adds the coordinates of unit `i` + 1, if they vary.
void add_further_texcoords(MeshData& data, const std::vector<FurtherTexcoords>& all,
                           std::size_t i) {
    const auto varies = [&](auto value) {
        return std::any_of(all.begin(), all.end(),
                           [&](const auto& v) { return value(v[i]) != value(all.front()[i]); });
    };
    if (all.empty() || !varies([](const vec4& v) { return v; })) return;
    UnitTexcoords& out = data.more_texcoords[i];
    const auto rq = [](const vec4& v) { return vec2(v.z, v.w); };
    const bool has_rq = rq(all.front()[i]) != vec2(0, 1) || varies(rq);
    for (const FurtherTexcoords& v : all) {
        out.st.push_back(vec2(v[i]));
        if (has_rq) out.rq.push_back(rq(v[i]));
    }
}

/// The values that vary become arrays of the mesh, the others the draw's current values.
void add_values(MeshData& data, const Assembly& a, const std::vector<FaceMaterials>& materials,
                const VertexValues& used) {
    const std::vector<AssembledVertex>& vertices = a.vertices;
    const auto color = [](const AssembledVertex& v) { return v.color; };
    const auto normal = [](const AssembledVertex& v) { return v.normal; };
    const auto texcoord = [](const AssembledVertex& v) { return v.texcoord; };
    const auto secondary = [](const AssembledVertex& v) { return v.secondary_color; };
    const auto fog = [](const AssembledVertex& v) { return v.fog_coordinate; };
    if (used.colors && !all_equal(vertices, color)) collect(data.colors, vertices, color);
    if (used.normals && !all_equal(vertices, normal)) collect(data.normals, vertices, normal);
    if (used.texcoords && !all_equal(vertices, texcoord)) add_texcoords(data, vertices);
    if (used.secondary_colors && !all_equal(vertices, secondary))
        collect(data.secondary_colors, vertices, secondary);
    if (used.fog_coordinates && !all_equal(vertices, fog))
        collect(data.fog_coordinates, vertices, fog);
    for (std::size_t i = 0; i < used.further_texcoords.size(); ++i)
        if (used.further_texcoords[i]) add_further_texcoords(data, a.further_texcoords, i);
    if (used.materials && materials.size() > 1) {
        data.materials = materials;
        collect(data.material_indices, vertices, [](const auto& v) { return v.material(); });
    }
}

MeshData mesh_data(const Assembly& a, const std::vector<FaceMaterials>& materials,
                   const VertexValues& used) {
    MeshData data{.primitive = a.primitive};
    add_positions(data, a.vertices);
    add_values(data, a, materials, used);
    data.indices = a.indices;
    data.polygon_sizes = a.polygon_sizes;
    if (a.has_hidden_edges && a.primitive >= Primitive::Triangles)
        collect(data.edge_flags, a.vertices, [](const auto& v) { return std::uint8_t(v.edge()); });
    return data;
}

bool uses_normals(GLenum gen_mode) {
    return gen_mode == GL_SPHERE_MAP || gen_mode == GL_NORMAL_MAP || gen_mode == GL_REFLECTION_MAP;
}

}  // namespace

VertexValues used_values(const State& s, bool is_feedback) {
    const bool lit = s.lighting.enable;
    VertexValues out{.colors = !lit || s.lighting.color_material, .normals = lit, .materials = lit};
    for (std::size_t i = 0; i < texture_unit_count; ++i) {
        const TextureUnit& unit = s.texture.units[i];
        if (!unit.is_enabled() && !(is_feedback && i == 0)) continue;
        bool& texcoords = i == 0 ? out.texcoords : out.further_texcoords[i - 1];
        for (const TexGenState& gen : unit.gen) {
            out.normals |= gen.enable && uses_normals(gen.mode);
            texcoords |= !gen.enable;
        }
    }
    out.secondary_colors = s.fog.color_sum && !lit;
    out.fog_coordinates = s.fog.enable && s.fog.coordinate_source == GL_FOG_COORDINATE;
    return out;
}

MeshRef mesh_of(const Assembly& assembly, const std::vector<FaceMaterials>& materials,
                const VertexValues& used) {
    return make_mesh(mesh_data(assembly, materials, used));
}

MeshRef MeshCache::mesh_of(Assembly& assembly, const std::vector<FaceMaterials>& materials,
                           const VertexValues& used) {
    if (next_ == entries_.size()) entries_.emplace_back();
    Entry& entry = entries_[next_++];
    if (entry.mesh && entry.used == used && entry.assembly == assembly &&
        entry.materials == materials)
        return entry.mesh;
    entry.mesh = gl::mesh_of(assembly, materials, used);
    entry.used = used;
    entry.materials = materials;
    std::swap(entry.assembly, assembly);
    return entry.mesh;
}

void MeshCache::begin_frame() {
    if (next_ == 0) return;  // Flush, then a swap
    entries_.resize(next_);
    next_ = 0;
}

}  // namespace gw::gl
