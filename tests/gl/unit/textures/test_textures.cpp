// Texture objects, images and completeness. [GL11] 3.8
#include "gl/entry/entry_points.h"

#include "tests/gl/unit/support/window.h"

#include <thread>

namespace gw::gl {
namespace {

using Color = std::array<GLubyte, 4>;

void image_1x1(GLint format, const Color& color) {
    glTexImage2D(GL_TEXTURE_2D, 0, format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

GLint level_value(GLenum name, GLint level = 0) {
    GLint out = -1;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level, name, &out);
    return out;
}

/// A pixel of a textured square.
Color textured(const Window& window) {
    use_pixel_coordinates(window);
    glEnable(GL_TEXTURE_2D);
    glRecti(0, 0, 32, 32);
    return window.pixel(5, 5);
}

GLint proxy_width() {
    GLint width = -1;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    return width;
}

}  // namespace

TEST(GlTextures, EveryInternalFormatKeepsTheComponentsOfItsBaseFormat) {
    struct Formats {
        std::vector<GLint> names;
        Color read;     ///< by GetTexImage, of (50, 100, 150, 200)
        Color replace;  ///< over white
    };
    const Formats table[] = {
        {{GL_ALPHA, GL_ALPHA4, GL_ALPHA8, GL_ALPHA12, GL_ALPHA16},
         {0, 0, 0, 200},
         {255, 255, 255, 200}},
        {{1, GL_LUMINANCE, GL_LUMINANCE4, GL_LUMINANCE8, GL_LUMINANCE12, GL_LUMINANCE16},
         {50, 0, 0, 255},
         {50, 50, 50, 255}},
        {{2, GL_LUMINANCE_ALPHA, GL_LUMINANCE4_ALPHA4, GL_LUMINANCE6_ALPHA2, GL_LUMINANCE8_ALPHA8,
          GL_LUMINANCE12_ALPHA4, GL_LUMINANCE12_ALPHA12, GL_LUMINANCE16_ALPHA16},
         {50, 0, 0, 200},
         {50, 50, 50, 200}},
        {{GL_INTENSITY, GL_INTENSITY4, GL_INTENSITY8, GL_INTENSITY12, GL_INTENSITY16},
         {50, 0, 0, 255},
         {50, 50, 50, 50}},
        {{3, GL_RGB, GL_R3_G3_B2, GL_RGB4, GL_RGB5, GL_RGB8, GL_RGB10, GL_RGB12, GL_RGB16},
         {50, 100, 150, 255},
         {50, 100, 150, 255}},
        {{4, GL_RGBA, GL_RGBA2, GL_RGBA4, GL_RGB5_A1, GL_RGBA8, GL_RGB10_A2, GL_RGBA12, GL_RGBA16},
         {50, 100, 150, 200},
         {50, 100, 150, 200}}};
    for (const Formats& formats : table)
        for (const GLint name : formats.names) {
            const Window window;
            image_1x1(name, {50, 100, 150, 200});
            EXPECT_EQ(level_value(GL_TEXTURE_INTERNAL_FORMAT), name);
            Color read{};
            glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
            EXPECT_EQ(read, formats.read) << name;
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            EXPECT_EQ(textured(window), formats.replace) << name;
        }
}

TEST(GlTextures, IncompleteTexturesAreAsIfTexturingWereOff) {
    const Window window;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(textured(window), (Color{255, 255, 255, 255}));  // no level 1
    const GLubyte red[] = {255, 0, 0};
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, red);
    EXPECT_EQ(textured(window), (Color{255, 255, 255, 255}));  // of another format
    glTexImage2D(GL_TEXTURE_2D, 1, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, red);
    EXPECT_EQ(textured(window), (Color{0, 0, 0, 255}));
}

TEST(GlTextures, ZeroSizesAreNoImageAndSizesThatTheProfileLacksAreErrors) {
    const auto expect = [](GLsizei width, GLsizei height, GLint border, GLenum error) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, width, height, border, GL_RGB, GL_UNSIGNED_BYTE,
                     nullptr);
        EXPECT_EQ(glGetError(), error) << width << " " << height << " " << border;
    };
    for (const Profile& profile : {opengl(), vgx()}) {
        const Window window(8, 8, profile);
        const GLenum of_any = profile.extensions.texture_sizes ? GL_NO_ERROR : GL_INVALID_VALUE;
        expect(8, 4, 0, GL_NO_ERROR);
        expect(10, 6, 1, GL_NO_ERROR);
        expect(0, 4, 0, GL_NO_ERROR);
        EXPECT_EQ(level_value(GL_TEXTURE_WIDTH), 0);
        expect(6, 4, 0, of_any);
        expect(9, 6, 1, of_any);
        expect(8192, 1, 0, of_any);
        expect(16384, 1, 0, GL_INVALID_VALUE);
        expect(2, 4, 1, GL_INVALID_VALUE);  // nothing inside the border
        expect(-1, 1, 0, GL_INVALID_VALUE);
        expect(4, 4, 2, GL_INVALID_VALUE);
    }
}

