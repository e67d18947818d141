// What OpenGL 1.2 to 1.5 and 2.0 added to textures of one and two dimensions: sizes, wraps, levels of
// detail, mipmaps made from the base level, GL_COMBINE, sRGB.
#include "tests/gl/unit/support/window.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gw::gl {
namespace {

using Pixel = std::array<GLubyte, 4>;

/// Texels that differ from their neighbours.
std::vector<Pixel> some_texels(int width, int height) {
    std::vector<Pixel> out;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            out.push_back({GLubyte(7 * x), GLubyte(11 * y), GLubyte(x * y), GLubyte(255 - x)});
    return out;
}

void set_image(int level, int width, int height, const std::vector<Pixel>& texels,
               GLint format = GL_RGBA) {
    glTexImage2D(GL_TEXTURE_2D, level, format, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
}
void set_parameter(GLenum name, GLint value) { glTexParameteri(GL_TEXTURE_2D, name, value); }
void use_nearest() {
    set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    set_parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

/// A rectangle of pixels from 0, 0 on, with s and t from `first` to `last`.
void draw_rectangle(int width, int height, double first, double last) {
    glBegin(GL_TRIANGLE_FAN);
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        glTexCoord2d(first + (last - first) * x, first + (last - first) * y);
        glVertex2i(x * width, y * height);
    }
    glEnd();
}

GLint value_of_level(int level, GLenum name) {
    GLint value = -1;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level, name, &value);
    return value;
}
std::vector<Pixel> level_texels(int level) {
    std::vector<Pixel> out(std::size_t(value_of_level(level, GL_TEXTURE_WIDTH)) *
                           std::size_t(value_of_level(level, GL_TEXTURE_HEIGHT)));
    glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
    return out;
}

}  // namespace

TEST(GlLaterTextures, HaveAnySize) {
    for (const auto& [width, height] : {std::pair(100, 37), {1, 63}, {127, 64}, {3, 5}}) {
        Window window(width, height);
        use_pixel_coordinates(window);
        const std::vector<Pixel> texels = some_texels(width, height);
        set_image(0, width, height, texels);
        use_nearest();
        draw_rectangle(width, height, 0, 1);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        EXPECT_EQ(window.pixels(), texels) << width << "x" << height;
    }
}

TEST(GlLaterTextures, AreAsLargeAsTheProfileLetsThemBe) {
    for (const auto& [profile, largest] : {std::pair(opengl(), 8192), {vgx(), 4096}}) {
        const Window window(4, 4, profile);
        GLint said = 0, width = -1;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &said);
        EXPECT_EQ(said, largest);
        for (const int size : {largest, 2 * largest}) {
            glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, size, 1, 0, GL_RGB, GL_FLOAT, nullptr);
            glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
            EXPECT_EQ(width, size == largest ? size : 0);
        }
    }
    Window window(8192 / 64, 1);
    use_pixel_coordinates(window);
    std::vector<Pixel> texels(8192);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = {GLubyte(i / 64), GLubyte(i % 64), 0, 255};
    set_image(0, 8192, 1, texels);
    use_nearest();
    draw_rectangle(128, 1, 0, 1);
    for (int x = 0; x < 128; ++x)
        EXPECT_EQ(window.pixel(x, 0), (Pixel{GLubyte(x), 32, 0, 255})) << x;
}

