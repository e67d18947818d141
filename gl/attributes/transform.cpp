// Viewport, matrices, texture generation and clip planes. [GL11] 2.10, 2.11
#include "gl/api/calls.h"
#include "gl/api/finite.h"
#include "gl/api/values.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include "gw/base/elementary.h"
#include "gw/machine.h"
#include "gw/stages/vertex.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gw::gl {

namespace {

/// The machine's state has no modelview matrix: its draws do.
StateParts parts_of_matrix(const Context& context) {
    switch (context.state.transform.matrix_mode) {
        case GL_PROJECTION: return transform_part;
        case GL_TEXTURE: return texture_part;
    }
    return no_state_part;
}

/// Matrices hold floats: what GetFloatv hands out, LoadMatrixf brings back to the bit. What was
/// assembled is drawn with the old one, if the bits differ.
void set_matrix(Context& context, const dmat4& m) {
    dmat4& top = context.matrices.current(context.state).top();
    const dmat4 rounded{glm::mat4(m)};
    if (std::memcmp(&top, &rounded, sizeof top) == 0) return;
    begin_change(context, parts_of_matrix(context));
    top = rounded;
}
void multiply(Context& context, const dmat4& m) {
    set_matrix(context, product(context.matrices.current(context.state).top(), m));
}

/// [GL11] 2.10.2: rotation by `angle` degrees about an axis of length 1.
dmat4 rotation(double angle, const dvec3& axis) {
    const double s = sin_degrees(angle), k = cos_degrees(angle);
    const double x = axis.x, y = axis.y, z = axis.z, rest = 1 - k;
    dmat4 m(1);
    m[0] = {x * x * rest + k, y * x * rest + z * s, z * x * rest - y * s, 0};
    m[1] = {x * y * rest - z * s, y * y * rest + k, z * y * rest + x * s, 0};
    m[2] = {x * z * rest + y * s, y * z * rest - x * s, z * z * rest + k, 0};
    return m;
}

/// The row vector plane * inverse(matrix): a plane in eye space. [GL11] 2.10.4, 2.11
dvec4 plane_in_eye(const Context& context, const Params& p) {
    const dvec4 plane(p[0], p[1], p[2], p[3]);
    const dmat4 inverse = inverted(context.matrices.modelview.top());
    dvec4 out;
    for (int i = 0; i < 4; ++i) out[i] = dot4(plane, inverse[i]);
    return finite(out);
}

/// [GL13] 2.10.4
bool is_cube_mode(GLenum mode) { return mode == GL_NORMAL_MAP || mode == GL_REFLECTION_MAP; }

bool is_eye_or_object_plane(GLenum pname) {
    return pname == GL_EYE_PLANE || pname == GL_OBJECT_PLANE;
}

}  // namespace

namespace execute {

void depth_range(Context& context, GLclampd near_value, GLclampd far_value) {
    ViewportState& s = context.state.viewport;
    change(context, s.near_value, clamped(near_value, 0.0, 1.0));
    change(context, s.far_value, clamped(far_value, 0.0, 1.0));
}

void viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return set_error(context, GL_INVALID_VALUE);
    ViewportState& s = context.state.viewport;
    const int largest = largest_viewport(context.profile);
    change(context, s.x, std::clamp(x, -max_window_size, max_window_size));
    change(context, s.y, std::clamp(y, -max_window_size, max_window_size));
    change(context, s.width, std::min(width, largest));
    change(context, s.height, std::min(height, largest));
}

void matrix_mode(Context& context, GLenum mode) {
    if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE)
        return set_error(context, GL_INVALID_ENUM);
    context.state.transform.matrix_mode = mode;
}

void load_matrix(Context& context, const dmat4& m) { set_matrix(context, m); }
void mult_matrix(Context& context, const dmat4& m) { multiply(context, m); }
void load_identity(Context& context) { set_matrix(context, dmat4(1)); }

