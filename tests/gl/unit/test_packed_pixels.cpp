// Pixels packed into one number: EXT_packed_pixels, OpenGL 1.2's reversed types, EXT_packed_depth_stencil.
#include "tests/gl/unit/support/window.h"

#include <cmath>
#include <cstdint>

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;

template <class Number>
Color drawn(GLenum format, GLenum type, Number number) {
    const Window window;
    use_pixel_coordinates(window);
    glRasterPos2i(0, 0);
    glDrawPixels(1, 1, format, type, &number);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << type;
    return window.pixels()[0];
}

template <class Number>
Number read_back(GLenum format, GLenum type, const Color& color) {
    const Window window;
    use_pixel_coordinates(window);
    glRasterPos2i(0, 0);
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    std::array<Number, 2> memory{};
    glReadPixels(0, 0, 1, 1, format, type, memory.data());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << type;
    EXPECT_EQ(memory[1], 0) << type;
    return memory[0];
}

}  // namespace

/// [GL12] 3.6.4: the first component is in the highest bits, or reversed in the lowest.
TEST(GlPackedPixels, ComponentsHaveTheirBits) {
    const Color rgb{255, 0, 85, 255};  // 85: 1 of 3
    EXPECT_EQ(drawn<GLubyte>(GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 0b111'000'01), rgb);
    EXPECT_EQ(drawn<GLubyte>(GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, 0b01'000'111), rgb);
    const Color half{132, 0, 255, 255};  // 132: 16 of 31
    EXPECT_EQ(drawn<GLushort>(GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 16 << 11 | 31), half);
    EXPECT_EQ(drawn<GLushort>(GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, 31 << 11 | 16), half);
    const Color rgba{0x11, 0x22, 0x33, 0x44};
    EXPECT_EQ(drawn<GLushort>(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 0x1234), rgba);
    EXPECT_EQ(drawn<GLushort>(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, 0x4321), rgba);
    EXPECT_EQ(drawn<GLuint>(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, 0x11223344), rgba);
    EXPECT_EQ(drawn<GLuint>(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, 0x44332211), rgba);
    EXPECT_EQ(drawn<GLuint>(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, 0x44112233), rgba);
    EXPECT_EQ(drawn<GLuint>(GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8, 0x44332211), rgba);
    EXPECT_EQ(drawn<GLushort>(GL_ABGR_EXT, GL_UNSIGNED_SHORT_4_4_4_4_REV, 0x1234), rgba);
    const Color blue{0, 0, 255, 255};
    EXPECT_EQ(drawn<GLushort>(GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 31 << 1 | 1), blue);
    EXPECT_EQ(drawn<GLushort>(GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV, 1 << 15 | 31 << 10), blue);
    EXPECT_EQ(drawn<GLuint>(GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, 1023u << 2 | 3), blue);
    EXPECT_EQ(drawn<GLuint>(GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 3u << 30 | 1023 << 20), blue);
}

TEST(GlPackedPixels, ReadPixelsRoundsToNearest) {
    const Color color{255, 129, 0, 170};
    EXPECT_EQ(read_back<GLubyte>(GL_RGB, GL_UNSIGNED_BYTE_3_3_2, color), 0b111'100'00);
    EXPECT_EQ(read_back<GLushort>(GL_RGB, GL_UNSIGNED_SHORT_5_6_5, color), 31 << 11 | 32 << 5);
    EXPECT_EQ(read_back<GLushort>(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, color), 0xF80A);
    EXPECT_EQ(read_back<GLuint>(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, color), 0xFF8100AAu);
    EXPECT_EQ(read_back<GLuint>(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, color), 0xAAFF8100u);
    EXPECT_EQ(read_back<GLuint>(GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8, color), 0xAA0081FFu);
}

TEST(GlPackedPixels, SwappedBytesAreThoseOfTheNumber) {
    const Window window;
    use_pixel_coordinates(window);
    glRasterPos2i(0, 0);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 1);
    const std::array<GLushort, 2> numbers{0x3412, 0x7856};
    glDrawPixels(2, 1, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, numbers.data());
    EXPECT_EQ(window.pixels()[0], (Color{0x11, 0x22, 0x33, 0x44}));
    EXPECT_EQ(window.pixels()[1], (Color{0x55, 0x66, 0x77, 0x88}));
}

TEST(GlPackedPixels, TexturesTakeThem) {
    const Window window;
    const std::array<GLuint, 4> texels{0x44332211, 0x88776655, 0xCCBBAA99, 0x00FFEEDD};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV,
                 texels.data());
    std::array<GLuint, 4> got{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, got.data());
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(got, texels);
}