TEST(GlLaterTextures, WrapByMirrorsAndToTheBorder) {
    constexpr int size = 4, drawn = 20;
    const std::vector<Pixel> texels = some_texels(size, size);
    const Pixel border{255, 0, 255, 51};
    const std::array<float, 4> border_color{1, 0, 1, 0.2f};
    /// A texel of coordinate i, counted from -8.
    const auto mirrored = [](int i) {
        const int k = ((i % 8) + 8) % 8;
        return k < 4 ? k : 7 - k;
    };
    for (const GLenum wrap : {GL_MIRRORED_REPEAT, GL_CLAMP_TO_BORDER}) {
        Window window(drawn, drawn);
        use_pixel_coordinates(window);
        set_image(0, size, size, texels);
        use_nearest();
        set_parameter(GL_TEXTURE_WRAP_S, GLint(wrap));
        set_parameter(GL_TEXTURE_WRAP_T, GLint(wrap));
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border_color.data());
        draw_rectangle(drawn, drawn, -2, 3);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        for (int y = 0; y < drawn; ++y)
            for (int x = 0; x < drawn; ++x) {
                const int i = x - 8, k = y - 8;
                const bool inside = i >= 0 && i < size && k >= 0 && k < size;
                const Pixel mirror = texels[std::size_t(size * mirrored(k) + mirrored(i))];
                const Pixel bordered = inside ? texels[std::size_t(size * k + i)] : border;
                EXPECT_EQ(window.pixel(x, y), wrap == GL_MIRRORED_REPEAT ? mirror : bordered)
                    << wrap << ": " << x << ", " << y;
            }
    }
}

/// Levels of one colour each; the level that a rectangle of 16 x 16 pixels shows.
class Levels {
public:
    explicit Levels(int first = 0) : window_(16, 16) {
        use_pixel_coordinates(window_);
        for (int level = first; level <= 4; ++level)
            set_image(level, 16 >> level, 16 >> level,
                      std::vector<Pixel>(256, Pixel{GLubyte(10 + level), 0, 0, 255}));
        use_nearest();
        set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    }
    /// -1: no texture. `repeats`: so many texels of level 0 lie in a pixel.
    int shown(int repeats = 1) {
        glClear(GL_COLOR_BUFFER_BIT);
        glColor3ub(9, 0, 0);
        draw_rectangle(16, 16, 0, repeats);
        return window_.pixel(5, 5)[0] - 10;
    }

private:
    Window window_;
};

TEST(GlLaterTextures, ShowTheLevelsBetweenBaseAndMax) {
    Levels levels;
    EXPECT_EQ(levels.shown(), 0);
    EXPECT_EQ(levels.shown(4), 2);
    for (int base = 0; base <= 4; ++base) {
        set_parameter(GL_TEXTURE_BASE_LEVEL, base);
        EXPECT_EQ(levels.shown(), base);
        EXPECT_EQ(levels.shown(4), std::max(base, 2));
    }
    set_parameter(GL_TEXTURE_BASE_LEVEL, 1);
    set_parameter(GL_TEXTURE_MAX_LEVEL, 2);
    EXPECT_EQ(levels.shown(16), 2);
    set_image(3, 5, 5, some_texels(5, 5));  // fits nothing, and is not used
    EXPECT_EQ(levels.shown(16), 2);
    set_parameter(GL_TEXTURE_MAX_LEVEL, 3);
    EXPECT_EQ(levels.shown(16), -1);  // not complete
    set_parameter(GL_TEXTURE_BASE_LEVEL, 4);
    EXPECT_EQ(levels.shown(16), -1);  // base above max
    set_parameter(GL_TEXTURE_BASE_LEVEL, -1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

TEST(GlLaterTextures, NeedNoLevelBelowTheBase) {
    Levels levels(2);
    EXPECT_EQ(levels.shown(), -1);
    set_parameter(GL_TEXTURE_BASE_LEVEL, 2);
    EXPECT_EQ(levels.shown(), 2);
    EXPECT_EQ(levels.shown(16), 4);
    const Pixel changed{99, 0, 0, 255};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, changed.data());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
    const std::vector<Pixel> all(16, changed);
    glTexSubImage2D(GL_TEXTURE_2D, 2, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, all.data());
    EXPECT_EQ(levels.shown(), 89);
}

TEST(GlLaterTextures, BiasAndClampTheLevelOfDetail) {
    Levels levels;
    set_parameter(GL_TEXTURE_MIN_LOD, 1);
    EXPECT_EQ(levels.shown(), 1);
    set_parameter(GL_TEXTURE_MIN_LOD, -1000);
    set_parameter(GL_TEXTURE_MAX_LOD, 3);
    EXPECT_EQ(levels.shown(16), 3);
    set_parameter(GL_TEXTURE_MAX_LOD, 1000);
    set_parameter(GL_TEXTURE_LOD_BIAS, 2);
    EXPECT_EQ(levels.shown(), 2);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1);
    EXPECT_EQ(levels.shown(), 3);
    GLfloat bias = 0;
    glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &bias);
    EXPECT_EQ(bias, 1);
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, -2);
    EXPECT_EQ(levels.shown(), 0);
}

