// The table of entry points, and the rule of Begin and End that is asked for all of them.
#include "gl/entry/entry_points.h"

#include "tests/gl/unit/support/window.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace gw::gl {
namespace {

TEST(EntryPoints, HaveEachNameOnce) {
    std::set<std::string> names;
    for (const EntryPoint& point : entry_points())
        EXPECT_TRUE(names.insert(point.name).second) << point.name;
}

TEST(EntryPoints, AreFoundByTheirNames) {
    for (const EntryPoint& point : entry_points())
        EXPECT_EQ(find_entry_point(point.name), point.address) << point.name;
    EXPECT_EQ(find_entry_point("glNoSuchFunction"), nullptr);
    EXPECT_EQ(find_entry_point(nullptr), nullptr);
}

/// [GL11] has 336 functions; the others are of extensions.
TEST(EntryPoints, AreThe336OfVersion1_1) {
    const auto is_extension = [](const std::string& name) {
        return name.ends_with("EXT") || name.ends_with("ARB") || name.ends_with("MESA") ||
               name.starts_with("glBlendColor") || name.starts_with("glBlendEquation") ||
               name == "glDrawRangeElements";
    };
    const auto count = std::ranges::count_if(entry_points(), [&](const EntryPoint& point) {
        return is_offered(point.offer, opengl(), 11) && !is_extension(point.name);
    });
    EXPECT_EQ(count, 336);
}

/// SDL 2 draws by glBlendFuncSeparate if it finds it.
TEST(EntryPoints, AreOfferedByTheVersionThatHasThemAndByTheProfile) {
    const auto offer = [](std::string_view name) {
        return std::ranges::find(entry_points(), name, &EntryPoint::name)->offer;
    };
    for (int version = first_version; version <= last_version; ++version) {
        EXPECT_TRUE(is_offered(offer("glBegin"), vgx(), version));
        EXPECT_EQ(is_offered(offer("glLoadTransposeMatrixf"), opengl(), version), version >= 13);
        EXPECT_EQ(is_offered(offer("glBlendFuncSeparate"), opengl(), version), version >= 14);
        EXPECT_EQ(is_offered(offer("glGenBuffers"), opengl(), version), version >= 15);
        EXPECT_FALSE(is_offered(offer("glBlendFuncSeparate"), vgx(), version));
    }
}

TEST(EntryPoints, DoNothingWithoutAContext) {
    glBegin(GL_TRIANGLES);
    glEnd();
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(glGetString(GL_VERSION), nullptr);
    EXPECT_EQ(glGenLists(1), 0u);
}

/// Calls with arguments that are right outside of Begin and End.
struct Call {
    const char* name;
    void (*call)();
};
const std::vector<Call> forbidden_inside{
    {"glBegin", [] { glBegin(GL_POINTS); }},
    {"glEnable", [] { glEnable(GL_DEPTH_TEST); }},
    {"glDisable", [] { glDisable(GL_DEPTH_TEST); }},
    {"glClear", [] { glClear(GL_COLOR_BUFFER_BIT); }},
    {"glMatrixMode", [] { glMatrixMode(GL_MODELVIEW); }},
    {"glLoadIdentity", [] { glLoadIdentity(); }},
    {"glPushMatrix", [] { glPushMatrix(); }},
    {"glViewport", [] { glViewport(0, 0, 8, 8); }},
    {"glRectf", [] { glRectf(0, 0, 1, 1); }},
    {"glRasterPos2f", [] { glRasterPos2f(0, 0); }},
    {"glDrawArrays", [] { glDrawArrays(GL_POINTS, 0, 0); }},
    {"glGenLists", [] { glGenLists(1); }},
    {"glNewList", [] { glNewList(1, GL_COMPILE); }},
    {"glPushAttrib", [] { glPushAttrib(GL_CURRENT_BIT); }},
    {"glFlush", [] { glFlush(); }},
    {"glGetString", [] { glGetString(GL_VERSION); }},
    {"glIsEnabled", [] { glIsEnabled(GL_BLEND); }},
    {"glEvalMesh1", [] { glEvalMesh1(GL_POINT, 0, 1); }},
    {"glRenderMode", [] { glRenderMode(GL_RENDER); }},
    {"glShadeModel", [] { glShadeModel(GL_FLAT); }},
};

TEST(BeginEnd, RefusesWhatMayNotStandBetween) {
    const Window window;
    for (const Call& call : forbidden_inside) {
        glBegin(GL_POINTS);
        call.call();
        glEnd();
        EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION)) << call.name;
    }
}

TEST(BeginEnd, TakesTheValuesOfVertices) {
    const Window window;
    const GLfloat shininess = 3;
    glBegin(GL_POINTS);
    glColor3f(1, 0, 0);
    glNormal3f(0, 0, 1);
    glTexCoord2f(0, 0);
    glIndexi(1);
    glEdgeFlag(GL_TRUE);
    glMaterialfv(GL_FRONT, GL_SHININESS, &shininess);
    glVertex2f(0, 0);
    glEvalCoord1f(0);
    glEvalPoint1(0);
    glCallList(1);
    glEnd();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(Errors, KeepTheFirstUntilItIsRead) {
    const Window window;
    glEnable(GL_RED);
    glLineWidth(-1);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

}  // namespace
}  // namespace gw::gl
