// A pbuffer of an X server. Xlib is found through the library that links it.
#include "gw/error.h"
#include "inspect/peer/surface.h"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

// Xlib defines macros of the machine's words (None, Always).
#include <GL/glx.h>

namespace gw::peer {
namespace {

// clang-format off
#define GW_GLX_FUNCTIONS(X)                                                           \
    X(XOpenDisplay) X(XCloseDisplay) X(XDefaultScreen) X(XFree) X(XSync)              \
    X(XSetErrorHandler) X(glXQueryVersion) X(glXChooseFBConfig)                       \
    X(glXGetFBConfigAttrib) X(glXCreatePbuffer) X(glXDestroyPbuffer)                  \
    X(glXCreateNewContext) X(glXDestroyContext) X(glXMakeContextCurrent)
// clang-format on

struct GlxFunctions {
// NOLINTBEGIN(bugprone-macro-parentheses)
#define GW_DECLARE(name) decltype(&::name) name = nullptr;
    GW_GLX_FUNCTIONS(GW_DECLARE)
#undef GW_DECLARE
    // NOLINTEND(bugprone-macro-parentheses)
};

GlxFunctions glx_functions(const Loaded& loaded) {
    GlxFunctions f;
#define GW_FIND(name) loaded.get(#name, f.name);
    GW_GLX_FUNCTIONS(GW_FIND)
#undef GW_FIND
    return f;
}

thread_local bool x_failed = false;
int note_x_error(Display*, XErrorEvent*) {
    x_failed = true;
    return 0;
}

class GlxSurface : public Surface {
public:
    GlxSurface(const Loaded& loaded, int width, int height)
        : functions_(loaded.functions()), x_(glx_functions(loaded)) {
        open_display(loaded.path());
        x_.XSetErrorHandler(note_x_error);
        make_pbuffer(width, height);
        make_current();
        loaded.complete(functions_);
    }
    ~GlxSurface() override { close(); }
    GlxSurface(const GlxSurface&) = delete;
    GlxSurface& operator=(const GlxSurface&) = delete;

    void make_current() override {
        if (!x_.glXMakeContextCurrent(display_, pbuffer_, pbuffer_, context_))
            throw Error("GLX cannot make its context current");
        use(functions_);
    }

private:
    void open_display(const std::string& path) {
        display_ = x_.XOpenDisplay(nullptr);
        if (!display_) {
            const char* const name = std::getenv("DISPLAY");
            throw Error(fmt::format("{} draws through an X server: {}", path,
                                    name ? fmt::format("DISPLAY={} cannot be opened", name)
                                         : std::string("DISPLAY is not set")));
        }
        int major = 0, minor = 0;
        if (!x_.glXQueryVersion(display_, &major, &minor) || 10 * major + minor < 13)
            throw Error("the X server and " + path + " have no GLX 1.3 together");
    }

    int value(GLXFBConfig config, int name) const {
        int out = 0;
        x_.glXGetFBConfigAttrib(display_, config, name, &out);
        return out;
    }

    /// One of exactly 8 colour, 24 depth and 8 stencil bits; with one buffer if there is one.
    GLXFBConfig chosen_config() const {
        static constexpr int wanted[] = {GLX_DRAWABLE_TYPE,
                                         GLX_PBUFFER_BIT,
                                         GLX_RED_SIZE,
                                         8,
                                         GLX_GREEN_SIZE,
                                         8,
                                         GLX_BLUE_SIZE,
                                         8,
                                         GLX_ALPHA_SIZE,
                                         8,
                                         GLX_DEPTH_SIZE,
                                         24,
                                         GLX_STENCIL_SIZE,
                                         8,
                                         GLX_DOUBLEBUFFER,
                                         int(GLX_DONT_CARE),
                                         0};
        int count = 0;
        GLXFBConfig* const found =
            x_.glXChooseFBConfig(display_, x_.XDefaultScreen(display_), wanted, &count);
        GLXFBConfig best = nullptr;
        int best_score = -1;
        for (GLXFBConfig* config = found; config != found + count; ++config) {
            if (value(*config, GLX_RED_SIZE) != 8 || value(*config, GLX_DEPTH_SIZE) != 24 ||
                value(*config, GLX_STENCIL_SIZE) != 8)
                continue;
            const int score = 2 * (value(*config, GLX_ACCUM_RED_SIZE) >= 16) +
                              (value(*config, GLX_DOUBLEBUFFER) == 0);
            if (score > best_score) {
                best = *config;
                best_score = score;
            }
        }
        if (found) x_.XFree(found);
        if (!best) throw Error("GLX has no pbuffer of 8 colour, 24 depth and 8 stencil bits here");
        return best;
    }

    void make_pbuffer(int width, int height) {
        const GLXFBConfig config = chosen_config();
        const int size[] = {GLX_PBUFFER_WIDTH, width, GLX_PBUFFER_HEIGHT, height, 0};
        x_failed = false;
        pbuffer_ = x_.glXCreatePbuffer(display_, config, size);
        context_ = x_.glXCreateNewContext(display_, config, GLX_RGBA_TYPE, nullptr, 1);
        x_.XSync(display_, 0);
        if (x_failed || !pbuffer_ || !context_)
            throw Error(fmt::format("GLX makes no pbuffer of {}x{}", width, height));
    }

    void close() {
        if (!display_) return;
        x_.glXMakeContextCurrent(display_, 0, 0, nullptr);
        if (context_) x_.glXDestroyContext(display_, context_);
        if (pbuffer_) x_.glXDestroyPbuffer(display_, pbuffer_);
        x_.XCloseDisplay(display_);
    }

    Functions functions_;
    GlxFunctions x_;
    Display* display_ = nullptr;
    GLXPbuffer pbuffer_ = 0;
    GLXContext context_ = nullptr;
};

}  // namespace

std::unique_ptr<Surface> make_glx(const Loaded& loaded, int width, int height) {
    return std::make_unique<GlxSurface>(loaded, width, height);
}

}  // namespace gw::peer
