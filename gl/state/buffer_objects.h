// Buffer objects: arrays of bytes that the doors keep, for vertices, indices and pixels. [GL15] 2.9,
// GL_ARB_pixel_buffer_object
#pragma once

#include "gl/state/free_names.h"

#include <GL/gl.h>

#include <cstddef>
#include <cstdlib>
#include <map>
#include <memory>

namespace gw::gl {

struct BufferObject {
    struct Free {
        void operator()(std::byte* memory) const { std::free(memory); }
    };

    GLuint name = 0;
    std::size_t size = 0;
    std::unique_ptr<std::byte, Free> bytes;  ///< null if size is 0 and it was never set
    GLenum usage = GL_STATIC_DRAW, access = GL_READ_WRITE;
    bool is_mapped = false;
    /// The mapped range, and how it is used. GL_ARB_map_buffer_range
    struct Range {
        std::size_t offset = 0, length = 0;
        GLbitfield access = 0;
    } mapped;

    /// Whether `count` bytes from an offset on are in it.
    bool holds(std::size_t offset, std::size_t count) const {
        return offset <= size && count <= size - offset;
    }
};
using BufferRef = std::shared_ptr<BufferObject>;

/// The names of buffers. Contexts may share them. Null: reserved by GenBuffers, not bound yet.
struct BufferNames {
    std::map<GLuint, BufferRef> named;
    FreeNames free_names;
};

/// The name of a binding; 0: none.
inline GLuint name_of(const BufferRef& buffer) { return buffer ? buffer->name : 0; }

/// Where the bytes of a pointer are: the program's memory, or a buffer in which it is an offset.
inline const std::byte* bytes_at(const BufferRef& buffer, const void* pointer) {
    if (!buffer) return static_cast<const std::byte*>(pointer);
    return buffer->bytes.get() + reinterpret_cast<std::size_t>(pointer);
}

}  // namespace gw::gl
