#include "tests/gl/unit/support/window.h"

namespace gw::gl {

Window::Window(int width, int height, const Profile& profile, Buffers buffers, int samples)
    : context(profile), drawable(profile, width, height, "window", buffers, samples) {
    make_current(&context, &drawable);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

std::vector<std::array<GLubyte, 4>> Window::pixels() const {
    std::vector<std::array<GLubyte, 4>> out(std::size_t(drawable.width()) *
                                            std::size_t(drawable.height()));
    glReadPixels(0, 0, drawable.width(), drawable.height(), GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

std::array<GLubyte, 4> Window::pixel(int x, int y) const {
    std::array<GLubyte, 4> out{};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

void use_pixel_coordinates(const Window& window) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, window.drawable.width(), 0, window.drawable.height(), -1, 1);
    glMatrixMode(GL_MODELVIEW);
}

}  // namespace gw::gl
