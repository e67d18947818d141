// Buffers and lists.
#include "bench/peers/opengl_mesh.h"

#include "gw/mesh.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace gw::peers {
namespace {

struct Walk {
    std::span<const Triangle> triangles;
    std::unordered_map<std::uint64_t, std::uint32_t>
        across{};  ///< directed edge -> the triangle it belongs to
    std::vector<bool> taken{};

    static std::uint64_t edge(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{a} << 32 | b;
    }

    explicit Walk(std::span<const Triangle> t) : triangles(t), taken(t.size()) {
        for (std::uint32_t i = 0; i < t.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                across.emplace(edge(t[i].vertex[k], t[i].vertex[(k + 1) % 3]), i);
    }
    /// The corner opposite the directed edge of a triangle not yet taken, which it takes.
    bool step(std::uint32_t a, std::uint32_t b, std::uint32_t& opposite) {
        const auto found = across.find(edge(a, b));
        if (found == across.end() || taken[found->second]) return false;
        taken[found->second] = true;
        for (const std::uint32_t v : triangles[found->second].vertex)
            if (v != a && v != b) opposite = v;
        return true;
    }
    /// From one triangle on: every second triangle of a strip is turned round.
    std::vector<unsigned> strip_from(std::uint32_t first) {
        const auto& v = triangles[first].vertex;
        std::vector<unsigned> strip{v[0], v[1], v[2]};
        taken[first] = true;
        for (std::uint32_t next = 0;; strip.push_back(next)) {
            const std::size_t n = strip.size();
            const bool turned = n % 2 != 0;
            if (!step(strip[turned ? n - 1 : n - 2], strip[turned ? n - 2 : n - 1], next))
                return strip;
        }
    }
};

/// Appends a strip at an even place, so that it keeps its winding.
void join(std::vector<unsigned>& all, const std::vector<unsigned>& strip) {
    if (!all.empty()) {
        all.push_back(all.back());
        if (all.size() % 2 == 0) all.push_back(all.back());
        all.push_back(strip.front());
    }
    all.insert(all.end(), strip.begin(), strip.end());
}

/// Indices of one GL_TRIANGLE_STRIP that draws the mesh's triangles with their winding. It joins
/// the strips that walks across shared edges find, by triangles without area.
std::vector<unsigned> one_strip(const Mesh& mesh) {
    Walk walk(mesh.triangles());
    std::vector<unsigned> all;
    for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i)
        if (!walk.taken[i]) join(all, walk.strip_from(i));
    return all;
}

struct GlVertex {
    vec3 position, normal;
    vec2 texcoord;
    vec4 color;
};
struct IdVertex {
    vec3 position;
    std::array<unsigned char, 4> color;
};

std::vector<GlVertex> vertices_of(const MeshData& m) {
    std::vector<GlVertex> out;
    for (std::size_t i = 0; i < m.positions.size(); ++i)
        out.push_back({m.positions[i], m.normals.empty() ? vec3(0, 0, 1) : m.normals[i],
                       m.texcoords.empty() ? vec2(0) : m.texcoords[i],
                       m.colors.empty() ? vec4(1) : m.colors[i]});
    return out;
}

/// Every triangle with separate vertices, because OpenGL 1.1 has no colour per face.
std::vector<IdVertex> id_vertices(const Mesh& mesh, unsigned base) {
    std::vector<IdVertex> out;
    for (const Triangle& t : mesh.triangles()) {
        const unsigned id = base + mesh.polygon_id(t.polygon);
        for (const std::uint32_t v : t.vertex)
            out.push_back(
                {mesh.data().positions[v],
                 {(unsigned char)(id), (unsigned char)(id >> 8), (unsigned char)(id >> 16), 255}});
    }
    return out;
}

template <typename T>
unsigned make_buffer(GLenum target, const std::vector<T>& data) {
    unsigned name = 0;
    glGenBuffers(1, &name);
    glBindBuffer(target, name);
    glBufferData(target, GLsizeiptr(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
    return name;
}

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void enable_array(GLenum array, bool on) {
    on ? glEnableClientState(array) : glDisableClientState(array);
}

constexpr int attribute_sets = 5;

}  // namespace

GlMesh::GlMesh(const Mesh& mesh, Store store, unsigned id_base) : store_(store) {
    std::vector<unsigned> indices;
    for (const Triangle& t : mesh.triangles())
        indices.insert(indices.end(), t.vertex.begin(), t.vertex.end());
    id_count_ = int(indices.size());
    if (store_ == Store::Strips) indices = one_strip(mesh);
    index_count_ = int(indices.size());
    vertices_ = make_buffer(GL_ARRAY_BUFFER, vertices_of(mesh.data()));
    ids_ = make_buffer(GL_ARRAY_BUFFER, id_vertices(mesh, id_base));
    indices_ = make_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    if (store_ != Store::Lists) return;
    lists_ = glGenLists(attribute_sets);
    for (unsigned i = 0; i < attribute_sets; ++i) {
        glNewList(lists_ + i, GL_COMPILE);
        draw_buffers(Attributes(i));
        glEndList();
    }
}

void GlMesh::draw(Attributes attributes) const {
    if (store_ == Store::Lists)
        glCallList(lists_ + unsigned(attributes));
    else
        draw_buffers(attributes);
}

void GlMesh::draw_buffers(Attributes attributes) const {
    const bool ids = attributes == Attributes::Ids,
               texture = attributes == Attributes::NormalsAndTexture,
               colors = attributes == Attributes::Colors;
    enable_array(GL_VERTEX_ARRAY, true);
    enable_array(GL_NORMAL_ARRAY, attributes == Attributes::Normals || texture);
    enable_array(GL_TEXTURE_COORD_ARRAY, texture || colors);
    enable_array(GL_COLOR_ARRAY, ids || colors);
    glBindBuffer(GL_ARRAY_BUFFER, ids ? ids_ : vertices_);
    if (ids) {
        glVertexPointer(3, GL_FLOAT, sizeof(IdVertex), at(offsetof(IdVertex, position)));
        glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(IdVertex), at(offsetof(IdVertex, color)));
        glDrawArrays(GL_TRIANGLES, 0, id_count_);
        return;
    }
    glVertexPointer(3, GL_FLOAT, sizeof(GlVertex), at(offsetof(GlVertex, position)));
    glNormalPointer(GL_FLOAT, sizeof(GlVertex), at(offsetof(GlVertex, normal)));
    glTexCoordPointer(2, GL_FLOAT, sizeof(GlVertex), at(offsetof(GlVertex, texcoord)));
    glColorPointer(4, GL_FLOAT, sizeof(GlVertex), at(offsetof(GlVertex, color)));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glDrawElements(store_ == Store::Strips ? GL_TRIANGLE_STRIP : GL_TRIANGLES, index_count_,
                   GL_UNSIGNED_INT, nullptr);
}

}  // namespace gw::peers
