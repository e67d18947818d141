// Rectangles of pixels that are wider or higher than the machine's: [GL11] 3.6.4, 3.7, 4.3 have no
// largest size.
#include "tests/gl/unit/support/window.h"

#include <algorithm>

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;

constexpr int side = 32;

/// Moves the raster position, to places outside the window too.
void place(float x, float y) {
    glRasterPos2i(-1, -1);
    glBitmap(0, 0, 0, 0, x, y, nullptr);
}

/// The colour of a large image in column n and row m.
Color color_at(int n, int m) { return {GLubyte(n * 37), GLubyte(m * 101), GLubyte(n / 256), 255}; }

std::vector<Color> image(int width, int height) {
    std::vector<Color> out;
    for (int m = 0; m < height; ++m)
        for (int n = 0; n < width; ++n) out.push_back(color_at(n, m));
    return out;
}

struct Size {
    int width, height;
};
constexpr Size sizes[] = {{9001, 2}, {2, 9001}, {4097, 3}, {8192, 1}};
/// Pixels of the image at the window's corner: beside seams of pieces, and elsewhere.
constexpr int places[] = {0, 11, 4000, 4079, 4090, 4096, 8185, 8960};

/// For each size and place: the image is drawn so that its pixel (x, y) is at the window's corner.
template <class Draw, class Expected>
void expect_each(Draw draw, Expected expected) {
    const Window window(side, side);
    for (const Size& size : sizes)
        for (const int at : places) {
            const int x = size.width > side ? at : 0, y = size.height > side ? at : 0;
            if (x >= size.width || y >= size.height) continue;
            glClear(GL_COLOR_BUFFER_BIT);
            place(GLfloat(-x), GLfloat(-y));
            draw(size);
            const auto pixels = window.pixels();
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) {
                    const bool inside = x + i < size.width && y + j < size.height;
                    ASSERT_EQ(pixels[std::size_t(side * j + i)],
                              inside ? expected(x + i, y + j) : (Color{0, 0, 0, 0}))
                        << size.width << " x " << size.height << " at " << at;
                }
        }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(LargeRectangles, OfColoursAreDrawn) {
    expect_each(
        [](const Size& size) {
            glDrawPixels(size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                         image(size.width, size.height).data());
        },
        color_at);
}

TEST(LargeRectangles, OfColoursAreDrawnByLists) {
    expect_each(
        [](const Size& size) {
            glNewList(1, GL_COMPILE);
            glDrawPixels(size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                         image(size.width, size.height).data());
            glEndList();
            glCallList(1);
        },
        color_at);
}

TEST(LargeRectangles, OfBitsAreDrawn) {
    const auto bit = [](int n, int m) { return (n * 7 + m * 3) % 5 < 2; };
    expect_each(
        [&](const Size& size) {
            const int row = (size.width + 31) / 32 * 4;
            std::vector<GLubyte> bits(std::size_t(row) * std::size_t(size.height));
            for (int m = 0; m < size.height; ++m)
                for (int n = 0; n < size.width; ++n)
                    if (bit(n, m)) bits[std::size_t(row * m + n / 8)] |= GLubyte(0x80 >> n % 8);
            glBitmap(size.width, size.height, 0, 0, 0, 0, bits.data());
        },
        [&](int n, int m) {
            return bit(n, m) ? Color{255, 255, 255, 255} : Color{0, 0, 0, 0};
        });
}

/// Each value is drawn to the stencil plane, which the colours then show.
TEST(LargeRectangles, OfStencilValuesAreDrawn) {
    expect_each(
        [](const Size& size) {
            std::vector<GLubyte> values;
            for (const Color& color : image(size.width, size.height)) values.push_back(color[0]);
            glClear(GL_STENCIL_BUFFER_BIT);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glDrawPixels(size.width, size.height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE,
                         values.data());
            std::vector<GLubyte> stencils(side * side);
            std::vector<Color> colors(side * side, Color{0, 0, 0, 0});
            glReadPixels(0, 0, side, side, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
            std::vector<GLubyte> drawn(side * side, 0);
            for (std::size_t i = 0; i < stencils.size(); ++i) colors[i][0] = stencils[i];
            glRasterPos2i(-1, -1);
            glDrawPixels(side, side, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
        },
        [](int n, int m) {
            return Color{color_at(n, m)[0], 0, 0, 0};
        });
}

/// Columns of a zoomed image meet: none is left out at a seam, and none drawn twice.
TEST(LargeRectangles, MeetAtTheirSeamsUnderAnyZoom) {
    const Window window(64, 2);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    constexpr int width = 20000;
    const std::vector<Color> grey(width * 2, Color{100, 100, 100, 100});
    for (const GLfloat zoom : {0.003f, -0.003f, 0.0017f, 0.00321f, -0.00123f})
        for (const GLfloat x : {0.f, 0.3f, 20.7f, 63.9f}) {
            glClear(GL_COLOR_BUFFER_BIT);
            glPixelZoom(zoom, 1);
            place(x, 0);
            glDrawPixels(width, 2, GL_RGBA, GL_UNSIGNED_BYTE, grey.data());
            const double a = double(x), b = a + width * double(zoom);
            const auto pixels = window.pixels();
            for (int i = 0; i < 64; ++i) {
                const bool inside = i + 0.5 > std::min(a, b) && i + 0.5 < std::max(a, b);
                EXPECT_EQ(pixels[std::size_t(i)][0], inside ? 100 : 0)
                    << zoom << " " << x << " " << i;
            }
        }
}

TEST(LargeRectangles, AreCopiedAsFarAsTheyLieInTheWindow) {
    const Window window(side, side);
    const std::vector<Color> picture = image(side, side);
    for (const bool transfers : {false, true}) {
        place(0, 0);
        glDrawPixels(side, side, GL_RGBA, GL_UNSIGNED_BYTE, picture.data());
        glPixelTransferf(GL_RED_SCALE, transfers ? 0.f : 1.f);
        place(-6000 + 5, 3);
        glCopyPixels(-6000, -1, 8000, 9000, GL_COLOR);
        glPixelTransferf(GL_RED_SCALE, 1);
        const auto pixels = window.pixels();
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                Color expected = color_at(i, j);
                if (i >= 5 && j >= 4) {
                    expected = color_at(i - 5, j - 4);
                    if (transfers) expected[0] = 0;
                }
                ASSERT_EQ(pixels[std::size_t(side * j + i)], expected) << i << " " << j;
            }
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(LargeRectangles, AreReadAsFarAsTheyLieInTheWindow) {
    const Window window(side, side);
    place(0, 0);
    glDrawPixels(side, side, GL_RGBA, GL_UNSIGNED_BYTE, image(side, side).data());
    constexpr int width = 9000, height = 3;
    std::vector<Color> read(width * height);
    glReadPixels(-5000, -1, width, height, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    for (int i = 0; i < side; ++i)
        EXPECT_EQ(read[std::size_t(width + 5000 + i)], color_at(i, 0)) << i;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace gw::gl
