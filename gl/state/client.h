// The client's state: vertex arrays and pixel storage. [GL11] 2.8, 3.6.1
#pragma once

#include "gl/state/buffer_objects.h"

#include <GL/gl.h>

#include <array>
#include <vector>

namespace gw::gl {

/// The layout of pixels in the caller's memory. [GL11] 3.6.1
struct PixelStore {
    bool swap_bytes = false, lsb_first = false;
    GLint row_length = 0;  ///< pixels; 0: the width
    GLint skip_rows = 0, skip_pixels = 0;
    GLint alignment = 4;                      ///< of rows: 1, 2, 4, 8 bytes
    GLint image_height = 0, skip_images = 0;  ///< of three dimensions: rows; 0: the height
    BufferRef buffer;  ///< in which pointers to pixels are offsets; null: none
};

/// The arrays, in the order in which ArrayElement sends their values: the vertex last.
enum class Array : unsigned char {
    EdgeFlag,
    TexCoord,  ///< of unit 0
    TexCoord1,
    TexCoord2,
    TexCoord3,
    Color,
    SecondaryColor,
    FogCoordinate,
    Index,
    Normal,
    Vertex
};
inline constexpr std::size_t array_count = 11;
/// The texture coordinates of a unit.
constexpr Array texcoord_array(std::size_t unit) {
    return Array(std::size_t(Array::TexCoord) + unit);
}

/// One vertex array, in the caller's memory or in a buffer.
struct ClientArray {
    bool enable = false;
    GLint size = 4;
    GLenum type = GL_FLOAT;
    GLsizei stride = 0;  ///< as given; 0: the elements follow each other
    const unsigned char* pointer = nullptr;
    BufferRef buffer;  ///< in which the pointer is an offset; null: none

    bool is_given() const { return enable && (buffer || pointer != nullptr); }
    const unsigned char* bytes() const {
        return reinterpret_cast<const unsigned char*>(bytes_at(buffer, pointer));
    }
};

struct ClientState {
    std::array<ClientArray, array_count> arrays{{{.size = 1, .type = GL_UNSIGNED_BYTE},
                                                 {},
                                                 {},
                                                 {},
                                                 {},
                                                 {},
                                                 {.size = 3},
                                                 {.size = 1},
                                                 {.size = 1},
                                                 {.size = 3},
                                                 {}}};
    std::size_t active_unit = 0;  ///< that TexCoordPointer and its switch are about
    BufferRef array_buffer;       ///< of the arrays that are set next
    BufferRef element_buffer;     ///< of indices
    PixelStore pack, unpack;
    /// GL_EXT_compiled_vertex_array: the elements that the program promises not to change; a count of
    /// 0: none. A draw reads them all the same.
    GLint locked_first = 0;
    GLsizei locked_count = 0;

    ClientArray& array(Array a) { return arrays[std::size_t(a)]; }
    const ClientArray& array(Array a) const { return arrays[std::size_t(a)]; }
};

/// The array of this name, GL_VERTEX_ARRAY and so on; null: there is none.
inline ClientArray* find_array(ClientState& client, GLenum name) {
    switch (name) {
        case GL_EDGE_FLAG_ARRAY: return &client.array(Array::EdgeFlag);
        case GL_TEXTURE_COORD_ARRAY: return &client.array(texcoord_array(client.active_unit));
        case GL_COLOR_ARRAY: return &client.array(Array::Color);
        case GL_SECONDARY_COLOR_ARRAY: return &client.array(Array::SecondaryColor);
        case GL_FOG_COORDINATE_ARRAY: return &client.array(Array::FogCoordinate);
        case GL_INDEX_ARRAY: return &client.array(Array::Index);
        case GL_NORMAL_ARRAY: return &client.array(Array::Normal);
        case GL_VERTEX_ARRAY: return &client.array(Array::Vertex);
    }
    return nullptr;
}

inline constexpr std::size_t client_stack_depth = 16;
struct SavedClientState {
    GLbitfield mask = 0;
    ClientState state;
};

}  // namespace gw::gl
