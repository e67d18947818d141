#include "gw/stages/pixels/plane_texels.h"

#include "gw/base/arithmetic.h"

namespace gw {

Texels plane_texels(Plane plane, const Rect& rect, const std::vector<Rgba>& colors,
                    const Planes& planes, const Profile& profile) {
    Texels t{profile.color_bits};
    t.add_level(rect.width, rect.height);
    if (plane == Plane::Depth) {
        t.depths.reserve(rect.area());
        t.depth_bits = profile.depth_bits;
    }
    std::size_t next = 0;
    for (int y = rect.y; y < rect.y + rect.height; ++y)
        for (int x = rect.x; x < rect.x + rect.width; ++x) {
            const std::size_t i = planes.index(x, y);
            if (plane == Plane::Color) {
                t.set(next++, colors[i]);
                continue;
            }
            const std::uint32_t depth = planes.depth[i];
            const auto grey = std::uint16_t(rescale(depth, profile.depth_bits, profile.color_bits));
            t.set(next++, {grey, grey, grey, grey});
            t.depths.push_back(depth);
        }
    return t;
}

}  // namespace gw
