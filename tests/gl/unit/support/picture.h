// The planes of a small window after drawing, to compare two ways of drawing bit for bit.
#pragma once

#include "tests/gl/unit/support/window.h"

#include <cstdint>
#include <vector>

namespace gw::gl {

struct Picture {
    std::vector<GLubyte> color;
    std::vector<GLuint> depth;
    std::vector<GLubyte> stencil;
    bool operator==(const Picture&) const = default;
    friend std::ostream& operator<<(std::ostream& out, const Picture&) { return out << "picture"; }
};

/// The planes of the current drawable, by ReadPixels.
Picture picture_of(const Window& window);

/// What `draw` draws in a window of its own, in which object coordinates are pixels.
template <class Draw>
Picture drawn(Draw draw) {
    const Window window;
    use_pixel_coordinates(window);
    draw();
    return picture_of(window);
}

/// What a window shows before anything is drawn.
Picture blank();

/// Two ways of drawing give the same planes, and draw something.
template <class A, class B>
void expect_same_picture(A a, B b) {
    const Picture first = drawn(a);
    EXPECT_EQ(first, drawn(b));
    EXPECT_NE(first, blank());
}

}  // namespace gw::gl
