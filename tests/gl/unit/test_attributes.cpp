// PushAttrib .. PopClientAttrib: every group's variables, and no others. [GL11] 6.1.10, tables 6.5
// to 6.22
#include "tests/gl/unit/support/snapshot.h"
#include "tests/gl/unit/support/window.h"

#include <algorithm>
#include <set>

namespace gw::gl {
namespace {

void set_current() {
    glColor4f(0.25f, 0.5f, 0.75f, 0.125f);
    glIndexf(7);
    glNormal3f(1, 0, 0.5f);
    glTexCoord4f(1, 2, 3, 4);
    glEdgeFlag(GL_FALSE);
    glRasterPos4f(0.25f, 0.5f, 0.125f, 1.5f);
}
void set_point() {
    glPointSize(3);
    glEnable(GL_POINT_SMOOTH);
}
void set_line() {
    glLineWidth(4);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(5, 0x1234);
}
void set_polygon() {
    glCullFace(GL_FRONT);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    glPolygonOffset(2, 3);
    for (const GLenum cap :
         {GL_CULL_FACE, GL_POLYGON_SMOOTH, GL_POLYGON_STIPPLE, GL_POLYGON_OFFSET_POINT,
          GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_FILL})
        glEnable(cap);
}
void set_polygon_stipple() {
    std::array<GLubyte, 128> mask{};
    mask.fill(0x5A);
    glPolygonStipple(mask.data());
}
void set_pixel_mode() {
    for (const GLenum name :
         {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE, GL_RED_BIAS,
          GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS})
        glPixelTransferf(name, 0.375f);
    for (const GLenum name : {GL_MAP_COLOR, GL_MAP_STENCIL, GL_INDEX_SHIFT, GL_INDEX_OFFSET})
        glPixelTransferi(name, 1);
    glPixelZoom(2, -3);
    glReadBuffer(GL_FRONT_LEFT);
}
void set_light(GLenum light) {
    const float color[] = {0.25f, 0.5f, 0.75f, 0.5f}, other[] = {0.5f, 1, 2, 1};
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) glLightfv(light, name, color);
    glLightfv(light, GL_POSITION, other);
    glLightfv(light, GL_SPOT_DIRECTION, other);
    glLightf(light, GL_SPOT_EXPONENT, 4);
    glLightf(light, GL_SPOT_CUTOFF, 30);
    for (const GLenum name :
         {GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
        glLightf(light, name, 0.5f);
    glEnable(light);
}
void set_lighting() {
    const float color[] = {0.375f, 0.5f, 0.625f, 0.25f};
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) set_light(light);
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_COLOR_INDEXES})
        glMaterialfv(GL_FRONT_AND_BACK, name, color);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, color);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glShadeModel(GL_FLAT);
    glColorMaterial(GL_BACK, GL_SPECULAR);
    glEnable(GL_LIGHTING);
    glEnable(GL_COLOR_MATERIAL);
}
void set_fog() {
    const float color[] = {0.25f, 0.5f, 0.75f, 1};
    glFogfv(GL_FOG_COLOR, color);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    for (const GLenum name : {GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END, GL_FOG_INDEX})
        glFogf(name, 5);
    glEnable(GL_FOG);
}
void set_depth() {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glClearDepth(0.5);
}
void set_accum() { glClearAccum(-0.5f, 0.25f, 0.5f, 1); }
void set_stencil() {
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_LESS, 3, 0x55);
    glStencilOp(GL_ZERO, GL_INCR, GL_INVERT);
    glStencilMask(0x33);
    glClearStencil(9);
}
void set_viewport() {
    glViewport(1, 2, 3, 4);
    glDepthRange(0.25, 0.75);
}
void set_transform() {
    const double plane[] = {1, 2, 3, 4};
    for (GLenum i = GL_CLIP_PLANE0; i <= GL_CLIP_PLANE5; ++i) {
        glClipPlane(i, plane);
        glEnable(i);
    }
    glEnable(GL_NORMALIZE);
    glMatrixMode(GL_TEXTURE);
}
void set_color_buffer() {
    for (const GLenum cap : {GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP, GL_INDEX_LOGIC_OP})
        glEnable(cap);
    glDisable(GL_DITHER);
    glAlphaFunc(GL_LESS, 0.5f);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glBlendEquation(GL_MIN);
    glBlendColor(0.25f, 0.5f, 0.75f, 1);
    glLogicOp(GL_XOR);
    glDrawBuffer(GL_FRONT_LEFT);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
    glIndexMask(0x11);
    glClearColor(0.25f, 0.5f, 0.75f, 1);
    glClearIndex(3);
}
void set_hint() {
    for (const GLenum name : {GL_PERSPECTIVE_CORRECTION_HINT, GL_POINT_SMOOTH_HINT,
                              GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_FOG_HINT})
        glHint(name, GL_NICEST);
}
void set_eval() {
    for (GLenum i = 0; i < 9; ++i) {
        glEnable(GL_MAP1_COLOR_4 + i);
        glEnable(GL_MAP2_COLOR_4 + i);
    }
    glEnable(GL_AUTO_NORMAL);
    glMapGrid1f(3, 2, 4);
    glMapGrid2f(4, 1, 5, 6, 2, 8);
}
void set_list() { glListBase(77); }
void set_texture() {
    const float values[] = {0.25f, 0.5f, 0.75f, 0.5f};
    for (const GLenum target :
         {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) {
        glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP);
        glTexParameteri(target, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
        glTexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
        glTexParameteri(target, GL_TEXTURE_COMPARE_FUNC, GL_LESS);
        glBindTexture(target, target);
        glBindTexture(target, 0);
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP);
        glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP);
        glTexParameterf(target, GL_TEXTURE_PRIORITY, 0.5f);
        glTexParameterfv(target, GL_TEXTURE_BORDER_COLOR, values);
        glEnable(target);
    }
    for (const GLenum coord : {GL_S, GL_T, GL_R, GL_Q}) {
        glTexGeni(coord, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
        glTexGenfv(coord, GL_OBJECT_PLANE, values);
        glTexGenfv(coord, GL_EYE_PLANE, values);
        glEnable(GL_TEXTURE_GEN_S + (coord - GL_S));
    }
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, values);
}
void set_multisample() {
    glSampleCoverage(0.5f, GL_TRUE);
    glDisable(GL_MULTISAMPLE);
    for (const GLenum cap :
         {GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE})
        glEnable(cap);
}
void set_scissor() {
    glScissor(1, 2, 3, 4);
    glEnable(GL_SCISSOR_TEST);
}

