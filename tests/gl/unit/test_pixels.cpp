// Pixel rectangles in the caller's memory and on the screen. [GL11] 3.6, 3.7, 4.3
#include "gl/entry/entry_points.h"

#include "tests/gl/unit/support/window.h"

#include <cmath>
#include <latch>
#include <thread>

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;

/// A window of coloured noise, drawn by DrawPixels.
std::vector<Color> noise(const Window& window) {
    std::vector<Color> out(32 * 32);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {GLubyte(i * 7), GLubyte(i * 13 + i / 32), GLubyte(i * 29), GLubyte(i * 3)};
    use_pixel_coordinates(window);
    glRasterPos2i(0, 0);
    glDrawPixels(32, 32, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

}  // namespace

TEST(GlPixels, EveryFormatAndTypeReadsBackWhatItDraws) {
    for (const GLenum type : {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT,
                              GL_UNSIGNED_INT, GL_INT, GL_FLOAT})
        for (const GLenum format : {GL_RGBA, GL_BGRA, GL_ABGR_EXT}) {
            const Window window;
            const auto pixels = noise(window);
            EXPECT_EQ(window.pixels(), pixels);
            std::vector<GLubyte> memory(32 * 32 * 16);
            glReadPixels(0, 0, 32, 32, format, type, memory.data());
            glClear(GL_COLOR_BUFFER_BIT);
            glDrawPixels(32, 32, format, type, memory.data());
            EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
            if (type == GL_BYTE) continue;  // seven bits
            EXPECT_EQ(window.pixels(), pixels) << type;
        }
}

TEST(GlPixels, BytesOfEveryFormatAreChannels) {
    const std::vector<std::pair<GLenum, std::vector<std::size_t>>> formats{
        {GL_RGBA, {0, 1, 2, 3}},
        {GL_BGRA, {2, 1, 0, 3}},
        {GL_RGB, {0, 1, 2}},
        {GL_BGR, {2, 1, 0}},
        {GL_ABGR_EXT, {3, 2, 1, 0}},
        {GL_RED, {0}},
        {GL_BLUE, {2}},
        {GL_ALPHA, {3}}};
    const Window window;
    const auto pixels = noise(window);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (const auto& [format, channels] : formats)
        for (const std::size_t first : {0, 1})  // where words are aligned, and where they are not
            for (const int x : {0, 8, -8}) {    // also beyond the window
                alignas(4) std::array<GLubyte, 24 * 32 * 4 + 1> memory{};
                glReadPixels(x, 0, 24, 32, format, GL_UNSIGNED_BYTE, memory.data() + first);
                const GLubyte* at = memory.data() + first;
                for (int i = 0; i < 24 * 32; ++i)
                    for (const std::size_t channel : channels) {
                        const int column = x + i % 24, index = i / 24 * 32 + column;
                        ASSERT_EQ(*at++, column < 0 ? 0 : pixels[std::size_t(index)][channel])
                            << format << " at " << column << " " << i / 24;
                    }
            }
}

TEST(GlPixels, BytesOfEveryFormatAreDrawn) {
    const std::vector<std::pair<GLenum, Color>> formats{{GL_RGB, {10, 90, 200, 255}},
                                                        {GL_BGR, {200, 90, 10, 255}},
                                                        {GL_BGRA, {200, 90, 10, 40}},
                                                        {GL_ABGR_EXT, {40, 200, 90, 10}},
                                                        {GL_LUMINANCE_ALPHA, {10, 10, 10, 90}},
                                                        {GL_LUMINANCE, {10, 10, 10, 255}},
                                                        {GL_GREEN, {0, 10, 0, 255}}};
    const std::array<GLubyte, 4> components{10, 90, 200, 40};
    for (const auto& [format, expected] : formats) {
        const Window window;
        use_pixel_coordinates(window);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        const std::size_t count = format == GL_BGRA || format == GL_ABGR_EXT ? 4
                                  : format == GL_RGB || format == GL_BGR     ? 3
                                  : format == GL_LUMINANCE_ALPHA             ? 2
                                                                             : 1;
        std::vector<GLubyte> bytes;
        for (std::size_t i = 0; i < 27 * 25 * count; ++i) bytes.push_back(components[i % count]);
        glRasterPos2i(3, 2);
        glDrawPixels(27, 25, format, GL_UNSIGNED_BYTE, bytes.data());
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const bool is_inside = x >= 3 && x < 30 && y >= 2 && y < 27;
                ASSERT_EQ(window.pixel(x, y), is_inside ? expected : Color{}) << format;
            }
    }
}

