#include "bench/kinds/kinds.h"

#include <cstdint>
#include <utility>

namespace gw::bench {

namespace {

/// Textures of every sort, of 256 texels a side if nothing else is said.
struct Textures {
    GLuint plain = make_texture(GL_TEXTURE_2D, GL_LINEAR), nearest, mipmapped, odd, mirrored,
           bordered, line, volume, cube, depths, srgb;

    Textures() {
        fill(GL_RGBA8, 256, 256);
        nearest = make_texture(GL_TEXTURE_2D, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        fill(GL_RGBA8, 256, 256);
        mipmapped = make_texture(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
        fill(GL_RGBA8, 256, 256);
        odd = make_texture(GL_TEXTURE_2D, GL_LINEAR);
        fill(GL_RGBA8, 300, 200);
        mirrored = wrapped(GL_MIRRORED_REPEAT);
        bordered = wrapped(GL_CLAMP_TO_BORDER);
        line = make_texture(GL_TEXTURE_1D, GL_LINEAR);
        glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, noise().data());
        volume = make_texture(GL_TEXTURE_3D, GL_LINEAR);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 64, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     noise().data());
        cube = make_texture(GL_TEXTURE_CUBE_MAP, GL_LINEAR);
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 128, 128, 0, GL_RGBA,
                         GL_UNSIGNED_BYTE, noise().data());
        depths = make_texture(GL_TEXTURE_2D, GL_LINEAR);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 256, 256, 0, GL_DEPTH_COMPONENT,
                     GL_UNSIGNED_INT, noise().data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
        srgb = make_texture(GL_TEXTURE_2D, GL_LINEAR);
        fill(GL_SRGB8_ALPHA8, 256, 256);
    }

private:
    static void fill(GLint format, int width, int height) {
        glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     noise().data());
    }
    static GLuint wrapped(GLint wrap) {
        const GLuint name = make_texture(GL_TEXTURE_2D, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        fill(GL_RGBA8, 256, 256);
        return name;
    }
};
Textures& textures() {
    static Textures all;
    return all;
}

void use(GLuint texture, GLenum target = GL_TEXTURE_2D) {
    glEnable(target);
    glBindTexture(target, texture);
}
void use_units(std::initializer_list<GLuint> of_units) {
    GLenum unit = GL_TEXTURE0;
    for (const GLuint texture : of_units) {
        glActiveTexture(unit++);
        use(texture);
    }
    glActiveTexture(GL_TEXTURE0);
}
void combine(GLint function, float scale = 1) {
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, function);
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, scale);
}
void load(GLenum mode, float x_of_w, float y_of_w, float w) {
    const float matrix[16] = {1, 0, 0, x_of_w, 0, 1, 0, y_of_w, 0, 0, 1, 0, 0, 0, 0, w};
    glMatrixMode(mode);
    glLoadMatrixf(matrix);
    glMatrixMode(GL_MODELVIEW);
}
void blend(GLenum from, GLenum to) {
    glEnable(GL_BLEND);
    glBlendFunc(from, to);
}
void light(int count) {
    glEnable(GL_LIGHTING);
    for (int i = 0; i < count; ++i) {
        const float at[4] = {0.1f * float(i), 1, 1, 1};
        glEnable(GLenum(GL_LIGHT0 + i));
        glLightfv(GLenum(GL_LIGHT0 + i), GL_POSITION, at);
    }
}

