// GLX's functions of contexts. [GLX 1.4] 3.3.7; GLX_ARB_create_context
#include "gl/glx/displays.h"

#include "gl/attributes/attributes.h"
#include "gl/context/c_boundary.h"
#include "gl/glx/current.h"

#include <X11/Xmd.h>
// The numbers of the requests.
#include <GL/glxproto.h>

namespace {

using namespace gw::gl;
using namespace gw::gl::glx;

/// A new context; the arguments come from the program. Null after an error.
GLXContext create(Display* display, const Config& config, GLXContext share_list, int request) {
    if (share_list != nullptr && !is_context(share_list))
        return send_error(display, GlxError::Context, 0, request), nullptr;
    if (share_list != nullptr && share_list->config.visual.screen != config.visual.screen)
        return send_error(display, BadMatch, share_list->name, request), nullptr;
    return at_c_boundary([&] {
        std::shared_ptr<Shared> shared = share_list ? share_list->context.shared : nullptr;
        return keep_context(std::make_unique<__GLXcontextRec>(display, config, std::move(shared)));
    });
}

/// Begins a function that takes a configuration: an error unless it is one.
bool check_config(Display* display, GLXFBConfig config, int request) {
    if (is_config(display, config)) return true;
    send_error(display, GlxError::FBConfig, 0, request);
    return false;
}

/// The attributes of GLX_ARB_create_context.
struct ContextRequest {
    int major = 1, minor = 0;
    int flags = 0, profile = GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
    int render_type = GLX_RGBA_TYPE;
};

constexpr int known_flags = GLX_CONTEXT_DEBUG_BIT_ARB | GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB;

/// False if a name or value is unknown.
bool read_request(ContextRequest& request, const int* list) {
    for (; list != nullptr && list[0] != 0; list += 2) {
        switch (list[0]) {
            case GLX_CONTEXT_MAJOR_VERSION_ARB: request.major = list[1]; break;
            case GLX_CONTEXT_MINOR_VERSION_ARB: request.minor = list[1]; break;
            case GLX_CONTEXT_FLAGS_ARB: request.flags = list[1]; break;
            case GLX_CONTEXT_PROFILE_MASK_ARB: request.profile = list[1]; break;
            case GLX_RENDER_TYPE: request.render_type = list[1]; break;
            default: return false;
        }
    }
    const bool is_type =
        request.render_type == GLX_RGBA_TYPE || request.render_type == GLX_COLOR_INDEX_TYPE;
    return is_type && (request.flags & ~known_flags) == 0;
}

/// Whether OpenGL has such a version, and the version such a feature.
bool exists(const ContextRequest& request) {
    constexpr int last_minor[] = {5, 1, 3, 6};  // of 1, 2, 3, 4
    if (request.major < 1 || request.major > 4) return false;
    if (request.minor < 0 || request.minor > last_minor[request.major - 1]) return false;
    return request.major >= 3 || (request.flags & GLX_CONTEXT_FORWARD_COMPATIBLE_BIT_ARB) == 0;
}

/// Whether it is a profile; it counts from version 3.2 on only.
bool is_profile(int mask) {
    return mask == GLX_CONTEXT_CORE_PROFILE_BIT_ARB ||
           mask == GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
}

/// Whether the machine has such a context: versions 1.0 to 1.5.
bool is_offered(const ContextRequest& request) {
    return request.major == 1 && request.minor <= offered_minor();
}

/// The drawable of a name in MakeCurrent; null after an error. All configurations of a screen have
/// the same bits, so each of its contexts draws to each of its surfaces ([GLX 1.4] 2.1). A window
/// without a surface gets one with the context's visual.
std::shared_ptr<Surface> surface_of(Display* display, XID name, GLXContext context, int request) {
    const XVisualInfo& wanted = context->config.visual;
    if (auto known = find_surface(display, name)) {
        if (known->config().visual.screen == wanted.screen) return known;
        return send_error(display, BadMatch, name, request), nullptr;
    }
    const std::optional<x11::Geometry> window = x11::window_geometry(display, name);
    if (!window) return send_error(display, GlxError::Drawable, name, request), nullptr;
    if (window->depth != wanted.depth) return send_error(display, BadMatch, name, request), nullptr;
    return make_window_surface(display, name, context->config);
}

/// False after an error: selection and feedback keep the thread's context.
bool may_leave(Display* display, int request) {
    if (current == nullptr || current->selection.mode == GL_RENDER) return true;
    send_error(display, GlxError::ContextState, current_binding().context->name, request);
    return false;
}

void bind(Display* display, GLXContext context, XID draw_name, XID read_name,
          std::shared_ptr<Surface> draw, std::shared_ptr<Surface> read) {
    Current& binding = current_binding();
    if (binding.context != context) release_current();
    draw->follow_window();
    if (read != draw) read->follow_window();
    make_current(&context->context, draw.get(), read.get());
    binding.display = display;
    binding.context = context;
    binding.draw_name = draw_name;
    binding.read_name = read_name;
    binding.draw = std::move(draw);
    binding.read = std::move(read);
}

Bool make_context_current(Display* display, XID draw, XID read, GLXContext context, int request) {
    // The thread has a context of EGL.
    if (current != nullptr && current_binding().context == nullptr)
        return send_error(display, BadAccess, draw, request), False;
    if (!may_leave(display, request)) return False;
    if (context == nullptr) {
        if (draw != 0 || read != 0) return send_error(display, BadMatch, draw, request), False;
        release_current();
        return True;
    }
    if (!is_context(context)) return send_error(display, GlxError::Context, 0, request), False;
    if (draw == 0 || read == 0) return send_error(display, BadMatch, 0, request), False;
    auto draw_surface = surface_of(display, draw, context, request);
    if (!draw_surface) return False;
    auto read_surface = read == draw ? draw_surface : surface_of(display, read, context, request);
    if (!read_surface) return False;
    if (!take_context(context)) {
        // Toolkits tidy up in an exit handler, whatever other threads still do. An X error there
        // would end the program within exit().
        if (!has_exit_begun()) send_error(display, BadAccess, context->name, request);
        return False;
    }
    bind(display, context, draw, read, std::move(draw_surface), std::move(read_surface));
    return True;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

GLXContext glXCreateContext(Display* display, XVisualInfo* visual, GLXContext share_list, Bool) {
    return at_c_boundary([&]() -> GLXContext {
        Config* const config = visual != nullptr ? config_of_visual(display, *visual) : nullptr;
        const VisualID asked = visual != nullptr ? visual->visualid : 0;
        if (config == nullptr)
            return send_error(display, BadValue, asked, X_GLXCreateContext), nullptr;
        return create(display, *config, share_list, X_GLXCreateContext);
    });
}

GLXContext glXCreateNewContext(Display* display, GLXFBConfig config, int render_type,
                               GLXContext share_list, Bool) {
    return at_c_boundary([&]() -> GLXContext {
        if (!check_config(display, config, X_GLXCreateNewContext)) return nullptr;
        if (render_type != GLX_RGBA_TYPE) {
            const bool exists = render_type == GLX_COLOR_INDEX_TYPE;
            send_error(display, exists ? BadMatch : BadValue, 0, X_GLXCreateNewContext);
            return nullptr;
        }
        return create(display, *config, share_list, X_GLXCreateNewContext);
    });
}

GLXContext glXCreateContextAttribsARB(Display* display, GLXFBConfig config, GLXContext share_list,
                                      Bool, const int* list) {
    constexpr int request = 34;  // X_GLXCreateContextAttribsARB
    return at_c_boundary([&]() -> GLXContext {
        if (!check_config(display, config, request)) return nullptr;
        ContextRequest wanted;
        if (!read_request(wanted, list)) return send_error(display, BadValue, 0, request), nullptr;
        if (!is_profile(wanted.profile))
            return send_error(display, GlxError::Profile, 0, request), nullptr;
        if (!exists(wanted) || wanted.render_type != GLX_RGBA_TYPE)
            return send_error(display, BadMatch, 0, request), nullptr;
        if (!is_offered(wanted)) {
            report_refused_context(wanted.major, wanted.minor);
            return send_error(display, GlxError::FBConfig, 0, request), nullptr;
        }
        return create(display, *config, share_list, request);
    });
}

GLXContext glXCreateContextWithConfigSGIX(Display* display, GLXFBConfig config, int render_type,
                                          GLXContext share_list, Bool direct) {
    return glXCreateNewContext(display, config, render_type, share_list, direct);
}

void glXDestroyContext(Display* display, GLXContext context) {
    if (context == nullptr) return;
    at_c_boundary([&] {
        if (!is_context(context))
            return send_error(display, GlxError::Context, 0, X_GLXDestroyContext);
        destroy_context(context);
    });
}

Bool glXMakeCurrent(Display* display, GLXDrawable drawable, GLXContext context) {
    return at_c_boundary([&] {
        return make_context_current(display, drawable, drawable, context, X_GLXMakeCurrent);
    });
}

Bool glXMakeContextCurrent(Display* display, GLXDrawable draw, GLXDrawable read,
                           GLXContext context) {
    return at_c_boundary([&] {
        return make_context_current(display, draw, read, context, X_GLXMakeContextCurrent);
    });
}

Bool glXMakeCurrentReadSGI(Display* display, GLXDrawable draw, GLXDrawable read,
                           GLXContext context) {
    return glXMakeContextCurrent(display, draw, read, context);
}

void glXCopyContext(Display* display, GLXContext from, GLXContext to, unsigned long mask) {
    at_c_boundary([&] {
        if (!is_context(from) || !is_context(to))
            return send_error(display, GlxError::Context, 0, X_GLXCopyContext);
        if (from->config.visual.screen != to->config.visual.screen)
            return send_error(display, BadMatch, to->name, X_GLXCopyContext);
        if (to->is_current) return send_error(display, BadAccess, to->name, X_GLXCopyContext);
        copy_attributes(to->context, from->context, GLbitfield(mask));
    });
}

/// Every context draws in the program itself.
Bool glXIsDirect(Display* display, GLXContext context) {
    return at_c_boundary([&]() -> Bool {
        if (is_context(context)) return True;
        return send_error(display, GlxError::Context, 0, X_GLXIsDirect), False;
    });
}

int glXQueryContext(Display* display, GLXContext context, int name, int* value) {
    return at_c_boundary([&]() -> int {
        if (!is_context(context)) {
            send_error(display, GlxError::Context, 0, X_GLXQueryContext);
            return GLX_BAD_CONTEXT;
        }
        switch (name) {
            case GLX_FBCONFIG_ID: *value = context->config.id; return Success;
            case GLX_RENDER_TYPE: *value = GLX_RGBA_TYPE; return Success;
            case GLX_SCREEN: *value = context->config.visual.screen; return Success;
        }
        return GLX_BAD_ATTRIBUTE;
    });
}

GLXContext glXGetCurrentContext() { return current_binding().context; }
Display* glXGetCurrentDisplay() { return current_binding().display; }
GLXDrawable glXGetCurrentDrawable() { return current_binding().draw_name; }
GLXDrawable glXGetCurrentReadDrawable() { return current_binding().read_name; }
GLXDrawable glXGetCurrentReadDrawableSGI() { return current_binding().read_name; }

void glXWaitGL() {
    if (current != nullptr) guarded(*current, [] { finish_drawing(*current); });
}

void glXWaitX() {
    if (Display* const display = current_binding().display) XSync(display, False);
}

}  // extern "C"
#pragma GCC visibility pop
