// A client of X11 and GLX for the tests: a display, windows, and the pixels that the server shows.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#define GLX_GLXEXT_PROTOTYPES
#include <GL/glx.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>

/// What a window or pixmap shows, top row first.
struct Shown {
    int width = 0, height = 0;
    std::vector<unsigned long> pixels;
    unsigned long at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    bool is_all(unsigned long pixel) const;
};

/// A test with a display of its own. X errors are collected, not fatal.
class Glx : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// The first configuration of the default visual.
    GLXFBConfig config(bool double_buffered) const;
    Window make_window(GLXFBConfig config, int width = 64, int height = 48);
    /// A context that is current on a new window.
    GLXContext make_current(bool double_buffered, int width = 64, int height = 48);

    Pixmap make_pixmap(int width, int height) const;
    /// Fills it as a client of X does, without OpenGL.
    void fill(Drawable drawable, unsigned long pixel, int width, int height) const;
    Shown shown(Drawable drawable, int width, int height) const;
    /// The pixel of a colour whose channels are 0 or 1.
    unsigned long pixel(bool r, bool g, bool b) const;

    /// The error codes that the calls of `action` raised.
    std::vector<int> errors_of(const std::function<void()>& action) const;
    int glx_error(int number) const;

    Display* display = nullptr;
    Window window = 0;
};

/// Clears the current drawable to a colour.
void clear_to(float r, float g, float b);
