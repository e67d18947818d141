// A mesh in OpenGL's hands: vertex and index buffers, of triangles or of one strip, or display
// lists of the former.
#pragma once

#include "bench/peers/opengl.h"

namespace gw::peers {

/// The attributes of a vertex that a draw reads.
enum class Attributes { Positions, Normals, NormalsAndTexture, Colors, Ids };

class GlMesh {
public:
    /// Identifiers id_base, id_base + 1, ... are the colours of Attributes::Ids.
    GlMesh(const Mesh& mesh, Store store, unsigned id_base);
    void draw(Attributes attributes) const;

private:
    void draw_buffers(Attributes attributes) const;
    Store store_;
    unsigned vertices_ = 0, indices_ = 0, ids_ = 0, lists_ = 0;
    int index_count_ = 0, id_count_ = 0;
};

}  // namespace gw::peers
