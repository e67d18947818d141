#include "image/rgbm.h"

#include <algorithm>
#include <cmath>

namespace gw::image {

std::array<std::uint8_t, 4> rgbm_of(const dvec3& color, double range) {
    dvec3 part(0);  // of the range
    for (int c = 0; c < 3; ++c) part[c] = std::clamp(color[c] / range, 0.0, 1.0);
    const double most = std::max(std::max(part.x, part.y), part.z);
    if (!(most > 0)) return {0, 0, 0, 0};
    const double a = std::min(std::ceil(most * 255), 255.0);
    std::array<std::uint8_t, 4> rgbm{};
    for (std::size_t c = 0; c < 3; ++c)
        rgbm[c] = std::uint8_t(std::min(std::floor(part[int(c)] / (a / 255) * 255 + 0.5), 255.0));
    rgbm[3] = std::uint8_t(a);
    return rgbm;
}

dvec3 color_of_rgbm(const std::array<std::uint8_t, 4>& rgbm, double range) {
    return dvec3(rgbm[0], rgbm[1], rgbm[2]) / 255.0 * (rgbm[3] / 255.0 * range);
}

}  // namespace gw::image
