// EGL's functions of surfaces and buffers. [EGL 1.5] 3.5, 3.6, 3.10
#include "gl/egl/displays.h"
#include "gl/egl/failure.h"
#include "gl/x11/geometry.h"

#include <algorithm>
#include <cstdint>

namespace {

using namespace gw;
using namespace gw::gl;
using namespace gw::gl::egl;
using Surface = gw::gl::egl::Surface;
using SurfaceKind = x11::Surface::Kind;

/// What a list of a new surface asks for.
struct WantedSurface {
    EGLint width = 0, height = 0;
    bool largest = false;
    EGLint render_buffer = EGL_BACK_BUFFER;
};

bool is_flag(EGLAttrib value) { return value == EGL_TRUE || value == EGL_FALSE; }

/// False if a surface of this kind has no such attribute. Throws Failure for a wrong value.
bool read_surface_attribute(WantedSurface& wanted, SurfaceKind kind, EGLAttrib name,
                            EGLAttrib value) {
    const bool is_pbuffer = kind == SurfaceKind::Pbuffer;
    switch (name) {
        case EGL_WIDTH:
        case EGL_HEIGHT:
            if (is_pbuffer && value < 0) throw Failure{EGL_BAD_PARAMETER};
            (name == EGL_WIDTH ? wanted.width : wanted.height) =
                EGLint(std::min<EGLAttrib>(value, INT32_MAX));
            return is_pbuffer;
        case EGL_LARGEST_PBUFFER: wanted.largest = value != EGL_FALSE; return is_pbuffer;
        case EGL_MIPMAP_TEXTURE: return is_pbuffer && is_flag(value);
        case EGL_TEXTURE_FORMAT:
        case EGL_TEXTURE_TARGET:
            if (is_pbuffer && value != EGL_NO_TEXTURE) throw Failure{EGL_BAD_MATCH};
            return is_pbuffer;
        case EGL_RENDER_BUFFER:
            wanted.render_buffer = EGLint(value);
            return kind == SurfaceKind::Window &&
                   (value == EGL_BACK_BUFFER || value == EGL_SINGLE_BUFFER);
        case EGL_GL_COLORSPACE:
            if (value == EGL_GL_COLORSPACE_SRGB) throw Failure{EGL_BAD_MATCH};
            return value == EGL_GL_COLORSPACE_LINEAR;
        case EGL_VG_ALPHA_FORMAT:
            if (value == EGL_VG_ALPHA_FORMAT_PRE) throw Failure{EGL_BAD_MATCH};
            return value == EGL_VG_ALPHA_FORMAT_NONPRE;
    }
    return false;
}

template <class Number>
WantedSurface read_surface_list(SurfaceKind kind, const Number* list) {
    WantedSurface wanted;
    for (; list != nullptr && list[0] != EGL_NONE; list += 2)
        if (!read_surface_attribute(wanted, kind, list[0], list[1]))
            throw Failure{EGL_BAD_ATTRIBUTE};
    return wanted;
}

/// A surface for a window or pixmap of the program's.
template <class Number>
EGLSurface create_native(EGLDisplay handle, EGLConfig config_handle, SurfaceKind kind, XID target,
                         const Number* list) {
    EglDisplay& display = initialized_display(handle);
    const Config& config = config_of(display, config_handle);
    const WantedSurface wanted = read_surface_list(kind, list);
    if (!config.has_windows()) throw Failure{EGL_BAD_MATCH};
    const auto size = kind == SurfaceKind::Window ? x11::window_geometry(display.native, target)
                                                  : x11::pixmap_geometry(display.native, target);
    if (!size)
        throw Failure{kind == SurfaceKind::Window ? EGL_BAD_NATIVE_WINDOW : EGL_BAD_NATIVE_PIXMAP};
    if (size->depth != config.visual.depth) throw Failure{EGL_BAD_MATCH};
    if (has_surface_for(display, target)) throw Failure{EGL_BAD_ALLOC};
    const Buffers buffers =
        wanted.render_buffer == EGL_BACK_BUFFER ? Buffers::Double : Buffers::Single;
    return keep(display, std::make_shared<Surface>(display.native, config, buffers, kind, target,
                                                   size->width, size->height));
}

/// The window or pixmap behind a pointer of the functions of platforms.
XID native_object(const void* pointer, EGLint error) {
    if (pointer == nullptr) throw Failure{error};
    return *static_cast<const XID*>(pointer);
}

EGLSurface create_pbuffer(EGLDisplay handle, EGLConfig config_handle, const EGLint* list) {
    EglDisplay& display = initialized_display(handle);
    const Config& config = config_of(display, config_handle);
    const WantedSurface wanted = read_surface_list(SurfaceKind::Pbuffer, list);
    const bool too_large = wanted.width > max_window_size || wanted.height > max_window_size;
    if (too_large && !wanted.largest) throw Failure{EGL_BAD_ALLOC};
    auto surface = std::make_shared<Surface>(display.native, config, Buffers::Back,
                                             SurfaceKind::Pbuffer, 0, wanted.width, wanted.height);
    surface->largest = wanted.largest;
    return keep(display, std::move(surface));
}

void query_surface(Surface& surface, EGLint name, EGLint* value) {
    const bool is_pbuffer = surface.kind() == SurfaceKind::Pbuffer;
    switch (name) {
        case EGL_CONFIG_ID: *value = surface.config().id; return;
        case EGL_WIDTH: *value = surface.width(); return;
        case EGL_HEIGHT: *value = surface.height(); return;
        case EGL_LARGEST_PBUFFER:
            if (is_pbuffer) *value = surface.largest ? EGL_TRUE : EGL_FALSE;
            return;
        case EGL_TEXTURE_FORMAT:
        case EGL_TEXTURE_TARGET:
            if (is_pbuffer) *value = EGL_NO_TEXTURE;
            return;
        case EGL_MIPMAP_TEXTURE:
            if (is_pbuffer) *value = EGL_FALSE;
            return;
        case EGL_MIPMAP_LEVEL:
            if (is_pbuffer) *value = surface.mipmap_level;
            return;
        case EGL_RENDER_BUFFER: *value = surface.render_buffer(); return;
        case EGL_SWAP_BEHAVIOR: *value = EGL_BUFFER_DESTROYED; return;
        case EGL_MULTISAMPLE_RESOLVE: *value = EGL_MULTISAMPLE_RESOLVE_DEFAULT; return;
        case EGL_GL_COLORSPACE: *value = EGL_GL_COLORSPACE_LINEAR; return;
        case EGL_VG_ALPHA_FORMAT: *value = EGL_VG_ALPHA_FORMAT_NONPRE; return;
        case EGL_HORIZONTAL_RESOLUTION:
        case EGL_VERTICAL_RESOLUTION: *value = EGL_UNKNOWN; return;
        case EGL_PIXEL_ASPECT_RATIO: *value = EGL_DISPLAY_SCALING; return;
    }
    throw Failure{EGL_BAD_ATTRIBUTE};
}

void set_attribute(Surface& surface, EGLint name, EGLint value) {
    switch (name) {
        case EGL_MIPMAP_LEVEL: surface.mipmap_level = value; return;
        case EGL_MULTISAMPLE_RESOLVE:
            if (value == EGL_MULTISAMPLE_RESOLVE_DEFAULT) return;
            throw Failure{value == EGL_MULTISAMPLE_RESOLVE_BOX ? EGL_BAD_MATCH : EGL_BAD_ATTRIBUTE};
        case EGL_SWAP_BEHAVIOR:
            if (value == EGL_BUFFER_DESTROYED) return;
            throw Failure{value == EGL_BUFFER_PRESERVED ? EGL_BAD_MATCH : EGL_BAD_ATTRIBUTE};
    }
    throw Failure{EGL_BAD_ATTRIBUTE};
}

/// Textures of surfaces are those of OpenGL ES.
EGLBoolean no_texture_of(EGLDisplay handle, EGLSurface surface, EGLint buffer) {
    return carried_out([&]() -> EGLBoolean {
        const auto found = surface_of(initialized_display(handle), surface);
        if (buffer != EGL_BACK_BUFFER) throw Failure{EGL_BAD_PARAMETER};
        throw Failure{found->kind() == SurfaceKind::Pbuffer ? EGL_BAD_MATCH : EGL_BAD_SURFACE};
    });
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                  const EGLint* list) {
    return carried_out(
        [&] { return create_native(display, config, SurfaceKind::Window, XID(window), list); });
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay display, EGLConfig config, void* window,
                                          const EGLAttrib* list) {
    return carried_out([&] {
        return create_native(display, config, SurfaceKind::Window,
                             native_object(window, EGL_BAD_NATIVE_WINDOW), list);
    });
}

EGLSurface eglCreatePlatformWindowSurfaceEXT(EGLDisplay display, EGLConfig config, void* window,
                                             const EGLint* list) {
    return carried_out([&] {
        return create_native(display, config, SurfaceKind::Window,
                             native_object(window, EGL_BAD_NATIVE_WINDOW), list);
    });
}

EGLSurface eglCreatePixmapSurface(EGLDisplay display, EGLConfig config, EGLNativePixmapType pixmap,
                                  const EGLint* list) {
    return carried_out(
        [&] { return create_native(display, config, SurfaceKind::Pixmap, XID(pixmap), list); });
}

EGLSurface eglCreatePlatformPixmapSurface(EGLDisplay display, EGLConfig config, void* pixmap,
                                          const EGLAttrib* list) {
    return carried_out([&] {
        return create_native(display, config, SurfaceKind::Pixmap,
                             native_object(pixmap, EGL_BAD_NATIVE_PIXMAP), list);
    });
}

EGLSurface eglCreatePlatformPixmapSurfaceEXT(EGLDisplay display, EGLConfig config, void* pixmap,
                                             const EGLint* list) {
    return carried_out([&] {
        return create_native(display, config, SurfaceKind::Pixmap,
                             native_object(pixmap, EGL_BAD_NATIVE_PIXMAP), list);
    });
}

EGLSurface eglCreatePbufferSurface(EGLDisplay display, EGLConfig config, const EGLint* list) {
    return carried_out([&] { return create_pbuffer(display, config, list); });
}

/// Images of OpenVG are the only client buffers of [EGL 1.5], and OpenVG is not there.
EGLSurface eglCreatePbufferFromClientBuffer(EGLDisplay display, EGLenum, EGLClientBuffer,
                                            EGLConfig config, const EGLint*) {
    return carried_out([&]() -> EGLSurface {
        config_of(initialized_display(display), config);
        throw Failure{EGL_BAD_PARAMETER};
    });
}

EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface) {
    return carried_out([&]() -> EGLBoolean {
        forget_surface(initialized_display(display), surface);
        return EGL_TRUE;
    });
}

