// The state variables of vertex arrays.
#include "gl/query/state_variables.h"

#include "gl/context/context.h"

namespace gw::gl {

namespace {

template <Array array>
void add_array(StateVariables& t, GLenum size, GLenum type, GLenum stride, GLenum buffer) {
    t[buffer] = [](Context& context) { return whole(name_of(context.client.array(array).buffer)); };
    if (size != 0)
        t[size] = [](Context& context) { return whole(context.client.array(array).size); };
    if (type != 0)
        t[type] = [](Context& context) { return whole(context.client.array(array).type); };
    t[stride] = [](Context& context) { return whole(context.client.array(array).stride); };
}

}  // namespace

void add_arrays(StateVariables& t) {
    add_array<Array::Vertex>(t, GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE,
                             GL_VERTEX_ARRAY_BUFFER_BINDING);
    add_array<Array::Normal>(t, 0, GL_NORMAL_ARRAY_TYPE, GL_NORMAL_ARRAY_STRIDE,
                             GL_NORMAL_ARRAY_BUFFER_BINDING);
    add_array<Array::Color>(t, GL_COLOR_ARRAY_SIZE, GL_COLOR_ARRAY_TYPE, GL_COLOR_ARRAY_STRIDE,
                            GL_COLOR_ARRAY_BUFFER_BINDING);
    add_array<Array::SecondaryColor>(t, GL_SECONDARY_COLOR_ARRAY_SIZE,
                                     GL_SECONDARY_COLOR_ARRAY_TYPE, GL_SECONDARY_COLOR_ARRAY_STRIDE,
                                     GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING);
    add_array<Array::FogCoordinate>(t, 0, GL_FOG_COORDINATE_ARRAY_TYPE,
                                    GL_FOG_COORDINATE_ARRAY_STRIDE,
                                    GL_FOG_COORDINATE_ARRAY_BUFFER_BINDING);
    add_array<Array::Index>(t, 0, GL_INDEX_ARRAY_TYPE, GL_INDEX_ARRAY_STRIDE,
                            GL_INDEX_ARRAY_BUFFER_BINDING);
    add_array<Array::EdgeFlag>(t, 0, 0, GL_EDGE_FLAG_ARRAY_STRIDE,
                               GL_EDGE_FLAG_ARRAY_BUFFER_BINDING);
    t[GL_ARRAY_ELEMENT_LOCK_FIRST_EXT] = [](Context& context) {
        return whole(context.client.locked_first);
    };
    t[GL_ARRAY_ELEMENT_LOCK_COUNT_EXT] = [](Context& context) {
        return whole(context.client.locked_count);
    };
    t[GL_ARRAY_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.client.array_buffer));
    };
    t[GL_ELEMENT_ARRAY_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(context.client.element_buffer));
    };
}

}  // namespace gw::gl
