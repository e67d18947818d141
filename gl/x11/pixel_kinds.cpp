#include "gl/x11/pixel_kinds.h"

#include <set>

namespace gw::gl::x11 {

std::vector<PixelKind> pixel_kinds(const std::vector<XVisualInfo>& visuals,
                                   const Profile& profile) {
    std::vector<PixelKind> out;
    for (const XVisualInfo& visual : visuals) out.push_back({0, visual});
    if (!profile.extensions.surfaces || !profile.extensions.multisample) return out;
    std::set<int> depths;
    for (const XVisualInfo& visual : visuals)
        if (depths.insert(visual.depth).second) out.push_back({4, visual});
    return out;
}

}  // namespace gw::gl::x11
