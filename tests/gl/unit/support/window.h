// A context and a drawable for a test, current while it lives. GL's own functions draw to it.
#pragma once

#include "gl/context/context.h"
#include "gl/draw/finish.h"

#include <GL/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <vector>

namespace gw::gl {

class Window {
public:
    explicit Window(int width = 32, int height = 32, const Profile& profile = opengl(),
                    Buffers buffers = Buffers::Single, int samples = 0);
    ~Window() { make_current(nullptr, nullptr); }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    Context context;
    Drawable drawable;

    /// R, G, B, A of all pixels, by ReadPixels; bottom row first.
    std::vector<std::array<GLubyte, 4>> pixels() const;
    std::array<GLubyte, 4> pixel(int x, int y) const;
};

/// A projection in which object coordinates are pixels.
void use_pixel_coordinates(const Window& window);

}  // namespace gw::gl
