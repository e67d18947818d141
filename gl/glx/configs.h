// Frame buffer configurations: single and double buffered, without samples and with, of each depth of a
// screen, and the bits of the profile. [GLX 1.4] 3.3.3
#pragma once

#include "gl/glx/glx.h"

#include <deque>
#include <optional>
#include <vector>

struct __GLXFBConfigRec {
    XVisualInfo visual{};
    bool double_buffered = false;
    int samples = 0;  ///< of a pixel
    int id = 0;
    int color_bits = 0, depth_bits = 0, stencil_bits = 0, accum_bits = 0;  ///< the profile's
};

namespace gw::gl::glx {

using Config = __GLXFBConfigRec;

/// The configurations of a screen in the order that ChooseFBConfig returns them in. Each has a TrueColor
/// visual of its own if its depth has enough; else those of a depth share them. The first visual of a
/// depth is double buffered without samples, as are those that are left over.
///
/// Three orders of [GLX 1.4] table 3.4 decide: single before double, then fewer samples first. Then the
/// depth of the screen's default visual is first and visuals with an alpha channel are last.
std::deque<Config> make_configs(Display* display, int screen, int first_id);

/// The value of an attribute; none: no such attribute.
std::optional<int> attribute(const Config& config, int name);

/// The configurations that match a list of names and values that ends with 0, by [GLX 1.4] table
/// 3.4. No value if a name or value does not exist.
std::optional<std::vector<Config*>> matching(std::deque<Config>& configs, const int* list);

/// The attribute list of ChooseVisual, in which booleans have no values, as one of ChooseFBConfig.
/// No value if a name does not exist, or if the list asks for colour indices.
std::optional<std::vector<int>> list_of_visual_attributes(const int* list);

}  // namespace gw::gl::glx
