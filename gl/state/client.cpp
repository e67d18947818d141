#include "gl/state/client.h"

namespace gw::gl {

ClientArray* find_array(ClientState& client, GLenum name) {
    switch (name) {
        case GL_EDGE_FLAG_ARRAY: return &client.array(Array::EdgeFlag);
        case GL_TEXTURE_COORD_ARRAY: return &client.array(Array::TexCoord);
        case GL_COLOR_ARRAY: return &client.array(Array::Color);
        case GL_INDEX_ARRAY: return &client.array(Array::Index);
        case GL_NORMAL_ARRAY: return &client.array(Array::Normal);
        case GL_VERTEX_ARRAY: return &client.array(Array::Vertex);
    }
    return nullptr;
}

}  // namespace gw::gl
