// A call that sets what is set leaves the mesh open that is being assembled; one that sets something
// else draws it with the old state. Programs load the same matrix for every shape.
#include "tests/gl/unit/support/picture.h"

#include <cmath>

namespace gw::gl {
namespace {

struct Setting {
    const char* name;
    void (*set)(bool other);
};

void load(GLenum mode, bool other) {
    GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1};
    if (other) m[12] = 4;
    glMatrixMode(mode);
    glLoadMatrixf(m);
    glMatrixMode(GL_MODELVIEW);
}

constexpr GLfloat greys[2][4] = {{0.25f, 0.25f, 0.25f, 1}, {0.5f, 0.5f, 0.5f, 1}};
constexpr GLdouble planes[2][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}};

constexpr Setting settings[] = {
    {"LoadMatrix, modelview", [](bool other) { load(GL_MODELVIEW, other); }},
    {"LoadMatrix, projection", [](bool other) { load(GL_PROJECTION, other); }},
    {"LoadMatrix, texture", [](bool other) { load(GL_TEXTURE, other); }},
    {"Translate", [](bool other) { glTranslatef(other, 0, 0); }},
    {"Scale", [](bool other) { glScalef(1, other ? 2 : 1, 1); }},
    {"Rotate", [](bool other) { glRotatef(other ? 90 : 0, 0, 0, 1); }},
    {"PushMatrix to PopMatrix",
     [](bool other) {
         glPushMatrix();
         if (other) glTranslatef(1, 0, 0);
         glPopMatrix();
     }},
    {"PushAttrib to PopAttrib",
     [](bool other) {
         glPushAttrib(GL_ALL_ATTRIB_BITS);
         if (other) glEnable(GL_BLEND);
         glPopAttrib();
     }},
    {"a colour from PushAttrib to PopAttrib",
     [](bool other) {
         glPushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT);
         glColor3f(0, 1, 0);
         glMaterialfv(GL_FRONT, GL_DIFFUSE, greys[0]);
         if (other) glShadeModel(GL_FLAT);
         glPopAttrib();
     }},
    {"Enable", [](bool other) { (other ? glDisable : glEnable)(GL_LIGHTING); }},
    {"Lightfv", [](bool other) { glLightfv(GL_LIGHT0, GL_DIFFUSE, greys[other]); }},
    {"Lightfv, position", [](bool other) { glLightfv(GL_LIGHT0, GL_POSITION, greys[other]); }},
    {"Lightf", [](bool other) { glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, other ? 20 : 30); }},
    {"LightModelfv", [](bool other) { glLightModelfv(GL_LIGHT_MODEL_AMBIENT, greys[other]); }},
    {"LightModeli", [](bool other) { glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, other); }},
    {"ColorMaterial",
     [](bool other) { glColorMaterial(GL_FRONT, other ? GL_DIFFUSE : GL_AMBIENT); }},
    {"ShadeModel", [](bool other) { glShadeModel(other ? GL_FLAT : GL_SMOOTH); }},
    {"Viewport", [](bool other) { glViewport(0, 0, 32, other ? 32 : 16); }},
    {"DepthRange", [](bool other) { glDepthRange(0, other ? 1 : 0.5); }},
    {"ClipPlane", [](bool other) { glClipPlane(GL_CLIP_PLANE0, planes[other]); }},
    {"TexGeni",
     [](bool other) {
         glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, other ? GL_SPHERE_MAP : GL_OBJECT_LINEAR);
     }},
    {"TexGendv", [](bool other) { glTexGendv(GL_S, GL_EYE_PLANE, planes[other]); }},
    {"PointSize", [](bool other) { glPointSize(other ? 2 : 3); }},
    {"PointParameterf", [](bool other) { glPointParameterf(GL_POINT_SIZE_MIN, other ? 2 : 3); }},
    {"LineWidth", [](bool other) { glLineWidth(other ? 2 : 3); }},
    {"LineStipple", [](bool other) { glLineStipple(1, other ? 2 : 3); }},
    {"CullFace", [](bool other) { glCullFace(other ? GL_BACK : GL_FRONT); }},
    {"FrontFace", [](bool other) { glFrontFace(other ? GL_CCW : GL_CW); }},
    {"PolygonMode", [](bool other) { glPolygonMode(GL_FRONT, other ? GL_FILL : GL_LINE); }},
    {"PolygonOffset", [](bool other) { glPolygonOffset(1, other ? 2 : 3); }},
    {"PolygonStipple",
     [](bool other) {
         GLubyte pattern[128] = {GLubyte(other ? 1 : 2)};
         glPolygonStipple(pattern);
     }},
    {"BindTexture", [](bool other) { glBindTexture(GL_TEXTURE_2D, other ? 2 : 1); }},
    {"TexParameteri",
     [](bool other) {
         glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, other ? GL_REPEAT : GL_CLAMP);
     }},
    {"TexParameteri, level",
     [](bool other) { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, other ? 2 : 3); }},
    {"TexParameteri, depths",
     [](bool other) {
         glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, other ? GL_LUMINANCE : GL_ALPHA);
     }},
    {"TexParameterfv",
     [](bool other) { glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, greys[other]); }},
    {"TexEnvi",
     [](bool other) {
         glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, other ? GL_MODULATE : GL_DECAL);
     }},
    {"TexEnvfv",
     [](bool other) { glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, greys[other]); }},
    {"Fogi", [](bool other) { glFogi(GL_FOG_MODE, other ? GL_EXP : GL_LINEAR); }},
    {"Fogfv", [](bool other) { glFogfv(GL_FOG_COLOR, greys[other]); }},
    {"Scissor", [](bool other) { glScissor(0, 0, 8, other ? 8 : 9); }},
    {"AlphaFunc", [](bool other) { glAlphaFunc(GL_GREATER, other ? 0.5f : 0.25f); }},
    {"StencilFunc", [](bool other) { glStencilFunc(GL_EQUAL, other, 1); }},
    {"StencilOp", [](bool other) { glStencilOp(GL_KEEP, GL_KEEP, other ? GL_KEEP : GL_INCR); }},
    {"StencilMask", [](bool other) { glStencilMask(other ? 1 : 2); }},
    {"DepthFunc", [](bool other) { glDepthFunc(other ? GL_LESS : GL_LEQUAL); }},
    {"DepthMask", [](bool other) { glDepthMask(GLboolean(other)); }},
    {"BlendFunc", [](bool other) { glBlendFunc(GL_ONE, other ? GL_ONE : GL_DST_ALPHA); }},
    {"BlendEquation", [](bool other) { glBlendEquation(other ? GL_MIN : GL_MAX); }},
    {"BlendColor", [](bool other) { glBlendColor(other, 0, 0, 0); }},
    {"LogicOp", [](bool other) { glLogicOp(other ? GL_COPY : GL_XOR); }},
    {"ColorMask", [](bool other) { glColorMask(GLboolean(other), 1, 1, 1); }},
    {"SampleCoverage", [](bool other) { glSampleCoverage(other ? 0.5f : 0.25f, GL_FALSE); }},
    {"DrawBuffer", [](bool other) { glDrawBuffer(other ? GL_NONE : GL_FRONT); }},
};