TEST(GlTextures, ErrorsReadNoMemory) {
    const Window window;
    const GLubyte one[4] = {1, 2, 3, 4};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1 << 30, 1 << 30, 0, GL_RGBA, GL_UNSIGNED_BYTE, one);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 4096, 4096, 0, GL_RGBA, GL_UNSIGNED_BYTE, one);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glDrawPixels(1 << 30, 1 << 30, GL_RGBA, GL_UNSIGNED_BYTE, one);
    EXPECT_EQ(glGetError(), GLenum(GL_OUT_OF_MEMORY));
}

/// Bytes take a short way unless the transfer changes them.
TEST(GlTextures, BytesOfAllFormatsAreTheirColours) {
    const Window window;
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    struct Row {
        GLenum format;
        std::size_t size;
        std::array<int, 4> place;  // -1: 0, -2: 1
    };
    constexpr Row rows[] = {{GL_RGBA, 4, {0, 1, 2, 3}},
                            {GL_BGRA, 4, {2, 1, 0, 3}},
                            {GL_ABGR_EXT, 4, {3, 2, 1, 0}},
                            {GL_RGB, 3, {0, 1, 2, -2}},
                            {GL_BGR, 3, {2, 1, 0, -2}},
                            {GL_LUMINANCE, 1, {0, 0, 0, -2}},
                            {GL_LUMINANCE_ALPHA, 2, {0, 0, 0, 1}},
                            {GL_ALPHA, 1, {-1, -1, -1, 0}},
                            {GL_GREEN, 1, {-1, 0, -1, -2}}};
    for (const Row& row : rows) {
        std::vector<GLubyte> bytes(64 * row.size);
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = GLubyte(7 * i + 3);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, 8, 8, 0, row.format, GL_UNSIGNED_BYTE,
                     bytes.data());
        std::array<std::array<GLushort, 4>, 64> texels{};
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, texels.data());
        for (std::size_t i = 0; i < 64; ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const int place = row.place[k];
                const int expected = place < 0 ? (place == -2 ? 65535 : 0)
                                               : 257 * bytes[i * row.size + std::size_t(place)];
                EXPECT_EQ(texels[i][k], expected) << row.format << " " << i << " " << k;
            }
    }
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    const std::array<GLubyte, 4> one{200, 100, 50, 25};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, one.data());
    std::array<GLushort, 4> texel{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, texel.data());
    EXPECT_EQ(texel, (std::array<GLushort, 4>{25700, 25700, 12850, 6425}));
}

/// [GL11] 6.1.4
TEST(GlTextures, GetTexImageHasNoTransferAndLuminanceIsRed) {
    const Window window;
    const std::array<GLfloat, 4> given{0.5f, 0.25f, 0.125f, 0.75f};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_FLOAT, given.data());
    glPixelTransferf(GL_RED_BIAS, 0.5f);
    std::array<GLubyte, 4> out{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    EXPECT_EQ(out, (std::array<GLubyte, 4>{128, 64, 32, 191}));
    glGetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, out.data());
    EXPECT_EQ(out[0], 128);
    EXPECT_EQ(out[1], 191);
}

