// Frame buffer configurations: each TrueColor visual of a screen without samples, then the first of
// each depth with samples; without a window system, the same of no visual. All have the bits of the
// profile. [EGL 1.5] 3.4
#pragma once

#include "gl/egl/egl.h"

#include <deque>
#include <optional>
#include <vector>

namespace gw::gl::egl {

struct Config {
    int id = 0;
    int samples = 0;       ///< of a pixel
    XVisualInfo visual{};  ///< its `visual` is null if there is no window system
    bool has_windows() const { return visual.visual != nullptr; }
};

/// The configurations of a screen in the order that ChooseConfig returns them in. They differ in
/// samples and visual only, so of [EGL 1.5] 3.4.1.2's orders three decide: fewer samples first, then by
/// number. Of equal samples, the screen's default visual is first.
std::deque<Config> make_x11_configs(Display* native, int screen);
std::deque<Config> make_surfaceless_configs();

/// The value of an attribute; none: no such attribute.
std::optional<EGLint> attribute(const Config& config, EGLint name);

/// The configurations that match a list of names and values that ends with NONE, by [EGL 1.5] table
/// 3.4. MATCH_NATIVE_PIXMAP is left to the caller. Throws Failure if a name or value does not exist.
std::vector<Config*> matching(std::deque<Config>& configs, const EGLint* list);

}  // namespace gw::gl::egl
