// Configurations and visuals. [GLX 1.4] 3.3.3, table 3.4
#include "tests/gl/x11/client.h"

#include <algorithm>

namespace {

class GlxConfigs : public Glx {
protected:
    std::vector<GLXFBConfig> chosen(const std::vector<int>& list) const {
        int count = -1;
        GLXFBConfig* const found =
            glXChooseFBConfig(display, DefaultScreen(display), list.data(), &count);
        std::vector<GLXFBConfig> out(found, found + (found != nullptr ? count : 0));
        if (found != nullptr) XFree(found);
        return out;
    }
    int value(GLXFBConfig of, int name) const {
        int value = -1;
        EXPECT_EQ(glXGetFBConfigAttrib(display, of, name, &value), Success) << name;
        return value;
    }
    XVisualInfo* visual(std::vector<int> list) const {
        return glXChooseVisual(display, DefaultScreen(display), list.data());
    }
};

TEST_F(GlxConfigs, SingleBufferedComeFirst) {
    const auto all = chosen({0});
    ASSERT_GE(all.size(), 2u);
    EXPECT_EQ(value(all.front(), GLX_DOUBLEBUFFER), False);
    EXPECT_EQ(value(all.back(), GLX_DOUBLEBUFFER), True);
    for (std::size_t i = 1; i < all.size(); ++i)
        EXPECT_LE(value(all[i - 1], GLX_DOUBLEBUFFER), value(all[i], GLX_DOUBLEBUFFER));
}

TEST_F(GlxConfigs, TheDefaultVisualIsTheFirstOfItsKind) {
    const VisualID initial = XVisualIDFromVisual(DefaultVisual(display, DefaultScreen(display)));
    EXPECT_EQ(VisualID(value(config(false), GLX_VISUAL_ID)), initial);
    EXPECT_EQ(VisualID(value(config(true), GLX_VISUAL_ID)), initial);
}

TEST_F(GlxConfigs, HaveTheBitsOfTheProfile) {
    const GLXFBConfig any = config(true);
    for (const int name : {GLX_RED_SIZE, GLX_GREEN_SIZE, GLX_BLUE_SIZE, GLX_ALPHA_SIZE})
        EXPECT_GE(value(any, name), 8);
    EXPECT_GE(value(any, GLX_DEPTH_SIZE), 24);
    EXPECT_EQ(value(any, GLX_STENCIL_SIZE), 8);
    EXPECT_GE(value(any, GLX_ACCUM_RED_SIZE), 16);
    const int bits = value(any, GLX_RED_SIZE);
    EXPECT_EQ(value(any, GLX_BUFFER_SIZE), 4 * bits);
}

TEST_F(GlxConfigs, SizesAreMinima) {
    const int depth = value(config(true), GLX_DEPTH_SIZE);
    EXPECT_FALSE(chosen({GLX_DEPTH_SIZE, depth, 0}).empty());
    EXPECT_TRUE(chosen({GLX_DEPTH_SIZE, depth + 1, 0}).empty());
}

TEST_F(GlxConfigs, ANumberIsTakenWhateverElseIsAsked) {
    const int id = value(config(true), GLX_FBCONFIG_ID);
    const auto found = chosen({GLX_STEREO, True, GLX_FBCONFIG_ID, id, GLX_DEPTH_SIZE, 99, 0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(value(found[0], GLX_FBCONFIG_ID), id);
}

/// GLX_ARB_multisample: fewer samples come first.
TEST_F(GlxConfigs, SamplesAreMinima) {
    EXPECT_EQ(value(config(true), GLX_SAMPLE_BUFFERS), 0);
    for (const auto& [asked, given] : {std::pair{0, 0}, {1, 4}, {4, 4}}) {
        const auto found = chosen({GLX_DOUBLEBUFFER, True, GLX_SAMPLES, asked, 0});
        ASSERT_FALSE(found.empty()) << asked;
        EXPECT_EQ(value(found[0], GLX_SAMPLES), given) << asked;
        EXPECT_EQ(value(found[0], GLX_SAMPLE_BUFFERS), given > 0 ? 1 : 0);
        EXPECT_EQ(value(found.back(), GLX_SAMPLES), 4);
    }
    EXPECT_TRUE(chosen({GLX_SAMPLES, 5, 0}).empty());
    XVisualInfo* const found = visual({GLX_RGBA, GLX_DOUBLEBUFFER, GLX_SAMPLE_BUFFERS, 1, 0});
    ASSERT_NE(found, nullptr);
    int samples = -1;
    EXPECT_EQ(glXGetConfig(display, found, GLX_SAMPLES, &samples), Success);
    EXPECT_EQ(samples, 4);
    XFree(found);
}

TEST_F(GlxConfigs, UnknownNamesAndValuesGiveNone) {
    EXPECT_TRUE(chosen({0x7777, 1, 0}).empty());
    EXPECT_TRUE(chosen({GLX_DOUBLEBUFFER, 7, 0}).empty());
    EXPECT_TRUE(chosen({GLX_RED_SIZE, -7, 0}).empty());
    int value = 0;
    EXPECT_EQ(glXGetFBConfigAttrib(display, config(true), 0x7777, &value), GLX_BAD_ATTRIBUTE);
}

TEST_F(GlxConfigs, ColourIndicesAndStereoAreNotOffered) {
    EXPECT_TRUE(chosen({GLX_RENDER_TYPE, GLX_COLOR_INDEX_BIT, 0}).empty());
    EXPECT_TRUE(chosen({GLX_STEREO, True, 0}).empty());
    EXPECT_EQ(visual({0}), nullptr);
    EXPECT_EQ(visual({GLX_RGBA, GLX_STEREO, 0}), nullptr);
}

/// Programs look for the configuration of their visual in this way.
TEST_F(GlxConfigs, TheFirstOfAllWithAVisualIsDoubleBuffered) {
    XVisualInfo* const wanted = visual({GLX_RGBA, GLX_DOUBLEBUFFER, 0});
    ASSERT_NE(wanted, nullptr);
    int count = 0;
    GLXFBConfig* const all = glXGetFBConfigs(display, DefaultScreen(display), &count);
    GLXFBConfig* const end = all + count;
    const auto has_visual = [&](GLXFBConfig config) {
        return value(config, GLX_VISUAL_ID) == int(wanted->visualid);
    };
    GLXFBConfig* const found = std::find_if(all, end, has_visual);
    ASSERT_NE(found, end);
    EXPECT_EQ(value(*found, GLX_DOUBLEBUFFER), True);
    EXPECT_EQ(value(*found, GLX_SAMPLES), 0);
    EXPECT_EQ(std::count_if(all, end, has_visual), 4) << "single and double, of 0 and 4 samples";
    XFree(all);
    XFree(wanted);
}

TEST_F(GlxConfigs, AVisualIsDoubleBufferedOnlyIfItWasAskedFor) {
    for (const bool double_buffered : {false, true}) {
        XVisualInfo* const found =
            double_buffered
                ? visual({GLX_USE_GL, GLX_RGBA, GLX_DOUBLEBUFFER, GLX_DEPTH_SIZE, 16, 0})
                : visual({GLX_RGBA, GLX_DEPTH_SIZE, 16, 0});
        ASSERT_NE(found, nullptr);
        int value = -1;
        EXPECT_EQ(glXGetConfig(display, found, GLX_DOUBLEBUFFER, &value), Success);
        EXPECT_EQ(value, int(double_buffered));
        EXPECT_EQ(glXGetConfig(display, found, GLX_RGBA, &value), Success);
        EXPECT_EQ(value, True);
        EXPECT_EQ(glXGetConfig(display, found, GLX_SWAP_METHOD_OML, &value), Success);
        EXPECT_EQ(value, double_buffered ? GLX_SWAP_COPY_OML : GLX_SWAP_UNDEFINED_OML);
        EXPECT_EQ(glXGetConfig(display, found, GLX_DRAWABLE_TYPE, &value), GLX_BAD_ATTRIBUTE);
        XFree(found);
    }
}

}  // namespace