EGLBoolean eglQuerySurface(EGLDisplay display, EGLSurface surface, EGLint name, EGLint* value) {
    return carried_out([&]() -> EGLBoolean {
        const auto found = surface_of(initialized_display(display), surface);
        if (value == nullptr) throw Failure{EGL_BAD_PARAMETER};
        query_surface(*found, name, value);
        return EGL_TRUE;
    });
}

EGLBoolean eglSurfaceAttrib(EGLDisplay display, EGLSurface surface, EGLint name, EGLint value) {
    return carried_out([&]() -> EGLBoolean {
        set_attribute(*surface_of(initialized_display(display), surface), name, value);
        return EGL_TRUE;
    });
}

EGLBoolean eglBindTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
    return no_texture_of(display, surface, buffer);
}

EGLBoolean eglReleaseTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
    return no_texture_of(display, surface, buffer);
}

EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    return carried_out([&]() -> EGLBoolean {
        const auto found = surface_of(initialized_display(display), surface);
        if (!binding().context || found != binding().draw) throw Failure{EGL_BAD_SURFACE};
        const bool swaps = found->kind() == SurfaceKind::Window && found->is_double_buffered();
        guarded(*current, [&] { swaps ? finish_frame(*current) : finish_drawing(*current); });
        if (found->kind() != SurfaceKind::Window) return EGL_TRUE;
        found->swap_buffers();
        if (!found->follow_window()) throw Failure{EGL_BAD_NATIVE_WINDOW};
        return EGL_TRUE;
    });
}