void rotate(Context& context, double angle, double x, double y, double z) {
    const dvec3 axis(x, y, z);
    const double size = length(axis);
    if (size == 0 || !std::isfinite(size)) return;
    multiply(context, rotation(std::remainder(angle, 360.0), dvec3(x / size, y / size, z / size)));
}

void translate(Context& context, double x, double y, double z) {
    dmat4 m(1);
    m[3] = {x, y, z, 1};
    multiply(context, m);
}

void scale(Context& context, double x, double y, double z) {
    dmat4 m(1);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    multiply(context, m);
}

void frustum(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
             GLdouble near_value, GLdouble far_value) {
    if (near_value <= 0 || far_value <= 0 || left == right || bottom == top ||
        near_value == far_value)
        return set_error(context, GL_INVALID_VALUE);
    const double width = right - left, height = top - bottom, depth = far_value - near_value;
    dmat4 m(0);
    m[0][0] = 2 * near_value / width;
    m[1][1] = 2 * near_value / height;
    m[2] = {(right + left) / width, (top + bottom) / height, -(far_value + near_value) / depth, -1};
    m[3][2] = -2 * far_value * near_value / depth;
    multiply(context, m);
}

void ortho(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top,
           GLdouble near_value, GLdouble far_value) {
    if (left == right || bottom == top || near_value == far_value)
        return set_error(context, GL_INVALID_VALUE);
    const double width = right - left, height = top - bottom, depth = far_value - near_value;
    dmat4 m(1);
    m[0][0] = 2 / width;
    m[1][1] = 2 / height;
    m[2][2] = -2 / depth;
    m[3] = {-(right + left) / width, -(top + bottom) / height, -(far_value + near_value) / depth,
            1};
    multiply(context, m);
}

void push_matrix(Context& context) {
    MatrixStack& stack = context.matrices.current(context.state);
    if (stack.entries.size() >= stack.depth) return set_error(context, GL_STACK_OVERFLOW);
    stack.entries.push_back(dmat4(stack.top()));
}

void pop_matrix(Context& context) {
    MatrixStack& stack = context.matrices.current(context.state);
    if (stack.entries.size() == 1) return set_error(context, GL_STACK_UNDERFLOW);
    if (stack.top() != stack.entries[stack.entries.size() - 2])
        begin_change(context, parts_of_matrix(context));
    stack.entries.pop_back();
}

void tex_gen(Context& context, GLenum coord, GLenum pname, const Params& params) {
    if (coord < GL_S || coord > GL_Q) return set_error(context, GL_INVALID_ENUM);
    TexGenState& s = context.state.texture.unit().gen[coord - GL_S];
    if (is_eye_or_object_plane(pname)) {
        if (params.count < 4) return set_error(context, GL_INVALID_ENUM);
        if (pname == GL_EYE_PLANE)
            return change(context, s.eye_plane, plane_in_eye(context, params));
        return change(context, s.object_plane, dvec4(params[0], params[1], params[2], params[3]));
    }
    const GLenum mode = params.token();
    const bool known =
        mode == GL_OBJECT_LINEAR || mode == GL_EYE_LINEAR ||
        (mode == GL_SPHERE_MAP && coord <= GL_T) ||
        (is_cube_mode(mode) && coord <= GL_R && context.profile.extensions.texture_cube);
    if (pname != GL_TEXTURE_GEN_MODE || !known) return set_error(context, GL_INVALID_ENUM);
    change(context, s.mode, mode);
}

void clip_plane(Context& context, GLenum plane, const Params& equation) {
    if (plane < GL_CLIP_PLANE0 || plane > GL_CLIP_PLANE5)
        return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.transform.clip_plane[plane - GL_CLIP_PLANE0],
           plane_in_eye(context, equation));
}

void clip_control(Context& context, GLenum origin, GLenum depth) {
    if ((origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT) ||
        (depth != GL_NEGATIVE_ONE_TO_ONE && depth != GL_ZERO_TO_ONE))
        return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.transform.clip_origin, origin);
    change(context, context.state.transform.clip_depth_mode, depth);
}

}  // namespace execute

}  // namespace gw::gl
