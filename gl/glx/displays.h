// The configurations and GLX drawables of each display that a program opened. Forgotten when the
// program closes the display.
#pragma once

#include "gl/glx/configs.h"
#include "gl/glx/errors.h"
#include "gl/glx/surface.h"
#include "gl/x11/geometry.h"

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace gw::gl::glx {

/// The numbers of GLX on a display.
const ExtensionCodes& codes_of(Display* display);

/// A screen's configurations; none if there is no such screen.
std::deque<Config>& configs_of(Display* display, int screen);
/// Whether a program's pointer is a configuration of this display.
bool is_config(Display* display, GLXFBConfig config);

/// The configuration of a visual (GLX 1.2). Of those that share it, the one for which ChooseVisual or
/// GetVisualFromFBConfig last returned it; before, the one with the fewest samples, double buffered
/// if there is one. Null: not a visual of GLX.
Config* config_of_visual(Display* display, const XVisualInfo& visual);
/// A copy of the visual, which the program frees with XFree.
XVisualInfo* chosen_visual(Display* display, const Config& config);

/// The drawable of this name; null: there is none. A name is known on all displays of its server.
std::shared_ptr<Surface> find_surface(Display* display, XID name);
/// The drawable of a window that GLX has not met yet.
std::shared_ptr<Surface> make_window_surface(Display* display, XID window, const Config& config);
void add_surface(Display* display, XID name, std::shared_ptr<Surface> surface);
/// False if no drawable of this kind has the name.
bool remove_surface(Display* display, XID name, Surface::Kind kind);

}  // namespace gw::gl::glx