/// `r`: texture coordinates have three numbers.
void put(float s, float t, float x, float y, float z, bool r = false) {
    for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE2, GL_TEXTURE3})
        glMultiTexCoord2f(unit, 2 * s, 2 * t);
    if (r)
        glTexCoord3f(s, t, z);
    else
        glTexCoord2f(s, t);
    glNormal3f(x / 2, y / 2, 0.7f);
    glColor4f(s, t, 1 - s, 0.5f + t / 2);
    glVertex3f(x, y, z / 2);
}
void draw_square(bool r) {
    glBegin(GL_QUADS);
    put(0, 0, -0.9f, -0.9f, 0.1f, r);
    put(2, 0.1f, 0.9f, -0.8f, 0.3f, r);
    put(2.1f, 2, 0.85f, 0.9f, 0.9f, r);
    put(0, 2, -0.8f, 0.85f, 0.4f, r);
    glEnd();
}
void draw_mesh() {
    constexpr int strips = 24;
    const auto at = [](int i) { return -0.9f + 1.8f * float(i) / strips; };
    for (int j = 0; j < strips; ++j) {
        glBegin(GL_TRIANGLE_STRIP);
        for (int i = 0; i <= strips; ++i)
            for (int k = 0; k < 2; ++k)
                put(at(i) + 1, at(j + k) + 1, at(i), at(j + k), 0.5f + 0.3f * at(i) * at(j + k));
        glEnd();
    }
}
void draw_points() {
    glBegin(GL_POINTS);
    for (int i = 0; i < 900; ++i)
        glVertex2f(-0.9f + 0.06f * float(i % 30), -0.9f + 0.06f * float(i / 30));
    glEnd();
}

Kind square(std::string name, std::function<void()> begin, bool r = false) {
    return {std::move(name), std::move(begin), [r] { draw_square(r); }};
}
Kind mesh(std::string name, std::function<void()> begin) {
    return {std::move(name), std::move(begin), draw_mesh};
}
Kind outline(std::string name, GLenum mode, std::function<void()> begin) {
    return mesh(std::move(name), [=, begin = std::move(begin)] {
        glPolygonMode(GL_FRONT_AND_BACK, mode);
        begin();
    });
}

/// 100,000 points that are scattered over the window.
Kind point_cloud() {
    static std::vector<float> at, color;
    const auto begin = [] {
        glEnable(GL_DEPTH_TEST);
        std::uint32_t seed = 1;
        const auto random = [&] { return float(seed = seed * 1664525 + 1013904223) / 0x1p32f; };
        at.clear();
        color.clear();
        for (int i = 0; i < 300000; ++i) {
            at.push_back(2 * random() - 1);
            color.push_back(random());
        }
    };
    return {"point-cloud", begin, [] {
                for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY})
                    glEnableClientState(array);
                glVertexPointer(3, GL_FLOAT, 0, at.data());
                glColorPointer(3, GL_FLOAT, 0, color.data());
                glClear(GL_DEPTH_BUFFER_BIT);
                glDrawArrays(GL_POINTS, 0, GLsizei(at.size() / 3));
                for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY})
                    glDisableClientState(array);
            }};
}