TEST(GlPixels, StorageSkipsAlignsAndSwaps) {
    const Window window;
    const auto pixels = noise(window);
    std::array<GLubyte, 400> memory{};
    glPixelStorei(GL_PACK_ROW_LENGTH, 7);
    glPixelStorei(GL_PACK_SKIP_ROWS, 2);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glReadPixels(4, 5, 3, 2, GL_RGB, GL_UNSIGNED_BYTE, memory.data());
    std::array<GLubyte, 400> expected{};
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 3; ++x)
            for (std::size_t k = 0; k < 3; ++k)  // 7 * 3 bytes are 24 with their padding
                expected[(y + 2) * 24 + (x + 3) * 3 + k] = pixels[(y + 5) * 32 + x + 4][k];
    EXPECT_EQ(memory, expected);
    for (GLenum i = 0; i < 6; ++i) glPixelStorei(GL_PACK_SWAP_BYTES + i, i == 5 ? 1 : i == 0);
    std::array<GLushort, 1> word{};
    glReadPixels(4, 5, 1, 1, GL_RED, GL_UNSIGNED_SHORT, word.data());
    const int red = pixels[5 * 32 + 4][0] * 257;
    EXPECT_EQ(int(word[0]), (red & 255) << 8 | red >> 8);
}

TEST(GlPixels, BitmapsDrawTheirBitsAndMoveTheRasterPosition) {
    for (const int lsb_first : {0, 1}) {
        const Window window;
        use_pixel_coordinates(window);
        glPixelStorei(GL_UNPACK_LSB_FIRST, lsb_first);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
        const GLubyte bits[] = {0x93, 0xC5, 0x3A, 0x77};
        glRasterPos2i(10, 12);
        glBitmap(9, 2, 2, 1, 5.5f, -3, bits);
        std::array<GLfloat, 4> raster{};
        glGetFloatv(GL_CURRENT_RASTER_POSITION, raster.data());
        EXPECT_EQ(raster[0], 15.5f);
        EXPECT_EQ(raster[1], 9);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const int column = x - 8, row = y - 11;
                bool expected = false;
                if (column >= 0 && column < 9 && row >= 0 && row < 2) {
                    const int bit = column + 3, byte = bits[2 * row + bit / 8];
                    expected = (byte >> (lsb_first ? bit % 8 : 7 - bit % 8) & 1) != 0;
                }
                EXPECT_EQ(window.pixel(x, y)[0], expected ? 255 : 0) << x << " " << y;
            }
    }
}

/// [GL11] 4.3.2: components are clamped at the end, floats too.
TEST(GlPixels, BitmapsAtWholePixelsAreNotOneOff) {
    constexpr GLubyte row = 0x80;
    for (const int height : {32, 48, 75, 120, 240, 300}) {
        Window window(2, height);
        use_pixel_coordinates(window);
        for (int y = 0; y < height; ++y) {
            glRasterPos2i(1, y);
            glBitmap(1, 1, 0, 0, 0, 0, &row);
            EXPECT_EQ(window.pixel(1, y)[0], 255) << y << " of " << height;
        }
    }
}

TEST(GlPixels, LuminanceIsTheSumOfColoursUpTo1) {
    const Window window;
    glClearColor(0.25f, 0.5f, 0.125f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT);
    std::array<GLfloat, 2> out{};
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE_ALPHA, GL_FLOAT, out.data());
    EXPECT_NEAR(out[0], 0.875, 0.01);
    EXPECT_NEAR(out[1], 0.5, 0.01);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glReadPixels(0, 0, 1, 1, GL_LUMINANCE_ALPHA, GL_FLOAT, out.data());
    EXPECT_EQ(out[0], 1);
}

/// GL_ARB_window_pos, GL_MESA_window_pos
TEST(GlPixels, WindowPosTakesWindowCoordinatesAndCurrentValues) {
    const Window window;
    glTranslatef(5, 6, 7);
    glEnable(GL_LIGHTING);
    glDepthRange(0.25, 0.75);
    glColor4f(0.5f, 2, 0, 1);
    glTexCoord2f(3, 4);
    using Four = std::array<GLfloat, 4>;
    const auto value = [](GLenum name) {
        Four out{};
        glGetFloatv(name, out.data());
        return out;
    };
    const auto call = reinterpret_cast<void(GLAPIENTRY*)(GLdouble, GLdouble, GLdouble)>(
        find_entry_point("glWindowPos3dARB"));
    ASSERT_NE(call, nullptr);
    call(-3, 1.5, 0.5);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION), (Four{-3, 1.5f, 0.5f, 1}));
    EXPECT_EQ(value(GL_CURRENT_RASTER_COLOR), (Four{0.5f, 1, 0, 1}));
    EXPECT_EQ(value(GL_CURRENT_RASTER_TEXTURE_COORDS), (Four{3, 4, 0, 1}));
    EXPECT_EQ(value(GL_CURRENT_RASTER_DISTANCE)[0], 0);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION_VALID)[0], 1);
    call(1, 2, -9);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION)[2], 0.25f);
    call(1, 2, 9);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION)[2], 0.75f);
    const auto from_shorts =
        reinterpret_cast<void(GLAPIENTRY*)(const GLshort*)>(find_entry_point("glWindowPos2svARB"));
    const std::array<GLshort, 2> shorts{7, -8};
    from_shorts(shorts.data());
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION), (Four{7, -8, 0.25f, 1}));
    const auto with_w = reinterpret_cast<void(GLAPIENTRY*)(GLfloat, GLfloat, GLfloat, GLfloat)>(
        find_entry_point("glWindowPos4fMESA"));
    with_w(3, 2, 1, 0.5f);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION), (Four{3, 2, 0.75f, 0.5f}));
    call(std::nan(""), 0, 0);
    EXPECT_EQ(value(GL_CURRENT_RASTER_POSITION_VALID)[0], 0);
}

