#include "tests/gl/unit/support/picture.h"

namespace gw::gl {

Picture picture_of(const Window& window) {
    const int width = window.drawable.width(), height = window.drawable.height();
    const auto area = std::size_t(width) * std::size_t(height);
    Picture out{std::vector<GLubyte>(4 * area), std::vector<GLuint>(area),
                std::vector<GLubyte>(area)};
    glPushAttrib(GL_PIXEL_MODE_BIT);
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    for (const GLenum name : {GL_PACK_SWAP_BYTES, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                              GL_PACK_SKIP_PIXELS, GL_PACK_LSB_FIRST})
        glPixelStorei(name, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, out.color.data());
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, out.depth.data());
    glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, out.stencil.data());
    glPopClientAttrib();
    glPopAttrib();
    return out;
}

Picture blank() {
    return drawn([] {});
}

}  // namespace gw::gl