EGLBoolean eglCopyBuffers(EGLDisplay handle, EGLSurface surface, EGLNativePixmapType pixmap) {
    return carried_out([&]() -> EGLBoolean {
        EglDisplay& display = initialized_display(handle);
        const auto from = surface_of(display, surface);
        const auto to =
            display.native ? x11::pixmap_geometry(display.native, XID(pixmap)) : std::nullopt;
        if (!to) throw Failure{EGL_BAD_NATIVE_PIXMAP};
        const XVisualInfo& visual = from->config().visual;
        if (to->depth != visual.depth) throw Failure{EGL_BAD_MATCH};
        if (from == binding().draw) guarded(*current, [] { finish_drawing(*current); });
        const x11::LockedDisplay locked(display.native);  // before the drawable, as everywhere
        const auto lock = from->exclusive();
        x11::ShownImage(display.native, visual, XID(pixmap), to->height)
            .show(*from, from->has_back_plane() ? ReadBuffer::Back : ReadBuffer::Front);
        return EGL_TRUE;
    });
}

/// The machine has no monitor: a swap never waits.
EGLBoolean eglSwapInterval(EGLDisplay display, EGLint) {
    return carried_out([&]() -> EGLBoolean {
        initialized_display(display);
        if (!binding().context) throw Failure{EGL_BAD_CONTEXT};
        if (!binding().draw) throw Failure{EGL_BAD_SURFACE};
        return EGL_TRUE;
    });
}

}  // extern "C"
#pragma GCC visibility pop
