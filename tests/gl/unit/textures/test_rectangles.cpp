// Rectangle textures: coordinates that count texels, and what they refuse. GL_ARB_texture_rectangle
#include "tests/gl/unit/support/window.h"

#include <string_view>

namespace gw::gl {
namespace {

using Pixel = std::array<GLubyte, 4>;
constexpr int width = 7, height = 5;  // no powers of two

/// The texel at column x and row y.
Pixel texel(int x, int y) { return {GLubyte(30 * x), GLubyte(50 * y), GLubyte(9 * x + y), 255}; }

void use_rectangle(GLenum filter = GL_NEAREST) {
    std::vector<Pixel> texels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) texels.push_back(texel(x, y));
    glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GLint(filter));
    glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GLint(filter));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_RECTANGLE);
}

/// The whole texture at the window's corner, one texel a pixel.
void draw_whole(GLenum unit = GL_TEXTURE0) {
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair{0, 0}, {width, 0}, {width, height}, {0, height}}) {
        glMultiTexCoord2i(unit, x, y);
        glVertex2i(x, y);
    }
    glEnd();
}

void expect_whole(const Window& window) {
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) EXPECT_EQ(window.pixel(x, y), texel(x, y)) << x << ' ' << y;
}

Pixel looked_up(const Window& window, float s, float t) {
    glTexCoord2f(s, t);
    glRecti(0, 0, 1, 1);
    return window.pixel(0, 0);
}

void expect_error(GLenum error, const char* what) { EXPECT_EQ(glGetError(), error) << what; }

GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}
GLint parameter(GLenum name) {
    GLint value = -1;
    glGetTexParameteriv(GL_TEXTURE_RECTANGLE, name, &value);
    return value;
}

}  // namespace

TEST(GlRectangles, AreDrawnTexelByTexel) {
    const Window window;
    use_pixel_coordinates(window);
    use_rectangle();
    draw_whole();
    expect_whole(window);
    EXPECT_EQ(looked_up(window, 3, 2), texel(3, 2));  // on the side between two
    glDisable(GL_TEXTURE_RECTANGLE);
    glActiveTexture(GL_TEXTURE2);
    use_rectangle(GL_LINEAR);  // at the centres of texels
    glClear(GL_COLOR_BUFFER_BIT);
    draw_whole(GL_TEXTURE2);
    expect_whole(window);
    expect_error(GL_NO_ERROR, "drawing");
}

TEST(GlRectangles, FollowTheMatrixAndTheirSize) {
    const Window window;
    use_pixel_coordinates(window);
    use_rectangle();
    glMatrixMode(GL_TEXTURE);
    glTranslatef(2, 1, 0);
    EXPECT_EQ(looked_up(window, 0.5f, 0.5f), texel(2, 1));
    const std::vector<Pixel> wide(64 * 2, Pixel{1, 2, 3, 255});
    glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA8, 64, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 wide.data());
    const Pixel one{200, 100, 50, 255};
    glTexSubImage2D(GL_TEXTURE_RECTANGLE, 0, 40, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, one.data());
    EXPECT_EQ(looked_up(window, 38.5f, 0.5f), one);
    EXPECT_EQ(looked_up(window, 37.5f, 0.5f), (Pixel{1, 2, 3, 255}));
    GLint size = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_RECTANGLE, 0, GL_TEXTURE_WIDTH, &size);
    EXPECT_EQ(size, 64);
}

TEST(GlRectangles, AreClampedAtTheirSides) {
    const Window window;
    use_pixel_coordinates(window);
    use_rectangle();
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GLint(GL_CLAMP_TO_EDGE));
    EXPECT_EQ(looked_up(window, 100, 2.5f), texel(width - 1, 2));
    EXPECT_EQ(looked_up(window, -100, 2.5f), texel(0, 2));
    const GLfloat border[] = {1, 1, 0, 1};
    glTexParameterfv(GL_TEXTURE_RECTANGLE, GL_TEXTURE_BORDER_COLOR, border);
    glTexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    EXPECT_EQ(looked_up(window, width + 0.5f, 2.5f), (Pixel{255, 255, 0, 255}));
}

/// Above two dimensions, below three.
TEST(GlRectangles, HaveTheirPlaceAmongTheTargets) {
    const Window window;
    use_pixel_coordinates(window);
    const Pixel other{9, 9, 9, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, other.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    use_rectangle();
    EXPECT_EQ(looked_up(window, 3.5f, 4.5f), texel(3, 4));
    const Pixel volume{70, 80, 90, 255};
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 1, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, volume.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_3D);
    EXPECT_EQ(looked_up(window, 0.5f, 0.5f), volume);
}