void draw_square(float x) {
    glBegin(GL_QUADS);
    glVertex2f(x, 2);
    glVertex2f(x + 8, 2);
    glVertex2f(x + 8, 10);
    glVertex2f(x, 10);
    glEnd();
}

TEST(EqualValues, LeaveTheOpenMeshOpen) {
    for (const Setting& s : settings) {
        const Window window;
        const auto is_open = [&] { return !window.context.assembler.mesh.empty(); };
        use_pixel_coordinates(window);
        s.set(false);
        draw_square(0);
        ASSERT_TRUE(is_open()) << s.name;
        s.set(false);
        EXPECT_TRUE(is_open()) << s.name;
        s.set(true);
        EXPECT_FALSE(is_open()) << s.name;
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << s.name;
    }
}

/// A zero with the other sign is another matrix.
TEST(EqualValues, OfMatricesHaveEqualBits) {
    const Window window;
    GLfloat m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, found[16];
    glLoadMatrixf(m);
    m[1] = -0.0f;
    glLoadMatrixf(m);
    glGetFloatv(GL_MODELVIEW_MATRIX, found);
    EXPECT_TRUE(std::signbit(found[1]));
}

/// PopAttrib brings materials back for the vertices after it, in the same mesh.
TEST(EqualValues, OfPoppedMaterialsAreThoseOfLaterVertices) {
    const auto squares = [](bool finishes) {
        glEnable(GL_LIGHTING);
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, greys[1]);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, greys[1]);
        draw_square(0);
        glPushAttrib(GL_LIGHTING_BIT);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, greys[0]);
        draw_square(10);
        if (finishes) glFinish();
        glPopAttrib();
        if (finishes) glFinish();
        draw_square(20);
    };
    expect_same_picture([&] { squares(false); }, [&] { squares(true); });
}

}  // namespace
}  // namespace gw::gl