/// [GL11] 3.8.6
TEST(GlTextures, AProxyIsZeroedByWhatIsTooLargeAndKeptByErrors) {
    const Window window;
    const auto ask = [](GLint level, GLsizei width, GLint border) {
        glTexImage2D(GL_PROXY_TEXTURE_2D, level, GL_RGBA, width, 8, border, GL_RGBA,
                     GL_UNSIGNED_BYTE, nullptr);
        return glGetError();
    };
    EXPECT_EQ(ask(0, 8, 0), GLenum(GL_NO_ERROR));
    EXPECT_EQ(ask(5555, 8, 0), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(ask(0, -8, 0), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(ask(0, 8, 2), GLenum(GL_INVALID_VALUE));
    EXPECT_EQ(proxy_width(), 8);
    EXPECT_EQ(ask(0, 16384, 0), GLenum(GL_NO_ERROR));
    EXPECT_EQ(proxy_width(), 0);
}

TEST(GlTextures, ObjectsAreNamedBoundAndDeleted) {
    const Window window;
    std::array<GLuint, 3> names{};
    glGenTextures(3, names.data());
    EXPECT_FALSE(glIsTexture(names[0]));  // reserved, no object yet
    glBindTexture(GL_TEXTURE_2D, names[0]);
    EXPECT_TRUE(glIsTexture(names[0]));
    glBindTexture(GL_TEXTURE_1D, names[0]);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    image_1x1(GL_RGB, {9, 9, 9, 9});
    glDeleteTextures(3, names.data());
    GLint bound = -1;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 0);
    EXPECT_EQ(level_value(GL_TEXTURE_WIDTH), 0);
    EXPECT_FALSE(glIsTexture(names[0]));
    glBindTexture(GL_TEXTURE_2D, names[0]);
    EXPECT_EQ(level_value(GL_TEXTURE_WIDTH), 0);
}

TEST(GlTextures, SubImagesCountFromInsideTheBorder) {
    const Window window;
    std::array<Color, 36> image{}, read{};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    const std::array<Color, 2> part{{{1, 2, 3, 4}, {5, 6, 7, 8}}};
    glTexSubImage2D(GL_TEXTURE_2D, 0, -1, 2, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    image[18] = part[0];
    image[19] = part[1];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read, image);
    glTexSubImage2D(GL_TEXTURE_2D, 0, -2, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

/// GL_EXT_subtexture and GL_EXT_copy_texture, as programs before OpenGL 1.1 have them.
TEST(GlTextures, ExtensionsReplaceAndCopyParts) {
    const Window window;
    const auto function = [](auto* same, const char* name) {
        return reinterpret_cast<decltype(same)>(find_entry_point(name));
    };
    const std::array<Color, 4> image{};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    const Color texel{1, 2, 3, 4};
    function(&glTexSubImage2D, "glTexSubImage2DEXT")(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA,
                                                     GL_UNSIGNED_BYTE, &texel);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    function(&glCopyTexSubImage2D, "glCopyTexSubImage2DEXT")(GL_TEXTURE_2D, 0, 1, 1, 0, 0, 1, 1);
    std::array<Color, 4> read{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read, (std::array<Color, 4>{texel, {}, {}, {255, 255, 255, 255}}));
    function(&glCopyTexImage2D, "glCopyTexImage2DEXT")(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 4, 2, 0);
    EXPECT_EQ(level_value(GL_TEXTURE_WIDTH), 4);
}

/// A thread sees what another one's context changed when it binds the object again.
TEST(GlTextures, BindTextureTakesTheChangesOfOtherContexts) {
    const Window window;
    Context other(opengl(), window.context.shared);
    use_pixel_coordinates(window);
    const std::array<Color, 2> texels{Color{255, 0, 0, 255}, Color{0, 255, 0, 255}};
    glBindTexture(GL_TEXTURE_2D, 7);
    image_1x1(GL_RGBA, texels[0]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
    glTexCoord2f(1.25f, 0);
    const auto drawn = [&] {
        glRecti(0, 0, 32, 32);
        return window.pixel(5, 5);
    };
    EXPECT_EQ(drawn(), texels[0]);
    std::thread([&] {
        make_current(&other, nullptr);
        glBindTexture(GL_TEXTURE_2D, 7);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        make_current(nullptr, nullptr);
    }).join();
    glBindTexture(GL_TEXTURE_2D, 7);
    EXPECT_EQ(drawn(), texels[1]);
    std::thread([&] {
        make_current(&other, nullptr);
        const GLuint name = 7;
        glDeleteTextures(1, &name);
        make_current(nullptr, nullptr);
    }).join();
    glBindTexture(GL_TEXTURE_2D, 7);
    GLint wrap = 0;
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
    EXPECT_EQ(wrap, GL_REPEAT);
}

/// Scale, bias and maps apply to uploads and to copies from the drawable.
TEST(GlTextures, CopiesFromTheDrawableAreTransferred) {
    const Window window;
    glClearColor(0.2f, 0.4f, 0.6f, 0.8f);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::array<GLfloat, 2> swapped{1, 0};
    for (const GLenum map : {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B})
        glPixelMapfv(map, 2, swapped.data());
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 2, swapped.data());
    glPixelTransferi(GL_MAP_COLOR, 1);
    glPixelTransferf(GL_GREEN_BIAS, 0.5f);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 2, 2, 0);
    std::array<std::array<GLubyte, 4>, 4> read{};
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    for (const auto& texel : read) EXPECT_EQ(texel, (std::array<GLubyte, 4>{255, 0, 0, 0}));
}

TEST(GlTextures, CopiesGoIntoAPart) {
    const Window window;
    use_pixel_coordinates(window);
    const std::vector<GLubyte> black(4 * 8 * 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, black.data());
    glColor3ub(10, 20, 30);
    glRecti(5, 6, 6, 7);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 1, 4, 5, 3, 2);  // the rectangle is its pixel 1, 1
    std::vector<std::array<GLubyte, 4>> read(8 * 4);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const bool is_copied = i / 8 == 2 && i % 8 == 4;
        EXPECT_EQ(read[i][2], is_copied ? 30 : 0) << i;
    }
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 6, 1, 0, 0, 3, 1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

/// [GL11] tables 3.18 and 3.19, of texel (0.2, 0.4, 0.6, 0.8), fragment (1, 0.6, 0.4, 0.4) and
/// environment colour (0, 1, 1, 0.2); the formats keep R, R A, A, R, RGB, RGBA.
TEST(GlTextures, EnvironmentsOfEveryBaseFormat) {
    struct Row {
        GLint format;
        GLint mode;
        std::array<double, 4> color;
    };
    constexpr Row rows[] = {
        {GL_ALPHA, GL_REPLACE, {1, 0.6, 0.4, 0.8}},
        {GL_ALPHA, GL_MODULATE, {1, 0.6, 0.4, 0.32}},
        {GL_ALPHA, GL_BLEND, {1, 0.6, 0.4, 0.32}},
        {GL_LUMINANCE, GL_REPLACE, {0.2, 0.2, 0.2, 0.4}},
        {GL_LUMINANCE, GL_MODULATE, {0.2, 0.12, 0.08, 0.4}},
        {GL_LUMINANCE, GL_BLEND, {0.8, 0.68, 0.52, 0.4}},
        {GL_LUMINANCE_ALPHA, GL_REPLACE, {0.2, 0.2, 0.2, 0.8}},
        {GL_LUMINANCE_ALPHA, GL_MODULATE, {0.2, 0.12, 0.08, 0.32}},
        {GL_LUMINANCE_ALPHA, GL_BLEND, {0.8, 0.68, 0.52, 0.32}},
        {GL_INTENSITY, GL_REPLACE, {0.2, 0.2, 0.2, 0.2}},
        {GL_INTENSITY, GL_MODULATE, {0.2, 0.12, 0.08, 0.08}},
        {GL_INTENSITY, GL_BLEND, {0.8, 0.68, 0.52, 0.36}},
        {GL_RGB, GL_REPLACE, {0.2, 0.4, 0.6, 0.4}},
        {GL_RGB, GL_MODULATE, {0.2, 0.24, 0.24, 0.4}},
        {GL_RGB, GL_DECAL, {0.2, 0.4, 0.6, 0.4}},
        {GL_RGB, GL_BLEND, {0.8, 0.76, 0.76, 0.4}},
        {GL_RGBA, GL_REPLACE, {0.2, 0.4, 0.6, 0.8}},
        {GL_RGBA, GL_MODULATE, {0.2, 0.24, 0.24, 0.32}},
        {GL_RGBA, GL_DECAL, {0.36, 113 / 255.0, 142 / 255.0, 0.4}},  // two rounded products
        {GL_RGBA, GL_BLEND, {0.8, 0.76, 0.76, 0.32}},
    };
    const Window window;
    const std::array<GLubyte, 4> texel{51, 102, 153, 204};
    const std::array<GLfloat, 4> environment{0, 1, 1, 0.2f};
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, environment.data());
    glEnable(GL_TEXTURE_2D);
    glColor4f(1, 0.6f, 0.4f, 0.4f);
    for (const Row& row : rows) {
        glTexImage2D(GL_TEXTURE_2D, 0, row.format, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     texel.data());
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, row.mode);
        glRecti(-1, -1, 1, 1);
        const auto pixel = window.pixel(9, 9);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_EQ(int(pixel[i]), int(row.color[i] * 255 + 0.5))
                << std::hex << row.format << " " << row.mode << " channel " << i;
    }
}

}  // namespace gw::gl
