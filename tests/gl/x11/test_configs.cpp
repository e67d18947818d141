// Configurations and visuals. [GLX 1.4] 3.3.3, table 3.4
#include "tests/gl/x11/client.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace {

/// Whether it is double buffered, and its samples.
using Kind = std::pair<int, int>;

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
    std::vector<GLXFBConfig> all() const {
        int count = 0;
        GLXFBConfig* const found = glXGetFBConfigs(display, DefaultScreen(display), &count);
        std::vector<GLXFBConfig> out(found, found + count);
        XFree(found);
        return out;
    }
    /// How many TrueColor visuals each depth has.
    std::map<int, int> visuals_of_depths() const {
        XVisualInfo like{};
        like.screen = DefaultScreen(display);
        like.c_class = TrueColor;
        int count = 0;
        XVisualInfo* const found =
            XGetVisualInfo(display, VisualScreenMask | VisualClassMask, &like, &count);
        std::map<int, int> out;
        for (int i = 0; i < count; ++i) ++out[found[i].depth];
        XFree(found);
        return out;
    }
    Kind kind_of(GLXFBConfig of) const {
        return {value(of, GLX_DOUBLEBUFFER), value(of, GLX_SAMPLES)};
    }
    /// What GetConfig says of a visual.
    Kind config_of(VisualID id) const {
        XVisualInfo like{};
        like.visualid = id;
        int count = 0;
        XVisualInfo* const found = XGetVisualInfo(display, VisualIDMask, &like, &count);
        Kind kind{-1, -1};
        EXPECT_EQ(glXGetConfig(display, found, GLX_DOUBLEBUFFER, &kind.first), Success);
        EXPECT_EQ(glXGetConfig(display, found, GLX_SAMPLES, &kind.second), Success);
        XFree(found);
        return kind;
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

TEST_F(GlxConfigs, TheDefaultVisualIsDoubleBuffered) {
    const VisualID initial = XVisualIDFromVisual(DefaultVisual(display, DefaultScreen(display)));
    EXPECT_EQ(VisualID(value(config(true), GLX_VISUAL_ID)), initial);
    EXPECT_EQ(config_of(initial), (Kind{True, 0}));
}

/// Those of a depth that has fewer share them.
TEST_F(GlxConfigs, EachHasItsOwnVisual) {
    const std::map<int, int> visuals = visuals_of_depths();
    std::map<int, std::set<int>> met;
    std::map<int, int> configurations;
    for (const GLXFBConfig config : all()) {
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, config);
        met[visual->depth].insert(int(visual->visualid));
        ++configurations[visual->depth];
        XFree(visual);
    }
    for (const auto& [depth, count] : visuals) {
        EXPECT_EQ(int(met[depth].size()), count) << depth;
        EXPECT_EQ(configurations[depth], std::max(count, 4)) << depth;
    }
}

TEST_F(GlxConfigs, AVisualMeansTheConfigurationThatItWasChosenFor) {
    for (const GLXFBConfig config : all()) {
        XVisualInfo* const visual = glXGetVisualFromFBConfig(display, config);
        EXPECT_EQ(config_of(visual->visualid), kind_of(config));
        EXPECT_EQ(glXGetFBConfigFromVisualSGIX(display, visual), config);
        XFree(visual);
    }
}

/// GetConfig of a visual and a context on it agree, whatever was chosen in between.
TEST_F(GlxConfigs, AContextHasTheConfigurationOfItsVisual) {
    XVisualInfo* const found[] = {visual({GLX_RGBA, 0}), visual({GLX_RGBA, GLX_DOUBLEBUFFER, 0}),
                                  visual({GLX_RGBA, GLX_SAMPLE_BUFFERS, 1, 0}),
                                  visual({GLX_RGBA, GLX_DOUBLEBUFFER, GLX_SAMPLES, 4, 0})};
    const Kind asked[] = {{False, 0}, {True, 0}, {False, 4}, {True, 4}};
    const bool has_enough = visuals_of_depths()[found[0]->depth] >= 4;
    for (int i = 0; i < 4; ++i) {
        const Kind kind = config_of(found[i]->visualid);
        EXPECT_TRUE(kind == asked[i] || !has_enough) << i;
        const GLXContext context = glXCreateContext(display, found[i], nullptr, True);
        const Window of = make_window(glXGetFBConfigFromVisualSGIX(display, found[i]));
        ASSERT_TRUE(glXMakeCurrent(display, of, context));
        GLboolean is_double = 7;
        glGetBooleanv(GL_DOUBLEBUFFER, &is_double);
        GLint samples = -1;
        glGetIntegerv(GL_SAMPLES, &samples);
        EXPECT_EQ((Kind{is_double, samples}), kind) << i;
        glXMakeCurrent(display, 0, nullptr);
        glXDestroyContext(display, context);
        XDestroyWindow(display, of);
        XFree(found[i]);
    }
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
    const std::vector<GLXFBConfig> configs = all();
    const auto found = std::find_if(configs.begin(), configs.end(), [&](GLXFBConfig config) {
        return value(config, GLX_VISUAL_ID) == int(wanted->visualid);
    });
    ASSERT_NE(found, configs.end());
    EXPECT_EQ(kind_of(*found), (Kind{True, 0}));
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