/// [GL12] table 3.8.
TEST(GlPackedPixels, FormatsMustHaveTheComponents) {
    const Window window;
    const GLuint number = 0;
    for (const auto& [format, type] :
         std::vector<std::pair<GLenum, GLenum>>{{GL_RGBA, GL_UNSIGNED_BYTE_3_3_2},
                                                {GL_BGR, GL_UNSIGNED_SHORT_5_6_5},
                                                {GL_ABGR_EXT, GL_UNSIGNED_SHORT_5_5_5_1},
                                                {GL_RGB, GL_UNSIGNED_INT_8_8_8_8},
                                                {GL_DEPTH_COMPONENT, GL_UNSIGNED_INT_8_8_8_8}}) {
        glDrawPixels(1, 1, format, type, &number);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION)) << format << ' ' << type;
    }
    glColorPointer(4, GL_UNSIGNED_INT_8_8_8_8, 0, &number);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
}

/// EXT_packed_depth_stencil: pairs are written through the masks, without tests, and copied so.
TEST(GlPackedPixels, DepthsAndStencilsAreWrittenTogether) {
    const Window window;
    use_pixel_coordinates(window);
    using Pairs = std::array<GLuint, 4>;
    const Pairs pairs{0x00000001, 0x40000080, 0x7FFFFF7F, 0xFFFFFFFF};
    const auto read = [](int x, int y) {
        Pairs out{};
        glReadPixels(x, y, 2, 2, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, out.data());
        return out;
    };
    // Every test would fail.
    for (const GLenum test : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_ALPHA_TEST}) glEnable(test);
    glDepthFunc(GL_NEVER);
    glStencilFunc(GL_NEVER, 0, 255);
    glStencilOp(GL_INCR, GL_INCR, GL_INCR);
    glAlphaFunc(GL_NEVER, 0);
    const auto before = window.pixels();
    glRasterPos2i(3, 4);
    glDrawPixels(2, 2, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pairs.data());
    EXPECT_EQ(read(3, 4), pairs);
    EXPECT_EQ(window.pixels(), before);
    glRasterPos2i(10, 11);
    glCopyPixels(3, 4, 2, 2, GL_DEPTH_STENCIL);
    EXPECT_EQ(read(10, 11), pairs);
    GLint func = 0;
    glGetIntegerv(GL_DEPTH_FUNC, &func);
    EXPECT_EQ(func, GL_NEVER);

    // Masks, transfer and zoom apply.
    glStencilMask(0x0F);
    glDepthMask(GL_FALSE);
    const Pairs ones{~0u, ~0u, ~0u, ~0u};
    glDrawPixels(2, 2, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, ones.data());
    EXPECT_EQ(read(10, 11), (Pairs{0x0000000F, 0x4000008F, 0x7FFFFF7F, 0xFFFFFFFF}));
    glStencilMask(~0u);
    glDepthMask(GL_TRUE);
    glPixelTransferf(GL_DEPTH_BIAS, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 2);
    glPixelZoom(2, 2);
    glRasterPos2i(20, 20);
    glDrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, pairs.data());
    glPixelTransferf(GL_DEPTH_BIAS, 0);
    glPixelTransferi(GL_INDEX_OFFSET, 0);
    EXPECT_EQ(read(20, 20), (Pairs{0xFFFFFF03, 0xFFFFFF03, 0xFFFFFF03, 0xFFFFFF03}));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

namespace {

/// A packed type's bits from the first component on, by [GL12] table 3.8.
struct Layout {
    GLenum type;
    std::size_t bytes;
    std::array<unsigned, 4> bits;
    bool is_reversed;
};
constexpr Layout layouts[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, {3, 3, 2, 0}, false},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, {3, 3, 2, 0}, true},
    {GL_UNSIGNED_SHORT_5_6_5, 2, {5, 6, 5, 0}, false},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, {5, 6, 5, 0}, true},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, {4, 4, 4, 4}, false},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, {4, 4, 4, 4}, true},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, {5, 5, 5, 1}, false},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, {5, 5, 5, 1}, true},
    {GL_UNSIGNED_INT_8_8_8_8, 4, {8, 8, 8, 8}, false},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, {8, 8, 8, 8}, true},
    {GL_UNSIGNED_INT_10_10_10_2, 4, {10, 10, 10, 2}, false},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, {10, 10, 10, 2}, true},
};

/// The channels R, G, B, A of the components of a format.
std::array<std::size_t, 4> channels_of(GLenum format) {
    if (format == GL_BGRA) return {2, 1, 0, 3};
    if (format == GL_ABGR_EXT) return {3, 2, 1, 0};
    return {0, 1, 2, 3};
}

/// Calls visit(component, shift) for each one.
template <class Visit>
void each_component(const Layout& layout, Visit visit) {
    unsigned below = 0, above = unsigned(8 * layout.bytes);
    for (std::size_t i = 0; i < 4 && layout.bits[i] != 0; ++i) {
        above -= layout.bits[i];
        visit(i, layout.is_reversed ? below : above);
        below += layout.bits[i];
    }
}

double largest(unsigned bits) { return double((1u << bits) - 1); }

