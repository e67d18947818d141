// EGL's objects: displays, their configurations, contexts and surfaces. A handle of EGL is the
// address of what it names; it is looked up before it is used. A display is never destroyed.
#pragma once

#include "gl/egl/current.h"

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace gw::gl::egl {

/// Surfaceless and Device have no windows.
enum class Platform { X11, Surfaceless, Device };

struct EglDisplay {
    const Platform platform;
    Display* native;  ///< null: EGL opens the default one
    int screen;       ///< of X11; -1: the display's default

    bool is_initialized = false;
    std::deque<Config> configs;
    std::map<EGLSurface, std::shared_ptr<Surface>> surfaces;
    std::map<EGLContext, std::shared_ptr<ClientContext>> contexts;
    std::set<EGLSync> syncs;
};

/// The device of EGL_EXT_device_enumeration.
EGLDeviceEXT machine_device();

/// The display of this platform, made when it is first asked for.
EglDisplay& display_for(Platform platform, Display* native, int screen = -1);
/// The default display: EGL_PLATFORM's platform, else X11 if there is a server, else none.
Platform default_platform();

/// Throws Failure if the server cannot be reached.
void initialize(EglDisplay& display);
/// Forgets contexts and surfaces. Those that are current live until they are left.
void terminate(EglDisplay& display);

// The object that a program's handle names. Throw EGL's Failure if there is none.
EglDisplay& known_display(EGLDisplay handle);
EglDisplay& initialized_display(EGLDisplay handle);
Config& config_of(EglDisplay& display, EGLConfig handle);
std::shared_ptr<Surface> surface_of(EglDisplay& display, EGLSurface handle);
std::shared_ptr<ClientContext> context_of(EglDisplay& display, EGLContext handle);

EGLSurface keep(EglDisplay& display, std::shared_ptr<Surface> surface);
EGLContext keep(EglDisplay& display, std::shared_ptr<ClientContext> context);
EGLSync keep_new_sync(EglDisplay& display);
/// Whether a surface of the display shows in this window or pixmap.
bool has_surface_for(const EglDisplay& display, XID target);
/// They throw Failure if there is no such object.
void forget_surface(EglDisplay& display, EGLSurface handle);
void forget_context(EglDisplay& display, EGLContext handle);
void check_sync(const EglDisplay& display, EGLSync handle);
void forget_sync(EglDisplay& display, EGLSync handle);

}  // namespace gw::gl::egl
