// Lights, materials and ColorMaterial. [GL11] 2.13
#include "tests/gl/unit/support/window.h"

#include <cmath>

namespace gw::gl {
namespace {

using Four = std::array<GLfloat, 4>;

Four light_value(GLenum name) {
    Four out{};
    glGetLightfv(GL_LIGHT3, name, out.data());
    return out;
}
Four material_value(GLenum face, GLenum name) {
    Four out{};
    glGetMaterialfv(face, name, out.data());
    return out;
}
void expect_error(GLenum error) { EXPECT_EQ(glGetError(), error); }

/// The colour of a point under LIGHT0 along -z, whose spot has this angle to it, in degrees.
std::array<GLubyte, 4> lit_by_directional_spot(double angle, float cutoff) {
    const Window window;
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    const Four black{0, 0, 0, 1}, white{1, 1, 1, 1}, from_z{0, 0, 1, 0};
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black.data());
    glLightfv(GL_LIGHT0, GL_DIFFUSE, white.data());
    glLightfv(GL_LIGHT0, GL_POSITION, from_z.data());
    glMaterialfv(GL_FRONT, GL_DIFFUSE, white.data());
    const double radians = angle * 3.14159265358979 / 180;
    const Four direction{float(std::sin(radians)), 0, float(-std::cos(radians)), 0};
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction.data());
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff);
    glRectf(-1, -1, 1, 1);
    return window.pixel(4, 4);
}

}  // namespace

TEST(GlLighting, PositionsAndDirectionsGoThroughTheModelview) {
    const Window window;
    glTranslatef(10, 20, 30);
    glScalef(2, 3, 4);
    const Four position{1, 1, 1, 2};
    glLightfv(GL_LIGHT3, GL_POSITION, position.data());
    EXPECT_EQ(light_value(GL_POSITION), (Four{22, 43, 64, 2}));
    glLightfv(GL_LIGHT3, GL_SPOT_DIRECTION, position.data());
    EXPECT_EQ(light_value(GL_SPOT_DIRECTION), (Four{2, 3, 4, 0}));
    glLoadIdentity();
    EXPECT_EQ(light_value(GL_POSITION), (Four{22, 43, 64, 2}));
}

TEST(GlLighting, DirectionalLightsHaveASpotToo) {
    EXPECT_EQ(lit_by_directional_spot(60, 180)[0], 255);
    EXPECT_EQ(lit_by_directional_spot(60, 90)[0], 64);  // cos 60 degrees, squared
    EXPECT_EQ(lit_by_directional_spot(60, 45)[0], 0);
    EXPECT_EQ(lit_by_directional_spot(120, 90)[0], 0);
    EXPECT_EQ(lit_by_directional_spot(0, 10)[0], 255);
}

TEST(GlLighting, IntegerParametersAreUnitsForColorsOnly) {
    const Window window;
    constexpr GLint largest = 0x7FFFFFFF;
    const std::array<GLint, 4> color{largest, -largest - 1, largest, largest};
    glLightiv(GL_LIGHT3, GL_DIFFUSE, color.data());
    EXPECT_EQ(light_value(GL_DIFFUSE), (Four{1, -1, 1, 1}));
    glMaterialiv(GL_FRONT, GL_EMISSION, color.data());
    EXPECT_EQ(material_value(GL_FRONT, GL_EMISSION), (Four{1, -1, 1, 1}));
    const std::array<GLint, 4> position{1, 2, 3, 4};
    glLightiv(GL_LIGHT3, GL_POSITION, position.data());
    EXPECT_EQ(light_value(GL_POSITION), (Four{1, 2, 3, 4}));
    std::array<GLint, 4> back{};
    glGetLightiv(GL_LIGHT3, GL_DIFFUSE, back.data());
    EXPECT_EQ(back, color);
    glGetLightiv(GL_LIGHT3, GL_POSITION, back.data());
    EXPECT_EQ(back, position);
}