/// 32 x 32 numbers of a layout.
std::vector<GLubyte> numbers(const Layout& layout) {
    std::vector<GLubyte> out(32 * 32 * layout.bytes);
    std::uint32_t state = 7;
    for (GLubyte& byte : out) byte = GLubyte((state = state * 1664525 + 1013904223) >> 24);
    return out;
}
std::uint32_t number_at(const Layout& layout, const std::vector<GLubyte>& from, std::size_t i) {
    std::uint32_t out = 0;
    for (std::size_t k = layout.bytes; k-- > 0;) out = out << 8 | from[i * layout.bytes + k];
    return out;
}

template <class Check>
void for_each_layout(Check check) {
    for (const Layout& layout : layouts)
        for (const GLenum format : {GL_RGB, GL_RGBA, GL_BGRA, GL_ABGR_EXT}) {
            const bool has_alpha = layout.bits[3] != 0;
            if (has_alpha != (format != GL_RGB)) continue;
            if (format == GL_ABGR_EXT && layout.bits[0] != layout.bits[3]) continue;
            SCOPED_TRACE(testing::Message() << std::hex << layout.type << " " << format);
            check(layout, format);
        }
}

}  // namespace

/// So many that tables convert them, with and without pixel transfer.
TEST(GlPackedPixels, ManyAreDrawnAsTheirComponents) {
    for_each_layout([](const Layout& layout, GLenum format) {
        const std::vector<GLubyte> pixels = numbers(layout);
        for (const float scale : {1.0f, 0.5f}) {
            const Window window(32, 32);
            use_pixel_coordinates(window);
            glPixelTransferf(GL_GREEN_SCALE, scale);
            glRasterPos2i(0, 0);
            glDrawPixels(32, 32, format, layout.type, pixels.data());
            glPixelTransferf(GL_GREEN_SCALE, 1);
            const auto drawn = window.pixels();
            for (std::size_t i = 0; i < drawn.size(); ++i) {
                std::array<double, 4> wanted{0, 0, 0, 1};
                each_component(layout, [&](std::size_t k, unsigned shift) {
                    const double most = largest(layout.bits[k]);
                    wanted[channels_of(format)[k]] =
                        double(number_at(layout, pixels, i) >> shift & unsigned(most)) / most;
                });
                wanted[1] *= double(scale);
                // Of 10 bits, halves are at hand; else the nearest value is the only one.
                for (std::size_t k = 0; k < 4; ++k)
                    ASSERT_LE(std::abs(wanted[k] * 255 - drawn[i][k]), 0.5001) << i << ' ' << k;
            }
        }
    });
}

TEST(GlPackedPixels, ManyAreReadAsTheirComponents) {
    for_each_layout([](const Layout& layout, GLenum format) {
        const Window window(32, 32);
        use_pixel_coordinates(window);
        const std::vector<GLubyte> colors = numbers({GL_UNSIGNED_BYTE, 4, {}, false});
        glRasterPos2i(0, 0);
        glDrawPixels(32, 32, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
        for (const GLint alignment : {1, 8}) {
            glPixelStorei(GL_PACK_ALIGNMENT, alignment);
            std::vector<GLubyte> read(32 * 32 * layout.bytes);
            glReadPixels(0, 0, 32, 32, format, layout.type, read.data());
            for (std::size_t i = 0; i < 32 * 32; ++i)
                each_component(layout, [&](std::size_t k, unsigned shift) {
                    const double most = largest(layout.bits[k]);
                    const double color = colors[4 * i + channels_of(format)[k]] / 255.0;
                    ASSERT_EQ(number_at(layout, read, i) >> shift & unsigned(most),
                              unsigned(std::floor(color * most + 0.5)))
                        << i << ' ' << k;
                });
        }
    });
}

TEST(GlPackedPixels, ManyTexelsAreReadAsTheirComponents) {
    for_each_layout([](const Layout& layout, GLenum format) {
        const Window window(4, 4);
        const std::vector<GLubyte> pixels = numbers(layout);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, 32, 32, 0, format, layout.type, pixels.data());
        std::vector<GLubyte> read(pixels.size());
        glGetTexImage(GL_TEXTURE_2D, 0, format, layout.type, read.data());
        EXPECT_EQ(read, pixels);
    });
}

TEST(GlPackedPixels, DepthsAndStencilsAreNoColors) {
    const Window window;
    GLuint memory[16]{};
    const auto error = [] { return glGetError(); };
    glDrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT, memory);
    EXPECT_EQ(error(), GLenum(GL_INVALID_ENUM));
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT_24_8, memory);
    EXPECT_EQ(error(), GLenum(GL_INVALID_OPERATION));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                 memory);
    EXPECT_EQ(error(), GLenum(GL_INVALID_OPERATION));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, memory);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_DEPTH_COMPONENT,
                 GL_UNSIGNED_INT_8_8_8_8, memory);
    EXPECT_EQ(error(), GLenum(GL_INVALID_OPERATION));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, memory);
    EXPECT_EQ(error(), GLenum(GL_INVALID_OPERATION));
}

}  // namespace gw::gl
