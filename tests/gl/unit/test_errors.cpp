// Wrong arguments: the error that the specification prescribes, and nothing else changes.
#include "tests/gl/unit/support/window.h"

#include <cmath>

namespace gw::gl {
namespace {

struct Case {
    const char* text;
    GLenum error;
    void (*call)();
};

GLfloat numbers[64] = {};
GLuint names[4] = {1, 2, 3, 4};
GLubyte texels[4 * 64 * 64] = {};

constexpr GLenum bad_enum = GL_INVALID_ENUM, bad_value = GL_INVALID_VALUE;
constexpr GLenum bad_operation = GL_INVALID_OPERATION;

const std::vector<Case> cases{
    {"Begin 10", bad_enum, [] { glBegin(10); }},
    {"End", bad_operation, [] { glEnd(); }},
    {"Enable RED", bad_enum, [] { glEnable(GL_RED); }},
    {"Disable LIGHT0 + 8", bad_enum, [] { glDisable(GL_LIGHT0 + 8); }},
    {"IsEnabled RED", bad_enum, [] { glIsEnabled(GL_RED); }},
    {"EnableClientState RED", bad_enum, [] { glEnableClientState(GL_RED); }},
    {"VertexPointer size 1", bad_value, [] { glVertexPointer(1, GL_FLOAT, 0, numbers); }},
    {"VertexPointer size 5", bad_value, [] { glVertexPointer(5, GL_FLOAT, 0, numbers); }},
    {"VertexPointer type BYTE", bad_enum, [] { glVertexPointer(3, GL_BYTE, 0, numbers); }},
    {"VertexPointer stride -1", bad_value, [] { glVertexPointer(3, GL_FLOAT, -1, numbers); }},
    {"NormalPointer type UNSIGNED_BYTE", bad_enum,
     [] { glNormalPointer(GL_UNSIGNED_BYTE, 0, numbers); }},
    {"ColorPointer size 2", bad_value, [] { glColorPointer(2, GL_FLOAT, 0, numbers); }},
    {"TexCoordPointer size 0", bad_value, [] { glTexCoordPointer(0, GL_FLOAT, 0, numbers); }},
    {"InterleavedArrays RED", bad_enum, [] { glInterleavedArrays(GL_RED, 0, numbers); }},
    {"InterleavedArrays stride -1", bad_value, [] { glInterleavedArrays(GL_V3F, -1, numbers); }},
    {"DrawArrays mode 10", bad_enum, [] { glDrawArrays(10, 0, 1); }},
    {"DrawArrays count -1", bad_value, [] { glDrawArrays(GL_POINTS, 0, -1); }},
    {"DrawElements type FLOAT", bad_enum, [] { glDrawElements(GL_POINTS, 1, GL_FLOAT, names); }},
    {"DrawElements count -1", bad_value,
     [] { glDrawElements(GL_POINTS, -1, GL_UNSIGNED_INT, names); }},
    {"MatrixMode COLOR", bad_enum, [] { glMatrixMode(GL_COLOR); }},
    {"Viewport width -1", bad_value, [] { glViewport(0, 0, -1, 1); }},
    {"Frustum near 0", bad_value, [] { glFrustum(-1, 1, -1, 1, 0, 1); }},
    {"Frustum left = right", bad_value, [] { glFrustum(1, 1, -1, 1, 1, 2); }},
    {"Ortho bottom = top", bad_value, [] { glOrtho(-1, 1, 2, 2, 1, 2); }},
    {"PopMatrix", GL_STACK_UNDERFLOW, [] { glPopMatrix(); }},
    {"TexGen coord RED", bad_enum, [] { glTexGeni(GL_RED, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR); }},
    {"TexGen R SPHERE_MAP", bad_enum, [] { glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }},
    {"TexGeni S OBJECT_PLANE", bad_enum, [] { glTexGeni(GL_S, GL_OBJECT_PLANE, 1); }},
    {"ClipPlane 6", bad_enum,
     [] {
         const GLdouble plane[4] = {};
         glClipPlane(GL_CLIP_PLANE0 + 6, plane);
     }},
    {"Light LIGHT8", bad_enum, [] { glLightf(GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 45); }},
    {"Lightf POSITION", bad_enum, [] { glLightf(GL_LIGHT0, GL_POSITION, 45); }},
    {"Light cutoff 91", bad_value, [] { glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91); }},
    {"Light exponent 129", bad_value, [] { glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129); }},
    {"Light attenuation -1", bad_value, [] { glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1); }},
    {"LightModel RED", bad_enum, [] { glLightModelf(GL_RED, 1); }},
    {"Material face LEFT", bad_enum, [] { glMaterialfv(GL_LEFT, GL_AMBIENT, numbers); }},
    {"Materialf AMBIENT", bad_enum, [] { glMaterialf(GL_FRONT, GL_AMBIENT, 1); }},
    {"Material shininess 129", bad_value, [] { glMaterialf(GL_FRONT, GL_SHININESS, 129); }},
    {"ColorMaterial SHININESS", bad_enum, [] { glColorMaterial(GL_FRONT, GL_SHININESS); }},
    {"ShadeModel FRONT", bad_enum, [] { glShadeModel(GL_FRONT); }},
    {"FrontFace FRONT", bad_enum, [] { glFrontFace(GL_FRONT); }},
    {"CullFace CW", bad_enum, [] { glCullFace(GL_CW); }},
    {"PointSize 0", bad_value, [] { glPointSize(0); }},
    {"PointSize NaN", bad_value, [] { glPointSize(std::nanf("")); }},
    {"LineWidth -1", bad_value, [] { glLineWidth(-1); }},
    {"PolygonMode face LEFT", bad_enum, [] { glPolygonMode(GL_LEFT, GL_FILL); }},
    {"PolygonMode FLAT", bad_enum, [] { glPolygonMode(GL_FRONT, GL_FLAT); }},
    {"PixelStore alignment 3", bad_value, [] { glPixelStorei(GL_PACK_ALIGNMENT, 3); }},
    {"PixelStore row length -1", bad_value, [] { glPixelStorei(GL_UNPACK_ROW_LENGTH, -1); }},
    {"PixelStore RED", bad_enum, [] { glPixelStorei(GL_RED, 1); }},
    {"PixelTransfer RED", bad_enum, [] { glPixelTransferf(GL_RED, 1); }},
    {"PixelMap RED", bad_enum, [] { glPixelMapfv(GL_RED, 1, numbers); }},
    {"PixelMap I_TO_R size 3", bad_value, [] { glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 3, numbers); }},
    {"PixelMap size 0", bad_value, [] { glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, numbers); }},
    {"DrawPixels width -1", bad_value,
     [] { glDrawPixels(-1, 1, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"DrawPixels format RED_BITS", bad_enum,
     [] { glDrawPixels(1, 1, GL_RED_BITS, GL_UNSIGNED_BYTE, texels); }},
    {"DrawPixels RGB BITMAP", bad_enum, [] { glDrawPixels(1, 1, GL_RGB, GL_BITMAP, texels); }},
    {"Bitmap height -1", bad_value, [] { glBitmap(1, -1, 0, 0, 0, 0, texels); }},
    {"CopyPixels RGB", bad_enum, [] { glCopyPixels(0, 0, 1, 1, GL_RGB); }},
    {"ReadPixels type DOUBLE", bad_enum,
     [] { glReadPixels(0, 0, 1, 1, GL_RGB, GL_DOUBLE, texels); }},
    {"ReadPixels COLOR_INDEX", bad_operation,
     [] { glReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, texels); }},
    {"ReadPixels height -1", bad_value,
     [] { glReadPixels(0, 0, 1, -1, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D target 1D", bad_enum,
     [] { glTexImage2D(GL_TEXTURE_1D, 0, 3, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D width 16384", bad_value,
     [] { glTexImage2D(GL_TEXTURE_2D, 0, 3, 16384, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D level -1", bad_value,
     [] { glTexImage2D(GL_TEXTURE_2D, -1, 3, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D border 2", bad_value,
     [] { glTexImage2D(GL_TEXTURE_2D, 0, 3, 4, 4, 2, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D components 5", bad_value,
     [] { glTexImage2D(GL_TEXTURE_2D, 0, 5, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexImage2D format STENCIL_INDEX", bad_enum,
     [] {
         glTexImage2D(GL_TEXTURE_2D, 0, 3, 4, 4, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, texels);
     }},
    {"TexSubImage2D of no image", bad_operation,
     [] { glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, texels); }},
    {"TexSubImage2D outside", bad_value,
     [] {
         glTexImage2D(GL_TEXTURE_2D, 0, 3, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
         glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 2, 1, GL_RGB, GL_UNSIGNED_BYTE, texels);
     }},
    {"TexParameter wrap LINEAR", bad_enum,
     [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR); }},
    {"TexParameter mag filter mipmap", bad_enum,
     [] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR); }},
    {"TexEnv mode BLEND_SRC", bad_enum,
     [] { glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND_SRC); }},
    {"BindTexture target RED", bad_enum, [] { glBindTexture(GL_RED, 1); }},
    {"BindTexture of another target", bad_operation,
     [] {
         glBindTexture(GL_TEXTURE_1D, 77);
         glBindTexture(GL_TEXTURE_2D, 77);
     }},
    {"GenTextures -1", bad_value, [] { glGenTextures(-1, names); }},
    {"DeleteTextures -1", bad_value, [] { glDeleteTextures(-1, names); }},
    {"Fog mode NEAREST", bad_enum, [] { glFogi(GL_FOG_MODE, GL_NEAREST); }},
    {"Fog density -1", bad_value, [] { glFogf(GL_FOG_DENSITY, -1); }},
    {"Scissor width -1", bad_value, [] { glScissor(0, 0, -1, 0); }},
    {"AlphaFunc KEEP", bad_enum, [] { glAlphaFunc(GL_KEEP, 0); }},
    {"StencilFunc KEEP", bad_enum, [] { glStencilFunc(GL_KEEP, 0, 1); }},
    {"StencilOp ALWAYS", bad_enum, [] { glStencilOp(GL_KEEP, GL_KEEP, GL_ALWAYS); }},
    {"DepthFunc KEEP", bad_enum, [] { glDepthFunc(GL_KEEP); }},
    {"BlendFunc source RED", bad_enum, [] { glBlendFunc(GL_RED, GL_ONE); }},
    {"BlendFunc destination SRC_ALPHA_SATURATE", bad_enum,
     [] { glBlendFunc(GL_ONE, GL_SRC_ALPHA_SATURATE); }},
    {"LogicOp ALWAYS", bad_enum, [] { glLogicOp(GL_ALWAYS); }},
    {"DrawBuffer RED", bad_enum, [] { glDrawBuffer(GL_RED); }},
    {"DrawBuffer AUX0", bad_operation, [] { glDrawBuffer(GL_AUX0); }},
    {"ReadBuffer RED", bad_enum, [] { glReadBuffer(GL_RED); }},
    {"Clear bit 0", bad_value, [] { glClear(1); }},
    {"Accum RETURN + 9", bad_enum, [] { glAccum(GL_RETURN + 9, 1); }},
    {"Map1 order 0", bad_value, [] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, numbers); }},
    {"Map1 stride 2", bad_value, [] { glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, numbers); }},
    {"Map1 u1 = u2", bad_value, [] { glMap1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, numbers); }},
    {"Map2 target MAP1", bad_enum,
     [] { glMap2f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, 0, 1, 3, 2, numbers); }},
    {"MapGrid1 0", bad_value, [] { glMapGrid1f(0, 0, 1); }},
    {"EvalMesh1 FILL", bad_enum, [] { glEvalMesh1(GL_FILL, 0, 1); }},
    {"RenderMode FILL", bad_enum, [] { glRenderMode(GL_FILL); }},
    {"RenderMode SELECT without buffer", bad_operation, [] { glRenderMode(GL_SELECT); }},
    {"FeedbackBuffer RED", bad_enum, [] { glFeedbackBuffer(4, GL_RED, numbers); }},
    {"NewList 0", bad_value, [] { glNewList(0, GL_COMPILE); }},
    {"NewList mode", bad_enum, [] { glNewList(1, GL_RENDER); }},
    {"EndList", bad_operation, [] { glEndList(); }},
    {"CallLists -1", bad_value, [] { glCallLists(-1, GL_UNSIGNED_INT, names); }},
    {"CallLists DOUBLE", bad_enum, [] { glCallLists(1, GL_DOUBLE, names); }},
    {"GenLists -1", bad_value, [] { glGenLists(-1); }},
    {"DeleteLists -1", bad_value, [] { glDeleteLists(1, -1); }},
    {"Hint RED", bad_enum, [] { glHint(GL_RED, GL_NICEST); }},
    {"Hint mode RED", bad_enum, [] { glHint(GL_FOG_HINT, GL_RED); }},
    {"GetFloatv RED", bad_enum, [] { glGetFloatv(GL_RED, numbers); }},
    {"GetString RED", bad_enum, [] { glGetString(GL_RED); }},
    {"GetLight AMBIENT_AND_DIFFUSE", bad_enum,
     [] { glGetLightfv(GL_LIGHT0, GL_AMBIENT_AND_DIFFUSE, numbers); }},
    {"GetMaterial FRONT_AND_BACK", bad_enum,
     [] { glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, numbers); }},
    {"GetTexLevelParameter level 99", bad_value,
     [] { glGetTexLevelParameterfv(GL_TEXTURE_2D, 99, GL_TEXTURE_WIDTH, numbers); }},
    {"PopAttrib", GL_STACK_UNDERFLOW, [] { glPopAttrib(); }},
    {"PopClientAttrib", GL_STACK_UNDERFLOW, [] { glPopClientAttrib(); }},
};

TEST(Errors, AreThoseOfTheSpecification) {
    for (const Case& c : cases) {
        const Window window;
        c.call();
        EXPECT_EQ(glGetError(), c.error) << c.text;
    }
}

/// Numbers that are none, or beyond the machine's, are replaced or draw nothing; the frame is drawn.
TEST(Errors, NumbersThatAreNotFiniteLoseNothing) {
    const GLfloat nan = std::nanf(""), inf = HUGE_VALF;
    const Window window;
    use_pixel_coordinates(window);
    testing::internal::CaptureStderr();
    glClearColor(nan, 1, inf, -inf);
    glClearDepth(std::nan(""));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glAlphaFunc(GL_ALWAYS, nan);
    glPolygonOffset(nan, inf);
    glDepthRange(std::nan(""), 1);
    glPointSize(inf);
    glLineWidth(inf);
    glFogf(GL_FOG_END, nan);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, nan);
    glPixelZoom(nan, inf);
    glBegin(GL_TRIANGLES);
    glColor4f(nan, inf, -inf, nan);
    glNormal3f(nan, inf, 0);
    glTexCoord4f(nan, inf, -inf, nan);
    glVertex2f(0, 0);
    glVertex2f(4, 0);
    glVertex2f(0, 4);
    glEnd();
    glPushMatrix();
    for (int i = 0; i < 10; ++i) glScalef(3e38f, 3e38f, 3e38f);
    glRectf(0, 0, 32, 32);
    glPopMatrix();
    glViewport(0, 0, 0, 0);
    glRectf(0, 0, 32, 32);
    EXPECT_EQ(window.pixel(20, 20), (std::array<GLubyte, 4>{0, 255, 255, 0}));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// A list keeps wrong calls too; the error comes when it is played. [GL11] 5.4
TEST(Errors, OfListedCallsComeWhenTheListIsPlayed) {
    const Window window;
    glNewList(1, GL_COMPILE);
    glShadeModel(GL_FRONT);
    glEndList();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glCallList(1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
}

TEST(Errors, StacksEndAtTheirDepths) {
    const Window window;
    for (int i = 1; i < 32; ++i) glPushMatrix();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glPushMatrix();
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
    for (int i = 0; i < 16; ++i) glPushAttrib(GL_ALL_ATTRIB_BITS);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
}

}  // namespace
}  // namespace gw::gl