TEST(GlLighting, ValuesOutOfRangeAreErrors) {
    const Window window;
    for (const float cutoff : {-1.0f, 90.5f, 179.0f, 181.0f}) {
        glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, cutoff);
        expect_error(GL_INVALID_VALUE);
    }
    for (const float exponent : {-1.0f, 128.5f}) {
        glLightf(GL_LIGHT3, GL_SPOT_EXPONENT, exponent);
        expect_error(GL_INVALID_VALUE);
        glMaterialf(GL_FRONT, GL_SHININESS, exponent);
        expect_error(GL_INVALID_VALUE);
    }
    for (const GLenum name :
         {GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION}) {
        glLightf(GL_LIGHT3, name, -0.5f);
        expect_error(GL_INVALID_VALUE);
    }
    for (const float cutoff : {0.0f, 90.0f, 180.0f}) glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, cutoff);
    expect_error(GL_NO_ERROR);
    glLightf(GL_LIGHT3, GL_AMBIENT, 1);
    expect_error(GL_INVALID_ENUM);
    glLightf(GL_LIGHT7 + 1, GL_SPOT_CUTOFF, 1);
    expect_error(GL_INVALID_ENUM);
    glMaterialf(GL_FRONT_LEFT, GL_SHININESS, 1);
    expect_error(GL_INVALID_ENUM);
    glColorMaterial(GL_FRONT, GL_SHININESS);
    expect_error(GL_INVALID_ENUM);
    glLightModelf(GL_LIGHT_MODEL_AMBIENT, 1);
    expect_error(GL_INVALID_ENUM);
}

TEST(GlLighting, MaterialsFollowTheColorWhileColorMaterialIsOn) {
    const Window window;
    glColorMaterial(GL_BACK, GL_SPECULAR);
    glColor4f(1, 0, 0.5f, 0.25f);
    EXPECT_EQ(material_value(GL_BACK, GL_SPECULAR), (Four{0, 0, 0, 1}));
    glEnable(GL_COLOR_MATERIAL);
    EXPECT_EQ(material_value(GL_BACK, GL_SPECULAR), (Four{1, 0, 0.5f, 0.25f}));
    EXPECT_EQ(material_value(GL_FRONT, GL_SPECULAR), (Four{0, 0, 0, 1}));
    glColor4f(0, 1, 0, 1);
    const Four other{0.5f, 0.5f, 0.5f, 0.5f};
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, other.data());  // the back follows
    EXPECT_EQ(material_value(GL_BACK, GL_SPECULAR), (Four{0, 1, 0, 1}));
    EXPECT_EQ(material_value(GL_FRONT, GL_SPECULAR), other);
    glColorMaterial(GL_FRONT, GL_EMISSION);
    glColor4f(0, 0, 1, 1);
    EXPECT_EQ(material_value(GL_BACK, GL_SPECULAR), (Four{0, 1, 0, 1}));
    EXPECT_EQ(material_value(GL_FRONT, GL_EMISSION), (Four{0, 0, 1, 1}));
    glDisable(GL_COLOR_MATERIAL);
    glColor4f(1, 1, 1, 1);
    EXPECT_EQ(material_value(GL_FRONT, GL_EMISSION), (Four{0, 0, 1, 1}));
}

TEST(GlLighting, TwoSidesHaveTheirOwnMaterials) {
    const Window window;
    use_pixel_coordinates(window);
    const Four red{1, 0, 0, 1}, green{0, 1, 0, 1};
    glMaterialfv(GL_FRONT, GL_EMISSION, red.data());
    glMaterialfv(GL_BACK, GL_EMISSION, green.data());
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE}) {
        const Four black{0, 0, 0, 1};
        glMaterialfv(GL_FRONT_AND_BACK, name, black.data());
    }
    glEnable(GL_LIGHTING);
    using Color = std::array<GLubyte, 4>;
    glRecti(20, 0, 0, 20);  // seen from its back
    EXPECT_EQ(window.pixel(5, 5), (Color{255, 0, 0, 255}));
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glRecti(20, 0, 0, 20);
    EXPECT_EQ(window.pixel(5, 5), (Color{0, 255, 0, 255}));
    glRecti(0, 0, 20, 20);
    EXPECT_EQ(window.pixel(5, 5), (Color{255, 0, 0, 255}));
}

}  // namespace gw::gl