/// The mean of each 2 x 2 texels; sizes are even.
std::vector<Pixel> halved(const std::vector<Pixel>& texels, int width, int height) {
    std::vector<Pixel> out;
    for (int y = 0; y < height; y += 2)
        for (int x = 0; x < width; x += 2) {
            Pixel mean{};
            for (std::size_t c = 0; c < 4; ++c) {
                int sum = 0;
                for (const int at : {width * y + x, width * y + x + 1, width * (y + 1) + x,
                                     width * (y + 1) + x + 1})
                    sum += texels[std::size_t(at)][c];
                mean[c] = GLubyte((sum + 2) / 4);
            }
            out.push_back(mean);
        }
    return out;
}

TEST(GlLaterTextures, MakeTheLevelsAfterTheBaseLevel) {
    const Window window;
    std::vector<Pixel> texels = some_texels(12, 4);
    set_image(0, 12, 4, texels);
    EXPECT_EQ(value_of_level(1, GL_TEXTURE_WIDTH), 0);
    set_parameter(GL_GENERATE_MIPMAP, GL_TRUE);
    set_image(0, 12, 4, texels);
    for (const auto& [level, width, height] : {std::array{1, 6, 2}, {2, 3, 1}, {3, 1, 1}}) {
        EXPECT_EQ(value_of_level(level, GL_TEXTURE_WIDTH), width);
        EXPECT_EQ(value_of_level(level, GL_TEXTURE_HEIGHT), height);
    }
    EXPECT_EQ(value_of_level(4, GL_TEXTURE_WIDTH), 0);
    EXPECT_EQ(level_texels(1), halved(texels, 12, 4));
    const Pixel other{200, 100, 40, 80};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, other.data());
    texels[12 * 2 + 3] = other;
    EXPECT_EQ(level_texels(1), halved(texels, 12, 4));
    set_parameter(GL_TEXTURE_MAX_LEVEL, 1);
    set_parameter(GL_GENERATE_MIPMAP, GL_FALSE);
    set_image(0, 2, 2, some_texels(2, 2));
    EXPECT_EQ(value_of_level(1, GL_TEXTURE_WIDTH), 6);
}

/// [GL13] table 3.24, with numbers 0 and 1, which every function keeps exact.
int combined(GLenum func, int a, int b, int c) {
    switch (func) {
        case GL_REPLACE: return a;
        case GL_MODULATE: return a * b;
        case GL_ADD: return std::min(a + b, 1);
        case GL_INTERPOLATE: return a * c + b * (1 - c);
    }
    return std::max(a - b, 0);  // GL_SUBTRACT
}

