// The row of y = -1 and the range of depths. GL_ARB_clip_control
#include "tests/gl/unit/support/picture.h"

namespace gw::gl {

namespace {

GLuint depth_of(GLenum mode, GLfloat z) {
    const Window window(1, 1);
    glClipControl(GL_LOWER_LEFT, mode);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glBegin(GL_POINTS);
    glVertex3f(0, 0, z);
    glEnd();
    GLuint depth = 0;
    glReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &depth);
    return depth >> 8;
}

}  // namespace

TEST(GlClipControl, DepthsOfZeroToOneAreThoseOfTheWindow) {
    for (const GLfloat z : {0.25f, 0.5f, 0.75f})
        EXPECT_EQ(depth_of(GL_ZERO_TO_ONE, z), depth_of(GL_NEGATIVE_ONE_TO_ONE, 2 * z - 1)) << z;
    EXPECT_NEAR(depth_of(GL_ZERO_TO_ONE, 0.25f), 0x1p22, 2);
}

/// What lies on the near or far plane is drawn: with_room_for_rounding.
TEST(GlClipControl, BothEndsOfTheRangeAreInside) {
    EXPECT_LE(depth_of(GL_ZERO_TO_ONE, 0), 2u);
    EXPECT_GE(depth_of(GL_ZERO_TO_ONE, 1), 0xFFFFFDu);
    EXPECT_EQ(depth_of(GL_ZERO_TO_ONE, -0.5f), 0u);  // clipped: the cleared plane
    EXPECT_NE(depth_of(GL_NEGATIVE_ONE_TO_ONE, -0.5f), 0u);
}

TEST(GlClipControl, UpperLeftDrawsThePictureUpsideDownWithTheSameFaces) {
    const auto draw = [](GLenum origin) {
        const Window window(4, 4);
        glClipControl(origin, GL_NEGATIVE_ONE_TO_ONE);
        glEnable(GL_CULL_FACE);
        glRectf(-1, -1, 0, 0);
        return window.pixels();
    };
    const auto lower = draw(GL_LOWER_LEFT), upper = draw(GL_UPPER_LEFT);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 4; ++x) EXPECT_EQ(lower[4 * y + x], upper[4 * (3 - y) + x]);
    EXPECT_EQ(lower[0][0], 255);
}

TEST(GlClipControl, FeedbackAndRasterPositionsFollow) {
    const Window window(8, 8);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    GLfloat reported[16] = {}, raster[4] = {};
    glFeedbackBuffer(16, GL_3D, reported);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_POINTS);
    glVertex3f(0, 0.5f, 0.25f);
    glVertex3f(0, 0, -0.5f);  // in front of the near plane
    glEnd();
    EXPECT_EQ(glRenderMode(GL_RENDER), 4);
    EXPECT_EQ(reported[2], 2);
    EXPECT_NEAR(reported[3], 0.25f, 0x1p-20);
    glRasterPos3f(0, 0.5f, 0.25f);
    glGetFloatv(GL_CURRENT_RASTER_POSITION, raster);
    EXPECT_EQ(raster[1], 2);
    EXPECT_NEAR(raster[2], 0.25f, 0x1p-20);
    glRasterPos3f(0, 0, -0.5f);
    GLboolean valid = GL_TRUE;
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    EXPECT_FALSE(valid);
}

TEST(GlClipControl, IsOfTheTransformGroup) {
    const Window window;
    glPushAttrib(GL_TRANSFORM_BIT);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glPopAttrib();
    GLint origin = 0, depth = 0;
    glGetIntegerv(GL_CLIP_ORIGIN, &origin);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth);
    EXPECT_EQ(origin, GL_LOWER_LEFT);
    EXPECT_EQ(depth, GL_NEGATIVE_ONE_TO_ONE);
    glClipControl(GL_ZERO_TO_ONE, GL_UPPER_LEFT);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
}

}  // namespace gw::gl
