// The kinds of pixels that configurations of GLX and EGL offer.
#pragma once

#include "gl/drawable/settings.h"
#include "gl/x11/x11.h"

#include <vector>

namespace gw::gl::x11 {

struct PixelKind {
    int samples = 0;  ///< of a pixel
    XVisualInfo visual{};
};

/// Each visual without samples; then, on a profile that has them, the first one of each depth with 4.
/// Of 8, two lie on sides of the pixel ([R17.2]): what fills a window would leave its lowest row out.
std::vector<PixelKind> pixel_kinds(const std::vector<XVisualInfo>& visuals, const Profile& profile);

}  // namespace gw::gl::x11
