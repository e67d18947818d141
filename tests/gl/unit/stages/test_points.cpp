// Sizes of points by distance, and point sprites. [GL14] 3.3, GL_ARB_point_sprite
#include "tests/gl/unit/support/picture.h"

#include <algorithm>

namespace gw::gl {

namespace {

/// The pixels of a point at a distance in front of the eye.
std::ptrdiff_t pixels_at(GLdouble distance, GLfloat size) {
    const Window window;
    glMatrixMode(GL_PROJECTION);
    glOrtho(-1, 1, -1, 1, 0, 100);
    glMatrixMode(GL_MODELVIEW);
    const GLfloat attenuation[] = {0, 0, 1 / 16.0f};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    glPointParameterf(GL_POINT_SIZE_MIN, 2);
    glPointParameteri(GL_POINT_SIZE_MAX, 12);
    glPointSize(size);
    glBegin(GL_POINTS);
    glVertex3d(0, 0, -distance);
    glEnd();
    const auto pixels = window.pixels();
    return std::ranges::count_if(pixels, [](const auto& p) { return p[0] != 0; });
}

/// Four texels: red, green below; blue, white above.
void set_texture() {
    const GLubyte texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glEnable(GL_TEXTURE_2D);
}

void replace_coordinates(GLint on) { glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, on); }

}  // namespace

TEST(GlPoints, ShrinkWithTheirDistanceBetweenTheirLimits) {
    EXPECT_EQ(pixels_at(4, 8), 64);
    EXPECT_EQ(pixels_at(8, 8), 16);
    EXPECT_EQ(pixels_at(64, 8), 4);   // the least size
    EXPECT_EQ(pixels_at(1, 8), 144);  // the greatest
    EXPECT_EQ(pixels_at(16, 24), 36);
}

/// t goes downwards: the texture's first row is at the top.
TEST(GlPointSprites, ShowTheTextureInUnitsThatReplaceCoordinates) {
    const auto drawn_sprite = [](GLint replaces, bool sprites) {
        const Window window(4, 4);
        set_texture();
        replace_coordinates(replaces);
        if (sprites) glEnable(GL_POINT_SPRITE);
        glPointSize(4);
        glTexCoord2f(0.75f, 0.75f);
        glBegin(GL_POINTS);
        glVertex2f(0, 0);
        glEnd();
        return window.pixels();
    };
    const std::array<GLubyte, 4> red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255},
        white{255, 255, 255, 255};
    const auto shown = drawn_sprite(GL_TRUE, true);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 4; ++x)
            EXPECT_EQ(shown[4 * y + x], y < 2 ? (x < 2 ? blue : white) : (x < 2 ? red : green));
    EXPECT_EQ(drawn_sprite(GL_FALSE, true), std::vector(16, white));
    EXPECT_EQ(drawn_sprite(GL_TRUE, false), std::vector(16, white));
}

TEST(GlPointSprites, AreSavedByTheGroupsOfPointsAndTextures) {
    const Window window;
    const auto state = [] {
        GLint replaces = 0;
        GLfloat attenuation[3] = {}, fade = 0;
        glGetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, &replaces);
        glGetFloatv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
        glGetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &fade);
        return std::array<double, 5>{double(replaces), double(glIsEnabled(GL_POINT_SPRITE)),
                                     attenuation[0], attenuation[2], fade};
    };
    const auto before = state();
    glPushAttrib(GL_POINT_BIT | GL_TEXTURE_BIT);
    const GLfloat attenuation[] = {2, 3, 4};
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    glPointParameterfARB(GL_POINT_FADE_THRESHOLD_SIZE, 5);
    glEnable(GL_POINT_SPRITE);
    replace_coordinates(GL_TRUE);
    EXPECT_EQ(state(), (std::array<double, 5>{1, 1, 2, 4, 5}));
    glPopAttrib();
    EXPECT_EQ(state(), before);
}

TEST(GlErrors, OfPointParameters) {
    const Window window;
    const auto expect = [](GLenum error, auto call) {
        call();
        EXPECT_EQ(glGetError(), error);
    };
    expect(GL_INVALID_VALUE, [] { glPointParameterf(GL_POINT_SIZE_MIN, -1); });
    expect(GL_INVALID_VALUE, [] { glPointParameteri(GL_POINT_FADE_THRESHOLD_SIZE, -1); });
    expect(GL_INVALID_ENUM, [] { glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1); });
    expect(GL_INVALID_ENUM, [] { glPointParameterf(GL_POINT_SIZE, 1); });
    expect(GL_INVALID_ENUM, [] { glTexEnvi(GL_POINT_SPRITE, GL_TEXTURE_ENV_MODE, GL_REPLACE); });
    expect(GL_INVALID_VALUE, [] { glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, 2); });
}

}  // namespace gw::gl
