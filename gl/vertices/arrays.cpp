// Elements of vertex arrays. [GL11] 2.8, [GL15] 2.9. The elements of a draw become vertices without a change of the current
// values. The specification leaves them open; programs draw on without setting them again. Elements
// of ArrayElement, and all elements while a list is open, become calls of immediate mode.
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/api/finite.h"
#include "gl/context/context.h"
#include "gl/lists/call.h"
#include "gl/pixels/formats.h"
#include "gl/vertices/array_types.h"
#include "gl/vertices/begin_end.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

namespace gw::gl {

namespace {

/// Element i of an array; components that it does not have are (0, 0, 1).
vec4 element(const ClientArray& a, GLint i, bool is_unit) {
    vec4 out{0, 0, 0, 1};
    const std::size_t bytes = a.type == GL_FLOAT ? sizeof(float) : array_component_bytes(a.type);
    const std::size_t stride = a.stride != 0 ? std::size_t(a.stride) : bytes * std::size_t(a.size);
    const unsigned char* at = a.bytes() + std::ptrdiff_t(i) * std::ptrdiff_t(stride);
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

bool is_given(const ClientState& client, Array a) { return client.array(a).is_given(); }

/// [GL11] 2.8: the order of the arrays, the vertex last.
void send_values(const ClientState& client, GLint i) {
    if (is_given(client, Array::EdgeFlag))
        perform<execute::edge_flag>(
            Function::EdgeFlag, GLboolean(element(client.array(Array::EdgeFlag), i, false).x != 0));
    if (is_given(client, Array::TexCoord)) {
        const vec4 v = element(client.array(Array::TexCoord), i, false);
        perform<execute::tex_coord>(Function::TexCoord4f, v.x, v.y, v.z, v.w);
    }
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit) {
        if (!is_given(client, texcoord_array(unit))) continue;
        const vec4 v = element(client.array(texcoord_array(unit)), i, false);
        perform<execute::multi_tex_coord>(Function::MultiTexCoord4f, GL_TEXTURE0 + GLenum(unit),
                                          v.x, v.y, v.z, v.w);
    }
    if (is_given(client, Array::Color)) {
        const vec4 v = element(client.array(Array::Color), i, true);
        perform<execute::color>(Function::Color4f, v.x, v.y, v.z, v.w);
    }
    if (is_given(client, Array::SecondaryColor)) {
        const vec4 v = element(client.array(Array::SecondaryColor), i, true);
        perform<execute::secondary_color>(Function::SecondaryColor3f, v.x, v.y, v.z);
    }
    if (is_given(client, Array::FogCoordinate))
        perform<execute::fog_coord>(Function::FogCoordf,
                                    element(client.array(Array::FogCoordinate), i, false).x);
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
    const unsigned char* const bytes = a.bytes();
    for (GLsizei k = 0; k < count; ++k) {
        vec4 out{0, 0, 0, 1};
        std::memcpy(&out.x, bytes + index_of(k) * stride, size * sizeof(float));
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
    set(Array::SecondaryColor, true,
        [](AssembledVertex& v, const vec4& c) { v.secondary_color = vec3(finite(c)); });
    set(Array::FogCoordinate, false,
        [](AssembledVertex& v, const vec4& f) { v.fog_coordinate = finite(f).x; });
    set(Array::Normal, true, [](AssembledVertex& v, const vec4& n) { v.normal = finite(n); });
    set(Array::Vertex, false, [](AssembledVertex& v, const vec4& p) { v.position = p; });
}

/// The same of units 1 to 3.
template <class IndexOf>
void set_further_texcoords(const ClientState& client, std::span<FurtherTexcoords> out,
                           IndexOf index_of) {
    for (std::size_t unit = 1; unit < texture_unit_count; ++unit) {
        const ClientArray& a = client.array(texcoord_array(unit));
        if (!a.is_given()) continue;
        for_each_element(a, GLsizei(out.size()), false, index_of,
                         [&](GLsizei k, const vec4& element) {
                             out[std::size_t(k)][unit - 1] = finite(element);
                         });
    }
}

/// Elements as vertices. What no array gives is the current value; the current values stay.
template <class IndexOf>
void add_elements(Context& context, GLsizei count, IndexOf index_of) {
    constexpr GLsizei some = 64;  // stay in the first cache
    std::array<AssembledVertex, some> vertices;
    vertices.fill(current_vertex(context.state.current));
    const bool has_further = context.assembler.keeps_further_texcoords;
    std::vector<FurtherTexcoords> further;
    if (has_further) further.assign(some, context.state.current.further_texcoords);
    for (GLsizei first = 0; first < count; first += some) {
        const std::span added(vertices.data(), std::size_t(std::min(some, count - first)));
        set_values(context.client, added, [&](GLsizei k) { return index_of(first + k); });
        const std::span added_further(further.data(), has_further ? added.size() : 0);
        set_further_texcoords(context.client, added_further,
                              [&](GLsizei k) { return index_of(first + k); });
        add_vertices(context, added, added_further);
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

/// Whether the elements up to an index are in an array's buffer.
bool holds(const ClientArray& a, std::uint32_t last) {
    const std::size_t bytes = array_component_bytes(a.type) * std::size_t(a.size);
    const std::size_t stride = a.stride != 0 ? std::size_t(a.stride) : bytes;
    const auto offset = reinterpret_cast<std::size_t>(a.pointer);
    if (!a.buffer->holds(offset, bytes)) return false;
    return stride == 0 || (a.buffer->size - offset - bytes) / stride >= last;
}

bool uses_buffers(const ClientState& client) {
    return client.element_buffer || std::ranges::any_of(client.arrays, [](const ClientArray& a) {
               return a.enable && a.buffer;
           });
}

/// Whether elements may be read: what stands in buffers is in them, and the program has mapped none.
/// Else INVALID_OPERATION. [GL15] 2.9 leaves the first open.
bool check_buffers(Context& context, std::uint32_t last) {
    for (const ClientArray& a : context.client.arrays) {
        if (!a.enable || !a.buffer) continue;
        if (a.buffer->is_mapped || !holds(a, last))
            return set_error(context, GL_INVALID_OPERATION), false;
    }
    return true;
}

/// Where the indices are; null: nowhere, or an error is set.
const GLvoid* indices_at(Context& context, const GLvoid* indices, GLsizei count, GLenum type) {
    const BufferRef& buffer = context.client.element_buffer;
    const bool is_there = !buffer || (!buffer->is_mapped &&
                                      buffer->holds(reinterpret_cast<std::size_t>(indices),
                                                    std::size_t(count) * component_bytes(type)));
    if (!is_there) return set_error(context, GL_INVALID_OPERATION), nullptr;
    return bytes_at(buffer, indices);
}

/// Buffers stay as they are while their elements are read: contexts of other threads may share them.
std::unique_lock<std::recursive_mutex> keep_buffers(Context& context) {
    if (!uses_buffers(context.client)) return {};
    return context.shared->exclusive();
}

/// Whether calls of several primitives are wrong as a whole: they draw none of them then.
bool are_negative(GLsizei primcount, const GLsizei* counts) {
    return primcount < 0 ||
           std::any_of(counts, counts + primcount, [](GLsizei count) { return count < 0; });
}

}  // namespace

namespace execute {

void array_element(Context& context, GLint i) {
    if (i < 0) return set_error(context, GL_INVALID_VALUE);
    const auto lock = keep_buffers(context);
    if (check_buffers(context, std::uint32_t(i))) send_element(context.client, i);
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
    const auto lock = keep_buffers(context);
    const std::uint32_t last = std::uint32_t(first) + std::uint32_t(count) - 1;
    if (count > 0 && !check_buffers(context, last)) return;
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
    const auto lock = keep_buffers(context);
    const GLvoid* const at = indices_at(context, indices, count, type);
    if (at == nullptr) return;
    const auto index_of = [&](GLsizei i) { return index_at(type, at, i); };
    if (lock && count > 0) {
        std::uint32_t last = 0;
        for (GLsizei i = 0; i < count; ++i) last = std::max(last, std::uint32_t(index_of(i)));
        if (!check_buffers(context, last)) return;
    }
    if (context.lists.open)
        return list_elements(context, Function::DrawElements, mode, count, index_of);
    if (!draw_shared(context, mode, count, index_of))
        draw_elements_one_by_one(context, mode, count, index_of);
}

void multi_draw_arrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count,
                       GLsizei primcount) {
    if (are_negative(primcount, count)) return set_error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] != 0) draw_arrays(context, mode, first[i], count[i]);
}

void multi_draw_elements(Context& context, GLenum mode, const GLsizei* count, GLenum type,
                         const GLvoid* const* indices, GLsizei primcount) {
    if (are_negative(primcount, count)) return set_error(context, GL_INVALID_VALUE);
    for (GLsizei i = 0; i < primcount; ++i)
        if (count[i] != 0) draw_elements(context, mode, count[i], type, indices[i]);
}

/// The range is a hint. EXT_draw_range_elements
void draw_range_elements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count,
                         GLenum type, const GLvoid* indices) {
    if (end < start && !context.assembler.inside) return set_error(context, GL_INVALID_VALUE);
    draw_elements(context, mode, count, type, indices);
}

}  // namespace execute

}  // namespace gw::gl
