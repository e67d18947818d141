// Texture units: each has textures, an environment, coordinates, generation, a matrix. [GL13] 2.7,
// 2.8, 2.10, 3.8
#include "gl/draw/submit.h"
#include "tests/gl/unit/support/window.h"
#include "tests/gl/unit/textures/row_texture.h"

namespace gw::gl {
namespace {

using Coordinates = std::array<GLdouble, 4>;

GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}
Coordinates coordinates(GLenum name) {
    Coordinates out{};
    glGetDoublev(name, out.data());
    return out;
}

GLubyte product(GLubyte a, GLubyte b) { return GLubyte((2 * a * b + 255) / 510); }
Pixel product(const Pixel& a, const Pixel& b) {
    return {product(a[0], b[0]), product(a[1], b[1]), product(a[2], b[2]), product(a[3], b[3])};
}

constexpr GLenum units[] = {GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE3};
constexpr Pixel unit_texels[] = {
    {200, 100, 50, 240}, {128, 220, 255, 255}, {250, 130, 90, 31}, {90, 255, 60, 255}};

}  // namespace

TEST(GlTextureUnits, ThereAreFour) {
    const Window window;
    EXPECT_EQ(integer(GL_MAX_TEXTURE_UNITS), 4);
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE0);
    EXPECT_EQ(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE0);
    glActiveTexture(GL_TEXTURE2);
    glClientActiveTexture(GL_TEXTURE3);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    for (const GLenum wrong : {GLenum(GL_TEXTURE0 + 4), GLenum(GL_TEXTURE0 - 1), GLenum(0)}) {
        glActiveTexture(wrong);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
        glClientActiveTexture(wrong);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
        glMultiTexCoord2f(wrong, 1, 1);
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    }
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE2);
    EXPECT_EQ(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE3);
}

