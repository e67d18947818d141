// Points, lines and polygons. [GL11] 3.3 to 3.5
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/context/context.h"
#include "gl/draw/submit.h"

#include <algorithm>

namespace gw::gl {

namespace execute {

void point_size(Context& c, GLfloat size) {
    if (!(size > 0)) return set_error(c, GL_INVALID_VALUE);
    change(c, c.state.point.size, size);
}

void line_width(Context& c, GLfloat width) {
    if (!(width > 0)) return set_error(c, GL_INVALID_VALUE);
    change(c, c.state.line.width, width);
}

void line_stipple(Context& c, GLint factor, GLushort pattern) {
    change(c, c.state.line.stipple_factor, std::clamp(factor, 1, 256));
    change(c, c.state.line.stipple_pattern, pattern);
}

void cull_face(Context& c, GLenum mode) {
    if (!is_face(mode)) return set_error(c, GL_INVALID_ENUM);
    change(c, c.state.polygon.cull_face, mode);
}

void polygon_stipple(Context& c, const Stipple& pattern) {
    auto& field = c.state.polygon_stipple.pattern;
    if (field && *field == pattern) return;
    begin_change(c);
    field = std::make_shared<const Stipple>(pattern);
}

void polygon_mode(Context& c, GLenum face, GLenum mode) {
    if (!is_face(face) || mode < GL_POINT || mode > GL_FILL) return set_error(c, GL_INVALID_ENUM);
    if (face != GL_BACK) change(c, c.state.polygon.front_mode, mode);
    if (face != GL_FRONT) change(c, c.state.polygon.back_mode, mode);
}

void polygon_offset(Context& c, GLfloat factor, GLfloat units) {
    change(c, c.state.polygon.offset_factor, float(finite(double(factor))));
    change(c, c.state.polygon.offset_units, float(finite(double(units))));
}

void polygon_offset_ext(Context& c, GLfloat factor, GLfloat bias) {
    const auto units = double((std::uint64_t{1} << c.profile.depth_bits) - 1);
    polygon_offset(c, factor, float(finite(double(bias) * units)));
}

}  // namespace execute

}  // namespace gw::gl