std::vector<Kind> texture_kinds() {
    return {
        square("linear", [] { use(textures().plain); }),
        square("nearest", [] { use(textures().nearest); }),
        square("mipmaps", [] { use(textures().mipmapped); }),
        square("odd-sides", [] { use(textures().odd); }),
        square("mirrored", [] { use(textures().mirrored); }),
        square("border", [] { use(textures().bordered); }),
        square(
            "three-coordinates", [] { use(textures().plain); }, true),
        square("one-dimension", [] { use(textures().line, GL_TEXTURE_1D); }),
        square(
            "volume", [] { use(textures().volume, GL_TEXTURE_3D); }, true),
        square(
            "cube", [] { use(textures().cube, GL_TEXTURE_CUBE_MAP); }, true),
        square(
            "compared-depths", [] { use(textures().depths); }, true),
        square("srgb", [] { use(textures().srgb); }),
        square("divided-by-q",
               [] {
                   use(textures().plain);
                   load(GL_TEXTURE, 0.1f, 0.2f, 1);
               }),
        square("perspective",
               [] {
                   use(textures().mipmapped);
                   load(GL_PROJECTION, 0.2f, 0.3f, 1.2f);
               }),
        square("two-units",
               [] {
                   use_units({textures().plain, textures().mipmapped});
               }),
        square("four-units",
               [] {
                   const Textures& t = textures();
                   use_units({t.plain, t.mipmapped, t.plain, t.mipmapped});
               }),
        square("combine-dot3",
               [] {
                   use(textures().plain);
                   combine(GL_DOT3_RGB);
               }),
        square("combine-interpolate",
               [] {
                   use(textures().plain);
                   combine(GL_INTERPOLATE);
               }),
        square("light-map",
               [] {
                   use_units({textures().mipmapped, textures().plain});
                   glActiveTexture(GL_TEXTURE1);
                   combine(GL_MODULATE, 2);
                   glActiveTexture(GL_TEXTURE0);
               }),
        mesh("sphere-map",
             [] {
                 use(textures().plain);
                 for (const GLenum c : {GL_S, GL_T})
                     glTexGeni(c, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
                 glEnable(GL_TEXTURE_GEN_S);
                 glEnable(GL_TEXTURE_GEN_T);
             }),
    };
}

std::vector<Kind> plain_kinds() {
    return {
        square("plain", [] {}),
        mesh("plain-mesh", [] {}),
        square("fog",
               [] {
                   glEnable(GL_FOG);
                   glFogi(GL_FOG_MODE, GL_EXP2);
               }),
        square("fog-coordinate",
               [] {
                   glEnable(GL_FOG);
                   glFogi(GL_FOG_MODE, GL_EXP2);
                   glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
                   glFogCoordf(0.7f);
               }),
        square("alpha-test",
               [] {
                   glEnable(GL_ALPHA_TEST);
                   glAlphaFunc(GL_GREATER, 0.7f);
               }),
        square("blend", [] { blend(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }),
        square("blend-destination-alpha", [] { blend(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA); }),
        square("blend-max",
               [] {
                   glEnable(GL_BLEND);
                   glBlendEquation(GL_MAX);
               }),
        square("logic-op",
               [] {
                   glEnable(GL_COLOR_LOGIC_OP);
                   glLogicOp(GL_XOR);
               }),
        square("depth", [] { glEnable(GL_DEPTH_TEST); }),
        square("stencil",
               [] {
                   glEnable(GL_STENCIL_TEST);
                   glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
               }),
        square("stipple",
               [] {
                   glEnable(GL_POLYGON_STIPPLE);
                   glPolygonStipple(noise().data());
               }),
        square("secondary-color",
               [] {
                   glEnable(GL_COLOR_SUM);
                   glSecondaryColor3f(0.2f, 0.1f, 0.3f);
               }),
        mesh("lit", [] { light(1); }),
        mesh("lit-by-eight", [] { light(8); }),
        mesh("separate-specular",
             [] {
                 const float white[4] = {1, 1, 1, 1};
                 use(textures().plain);
                 light(1);
                 glMaterialfv(GL_FRONT, GL_SPECULAR, white);
                 glMaterialf(GL_FRONT, GL_SHININESS, 20);
                 glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
             }),
        outline("lines", GL_LINE, [] {}),
        outline("wide-lines", GL_LINE, [] { glLineWidth(3); }),
        outline("smooth-lines", GL_LINE,
                [] {
                    glEnable(GL_LINE_SMOOTH);
                    blend(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                }),
        point_cloud(),
        outline("points", GL_POINT, [] { glPointSize(5); }),
        outline("smooth-points", GL_POINT,
                [] {
                    glPointSize(5);
                    glEnable(GL_POINT_SMOOTH);
                    blend(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                }),
        {"sprites",
         [] {
             use(textures().plain);
             glEnable(GL_POINT_SPRITE);
             glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
             glPointSize(16);
         },
         draw_points},
        mesh("smooth-polygons",
             [] {
                 glEnable(GL_POLYGON_SMOOTH);
                 blend(GL_SRC_ALPHA_SATURATE, GL_ONE);
             }),
        {"selection", [] {},
         [] {
             static std::vector<GLuint> hits(4096);
             glSelectBuffer(GLsizei(hits.size()), hits.data());
             glRenderMode(GL_SELECT);
             glPushName(1);
             draw_mesh();
             glRenderMode(GL_RENDER);
         }},
        {"feedback", [] {},
         [] {
             static std::vector<GLfloat> values(1 << 16);
             glFeedbackBuffer(GLsizei(values.size()), GL_3D_COLOR, values.data());
             glRenderMode(GL_FEEDBACK);
             draw_mesh();
             glRenderMode(GL_RENDER);
         }},
    };
}

}  // namespace

std::vector<Kind> fragment_kinds() {
    std::vector<Kind> out = plain_kinds();
    for (Kind& kind : texture_kinds()) out.push_back(std::move(kind));
    return out;
}

}  // namespace gw::bench
