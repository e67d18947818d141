// DrawPixels, Bitmap, CopyPixels. [GL11] 3.6.4, 3.7, 4.3.3
#include "gl/api/calls.h"
#include "gl/context/context.h"
namespace gw::gl::execute {
void draw_pixels(Context& c, GLsizei, GLsizei, GLenum, GLenum, const HostImage&) {
    set_error(c, GL_INVALID_OPERATION);
}
void bitmap(Context& c, GLsizei, GLsizei, float, float, float, float, const HostImage&) {
    set_error(c, GL_INVALID_OPERATION);
}
void copy_pixels(Context& c, GLint, GLint, GLsizei, GLsizei, GLenum) {
    set_error(c, GL_INVALID_OPERATION);
}
}  // namespace gw::gl::execute
