// VertexPointer .. InterleavedArrays: where vertex arrays are, and which count. [GL11] 2.8
#include "gl/api/calls.h"
#include "gl/context/context.h"
#include "gl/vertices/array_types.h"

namespace gw::gl {

namespace {

/// Sets an array's layout, or an error.
void set_pointer(Context& context, Array which, GLint size, GLenum type, GLsizei stride,
                 const GLvoid* pointer) {
    if (stride < 0) return set_error(context, GL_INVALID_VALUE);
    ClientArray& a = context.client.array(which);
    a.size = size;
    a.type = type;
    a.stride = stride;
    a.pointer = static_cast<const unsigned char*>(pointer);
    a.buffer = context.client.array_buffer;
}

bool is_coordinate_type(GLenum type) {
    return type == GL_SHORT || type == GL_INT || type == GL_FLOAT || type == GL_DOUBLE;
}

/// [GL11] table 2.5
struct Interleaved {
    GLenum format;
    int texcoords, colors, normals, positions;  ///< components; 0: none
    GLenum color_type;
};
constexpr Interleaved interleaved_formats[] = {
    {GL_V2F, 0, 0, 0, 2, 0},
    {GL_V3F, 0, 0, 0, 3, 0},
    {GL_C4UB_V2F, 0, 4, 0, 2, GL_UNSIGNED_BYTE},
    {GL_C4UB_V3F, 0, 4, 0, 3, GL_UNSIGNED_BYTE},
    {GL_C3F_V3F, 0, 3, 0, 3, GL_FLOAT},
    {GL_N3F_V3F, 0, 0, 3, 3, 0},
    {GL_C4F_N3F_V3F, 0, 4, 3, 3, GL_FLOAT},
    {GL_T2F_V3F, 2, 0, 0, 3, 0},
    {GL_T4F_V4F, 4, 0, 0, 4, 0},
    {GL_T2F_C4UB_V3F, 2, 4, 0, 3, GL_UNSIGNED_BYTE},
    {GL_T2F_C3F_V3F, 2, 3, 0, 3, GL_FLOAT},
    {GL_T2F_N3F_V3F, 2, 0, 3, 3, 0},
    {GL_T2F_C4F_N3F_V3F, 2, 4, 3, 3, GL_FLOAT},
    {GL_T4F_C4F_N3F_V4F, 4, 4, 3, 4, GL_FLOAT},
};

void set_client_array(Context& context, GLenum name, bool on) {
    ClientArray* const array = find_array(context.client, name);
    if (array == nullptr) return set_error(context, GL_INVALID_ENUM);
    array->enable = on;
}

}  // namespace

namespace execute {

void vertex_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                    const GLvoid* pointer) {
    if (size < 2 || size > 4) return set_error(context, GL_INVALID_VALUE);
    if (!is_coordinate_type(type)) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::Vertex, size, type, stride, pointer);
}

void normal_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer) {
    if (!is_coordinate_type(type) && type != GL_BYTE) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::Normal, 3, type, stride, pointer);
}

void color_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                   const GLvoid* pointer) {
    if (size < 3 || size > 4) return set_error(context, GL_INVALID_VALUE);
    if (array_component_bytes(type) == 0) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::Color, size, type, stride, pointer);
}

void secondary_color_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                             const GLvoid* pointer) {
    if (size != 3) return set_error(context, GL_INVALID_VALUE);
    if (array_component_bytes(type) == 0) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::SecondaryColor, size, type, stride, pointer);
}

void fog_coord_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer) {
    if (type != GL_FLOAT && type != GL_DOUBLE) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::FogCoordinate, 1, type, stride, pointer);
}

void index_pointer(Context& context, GLenum type, GLsizei stride, const GLvoid* pointer) {
    if (!is_coordinate_type(type) && type != GL_UNSIGNED_BYTE)
        return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::Index, 1, type, stride, pointer);
}

void tex_coord_pointer(Context& context, GLint size, GLenum type, GLsizei stride,
                       const GLvoid* pointer) {
    if (size < 1 || size > 4) return set_error(context, GL_INVALID_VALUE);
    if (!is_coordinate_type(type)) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, texcoord_array(context.client.active_unit), size, type, stride, pointer);
}

void edge_flag_pointer(Context& context, GLsizei stride, const GLvoid* pointer) {
    set_pointer(context, Array::EdgeFlag, 1, GL_UNSIGNED_BYTE, stride, pointer);
}

void client_active_texture(Context& context, GLenum texture) {
    const auto unit = unit_index(context.profile, texture);
    if (!unit) return set_error(context, GL_INVALID_ENUM);
    context.client.active_unit = *unit;
}

void enable_client_state(Context& context, GLenum array) { set_client_array(context, array, true); }
void disable_client_state(Context& context, GLenum array) {
    set_client_array(context, array, false);
}

void lock_arrays(Context& context, GLint first, GLsizei count) {
    if (first < 0 || count <= 0) return set_error(context, GL_INVALID_VALUE);
    if (context.client.locked_count > 0) return set_error(context, GL_INVALID_OPERATION);
    context.client.locked_first = first;
    context.client.locked_count = count;
}

void unlock_arrays(Context& context) {
    if (context.client.locked_count == 0) return set_error(context, GL_INVALID_OPERATION);
    context.client.locked_first = context.client.locked_count = 0;
}

void interleaved_arrays(Context& context, GLenum format, GLsizei stride, const GLvoid* pointer) {
    if (stride < 0) return set_error(context, GL_INVALID_VALUE);
    for (const Interleaved& f : interleaved_formats) {
        if (f.format != format) continue;
        auto at = reinterpret_cast<std::uintptr_t>(pointer);  // an offset if a buffer is bound
        const std::size_t color_bytes = std::size_t(f.colors) * array_component_bytes(f.color_type);
        const int floats = f.texcoords + f.normals + f.positions;
        const GLsizei step =
            stride != 0 ? stride : GLsizei(std::size_t(floats) * sizeof(float) + color_bytes);
        const auto take = [&](Array which, int size, GLenum type) {
            context.client.array(which).enable = size > 0;
            if (size == 0) return;
            set_pointer(context, which, size, type, step, reinterpret_cast<const GLvoid*>(at));
            at += std::size_t(size) * array_component_bytes(type);
        };
        for (const Array off :
             {Array::EdgeFlag, Array::Index, Array::SecondaryColor, Array::FogCoordinate})
            context.client.array(off).enable = false;
        take(texcoord_array(context.client.active_unit), f.texcoords, GL_FLOAT);
        take(Array::Color, f.colors, f.color_type);
        take(Array::Normal, f.normals, GL_FLOAT);
        return take(Array::Vertex, f.positions, GL_FLOAT);
    }
    set_error(context, GL_INVALID_ENUM);
}

}  // namespace execute

}  // namespace gw::gl
