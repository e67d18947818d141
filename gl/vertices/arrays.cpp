// Vertex arrays. [GL11] 2.8. The elements of a draw become vertices without a change of the current
// values. The specification leaves them open; programs draw on without setting them again. Elements
// of ArrayElement, and all elements while a list is open, become calls of immediate mode.
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/lists/call.h"
#include "gl/pixels/formats.h"
#include "gl/pixels/packed.h"
#include "gl/vertices/begin_end.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

namespace gw::gl {

namespace {

/// The bytes of a component; 0: no type of an array.
std::size_t bytes_of(GLenum type) {
    if (packed_type(type) != nullptr) return 0;
    return type == GL_DOUBLE ? 8 : component_bytes(type);
}

/// Element i of an array; components that it does not have are (0, 0, 1).
vec4 element(const ClientArray& a, GLint i, bool is_unit) {
    vec4 out{0, 0, 0, 1};
    const std::size_t bytes = a.type == GL_FLOAT ? sizeof(float) : bytes_of(a.type);
    const std::size_t stride = a.stride != 0 ? std::size_t(a.stride) : bytes * std::size_t(a.size);
    const unsigned char* at = a.pointer + std::ptrdiff_t(i) * std::ptrdiff_t(stride);
    if (a.type == GL_FLOAT) {
        std::memcpy(&out.x, at, std::size_t(a.size) * sizeof(float));
        return out;
    }
    for (int k = 0; k < a.size; ++k, at += bytes)
        out[k] = float(load_component(a.type, reinterpret_cast<const std::byte*>(at), !is_unit));

    return out;
}

/// An entry point's own way: into the open list, or carried out.
template <auto execute, class... Values>
void perform(Function function, Values... values) {
    call<Kind::Vertex, execute>(function, values...);
}

bool is_given(const ClientState& client, Array a) {
    return client.array(a).enable && client.array(a).pointer != nullptr;
}

/// [GL11] 2.8: the order of the arrays, the vertex last.
void send_values(const ClientState& client, GLint i) {
    if (is_given(client, Array::EdgeFlag))
        perform<execute::edge_flag>(
            Function::EdgeFlag, GLboolean(element(client.array(Array::EdgeFlag), i, false).x != 0));
    if (is_given(client, Array::TexCoord)) {
        const vec4 v = element(client.array(Array::TexCoord), i, false);
        perform<execute::tex_coord>(Function::TexCoord4f, v.x, v.y, v.z, v.w);
    }
    if (is_given(client, Array::Color)) {
        const vec4 v = element(client.array(Array::Color), i, true);
        perform<execute::color>(Function::Color4f, v.x, v.y, v.z, v.w);
    }
    if (is_given(client, Array::Index))
        perform<execute::index>(Function::Indexf, element(client.array(Array::Index), i, false).x);
    if (is_given(client, Array::Normal)) {
        const vec4 v = element(client.array(Array::Normal), i, true);
        perform<execute::normal>(Function::Normal3f, v.x, v.y, v.z);
    }
}
void send_element(const ClientState& client, GLint i) {
    send_values(client, i);
    if (!is_given(client, Array::Vertex)) return;
    const vec4 v = element(client.array(Array::Vertex), i, false);
    perform<execute::vertex>(Function::Vertex4f, v.x, v.y, v.z, v.w);
}

/// Calls take(k, element index_of(k)) for elements of `size` floats.
template <int size, class IndexOf, class Take>
void for_each_of_floats(const ClientArray& a, GLsizei count, IndexOf index_of, Take take) {
    const std::ptrdiff_t stride = a.stride != 0 ? a.stride : size * int(sizeof(float));
    for (GLsizei k = 0; k < count; ++k) {
        vec4 out{0, 0, 0, 1};
        std::memcpy(&out.x, a.pointer + index_of(k) * stride, size * sizeof(float));
        take(k, out);
    }
}
/// Calls take(k, element index_of(k)) for each k below `count`.
template <class IndexOf, class Take>
void for_each_element(const ClientArray& a, GLsizei count, bool is_unit, IndexOf index_of,
                      Take take) {
    if (a.type == GL_FLOAT && a.size == 2) return for_each_of_floats<2>(a, count, index_of, take);
    if (a.type == GL_FLOAT && a.size == 3) return for_each_of_floats<3>(a, count, index_of, take);
    if (a.type == GL_FLOAT && a.size == 4) return for_each_of_floats<4>(a, count, index_of, take);
    for (GLsizei k = 0; k < count; ++k) take(k, element(a, index_of(k), is_unit));
}

/// Gives vertices the values of elements.
template <class IndexOf>
void set_values(const ClientState& client, std::span<AssembledVertex> out, IndexOf index_of) {
    const auto set = [&](Array which, bool is_unit, auto value) {
        if (!is_given(client, which)) return;
        for_each_element(
            client.array(which), GLsizei(out.size()), is_unit, index_of,
            [&](GLsizei k, const vec4& element) { value(out[std::size_t(k)], element); });
    };
    set(Array::EdgeFlag, false,
        [](AssembledVertex& v, const vec4& flag) { v.edge_and_material = flag.x != 0 ? 1u : 0u; });
    set(Array::TexCoord, false, [](AssembledVertex& v, const vec4& s) { v.texcoord = finite(s); });
    set(Array::Color, true, [](AssembledVertex& v, const vec4& c) { v.color = finite(c); });
    set(Array::Normal, true, [](AssembledVertex& v, const vec4& n) { v.normal = finite(n); });
    set(Array::Vertex, false, [](AssembledVertex& v, const vec4& p) { v.position = p; });
}

/// Elements as vertices. What no array gives is the current value; the current values stay.
template <class IndexOf>
void add_elements(Context& context, GLsizei count, IndexOf index_of) {
    constexpr GLsizei some = 64;  // stay in the first cache
    std::array<AssembledVertex, some> vertices;
    vertices.fill(current_vertex(context.state.current));
    for (GLsizei first = 0; first < count; first += some) {
        const std::span added(vertices.data(), std::size_t(std::min(some, count - first)));
        set_values(context.client, added, [&](GLsizei k) { return index_of(first + k); });
        add_vertices(context, added);
    }
}

/// For each element from the least index to the greatest, itself; a lower one if no index names it:
/// there may be no memory then.
std::vector<GLint> named_elements(std::span<const std::uint32_t> indices, std::uint32_t first,
                                  std::uint32_t count) {
    std::vector<GLint> out(count, -1);
    for (const std::uint32_t index : indices) out[index - first] = GLint(index);
    for (std::size_t k = 1; k < out.size(); ++k)
        if (out[k] < 0) out[k] = out[k - 1];
    return out;
}

/// Draws separate primitives whose vertices stand in the mesh once each. False, and nothing is done:
/// the vertices are not shared, or not all of them can be drawn.
template <class IndexOf>
bool draw_shared(Context& context, GLenum mode, GLsizei count, IndexOf index_of) {
    const int corners = Assembly::separate_corners(mode);
    if (corners == 0 || !is_given(context.client, Array::Vertex)) return false;
    std::vector<std::uint32_t> indices(std::size_t(count - count % corners));
    if (indices.empty()) return false;
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const GLint index = index_of(GLsizei(i));
        if (index < 0) return false;
        indices[i] = std::uint32_t(index);
    }
    const auto [low, high] = std::minmax_element(indices.begin(), indices.end());
    const std::uint32_t first = *low, vertices = *high - first + 1;
    if (vertices >= indices.size()) return false;