/// Feedback and the raster position have the coordinates as they were given.
TEST(GlRectangles, KeepCoordinatesInTexels) {
    const Window window;
    use_pixel_coordinates(window);
    use_rectangle();
    std::vector<GLfloat> buffer(20);
    glFeedbackBuffer(20, GL_4D_COLOR_TEXTURE, buffer.data());
    glRenderMode(GL_FEEDBACK);
    glTexCoord2f(3.5f, 4.5f);
    glBegin(GL_POINTS);
    glVertex2f(1, 1);
    glEnd();
    EXPECT_EQ(glRenderMode(GL_RENDER), 13);
    EXPECT_EQ(buffer[9], 3.5f);
    EXPECT_EQ(buffer[10], 4.5f);
    glRasterPos2f(2, 3);
    GLfloat coordinates[4];
    glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, coordinates);
    EXPECT_EQ(coordinates[0], 3.5f);
    EXPECT_EQ(coordinates[1], 4.5f);
    const GLubyte bit = 0x80;
    glBitmap(1, 1, 0, 0, 0, 0, &bit);
    EXPECT_EQ(window.pixel(2, 3), texel(3, 4));
    EXPECT_EQ(looked_up(window, 1.5f, 1.5f), texel(1, 1));  // after feedback
}

TEST(GlRectangles, AreCopiedAndDrawnTo) {
    const Window window;
    use_pixel_coordinates(window);
    use_rectangle();
    draw_whole();
    glCopyTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA8, 1, 1, 6, 4, 0);
    EXPECT_EQ(looked_up(window, 5.5f, 3.5f), texel(6, 4));
    GLuint framebuffer = 0, texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_RECTANGLE, texture);
    EXPECT_EQ(integer(GL_TEXTURE_BINDING_RECTANGLE), GLint(texture));
    use_rectangle();
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_RECTANGLE, texture, 0);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    glClearColor(0, 1, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(looked_up(window, 5.5f, 3.5f), (Pixel{0, 255, 0, 255}));
    expect_error(GL_NO_ERROR, "framebuffer");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_RECTANGLE, texture, 1);
    expect_error(GL_INVALID_VALUE, "level 1 of a framebuffer");
    glBindTexture(GL_TEXTURE_2D, texture);
    expect_error(GL_INVALID_OPERATION, "a rectangle as another target");
}

TEST(GlRectangles, RefuseWhatTheyLack) {
    const Window window;
    const auto set = [](GLenum name, GLenum value) {
        glTexParameteri(GL_TEXTURE_RECTANGLE, name, GLint(value));
    };
    set(GL_TEXTURE_WRAP_S, GL_REPEAT);
    expect_error(GL_INVALID_ENUM, "repeated");
    set(GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    expect_error(GL_INVALID_ENUM, "mirrored");
    set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    expect_error(GL_INVALID_ENUM, "a filter of levels");
    set(GL_GENERATE_MIPMAP, GL_TRUE);
    expect_error(GL_INVALID_VALUE, "made levels");
    set(GL_TEXTURE_BASE_LEVEL, 1);
    expect_error(GL_INVALID_OPERATION, "another base level");
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GLint(GL_LINEAR));
    glGenerateMipmap(GL_TEXTURE_RECTANGLE);
    expect_error(GL_INVALID_ENUM, "GenerateMipmap");
    const auto image = [](GLint level, GLsizei side, GLint border) {
        glTexImage2D(GL_TEXTURE_RECTANGLE, level, GL_RGBA8, side, side, border, GL_RGBA,
                     GL_UNSIGNED_BYTE, nullptr);
    };
    image(1, 4, 0);
    expect_error(GL_INVALID_VALUE, "level 1");
    image(0, 4, 1);
    expect_error(GL_INVALID_VALUE, "a border");
    image(0, integer(GL_MAX_RECTANGLE_TEXTURE_SIZE) + 1, 0);
    expect_error(GL_INVALID_VALUE, "a side beyond the limit");
    GLint size = 0;
    glGetTexLevelParameteriv(GL_TEXTURE_RECTANGLE, 1, GL_TEXTURE_WIDTH, &size);
    expect_error(GL_INVALID_VALUE, "queries of level 1");
    glTexImage2D(GL_PROXY_TEXTURE_RECTANGLE, 0, GL_RGBA8, 9, 9, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_RECTANGLE, 0, GL_TEXTURE_WIDTH, &size);
    EXPECT_EQ(size, 9);
    glCompressedTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8,
                           "12345678");
    expect_error(GL_INVALID_ENUM, "blocks");
}

TEST(GlRectangles, AreNotOfMachinesWithoutSizes) {
    const Window window(8, 8, vgx());
    glEnable(GL_TEXTURE_RECTANGLE);
    expect_error(GL_INVALID_ENUM, "on vgx");
    const std::string_view names = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
    EXPECT_EQ(names.find("texture_rectangle"), std::string_view::npos);
}

}  // namespace gw::gl