struct Group {
    GLbitfield bit;
    void (*set)();
};
/// The raster position comes first, while the matrices and tests are the initial ones.
constexpr Group groups[] = {{GL_CURRENT_BIT, set_current},
                            {GL_POINT_BIT, set_point},
                            {GL_LINE_BIT, set_line},
                            {GL_POLYGON_BIT, set_polygon},
                            {GL_POLYGON_STIPPLE_BIT, set_polygon_stipple},
                            {GL_PIXEL_MODE_BIT, set_pixel_mode},
                            {GL_LIGHTING_BIT, set_lighting},
                            {GL_FOG_BIT, set_fog},
                            {GL_DEPTH_BUFFER_BIT, set_depth},
                            {GL_ACCUM_BUFFER_BIT, set_accum},
                            {GL_STENCIL_BUFFER_BIT, set_stencil},
                            {GL_VIEWPORT_BIT, set_viewport},
                            {GL_TRANSFORM_BIT, set_transform},
                            {GL_COLOR_BUFFER_BIT, set_color_buffer},
                            {GL_HINT_BIT, set_hint},
                            {GL_EVAL_BIT, set_eval},
                            {GL_LIST_BIT, set_list},
                            {GL_TEXTURE_BIT, set_texture},
                            {GL_SCISSOR_BIT, set_scissor},
                            {GL_MULTISAMPLE_BIT, set_multisample}};

void set_all() {
    for (const Group& group : groups) group.set();
}

/// The variables that a group's setter changes in a new context.
std::set<std::string> variables_of(const Group& group) {
    const Window window;
    const Snapshot before = snapshot();
    group.set();
    const auto changed = changes(before, snapshot());
    return {changed.begin(), changed.end()};
}

}  // namespace

TEST(GlAttributes, EveryGroupHasVariablesOfItsOwn) {
    std::set<std::string> seen;
    for (const Group& group : groups)
        for (const std::string& name : variables_of(group))
            EXPECT_TRUE(seen.insert(name).second) << name << " is in two groups";
    EXPECT_GT(seen.size(), 250u);
}

TEST(GlAttributes, PopRestoresExactlyItsGroup) {
    for (const Group& group : groups) {
        const std::set<std::string> own = variables_of(group);
        const Window window;
        const Snapshot before = snapshot();
        glPushAttrib(group.bit);
        set_all();
        // COLOR_MATERIAL makes the materials depend on the current colour too.
        glDisable(GL_COLOR_MATERIAL);
        const Snapshot changed = snapshot();
        glPopAttrib();
        const Snapshot after = snapshot();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        for (const auto& [name, values] : after) {
            if (name == variable(GL_ATTRIB_STACK_DEPTH)) continue;
            const Snapshot& expected = own.contains(name) ? before : changed;
            EXPECT_EQ(values, expected.at(name)) << name << " of group " << group.bit;
        }
    }
}