TEST(GlTextureUnits, ProfilesWithoutThemHaveOne) {
    const Window window(16, 16, reality());
    EXPECT_EQ(integer(GL_MAX_TEXTURE_UNITS), 1);
    glActiveTexture(GL_TEXTURE1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glEnable(GL_TEXTURE_3D);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glBindTexture(GL_TEXTURE_CUBE_MAP, 3);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPopAttrib();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlTextureUnits, EachMultiTexCoordSetsItsUnit) {
    const Window window;
    const auto expect = [](GLenum unit, const Coordinates& expected, const char* name) {
        for (const GLenum other : units) {
            glActiveTexture(other);
            const Coordinates untouched{9, 9, 9, 9};
            EXPECT_EQ(coordinates(GL_CURRENT_TEXTURE_COORDS), other == unit ? expected : untouched)
                << name;
            glMultiTexCoord4f(other, 9, 9, 9, 9);
        }
    };
    for (const GLenum unit : units) glMultiTexCoord4f(unit, 9, 9, 9, 9);
#define EXPECT_SETS(type, letter)                               \
    for (const GLenum unit : units) {                           \
        const type v[] = {type(1), type(2), type(3), type(4)};  \
        glMultiTexCoord1##letter(unit, v[0]);                   \
        expect(unit, {1, 0, 0, 1}, "1" #letter);                \
        glMultiTexCoord2##letter(unit, v[0], v[1]);             \
        expect(unit, {1, 2, 0, 1}, "2" #letter);                \
        glMultiTexCoord3##letter(unit, v[0], v[1], v[2]);       \
        expect(unit, {1, 2, 3, 1}, "3" #letter);                \
        glMultiTexCoord4##letter(unit, v[0], v[1], v[2], v[3]); \
        expect(unit, {1, 2, 3, 4}, "4" #letter);                \
        glMultiTexCoord1##letter##v(unit, v);                   \
        expect(unit, {1, 0, 0, 1}, "1" #letter "v");            \
        glMultiTexCoord2##letter##v(unit, v);                   \
        expect(unit, {1, 2, 0, 1}, "2" #letter "v");            \
        glMultiTexCoord3##letter##vARB(unit, v);                \
        expect(unit, {1, 2, 3, 1}, "3" #letter "vARB");         \
        glMultiTexCoord4##letter##v(unit, v);                   \
        expect(unit, {1, 2, 3, 4}, "4" #letter "v");            \
    }
    EXPECT_SETS(GLshort, s)
    EXPECT_SETS(GLint, i)
    EXPECT_SETS(GLfloat, f)
    EXPECT_SETS(GLdouble, d)
#undef EXPECT_SETS
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlTextureUnits, EachHasItsOwnStateThatPopAttribRestores) {
    const Window window;
    const auto set = [](int shift) {
        for (int i = 0; i < 4; ++i) {
            glActiveTexture(units[i]);
            const int k = (i + shift) % 4;
            constexpr GLenum targets[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
                                          GL_TEXTURE_CUBE_MAP};
            for (int target = 0; target < 4; ++target) {
                (target == k ? glEnable : glDisable)(targets[target]);
                glBindTexture(targets[target], GLuint(10 * target + k + 1));
            }
            glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, k == 0 ? 1 : k == 1 ? 2 : 4);
            glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_RGB, GLint(units[k]));
            glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, k % 2 ? GL_NORMAL_MAP : GL_REFLECTION_MAP);
            (k % 2 ? glEnable : glDisable)(GL_TEXTURE_GEN_Q);
        }
    };
    const auto expect = [](int shift) {
        for (int i = 0; i < 4; ++i) {
            glActiveTexture(units[i]);
            const int k = (i + shift) % 4;
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_1D), k == 0);
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_CUBE_MAP), k == 3);
            EXPECT_EQ(integer(GL_TEXTURE_BINDING_1D), k + 1);
            EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 10 + k + 1);
            EXPECT_EQ(integer(GL_TEXTURE_BINDING_3D), 20 + k + 1);
            EXPECT_EQ(integer(GL_TEXTURE_BINDING_CUBE_MAP), 30 + k + 1);
            GLint scale = 0, source = 0, mode = 0;
            glGetTexEnviv(GL_TEXTURE_ENV, GL_RGB_SCALE, &scale);
            glGetTexEnviv(GL_TEXTURE_ENV, GL_SOURCE1_RGB, &source);
            glGetTexGeniv(GL_R, GL_TEXTURE_GEN_MODE, &mode);
            EXPECT_EQ(scale, k == 0 ? 1 : k == 1 ? 2 : 4);
            EXPECT_EQ(source, GLint(units[k]));
            EXPECT_EQ(mode, k % 2 ? GL_NORMAL_MAP : GL_REFLECTION_MAP);
            EXPECT_EQ(glIsEnabled(GL_TEXTURE_GEN_Q), k % 2);
        }
    };
    set(0);
    expect(0);
    glActiveTexture(GL_TEXTURE1);
    glPushAttrib(GL_TEXTURE_BIT);
    set(1);
    expect(1);
    glPopAttrib();
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE1);
    expect(0);
    glPushAttrib(GL_ENABLE_BIT);
    for (const GLenum unit : units) {
        glActiveTexture(unit);
        for (const GLenum cap :
             {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_Q})
            glDisable(cap);
    }
    glPopAttrib();
    EXPECT_EQ(integer(GL_ACTIVE_TEXTURE), GL_TEXTURE3) << "not of GL_ENABLE_BIT";
    expect(0);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(GlTextureUnits, EachHasAMatrixStack) {
    const Window window;
    glMatrixMode(GL_TEXTURE);
    for (int i = 0; i < 4; ++i) {
        glActiveTexture(units[i]);
        for (int depth = 0; depth < i; ++depth) glPushMatrix();
        glTranslatef(float(i + 1), 0, 0);
    }
    for (int i = 0; i < 4; ++i) {
        glActiveTexture(units[i]);
        std::array<double, 16> m{};
        glGetDoublev(GL_TEXTURE_MATRIX, m.data());
        EXPECT_EQ(m[12], i + 1);
        glGetDoublev(GL_TRANSPOSE_TEXTURE_MATRIX, m.data());
        EXPECT_EQ(m[3], i + 1);
        EXPECT_EQ(integer(GL_TEXTURE_STACK_DEPTH), i + 1);
    }
    glActiveTexture(GL_TEXTURE0);
    glPopMatrix();
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
}

TEST(GlTextureUnits, ColoursPassThemInOrder) {
    const Window window(4, 4);
    Pixel expected{255, 180, 90, 255};
    for (int i = 0; i < 4; ++i) {
        use_texture_of(units[i], {unit_texels[i]});
        expected = product(expected, unit_texels[i]);
    }
    glColor4ub(255, 180, 90, 255);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(window.pixel(1, 2), expected);
    // A unit that is off is passed over.
    glActiveTexture(GL_TEXTURE2);
    glDisable(GL_TEXTURE_2D);
    expected = {255, 180, 90, 255};
    for (const int i : {0, 1, 3}) expected = product(expected, unit_texels[i]);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(window.pixel(1, 2), expected);
}

TEST(GlTextureUnits, CombineReadsTheTexturesOfOthers) {
    const Window window(4, 4);
    for (int i = 0; i < 4; ++i) use_texture_of(units[i], {unit_texels[i]});
    for (int i = 0; i < 4; ++i) {
        glActiveTexture(units[i]);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
        for (const GLenum func : {GL_COMBINE_RGB, GL_COMBINE_ALPHA})
            glTexEnvi(GL_TEXTURE_ENV, func, i == 0 ? GL_REPLACE : GL_MODULATE);
        for (const GLenum source : {GL_SOURCE0_RGB, GL_SOURCE0_ALPHA})
            glTexEnvi(GL_TEXTURE_ENV, source, GLint(units[(i + 1) % 4]));
    }
    glRectf(-1, -1, 1, 1);
    Pixel expected = unit_texels[1];
    for (const int i : {2, 3, 0}) expected = product(expected, unit_texels[i]);
    EXPECT_EQ(window.pixel(2, 2), expected);
    glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE0 + 4);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
}

