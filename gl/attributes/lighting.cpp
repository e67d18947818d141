// Lights, materials and the light model. [GL11] 2.13
#include "gl/attributes/attributes.h"

#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/api/values.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include "gl/api/convert.h"

#include "gw/stages/vertex.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// The direction in eye space, by the upper 3x3 of the modelview matrix.
vec3 direction_in_eye(const Context& context, const Params& p) {
    const dvec3 d = transform3(dmat3(context.matrices.modelview.top()), dvec3(p[0], p[1], p[2]));
    return vec3(finite(d));
}
vec4 position_in_eye(const Context& context, const Params& p) {
    return vec4(finite(transform(context.matrices.modelview.top(), dvec4(p[0], p[1], p[2], p[3]))));
}

void set_attenuation(Context& context, float& field, double value) {
    if (!(value >= 0)) return set_error(context, GL_INVALID_VALUE);
    change(context, field, float(value));
}

void set_cutoff(Context& context, float& field, double value) {
    if (!(value >= 0 && value <= 90) && value != 180) return set_error(context, GL_INVALID_VALUE);
    change(context, field, float(value));
}

void set_exponent(Context& context, float& field, double value) {
    if (!(value >= 0 && value <= 128)) return set_error(context, GL_INVALID_VALUE);
    change(context, field, float(value));
}

/// Materials change between vertices too, so that the open mesh keeps what it has.
template <class T>
void change_material(Context& context, T& field, const T& value) {
    if (field == value) return;
    field = value;
    context.assembler.material_changed = true;
}

void set_material(Context& context, MaterialState& m, GLenum pname, const Params& p) {
    const vec4 color = p.as_vec4();
    switch (pname) {
        case GL_AMBIENT: return change_material(context, m.ambient, color);
        case GL_DIFFUSE: return change_material(context, m.diffuse, color);
        case GL_SPECULAR: return change_material(context, m.specular, color);
        case GL_EMISSION: return change_material(context, m.emission, color);
        case GL_SHININESS: return change_material(context, m.shininess, float(p[0]));
        case GL_COLOR_INDEXES: return change_material(context, m.indexes, vec3(color));
        case GL_AMBIENT_AND_DIFFUSE:
            change_material(context, m.ambient, color);
            return change_material(context, m.diffuse, color);
    }
}

bool is_material_parameter(GLenum pname) {
    switch (pname) {
        case GL_AMBIENT:
        case GL_DIFFUSE:
        case GL_SPECULAR:
        case GL_EMISSION:
        case GL_SHININESS:
        case GL_COLOR_INDEXES:
        case GL_AMBIENT_AND_DIFFUSE: return true;
    }
    return false;
}

}  // namespace

void track_color(Context& context) {
    const LightingState& s = context.state.lighting;
    if (!s.color_material) return;
    const vec4& color = context.state.current.color;
    const Params p{{color.x, color.y, color.z, color.w}, 4};
    if (s.color_material_face != GL_BACK)
        set_material(context, context.state.lighting.material[0], s.color_material_mode, p);
    if (s.color_material_face != GL_FRONT)
        set_material(context, context.state.lighting.material[1], s.color_material_mode, p);
}

namespace execute {

void front_face(Context& context, GLenum mode) {
    if (mode != GL_CW && mode != GL_CCW) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.polygon.front_face, mode);
}

void shade_model(Context& context, GLenum mode) {
    if (mode != GL_FLAT && mode != GL_SMOOTH) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.lighting.shade_model, mode);
}

void light(Context& context, GLenum light, GLenum pname, const Params& params) {
    if (light < GL_LIGHT0 || light >= GL_LIGHT0 + GLenum(light_count) ||
        params.count < std::max(parameter_count(pname), 1))
        return set_error(context, GL_INVALID_ENUM);
    LightState& s = context.state.lighting.lights[light - GL_LIGHT0];
    switch (pname) {
        case GL_AMBIENT: return change(context, s.ambient, params.as_vec4());
        case GL_DIFFUSE: return change(context, s.diffuse, params.as_vec4());
        case GL_SPECULAR: return change(context, s.specular, params.as_vec4());
        case GL_POSITION: return change(context, s.position, position_in_eye(context, params));
        case GL_SPOT_DIRECTION:
            return change(context, s.spot_direction, direction_in_eye(context, params));
        case GL_SPOT_EXPONENT: return set_exponent(context, s.spot_exponent, params[0]);
        case GL_SPOT_CUTOFF: return set_cutoff(context, s.spot_cutoff, params[0]);
        case GL_CONSTANT_ATTENUATION:
            return set_attenuation(context, s.constant_attenuation, params[0]);
        case GL_LINEAR_ATTENUATION:
            return set_attenuation(context, s.linear_attenuation, params[0]);
        case GL_QUADRATIC_ATTENUATION:
            return set_attenuation(context, s.quadratic_attenuation, params[0]);
    }
    set_error(context, GL_INVALID_ENUM);
}

void light_model(Context& context, GLenum pname, const Params& params) {
    LightingState& s = context.state.lighting;
    switch (pname) {
        case GL_LIGHT_MODEL_AMBIENT:
            if (params.count < 4) return set_error(context, GL_INVALID_ENUM);
            return change(context, s.model_ambient, params.as_vec4());
        case GL_LIGHT_MODEL_LOCAL_VIEWER: return change(context, s.local_viewer, params[0] != 0);
        case GL_LIGHT_MODEL_TWO_SIDE: return change(context, s.two_side, params[0] != 0);
        case GL_LIGHT_MODEL_COLOR_CONTROL:
            if (params.token() != GL_SINGLE_COLOR && params.token() != GL_SEPARATE_SPECULAR_COLOR)
                return set_error(context, GL_INVALID_ENUM);
            return change(context, s.color_control, params.token());
    }
    set_error(context, GL_INVALID_ENUM);
}

void material(Context& context, GLenum face, GLenum pname, const Params& params) {
    if (!is_face(face) || !is_material_parameter(pname) || params.count < parameter_count(pname))
        return set_error(context, GL_INVALID_ENUM);
    if (pname == GL_SHININESS && !(params[0] >= 0 && params[0] <= 128))
        return set_error(context, GL_INVALID_VALUE);
    auto& materials = context.state.lighting.material;
    if (face != GL_BACK) set_material(context, materials[0], pname, params);
    if (face != GL_FRONT) set_material(context, materials[1], pname, params);
    track_color(context);
}

void color_material(Context& context, GLenum face, GLenum mode) {
    const bool is_mode = mode == GL_AMBIENT || mode == GL_DIFFUSE || mode == GL_SPECULAR ||
                         mode == GL_EMISSION || mode == GL_AMBIENT_AND_DIFFUSE;
    if (!is_face(face) || !is_mode) return set_error(context, GL_INVALID_ENUM);
    track_color(context);
    change(context, context.state.lighting.color_material_face, face);
    change(context, context.state.lighting.color_material_mode, mode);
}

}  // namespace execute

}  // namespace gw::gl
