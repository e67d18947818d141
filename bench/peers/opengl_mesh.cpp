// Buffers and lists.
#include "bench/peers/opengl_mesh.h"

#include "bench/peers/strips.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <cstddef>

namespace gw::peers {
namespace {

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
