// GLX's functions of windows, pixmaps, pbuffers and buffers. [GLX 1.4] 3.3.4 to 3.3.6, 3.3.10
#include "gl/glx/displays.h"

#include "gl/context/c_boundary.h"
#include "gl/glx/current.h"
#include "gl/x11/extension.h"

#include <X11/Xmd.h>
// The numbers of the requests.
#include <GL/glxproto.h>
#include <algorithm>

namespace {

using namespace gw::gl;
using namespace gw::gl::glx;
using gw::max_window_size;

/// The value of an attribute in a list that ends with 0; `other` if it is not there.
int value_of(const int* list, int name, int other) {
    for (; list != nullptr && list[0] != 0; list += 2)
        if (list[0] == name) return list[1];
    return other;
}

/// Whether drawables of both have the same buffers and samples.
bool is_alike(const Config& a, const Config& b) {
    return a.double_buffered == b.double_buffered && a.samples == b.samples;
}

/// A drawable for a window or pixmap of the program's; 0 after an error.
XID make_surface(Display* display, const Config& config, Surface::Kind kind, XID target,
                 int request) {
    const bool is_window = kind == Surface::Kind::Window;
    const std::optional<x11::Geometry> size =
        is_window ? x11::window_geometry(display, target) : x11::pixmap_geometry(display, target);
    if (!size) return send_error(display, is_window ? BadWindow : BadPixmap, target, request), 0;
    if (size->depth != config.visual.depth)
        return send_error(display, BadMatch, target, request), 0;
    auto surface = find_surface(display, target);
    if (surface && surface->has_glx_name) return send_error(display, BadAlloc, target, request), 0;
    if (!surface || !is_alike(surface->config(), config))
        surface =
            std::make_shared<Surface>(display, config, kind, target, size->width, size->height);
    const XID name = x11::new_name(display);
    surface->has_glx_name = true;
    add_surface(display, name, surface);
    // A window's own name means the same drawable.
    if (kind == Surface::Kind::Window) add_surface(display, target, surface);
    return name;
}

bool is_config_for(Display* display, GLXFBConfig config, int request) {
    if (is_config(display, config)) return true;
    return send_error(display, GlxError::FBConfig, 0, request), false;
}

/// The drawable of a name; null after an error.
std::shared_ptr<Surface> surface_named(Display* display, XID name, int request) {
    auto surface = find_surface(display, name);
    if (!surface) send_error(display, GlxError::Drawable, name, request);
    return surface;
}

void destroy_pixmap(Display* display, XID pixmap, int request) {
    at_c_boundary([&] {
        if (!remove_surface(display, pixmap, Surface::Kind::Pixmap))
            send_error(display, GlxError::Pixmap, pixmap, request);
    });
}

/// What the calling thread's context has assembled for a drawable.
void finish_current(const std::shared_ptr<Surface>& surface) {
    if (current != nullptr && current_binding().draw == surface)
        guarded(*current, [] { finish_drawing(*current); });
}

void query(Surface& surface, int name, unsigned* value) {
    surface.follow_window();
    const bool is_pbuffer = surface.kind() == Surface::Kind::Pbuffer;
    switch (name) {
        case GLX_WIDTH: *value = unsigned(surface.width()); return;
        case GLX_HEIGHT: *value = unsigned(surface.height()); return;
        case GLX_FBCONFIG_ID: *value = unsigned(surface.config().id); return;
        case GLX_EVENT_MASK: *value = unsigned(surface.event_mask); return;
        case GLX_PRESERVED_CONTENTS:
            if (is_pbuffer) *value = surface.preserved;
            return;
        case GLX_LARGEST_PBUFFER:
            if (is_pbuffer) *value = surface.largest;
            return;
    }
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

GLXWindow glXCreateWindow(Display* display, GLXFBConfig config, Window window, const int*) {
    return at_c_boundary([&]() -> XID {
        if (!is_config_for(display, config, X_GLXCreateWindow)) return 0;
        return make_surface(display, *config, Surface::Kind::Window, window, X_GLXCreateWindow);
    });
}

void glXDestroyWindow(Display* display, GLXWindow window) {
    at_c_boundary([&] {
        const auto surface = find_surface(display, window);
        // [GLX 1.4] 3.3.4: a GLX window goes with its window.
        const bool exists = surface && x11::window_geometry(display, surface->target());
        if (!remove_surface(display, window, Surface::Kind::Window) || !exists)
            send_error(display, GlxError::Window, window, X_GLXDestroyWindow);
    });
}

GLXPixmap glXCreatePixmap(Display* display, GLXFBConfig config, Pixmap pixmap, const int*) {
    return at_c_boundary([&]() -> XID {
        if (!is_config_for(display, config, X_GLXCreatePixmap)) return 0;
        return make_surface(display, *config, Surface::Kind::Pixmap, pixmap, X_GLXCreatePixmap);
    });
}

void glXDestroyPixmap(Display* display, GLXPixmap pixmap) {
    destroy_pixmap(display, pixmap, X_GLXDestroyPixmap);
}

GLXPixmap glXCreateGLXPixmap(Display* display, XVisualInfo* visual, Pixmap pixmap) {
    return at_c_boundary([&]() -> XID {
        Config* const config = visual != nullptr ? config_of_visual(display, *visual) : nullptr;
        const VisualID asked = visual != nullptr ? visual->visualid : 0;
        if (config == nullptr) return send_error(display, BadValue, asked, X_GLXCreateGLXPixmap), 0;
        return make_surface(display, *config, Surface::Kind::Pixmap, pixmap, X_GLXCreateGLXPixmap);
    });
}

GLXPixmap glXCreateGLXPixmapWithConfigSGIX(Display* display, GLXFBConfig config, Pixmap pixmap) {
    return glXCreatePixmap(display, config, pixmap, nullptr);
}

void glXDestroyGLXPixmap(Display* display, GLXPixmap pixmap) {
    destroy_pixmap(display, pixmap, X_GLXDestroyGLXPixmap);
}

GLXPbuffer glXCreatePbuffer(Display* display, GLXFBConfig config, const int* list) {
    return at_c_boundary([&]() -> XID {
        if (!is_config_for(display, config, X_GLXCreatePbuffer)) return 0;
        const bool largest = value_of(list, GLX_LARGEST_PBUFFER, False) != False;
        int width = value_of(list, GLX_PBUFFER_WIDTH, 0);
        int height = value_of(list, GLX_PBUFFER_HEIGHT, 0);
        if (width < 0 || height < 0) return send_error(display, BadValue, 0, X_GLXCreatePbuffer), 0;
        if (!largest && (width > max_window_size || height > max_window_size))
            return send_error(display, BadAlloc, 0, X_GLXCreatePbuffer), 0;
        const XID name = x11::new_name(display);
        auto surface =
            std::make_shared<Surface>(display, *config, Surface::Kind::Pbuffer, 0, width, height);
        surface->preserved = value_of(list, GLX_PRESERVED_CONTENTS, True) != False;
        surface->largest = largest;
        add_surface(display, name, std::move(surface));
        return name;
    });
}

void glXDestroyPbuffer(Display* display, GLXPbuffer pbuffer) {
    at_c_boundary([&] {
        if (!remove_surface(display, pbuffer, Surface::Kind::Pbuffer))
            send_error(display, GlxError::Pbuffer, pbuffer, X_GLXDestroyPbuffer);
    });
}

void glXQueryDrawable(Display* display, GLXDrawable drawable, int name, unsigned* value) {
    at_c_boundary([&] {
        if (const auto surface = surface_named(display, drawable, X_GLXGetDrawableAttributes))
            query(*surface, name, value);
    });
}

/// The machine keeps every pbuffer, so that no event ever comes.
void glXSelectEvent(Display* display, GLXDrawable drawable, unsigned long mask) {
    at_c_boundary([&] {
        if (const auto s = surface_named(display, drawable, X_GLXChangeDrawableAttributes))
            s->event_mask = mask & GLX_PBUFFER_CLOBBER_MASK;
    });
}

void glXGetSelectedEvent(Display* display, GLXDrawable drawable, unsigned long* mask) {
    at_c_boundary([&] {
        if (const auto surface = surface_named(display, drawable, X_GLXGetDrawableAttributes))
            *mask = surface->event_mask;
    });
}

void glXSwapBuffers(Display* display, GLXDrawable drawable) {
    at_c_boundary([&] {
        const auto surface = surface_named(display, drawable, X_GLXSwapBuffers);
        if (!surface) return;
        if (!surface->is_double_buffered()) return finish_current(surface);
        if (current != nullptr && current_binding().draw == surface)
            guarded(*current, [] { finish_frame(*current); });
        surface->swap_buffers();
    });
}

}  // extern "C"
#pragma GCC visibility pop
