// Secondary colours and fog coordinates: how programs give them, and what is drawn. [GL14] 2.7, 3.9,
// 3.10
#include "tests/gl/unit/support/picture.h"

namespace gw::gl {

namespace {

using Pixel = std::array<GLubyte, 4>;

void draw_square() { glRecti(0, 0, 32, 32); }

/// The pixel of a square that `draw` draws.
template <class Draw>
Pixel middle_of(Draw draw, const Profile& profile = opengl()) {
    const Window window(32, 32, profile);
    use_pixel_coordinates(window);
    draw();
    return window.pixel(16, 16);
}

void sum_colors() {
    glEnable(GL_COLOR_SUM);
    glColor3ub(10, 20, 30);
}

/// Linear fog of white whose coordinate is its share of white.
void fog_by_coordinate() {
    const GLfloat white[] = {1, 1, 1, 1};
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glFogfv(GL_FOG_COLOR, white);
    glColor3f(0, 0, 0);
}

struct Given {
    GLfloat position[2];
    GLfloat secondary[3];
    GLfloat fog;
};
constexpr Given corners[] = {{{0, 0}, {0.25f, 0, 1}, 0.125f},
                             {{32, 0}, {0, 0.5f, 0.5f}, 0.5f},
                             {{32, 32}, {1, 0, 0.25f}, 0.875f},
                             {{0, 32}, {0.5f, 1, 0}, 0.25f}};

void draw_corners() {
    glBegin(GL_QUADS);
    for (const Given& c : corners) {
        glSecondaryColor3fv(c.secondary);
        glFogCoordf(c.fog);
        glVertex2fv(c.position);
    }
    glEnd();
}

void set_corner_arrays() {
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
    glEnableClientState(GL_FOG_COORDINATE_ARRAY);
    glVertexPointer(2, GL_FLOAT, sizeof(Given), corners[0].position);
    glSecondaryColorPointer(3, GL_FLOAT, sizeof(Given), corners[0].secondary);
    glFogCoordPointer(GL_FLOAT, sizeof(Given), &corners[0].fog);
}

}  // namespace

TEST(GlColorSum, AddsTheSecondaryColorIfItIsEnabled) {
    const auto draw = [](bool sums) {
        return middle_of([&] {
            sum_colors();
            if (!sums) glDisable(GL_COLOR_SUM);
            glSecondaryColor3ub(100, 250, 255);
            draw_square();
        });
    };
    EXPECT_EQ(draw(false), (Pixel{10, 20, 30, 255}));
    EXPECT_EQ(draw(true), (Pixel{110, 255, 255, 255}));
}

/// [GL14] table 2.6: integers of every type are colours as those of Color are.
TEST(GlColorSum, EveryTypeGivesTheColorThatColorGives) {
    const auto summed = [](auto give) {
        return middle_of([&] {
            glEnable(GL_COLOR_SUM);
            glColor3f(0, 0, 0);
            give();
            draw_square();
        });
    };
    const auto colored = [](auto give) {
        return middle_of([&] {
            give();
            draw_square();
        });
    };
#define EXPECT_SAME_COLOR(suffix, type, ...)                                               \
    {                                                                                      \
        const type v[] = {__VA_ARGS__};                                                    \
        const Pixel expected = colored([&] { glColor3##suffix##v(v); });                   \
        EXPECT_EQ(summed([&] { glSecondaryColor3##suffix##v(v); }), expected);             \
        EXPECT_EQ(summed([&] { glSecondaryColor3##suffix##vEXT(v); }), expected);          \
        EXPECT_EQ(summed([&] { glSecondaryColor3##suffix(__VA_ARGS__); }), expected);      \
        EXPECT_EQ(summed([&] { glSecondaryColor3##suffix##EXT(__VA_ARGS__); }), expected); \
        EXPECT_NE(expected, (Pixel{0, 0, 0, 255}));                                        \
    }
    EXPECT_SAME_COLOR(b, GLbyte, 100, 20, 127)
    EXPECT_SAME_COLOR(d, GLdouble, 0.25, 0.5, 0.75)
    EXPECT_SAME_COLOR(f, GLfloat, 0.25f, 0.5f, 0.75f)
    EXPECT_SAME_COLOR(i, GLint, 1000000000, 2000000000, 300000000)
    EXPECT_SAME_COLOR(s, GLshort, 10000, 20000, 30000)
    EXPECT_SAME_COLOR(ub, GLubyte, 100, 200, 250)
    EXPECT_SAME_COLOR(ui, GLuint, 1000000000u, 2000000000u, 4000000000u)
    EXPECT_SAME_COLOR(us, GLushort, 10000, 20000, 60000)
#undef EXPECT_SAME_COLOR
}

TEST(GlFogCoordinate, IsTheDistanceOfFog) {
    const auto fogged = [](auto give) {
        return middle_of([&] {
            fog_by_coordinate();
            give();
            draw_square();
        });
    };
    EXPECT_EQ(fogged([] { glFogCoordf(0.25f); }), (Pixel{64, 64, 64, 255}));
    EXPECT_EQ(fogged([] { glFogCoordd(0.75); }), (Pixel{191, 191, 191, 255}));
    EXPECT_EQ(fogged([] { glFogCoordfEXT(2); }), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(fogged([] { glFogCoordf(-1); }), (Pixel{0, 0, 0, 255}));
    EXPECT_EQ(fogged([] {
                  glFogCoordf(2);
                  glFogi(GL_FOG_COORDINATE_SOURCE, GL_FRAGMENT_DEPTH);
              }),
              (Pixel{0, 0, 0, 255}));
}

TEST(GlVertexArrays, GiveSecondaryColorsAndFogCoordinates) {
    for (const auto set : {+[] { sum_colors(); }, +[] { fog_by_coordinate(); }}) {
        const Picture expected = drawn([&] {
            set();
            draw_corners();
        });
        EXPECT_EQ(drawn([&] {
                      set();
                      set_corner_arrays();
                      glDrawArrays(GL_QUADS, 0, 4);
                  }),
                  expected);
        EXPECT_EQ(drawn([&] {
                      set();
                      set_corner_arrays();
                      glBegin(GL_QUADS);
                      for (GLint i = 0; i < 4; ++i) glArrayElement(i);
                      glEnd();
                  }),
                  expected);
        EXPECT_NE(drawn([&] {
                      set();
                      draw_square();
                  }),
                  expected);
    }
}

/// A list that is long enough becomes meshes; their values are those of immediate mode.
TEST(GlDisplayLists, KeepSecondaryColorsAndFogCoordinates) {
    const auto many = [] {
        for (int i = 0; i < 20; ++i) draw_corners();
    };
    for (const auto set : {+[] { sum_colors(); }, +[] { fog_by_coordinate(); }})
        expect_same_picture(
            [&] {
                set();
                many();
                draw_square();  // with the values that are current now
            },
            [&] {
                set();
                glNewList(1, GL_COMPILE);
                many();
                glEndList();
                glSecondaryColor3f(0, 0, 0);
                glFogCoordf(0);
                glCallList(1);
                draw_square();
            });
}

/// [GL12] 2.13.1: the highlight is a colour of its own, which no texture darkens.
TEST(GlLighting, SeparateHighlightsAreAddedAfterTexture) {
    const auto lit = [](GLenum control, const Profile& profile) {
        return middle_of(
            [&] {
                const GLfloat white[] = {1, 1, 1, 1}, black[] = {0, 0, 0, 1};
                const GLubyte texel[] = {0, 0, 0, 255};
                glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
                glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
                glEnable(GL_TEXTURE_2D);
                glEnable(GL_LIGHTING);
                glEnable(GL_LIGHT0);
                glMaterialfv(GL_FRONT, GL_SPECULAR, white);
                glMaterialfv(GL_FRONT, GL_DIFFUSE, black);
                glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GLint(control));
                glNormal3f(0, 0, 1);
                draw_square();
            },
            profile);
    };
    EXPECT_EQ(lit(GL_SINGLE_COLOR, opengl()), (Pixel{0, 0, 0, 255}));
    EXPECT_EQ(lit(GL_SEPARATE_SPECULAR_COLOR, opengl()), (Pixel{255, 255, 255, 255}));
    EXPECT_EQ(lit(GL_SEPARATE_SPECULAR_COLOR, vgx()), (Pixel{0, 0, 0, 255}));
}

/// [GL14] 2.12: pixels take the values of the raster position.
TEST(GlRasterPosition, HasASecondaryColorAndAFogCoordinate) {
    const auto texel = [] {
        const GLubyte bit[] = {0x80};
        glBitmap(1, 1, 0, 0, 0, 0, bit);
    };
    for (const bool in_window : {false, true}) {
        const auto position = [&] {
            if (in_window)
                glWindowPos2i(16, 16);
            else
                glRasterPos2i(16, 16);
        };
        EXPECT_EQ(middle_of([&] {
                      sum_colors();
                      glSecondaryColor3ub(1, 2, 3);
                      position();
                      glSecondaryColor3ub(0, 0, 0);
                      texel();
                  }),
                  (Pixel{11, 22, 33, 255}));
        EXPECT_EQ(middle_of([&] {
                      fog_by_coordinate();
                      glFogCoordf(0.25f);
                      position();
                      glFogCoordf(0);
                      texel();
                  }),
                  (Pixel{64, 64, 64, 255}));
    }
}

TEST(GlAttributes, HaveSecondaryColorsFogCoordinatesAndTheirSwitches) {
    const Window window;
    const auto number = [](GLenum name) {
        GLdouble values[4] = {};
        glGetDoublev(name, values);
        return values[0];
    };
    glSecondaryColor3f(0.5f, 0, 0);
    glFogCoordf(3);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glSecondaryColor3f(0.25f, 0, 0);
    glFogCoordf(4);
    glEnable(GL_COLOR_SUM);
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    EXPECT_EQ(number(GL_CURRENT_SECONDARY_COLOR), 0.25);
    EXPECT_EQ(number(GL_CURRENT_FOG_COORDINATE), 4);
    EXPECT_EQ(number(GL_COLOR_SUM), 1);
    EXPECT_EQ(number(GL_FOG_COORDINATE_SOURCE), GL_FOG_COORDINATE);
    EXPECT_EQ(number(GL_LIGHT_MODEL_COLOR_CONTROL), GL_SEPARATE_SPECULAR_COLOR);
    glPopAttrib();
    EXPECT_EQ(number(GL_CURRENT_SECONDARY_COLOR), 0.5);
    EXPECT_EQ(number(GL_CURRENT_FOG_COORDINATE), 3);
    EXPECT_EQ(number(GL_COLOR_SUM), 0);
    EXPECT_EQ(number(GL_FOG_COORDINATE_SOURCE), GL_FRAGMENT_DEPTH);
    EXPECT_EQ(number(GL_LIGHT_MODEL_COLOR_CONTROL), GL_SINGLE_COLOR);
}

TEST(GlErrors, OfSecondaryColorsAndFogCoordinates) {
    const Window window;
    const auto expect = [](GLenum error, auto call) {
        call();
        EXPECT_EQ(glGetError(), error);
    };
    expect(GL_INVALID_VALUE, [] { glSecondaryColorPointer(4, GL_FLOAT, 0, nullptr); });
    expect(GL_INVALID_VALUE, [] { glSecondaryColorPointer(3, GL_FLOAT, -1, nullptr); });
    expect(GL_INVALID_ENUM, [] { glSecondaryColorPointer(3, GL_BITMAP, 0, nullptr); });
    expect(GL_INVALID_ENUM, [] { glFogCoordPointer(GL_INT, 0, nullptr); });
    expect(GL_INVALID_VALUE, [] { glFogCoordPointer(GL_DOUBLE, -1, nullptr); });
    expect(GL_INVALID_ENUM, [] { glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG); });
    expect(GL_INVALID_ENUM, [] { glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_LIGHTING); });
}

}  // namespace gw::gl