TEST(GlLaterTextures, CombineTheirColourWithOthers) {
    Window window(1, 1);
    use_pixel_coordinates(window);
    use_nearest();
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    const std::array<GLenum, 4> sources{GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
    int step = 0;
    for (const GLenum func : {GL_REPLACE, GL_MODULATE, GL_ADD, GL_INTERPOLATE, GL_SUBTRACT})
        for (int bits = 0; bits < 8; ++bits, ++step) {
            const int texel = bits & 1, constant = bits >> 1 & 1, primary = bits >> 2;
            const std::array<int, 4> values{texel, constant, primary, primary};
            set_image(0, 1, 1, {Pixel{GLubyte(255 * texel), 0, 0, GLubyte(255 * texel)}});
            const std::array<float, 4> env{float(constant), 0, 0, float(constant)};
            glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, env.data());
            glColor4f(float(primary), 0, 0, float(primary));
            std::array<int, 3> rgb{}, alpha{};
            for (GLenum i = 0; i < 3; ++i) {
                const std::size_t s = (std::size_t(step) + i) % 4, t = (s + 1 + i) % 4;
                const bool inverts = (step + int(i)) % 3 == 0;
                glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + i, GLint(sources[s]));
                glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + i, GLint(sources[t]));
                glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i,
                          inverts ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_COLOR);
                glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + i,
                          inverts ? GL_SRC_ALPHA : GL_ONE_MINUS_SRC_ALPHA);
                rgb[i] = inverts ? 1 - values[s] : values[s];
                alpha[i] = inverts ? values[t] : 1 - values[t];
            }
            glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GLint(func));
            glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GLint(func));
            ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
            draw_rectangle(1, 1, 0, 1);
            const Pixel got = window.pixel(0, 0);
            EXPECT_EQ(got[0], 255 * combined(func, rgb[0], rgb[1], rgb[2])) << func << ", " << bits;
            EXPECT_EQ(got[3], 255 * combined(func, alpha[0], alpha[1], alpha[2]))
                << func << ", " << bits;
        }
}

TEST(GlLaterTextures, CombineByScalesAndDotProducts) {
    Window window(1, 1);
    use_pixel_coordinates(window);
    use_nearest();
    const auto shown = [&](Pixel texel) {
        set_image(0, 1, 1, {texel});
        draw_rectangle(1, 1, 0, 1);
        return window.pixel(0, 0);
    };
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
    glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 4);
    EXPECT_EQ(shown({51, 10, 200, 30}), (Pixel{102, 20, 255, 120}));
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);
    glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 1);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
    glColor4f(1, 1, 1, 0);
    EXPECT_EQ(shown({255, 255, 255, 9}), (Pixel{255, 255, 255, 9}));
    EXPECT_EQ(shown({0, 0, 0, 9}), (Pixel{0, 0, 0, 9}));
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGBA);
    EXPECT_EQ(shown({255, 255, 255, 9}), (Pixel{255, 255, 255, 255}));
    const std::pair<GLenum, GLint> wrong[] = {
        {GL_COMBINE_ALPHA, GL_DOT3_RGB},
        {GL_COMBINE_RGB, GL_RED},
        {GL_SOURCE0_RGB, GL_RED},
        {GL_SOURCE2_ALPHA, GL_TEXTURE_2D},
        {GL_OPERAND0_ALPHA, GL_SRC_COLOR},
        {GL_OPERAND1_RGB, GL_DST_COLOR},
        {GL_TEXTURE_ENV_MODE, GL_ADD_SIGNED},
        {GL_SOURCE2_RGB + 1, GL_TEXTURE},
    };
    for (const auto& [name, value] : wrong) {
        glTexEnvi(GL_TEXTURE_ENV, name, value);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM)) << name << ": " << value;
    }
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glColor4f(0.2f, 1, 0, 0.4f);
    EXPECT_EQ(shown({100, 100, 100, 255}), (Pixel{151, 255, 100, 102}));
}

/// EXT_texture_sRGB: 188 is half of the light.
TEST(GlLaterTextures, DecodeSrgbColours) {
    Window window(1, 1);
    use_pixel_coordinates(window);
    use_nearest();
    for (const GLint format : {GL_SRGB8_ALPHA8, GL_SRGB8, GL_SRGB_ALPHA}) {
        set_image(0, 1, 1, {Pixel{188, 0, 255, 188}}, format);
        draw_rectangle(1, 1, 0, 1);
        const GLubyte alpha = format == GL_SRGB8 ? window.pixel(0, 0)[3] : 188;
        EXPECT_EQ(window.pixel(0, 0), (Pixel{128, 0, 255, alpha}));
    }
    const Window other(1, 1, vgx());
    set_image(0, 1, 1, {Pixel{1, 2, 3, 4}}, GL_SRGB8);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_VALUE));
}

}  // namespace gw::gl
