// The state variables of the active texture unit.
#include "gl/query/state_variables.h"

#include "gl/context/context.h"

namespace gw::gl {

namespace {

/// The array of the unit that ClientActiveTexture chose.
const ClientArray& texcoords(const Context& context) {
    return context.client.array(texcoord_array(context.client.active_unit));
}

const MatrixStack& stack(const Context& context) {
    return context.matrices.texture[context.state.texture.active];
}

/// The value of the active unit: unit 0 has `first`, the others have `further`.
const vec4& of_active(const Context& context, const vec4& first, const FurtherTexcoords& further) {
    const std::size_t unit = context.state.texture.active;
    return unit == 0 ? first : further[unit - 1];
}

template <std::size_t target>
void add_binding(StateVariables& t, GLenum name) {
    t[name] = [](Context& context) { return whole(context.state.texture.unit().bound[target]); };
}

}  // namespace

void add_texture_units(StateVariables& t) {
    t[GL_ACTIVE_TEXTURE] = [](Context& context) {
        return whole(GL_TEXTURE0 + context.state.texture.active);
    };
    t[GL_CLIENT_ACTIVE_TEXTURE] = [](Context& context) {
        return whole(GL_TEXTURE0 + context.client.active_unit);
    };
    add_binding<one_dimension>(t, GL_TEXTURE_BINDING_1D);
    add_binding<two_dimensions>(t, GL_TEXTURE_BINDING_2D);
    add_binding<rectangular>(t, GL_TEXTURE_BINDING_RECTANGLE);
    add_binding<three_dimensions>(t, GL_TEXTURE_BINDING_3D);
    add_binding<cube>(t, GL_TEXTURE_BINDING_CUBE_MAP);
    t[GL_CURRENT_TEXTURE_COORDS] = [](Context& context) {
        const CurrentState& now = context.state.current;
        return numbers_of(of_active(context, now.texcoord, now.further_texcoords));
    };
    t[GL_CURRENT_RASTER_TEXTURE_COORDS] = [](Context& context) {
        const CurrentState::Raster& raster = context.state.current.raster;
        return numbers_of(of_active(context, raster.texcoord, raster.further_texcoords));
    };
    t[GL_TEXTURE_MATRIX] = [](Context& context) { return numbers_of(stack(context).top()); };
    t[GL_TRANSPOSE_TEXTURE_MATRIX] = [](Context& context) {
        return numbers_of(glm::transpose(stack(context).top()));
    };
    t[GL_TEXTURE_STACK_DEPTH] = [](Context& context) {
        return whole(stack(context).entries.size());
    };
    t[GL_TEXTURE_COORD_ARRAY_SIZE] = [](Context& context) {
        return whole(texcoords(context).size);
    };
    t[GL_TEXTURE_COORD_ARRAY_TYPE] = [](Context& context) {
        return whole(texcoords(context).type);
    };
    t[GL_TEXTURE_COORD_ARRAY_STRIDE] = [](Context& context) {
        return whole(texcoords(context).stride);
    };
    t[GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING] = [](Context& context) {
        return whole(name_of(texcoords(context).buffer));
    };
}

}  // namespace gw::gl