TEST(GlTextureUnits, TheRasterPositionHasTheCoordinatesOfAll) {
    Window window(8, 8);
    use_pixel_coordinates(window);
    for (int i = 0; i < 4; ++i) glMultiTexCoord4f(units[i], float(i), 2, 3, 4);
    glActiveTexture(GL_TEXTURE2);
    glMatrixMode(GL_TEXTURE);
    glScalef(3, 1, 1);
    glMatrixMode(GL_MODELVIEW);
    glRasterPos2i(1, 1);
    for (int i = 0; i < 4; ++i) {
        glActiveTexture(units[i]);
        EXPECT_EQ(coordinates(GL_CURRENT_RASTER_TEXTURE_COORDS),
                  (Coordinates{i == 2 ? 6.0 : i, 2, 3, 4}));
    }
    use_texture_of(GL_TEXTURE3, {{10, 20, 30, 255}, {255, 128, 0, 255}});
    glMultiTexCoord2f(GL_TEXTURE3, 0.75f, 0);
    glRasterPos2i(1, 1);
    constexpr Pixel drawn{100, 100, 100, 255};
    glDrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, drawn.data());
    EXPECT_EQ(window.pixel(1, 1), product(drawn, {255, 128, 0, 255}));
}

TEST(GlTextureUnits, DeletedTexturesAreBoundToNone) {
    const Window window;
    for (const GLenum unit : units) {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_2D, 7);
    }
    constexpr GLuint name = 7;
    glDeleteTextures(1, &name);
    for (const GLenum unit : units) {
        glActiveTexture(unit);
        EXPECT_EQ(integer(GL_TEXTURE_BINDING_2D), 0);
    }
}

TEST(GlTextureUnits, ClientStateIsOfTheirOwn) {
    const Window window;
    glClientActiveTexture(GL_TEXTURE2);
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    constexpr GLshort values[4] = {};
    glTexCoordPointer(3, GL_SHORT, 12, values);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glClientActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_SIZE), 4);
    glClientActiveTexture(GL_TEXTURE1);
    glInterleavedArrays(GL_T2F_V3F, 0, values);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_SIZE), 2);
    glClientActiveTexture(GL_TEXTURE0);
    EXPECT_FALSE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    glPopClientAttrib();
    EXPECT_EQ(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE2);
    EXPECT_TRUE(glIsEnabled(GL_TEXTURE_COORD_ARRAY));
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_SIZE), 3);
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_TYPE), GL_SHORT);
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_STRIDE), 12);
    GLvoid* pointer = nullptr;
    glGetPointerv(GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, values);
}

TEST(GlTextureUnits, ThoseThatAreOffCostNothing) {
    Window window;
    use_texture_of(GL_TEXTURE0, {unit_texels[0]});
    glBegin(GL_POINTS);
    glMultiTexCoord2f(GL_TEXTURE2, 0.5f, 1);
    glVertex2i(0, 0);
    glEnd();
    EXPECT_TRUE(window.context.assembler.mesh.further_texcoords.empty());
    flush_mesh(window.context);
    EXPECT_EQ(window.context.translated.state->more_textures.units, nullptr);
    EXPECT_EQ(further_textures(window.context), nullptr);
}

}  // namespace gw::gl
