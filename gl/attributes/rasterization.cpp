// Points, lines and polygons. [GL11] 3.3 to 3.5
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include <algorithm>

namespace gw::gl {

namespace execute {

void point_size(Context& context, GLfloat size) {
    if (!(size > 0)) return set_error(context, GL_INVALID_VALUE);
    change(context, context.state.point.size, size);
}

/// [GL14] 3.3
void point_parameter(Context& context, GLenum pname, const Params& params) {
    PointState& s = context.state.point;
    if (pname == GL_POINT_DISTANCE_ATTENUATION) {
        if (params.count < 3) return set_error(context, GL_INVALID_ENUM);
        return change(context, s.attenuation, vec3(params.as_vec4()));
    }
    float* const field = pname == GL_POINT_SIZE_MIN              ? &s.min_size
                         : pname == GL_POINT_SIZE_MAX            ? &s.max_size
                         : pname == GL_POINT_FADE_THRESHOLD_SIZE ? &s.fade_threshold
                                                                 : nullptr;
    if (field == nullptr) return set_error(context, GL_INVALID_ENUM);
    if (!(params[0] >= 0)) return set_error(context, GL_INVALID_VALUE);
    change(context, *field, float(params[0]));
}

void line_width(Context& context, GLfloat width) {
    if (!(width > 0)) return set_error(context, GL_INVALID_VALUE);
    change(context, context.state.line.width, width);
}

void line_stipple(Context& context, GLint factor, GLushort pattern) {
    change(context, context.state.line.stipple_factor, std::clamp(factor, 1, 256));
    change(context, context.state.line.stipple_pattern, pattern);
}

void cull_face(Context& context, GLenum mode) {
    if (!is_face(mode)) return set_error(context, GL_INVALID_ENUM);
    change(context, context.state.polygon.cull_face, mode);
}

void polygon_stipple(Context& context, const Stipple& pattern) {
    auto& field = context.state.polygon_stipple.pattern;
    if (field && *field == pattern) return;
    begin_change_of(context, &field);
    field = std::make_shared<const Stipple>(pattern);
}

void polygon_mode(Context& context, GLenum face, GLenum mode) {
    if (!is_face(face) || mode < GL_POINT || mode > GL_FILL)
        return set_error(context, GL_INVALID_ENUM);
    if (face != GL_BACK) change(context, context.state.polygon.front_mode, mode);
    if (face != GL_FRONT) change(context, context.state.polygon.back_mode, mode);
}

void polygon_offset(Context& context, GLfloat factor, GLfloat units) {
    change(context, context.state.polygon.offset_factor, float(finite(double(factor))));
    change(context, context.state.polygon.offset_units, float(finite(double(units))));
}

void polygon_offset_ext(Context& context, GLfloat factor, GLfloat bias) {
    const auto units = double((std::uint64_t{1} << context.profile.depth_bits) - 1);
    polygon_offset(context, factor, float(finite(double(bias) * units)));
}

}  // namespace execute

}  // namespace gw::gl
