// GenBuffers .. GetBufferPointerv. [GL15] 2.9, GL_ARB_map_buffer_range, GL_ARB_copy_buffer. Usage is
// a hint; it changes nothing. A map is the buffer's own memory, so nothing waits or is flushed.
#include "gl/api/calls.h"
#include "gl/context/context.h"

#include <algorithm>
#include <cstring>

namespace gw::gl {

namespace {

/// What is bound to a target; null: no such target.
BufferRef* binding_of(Context& context, GLenum target) {
    switch (target) {
        case GL_ARRAY_BUFFER: return &context.client.array_buffer;
        case GL_ELEMENT_ARRAY_BUFFER: return &context.client.element_buffer;
        case GL_PIXEL_PACK_BUFFER: return &context.client.pack.buffer;
        case GL_PIXEL_UNPACK_BUFFER: return &context.client.unpack.buffer;
        case GL_COPY_READ_BUFFER: return &context.copy_read_buffer;
        case GL_COPY_WRITE_BUFFER: return &context.copy_write_buffer;
    }
    return nullptr;
}

/// The buffer that a call is about; null after an error.
BufferObject* bound_buffer(Context& context, GLenum target) {
    const BufferRef* const binding = binding_of(context, target);
    if (binding == nullptr) return set_error(context, GL_INVALID_ENUM), nullptr;
    if (!*binding) return set_error(context, GL_INVALID_OPERATION), nullptr;
    return binding->get();
}

/// The part of it that a call reads or writes; null after an error.
BufferObject* buffer_with_part(Context& context, GLenum target, GLintptr offset, GLsizeiptr size) {
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return nullptr;
    if (offset < 0 || size < 0 || !buffer->holds(std::size_t(offset), std::size_t(size)))
        return set_error(context, GL_INVALID_VALUE), nullptr;
    if (buffer->is_mapped) return set_error(context, GL_INVALID_OPERATION), nullptr;
    return buffer;
}

bool is_usage(GLenum usage) {
    return (usage >= GL_STREAM_DRAW && usage <= GL_STREAM_COPY) ||
           (usage >= GL_STATIC_DRAW && usage <= GL_STATIC_COPY) ||
           (usage >= GL_DYNAMIC_DRAW && usage <= GL_DYNAMIC_COPY);
}

constexpr GLbitfield all_access = GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT |
                                  GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_FLUSH_EXPLICIT_BIT |
                                  GL_MAP_UNSYNCHRONIZED_BIT;

/// Whether a map can be used so. What is read cannot be given up, and only what is written is flushed.
bool is_access(GLbitfield access) {
    const bool reads = (access & GL_MAP_READ_BIT) != 0, writes = (access & GL_MAP_WRITE_BIT) != 0;
    constexpr GLbitfield not_read =
        GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT | GL_MAP_UNSYNCHRONIZED_BIT;
    return (reads || writes) && !(reads && (access & not_read) != 0) &&
           (writes || (access & GL_MAP_FLUSH_EXPLICIT_BIT) == 0);
}

/// [GL15]'s word for how a map is used.
GLenum access_word(GLbitfield access) {
    if ((access & GL_MAP_WRITE_BIT) == 0) return GL_READ_ONLY;
    return (access & GL_MAP_READ_BIT) == 0 ? GL_WRITE_ONLY : GL_READ_WRITE;
}

/// The memory of a range; null after an error.
GLvoid* map(Context& context, BufferObject& buffer, const BufferObject::Range& range) {
    if (buffer.is_mapped) return set_error(context, GL_INVALID_OPERATION), nullptr;
    // A buffer without a store has nothing that could be mapped.
    if (!buffer.bytes) return set_error(context, GL_OUT_OF_MEMORY), nullptr;
    buffer.is_mapped = true;
    buffer.mapped = range;
    buffer.access = access_word(range.access);
    return buffer.bytes.get() + range.offset;
}

/// [GL15] 2.9: bindings of a deleted buffer become 0, in this context.
void unbind(Context& context, const BufferRef& buffer) {
    const auto leave = [&](BufferRef& binding) {
        if (binding == buffer) binding = nullptr;
    };
    leave(context.client.array_buffer);
    leave(context.client.element_buffer);
    leave(context.client.pack.buffer);
    leave(context.client.unpack.buffer);
    leave(context.copy_read_buffer);
    leave(context.copy_write_buffer);
    for (ClientArray& array : context.client.arrays) {
        if (array.buffer != buffer) continue;
        array.buffer = nullptr;
        array.pointer = nullptr;
    }
}

}  // namespace

namespace execute {

void gen_buffers(Context& context, GLsizei n, GLuint* buffers) {
    const auto lock = context.shared->exclusive();
    gen_names(context, context.shared->buffers, n, buffers);
}

void delete_buffers(Context& context, GLsizei n, const GLuint* buffers) {
    if (n < 0) return set_error(context, GL_INVALID_VALUE);
    if (buffers == nullptr) return;
    const auto lock = context.shared->exclusive();
    for (GLsizei i = 0; i < n; ++i) {
        const auto found = context.shared->buffers.named.find(buffers[i]);
        if (found == context.shared->buffers.named.end()) continue;
        if (found->second) {
            found->second->is_mapped = false;
            unbind(context, found->second);
        }
        context.shared->buffers.named.erase(found);
        context.shared->buffers.free_names.give_back(buffers[i]);
    }
}

GLboolean is_buffer(Context& context, GLuint buffer) {
    const auto lock = context.shared->exclusive();
    const auto found = context.shared->buffers.named.find(buffer);
    return found != context.shared->buffers.named.end() && found->second ? GL_TRUE : GL_FALSE;
}

void bind_buffer(Context& context, GLenum target, GLuint buffer) {
    BufferRef* const binding = binding_of(context, target);
    if (binding == nullptr) return set_error(context, GL_INVALID_ENUM);
    if (buffer == 0) {
        *binding = nullptr;
        return;
    }
    const auto lock = context.shared->exclusive();
    BufferRef& object = context.shared->buffers.named[buffer];
    if (!object) {
        object = std::make_shared<BufferObject>();
        object->name = buffer;
    }
    *binding = object;
}

void buffer_data(Context& context, GLenum target, GLsizeiptr size, const GLvoid* data,
                 GLenum usage) {
    const auto lock = context.shared->exclusive();
    if (binding_of(context, target) == nullptr || !is_usage(usage))
        return set_error(context, GL_INVALID_ENUM);
    if (size < 0) return set_error(context, GL_INVALID_VALUE);
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return;
    // Bytes that the program does not give are 0. calloc() does not touch them.
    const auto bytes = std::max(std::size_t(size), std::size_t(1));
    std::unique_ptr<std::byte, BufferObject::Free> fresh(
        static_cast<std::byte*>(data != nullptr ? std::malloc(bytes) : std::calloc(1, bytes)));
    if (!fresh) return set_error(context, GL_OUT_OF_MEMORY);
    if (data != nullptr) std::memcpy(fresh.get(), data, std::size_t(size));
    buffer->bytes = std::move(fresh);
    buffer->size = std::size_t(size);
    buffer->usage = usage;
    buffer->access = GL_READ_WRITE;
    buffer->is_mapped = false;
}

void buffer_sub_data(Context& context, GLenum target, GLintptr offset, GLsizeiptr size,
                     const GLvoid* data) {
    const auto lock = context.shared->exclusive();
    BufferObject* const buffer = buffer_with_part(context, target, offset, size);
    if (buffer == nullptr || data == nullptr || size == 0) return;
    std::memcpy(buffer->bytes.get() + offset, data, std::size_t(size));
}

void get_buffer_sub_data(Context& context, GLenum target, GLintptr offset, GLsizeiptr size,
                         GLvoid* data) {
    const auto lock = context.shared->exclusive();
    const BufferObject* const buffer = buffer_with_part(context, target, offset, size);
    if (buffer == nullptr || data == nullptr || size == 0) return;
    std::memcpy(data, buffer->bytes.get() + offset, std::size_t(size));
}

/// Parts of one buffer may not overlap.
void copy_buffer_sub_data(Context& context, GLenum read_target, GLenum write_target,
                          GLintptr read_offset, GLintptr write_offset, GLsizeiptr size) {
    const auto lock = context.shared->exclusive();
    const BufferObject* const from = buffer_with_part(context, read_target, read_offset, size);
    if (from == nullptr) return;
    BufferObject* const to = buffer_with_part(context, write_target, write_offset, size);
    if (to == nullptr) return;
    const bool overlap = read_offset < write_offset + size && write_offset < read_offset + size;
    if (from == to && overlap) return set_error(context, GL_INVALID_VALUE);
    if (size != 0)
        std::memcpy(to->bytes.get() + write_offset, from->bytes.get() + read_offset,
                    std::size_t(size));
}

GLvoid* map_buffer(Context& context, GLenum target, GLenum access) {
    const auto lock = context.shared->exclusive();
    if (binding_of(context, target) == nullptr ||
        (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE))
        return set_error(context, GL_INVALID_ENUM), nullptr;
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return nullptr;
    const GLbitfield bits = access == GL_READ_ONLY    ? GL_MAP_READ_BIT
                            : access == GL_WRITE_ONLY ? GL_MAP_WRITE_BIT
                                                      : GL_MAP_READ_BIT | GL_MAP_WRITE_BIT;
    return map(context, *buffer, {0, buffer->size, bits});
}

GLvoid* map_buffer_range(Context& context, GLenum target, GLintptr offset, GLsizeiptr length,
                         GLbitfield access) {
    const auto lock = context.shared->exclusive();
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return nullptr;
    if (offset < 0 || length < 0 || !buffer->holds(std::size_t(offset), std::size_t(length)) ||
        (access & ~all_access) != 0)
        return set_error(context, GL_INVALID_VALUE), nullptr;
    if (length == 0 || !is_access(access)) return set_error(context, GL_INVALID_OPERATION), nullptr;
    return map(context, *buffer, {std::size_t(offset), std::size_t(length), access});
}

void flush_mapped_buffer_range(Context& context, GLenum target, GLintptr offset,
                               GLsizeiptr length) {
    const auto lock = context.shared->exclusive();
    const BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return;
    const BufferObject::Range& range = buffer->mapped;
    if (!buffer->is_mapped || (range.access & GL_MAP_FLUSH_EXPLICIT_BIT) == 0)
        return set_error(context, GL_INVALID_OPERATION);
    const auto from = std::size_t(offset), size = std::size_t(length);
    if (offset < 0 || length < 0 || from > range.length || size > range.length - from)
        set_error(context, GL_INVALID_VALUE);
}

GLboolean unmap_buffer(Context& context, GLenum target) {
    const auto lock = context.shared->exclusive();
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr) return GL_FALSE;
    if (!buffer->is_mapped) return set_error(context, GL_INVALID_OPERATION), GL_FALSE;
    buffer->is_mapped = false;
    buffer->access = GL_READ_WRITE;
    return GL_TRUE;
}

void get_buffer_parameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
    const auto lock = context.shared->exclusive();
    const bool is_known = pname == GL_BUFFER_SIZE || pname == GL_BUFFER_USAGE ||
                          pname == GL_BUFFER_ACCESS || pname == GL_BUFFER_MAPPED ||
                          pname == GL_BUFFER_ACCESS_FLAGS || pname == GL_BUFFER_MAP_OFFSET ||
                          pname == GL_BUFFER_MAP_LENGTH;
    if (binding_of(context, target) == nullptr || !is_known)
        return set_error(context, GL_INVALID_ENUM);
    const BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr || params == nullptr) return;
    const auto size = [](std::size_t bytes) {
        return GLint(std::min<std::size_t>(bytes, 0x7FFFFFFF));
    };
    const BufferObject::Range mapped = buffer->is_mapped ? buffer->mapped : BufferObject::Range{};
    switch (pname) {
        case GL_BUFFER_SIZE: *params = size(buffer->size); return;
        case GL_BUFFER_ACCESS_FLAGS: *params = GLint(mapped.access); return;
        case GL_BUFFER_MAP_OFFSET: *params = size(mapped.offset); return;
        case GL_BUFFER_MAP_LENGTH: *params = size(mapped.length); return;
        case GL_BUFFER_USAGE: *params = GLint(buffer->usage); return;
        case GL_BUFFER_ACCESS: *params = GLint(buffer->access); return;
        case GL_BUFFER_MAPPED: *params = buffer->is_mapped ? GL_TRUE : GL_FALSE; return;
    }
}

void get_buffer_pointerv(Context& context, GLenum target, GLenum pname, GLvoid** params) {
    const auto lock = context.shared->exclusive();
    if (binding_of(context, target) == nullptr || pname != GL_BUFFER_MAP_POINTER)
        return set_error(context, GL_INVALID_ENUM);
    BufferObject* const buffer = bound_buffer(context, target);
    if (buffer == nullptr || params == nullptr) return;
    *params = buffer->is_mapped ? buffer->bytes.get() + buffer->mapped.offset : nullptr;
}

}  // namespace execute

}  // namespace gw::gl