TEST(GlPixels, AnInvalidRasterPositionDrawsNothing) {
    const Window window;
    use_pixel_coordinates(window);
    const auto before = window.pixels();
    glRasterPos2i(-1, 5);
    GLboolean valid = GL_TRUE;
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    EXPECT_EQ(valid, GL_FALSE);
    const std::vector<Color> white(64, Color{255, 255, 255, 255});
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    glBitmap(8, 8, 0, 0, 4, 4, white[0].data());
    EXPECT_EQ(window.pixels(), before);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlPixels, DepthAndStencilRectangles) {
    const Window window;
    use_pixel_coordinates(window);
    const GLuint depths[] = {0, 0x40000000, 0x80000000, 0xFFFFFFFF};
    const GLubyte stencils[] = {1, 2, 254, 255};
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glRasterPos2i(3, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glDrawPixels(2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glDrawPixels(2, 2, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths);
    std::array<GLubyte, 4> read{};
    glReadPixels(3, 4, 2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read, (std::array<GLubyte, 4>{1, 2, 254, 255}));
    std::array<GLbyte, 4> low_bits{};  // without the sign
    glReadPixels(3, 4, 2, 2, GL_STENCIL_INDEX, GL_BYTE, low_bits.data());
    EXPECT_EQ(low_bits, (std::array<GLbyte, 4>{1, 2, 126, 127}));
    std::array<GLubyte, 4> high{};
    glReadPixels(3, 4, 2, 2, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, high.data());
    EXPECT_EQ(high, (std::array<GLubyte, 4>{0, 64, 128, 255}));
}

TEST(GlPixels, TransferScalesBiasesAndMaps) {
    const Window window;
    const auto pixels = noise(window);
    glPixelTransferf(GL_RED_SCALE, 0);
    glPixelTransferf(GL_RED_BIAS, 1);
    const GLfloat inverse[] = {1, 0};
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 2, inverse);
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, inverse);
    EXPECT_EQ(window.pixel(4, 5), (Color{255, pixels[164][1], pixels[164][2], pixels[164][3]}));
    glPixelTransferi(GL_MAP_COLOR, GL_TRUE);
    EXPECT_EQ(window.pixel(4, 5), (Color{0, GLubyte(pixels[164][1] < 128 ? 255 : 0), 0, 0}));
}

TEST(GlPixels, CopiesAndZoomReadFromTheScreen) {
    const Window window;
    const auto pixels = noise(window);
    glRasterPos2i(20, 20);
    glCopyPixels(2, 3, 4, 4, GL_COLOR);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(window.pixel(20 + x, 20 + y), pixels[std::size_t((3 + y) * 32 + 2 + x)]);
    glPixelZoom(2, 3);
    glRasterPos2i(10, 10);
    glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(window.pixel(10 + x, 10 + y), pixels[std::size_t(y / 3 * 2 + x / 2)]);
}

/// Each thread adds its colour inside its own scissor box. No rectangle is drawn with the other
/// thread's state.
TEST(GlPixels, RectanglesOfTwoThreadsKeepTheirState) {
    Window window;
    make_current(nullptr, nullptr);
    std::latch both_ready(2);
    const auto draw = [&](Context& context, int left, const Color& color) {
        make_current(&context, &window.drawable);
        glEnable(GL_SCISSOR_TEST);
        glScissor(left, 0, 16, 32);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glRasterPos2f(-0.25f, 0);  // pixels 12 .. 27 of row 16 and above
        const std::vector<Color> dots(256, color);
        both_ready.arrive_and_wait();
        for (int i = 0; i < 2000; ++i) glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, dots.data());
        make_current(nullptr, nullptr);
    };
    Context left(opengl()), right(opengl());
    std::thread first([&] { draw(left, 0, {1, 0, 0, 0}); });
    std::thread second([&] { draw(right, 16, {0, 1, 0, 0}); });
    first.join();
    second.join();
    make_current(&window.context, &window.drawable);
    for (int x = 12; x < 28; ++x)
        EXPECT_EQ(window.pixel(x, 16), (x < 16 ? Color{255, 0, 0, 0} : Color{0, 255, 0, 0})) << x;
}

}  // namespace gw::gl