TEST(GlAttributes, PopOfAllBitsRestoresEverything) {
    const Window window;
    const Snapshot before = snapshot();
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    set_all();
    glPopAttrib();
    EXPECT_EQ(changes(before, snapshot()), std::vector<std::string>{});
}

TEST(GlAttributes, EnableBitRestoresEveryCapabilityAndNothingElse) {
    const Window window;
    const Snapshot before = snapshot();
    glPushAttrib(GL_ENABLE_BIT);
    set_all();
    const Snapshot changed = snapshot();
    glPopAttrib();
    const Snapshot after = snapshot();
    int capabilities = 0;
    for (const auto& [name, values] : after) {
        if (name == variable(GL_ATTRIB_STACK_DEPTH) || name.find(' ') != std::string::npos ||
            name == "stipple")
            continue;
        glIsEnabled(GLenum(std::stoul(name, nullptr, 16)));
        const bool is_capability = glGetError() == GL_NO_ERROR;
        capabilities += is_capability;
        EXPECT_EQ(values, (is_capability ? before : changed).at(name)) << name;
    }
    // lights, clip planes, textures and their coordinates, samples, maps, client arrays
    EXPECT_EQ(capabilities, 23 + 8 + 6 + 4 + 4 + 4 + 18 + 6);
}

TEST(GlAttributes, MaterialsFollowTheColorUntilPopDisablesColorMaterial) {
    const Window window;
    glPushAttrib(GL_ENABLE_BIT);
    glEnable(GL_COLOR_MATERIAL);
    glColor4f(1, 0, 0.5f, 0.25f);
    glPopAttrib();
    glColor4f(0, 1, 0, 1);
    std::array<float, 4> diffuse{};
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse.data());
    EXPECT_EQ(diffuse, (std::array{1.0f, 0.0f, 0.5f, 0.25f}));
}

TEST(GlAttributes, TextureBitRestoresBindingsAndTheParametersOfBoundTextures) {
    const Window window;
    glBindTexture(GL_TEXTURE_2D, 5);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glPushAttrib(GL_TEXTURE_BIT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glBindTexture(GL_TEXTURE_2D, 6);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
    glPopAttrib();
    GLint bound = 0, wrap = 0;
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_EQ(bound, 5);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
    EXPECT_EQ(wrap, GL_CLAMP);
    glBindTexture(GL_TEXTURE_2D, 6);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, &wrap);
    EXPECT_EQ(wrap, GL_CLAMP);  // not bound when it was pushed: it keeps its parameters
}

TEST(GlAttributes, StacksOverflowAfterSixteenAndUnderflowWhenEmpty) {
    const Window window;
    glPopAttrib();
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
    glPopClientAttrib();
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_UNDERFLOW));
    for (int i = 0; i < 16; ++i) {
        glPushAttrib(GL_CURRENT_BIT);
        glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glPushAttrib(GL_CURRENT_BIT);
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
    glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    EXPECT_EQ(glGetError(), GLenum(GL_STACK_OVERFLOW));
}

TEST(GlAttributes, ClientAttributesRestoreTheirGroup) {
    const Window window;
    const float values[4] = {};
    const auto set = [&] {
        for (GLenum i = 0; i < 6; ++i) {
            glPixelStorei(GL_UNPACK_SWAP_BYTES + i, i == 5 ? 8 : 1);
            glPixelStorei(GL_PACK_SWAP_BYTES + i, i == 5 ? 2 : 1);
        }
        glVertexPointer(3, GL_DOUBLE, 64, values);
        glEnableClientState(GL_VERTEX_ARRAY);
        glColorPointer(3, GL_SHORT, 32, values);
        glEnableClientState(GL_COLOR_ARRAY);
        glEdgeFlagPointer(16, values);
        glEnableClientState(GL_EDGE_FLAG_ARRAY);
    };
    const Snapshot before = snapshot();
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    set();
    const Snapshot changed = snapshot();
    EXPECT_GE(changes(before, changed).size(), 12u + 9u);
    glPopClientAttrib();
    EXPECT_EQ(changes(before, snapshot()), std::vector<std::string>{});
    GLvoid* pointer = const_cast<float*>(values);
    glGetPointerv(GL_VERTEX_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, nullptr);

    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    set();
    glPopClientAttrib();
    EXPECT_EQ(changes(before, snapshot()).size(), 12u);  // pixel storage stays as it was set
}

}  // namespace gw::gl