    execute::begin(context, mode);
    const std::vector<GLint> elements = named_elements(indices, first, vertices);
    add_elements(context, GLsizei(vertices), [&](GLsizei k) { return elements[std::size_t(k)]; });
    for (std::uint32_t& index : indices) index -= first;
    const bool whole = context.assembler.mesh.end_shared(vertices, indices);
    context.assembler.inside = false;
    return whole;
}

/// A whole primitive of elements. Without vertices it draws nothing.
template <class IndexOf>
void draw_elements_one_by_one(Context& context, GLenum mode, GLsizei count, IndexOf index_of) {
    execute::begin(context, mode);
    if (is_given(context.client, Array::Vertex)) add_elements(context, count, index_of);
    execute::end(context);
}

/// An open list keeps a whole primitive of elements as one call, which is wrong between Begin and
/// End as a whole.
template <class IndexOf>
void list_elements(Context& context, Function function, GLenum mode, GLsizei count,
                   IndexOf index_of) {
    const auto elements = std::make_shared<DisplayList>();
    const auto outer = std::exchange(context.lists.open, elements);
    const GLenum outer_mode = std::exchange(context.lists.mode, GLenum(GL_COMPILE));
    perform<execute::begin>(Function::Begin, mode);
    if (context.client.array(Array::Vertex).enable)
        for (GLsizei i = 0; i < count; ++i) send_element(context.client, index_of(i));
    perform<execute::end>(Function::End);
    elements->seal();
    context.lists.open = outer;
    context.lists.mode = outer_mode;
    call<Kind::Draw, execute::play_elements>(function, Elements(elements));
}

GLint index_at(GLenum type, const GLvoid* indices, GLsizei i) {
    const auto* at = static_cast<const unsigned char*>(indices);
    const auto read = [&](auto value) {
        std::memcpy(&value, at + std::size_t(i) * sizeof value, sizeof value);
        return GLint(value);
    };
    if (type == GL_UNSIGNED_BYTE) return read(GLubyte());
    return type == GL_UNSIGNED_SHORT ? read(GLushort()) : read(GLuint());
}

/// Sets an array's layout, or an error.
void set_pointer(Context& context, Array which, GLint size, GLenum type, GLsizei stride,
                 const GLvoid* pointer) {
    if (stride < 0) return set_error(context, GL_INVALID_VALUE);
    ClientArray& a = context.client.array(which);
    a.size = size;
    a.type = type;
    a.stride = stride;
    a.pointer = static_cast<const unsigned char*>(pointer);
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
    if (bytes_of(type) == 0) return set_error(context, GL_INVALID_ENUM);
    set_pointer(context, Array::Color, size, type, stride, pointer);
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
    set_pointer(context, Array::TexCoord, size, type, stride, pointer);
}

void edge_flag_pointer(Context& context, GLsizei stride, const GLvoid* pointer) {
    set_pointer(context, Array::EdgeFlag, 1, GL_UNSIGNED_BYTE, stride, pointer);
}

void enable_client_state(Context& context, GLenum array) { set_client_array(context, array, true); }
void disable_client_state(Context& context, GLenum array) {
    set_client_array(context, array, false);
}

void interleaved_arrays(Context& context, GLenum format, GLsizei stride, const GLvoid* pointer) {
    if (stride < 0) return set_error(context, GL_INVALID_VALUE);
    for (const Interleaved& f : interleaved_formats) {
        if (f.format != format) continue;
        const auto* at = static_cast<const unsigned char*>(pointer);
        const std::size_t color_bytes = std::size_t(f.colors) * bytes_of(f.color_type);
        const int floats = f.texcoords + f.normals + f.positions;
        const GLsizei step =
            stride != 0 ? stride : GLsizei(std::size_t(floats) * sizeof(float) + color_bytes);
        const auto take = [&](Array which, int size, GLenum type) {
            context.client.array(which).enable = size > 0;
            if (size == 0) return;
            set_pointer(context, which, size, type, step, at);
            at += std::size_t(size) * bytes_of(type);
        };
        context.client.array(Array::EdgeFlag).enable = context.client.array(Array::Index).enable =
            false;
        take(Array::TexCoord, f.texcoords, GL_FLOAT);
        take(Array::Color, f.colors, f.color_type);
        take(Array::Normal, f.normals, GL_FLOAT);
        return take(Array::Vertex, f.positions, GL_FLOAT);
    }
    set_error(context, GL_INVALID_ENUM);
}

void array_element(Context& context, GLint i) {
    if (i < 0) return set_error(context, GL_INVALID_VALUE);
    send_element(context.client, i);
}

void play_elements(Context& context, const Elements& elements) {
    context.calls.is_one_call = true;
    const CurrentState kept = context.state.current;
    elements->play(context);
    context.state.current = kept;
    context.calls.is_one_call = false;
}

void draw_arrays(Context& context, GLenum mode, GLint first, GLsizei count) {
    if (context.assembler.inside && !context.lists.open)
        return set_error(context, GL_INVALID_OPERATION);
    if (mode > GL_POLYGON) return set_error(context, GL_INVALID_ENUM);
    if (count < 0 || first < 0) return set_error(context, GL_INVALID_VALUE);
    const auto index_of = [&](GLsizei i) { return first + i; };
    if (context.lists.open)
        return list_elements(context, Function::DrawArrays, mode, count, index_of);
    draw_elements_one_by_one(context, mode, count, index_of);
}

void draw_elements(Context& context, GLenum mode, GLsizei count, GLenum type,
                   const GLvoid* indices) {
    if (context.assembler.inside && !context.lists.open)
        return set_error(context, GL_INVALID_OPERATION);
    if (mode > GL_POLYGON) return set_error(context, GL_INVALID_ENUM);
    if (count < 0) return set_error(context, GL_INVALID_VALUE);
    if (type != GL_UNSIGNED_BYTE && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_INT)
        return set_error(context, GL_INVALID_ENUM);
    if (indices == nullptr) return;
    const auto index_of = [&](GLsizei i) { return index_at(type, indices, i); };
    if (context.lists.open)
        return list_elements(context, Function::DrawElements, mode, count, index_of);
    if (!draw_shared(context, mode, count, index_of))
        draw_elements_one_by_one(context, mode, count, index_of);
}

/// The range is a hint. EXT_draw_range_elements
void draw_range_elements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count,
                         GLenum type, const GLvoid* indices) {
    if (end < start && !context.assembler.inside) return set_error(context, GL_INVALID_VALUE);
    draw_elements(context, mode, count, type, indices);
}

}  // namespace execute

}  // namespace gw::gl
