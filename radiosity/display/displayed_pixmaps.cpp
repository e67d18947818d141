#include "radiosity/display/displayed_pixmaps.h"

#include "radiosity/display/seams.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
DisplayedPixmaps::DisplayedPixmaps(const PixmapModel& model) {
    std::size_t count = 0;
    for (const Pixmap& p : model.pixmaps) {
        places_.push_back({count, p.width, p.height});
        count += std::size_t(p.width + 2) * std::size_t(p.height + 2);
    }
    colors_.resize(count);
}

dvec3 DisplayedPixmaps::at(std::uint32_t pixmap, const dvec2& uv) const {
    const Place& p = places_[pixmap];
    const double u = std::clamp(uv.x, 0.0, double(p.width)) - 0.5,
                 v = std::clamp(uv.y, 0.0, double(p.height)) - 0.5;
    const int x = std::min(static_cast<int>(std::floor(u)), p.width - 1),
              y = std::min(static_cast<int>(std::floor(v)), p.height - 1);
    const double wx = u - x, wy = v - y;
    const auto row = [&](int j) { return at(pixmap, x, j) * (1 - wx) + at(pixmap, x + 1, j) * wx; };
    return row(y) * (1 - wy) + row(y + 1) * wy;
}

namespace {

/// `value` of each texel, by its number.
template <class Value>
DisplayedPixmaps displayed(const PixmapModel& model, const Value& value) {
    DisplayedPixmaps colors(model);
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p) {
        const Pixmap& pixmap = model.pixmaps[p];
        for (int y = -1; y <= pixmap.height; ++y)
            for (int x = -1; x <= pixmap.width; ++x) {
                const std::size_t t = model.nearest[pixmap.texel(
                    std::clamp(x, 0, pixmap.width - 1), std::clamp(y, 0, pixmap.height - 1))];
                colors.at(p, x, y) = value(t);
            }
    }
    close_seams(model, colors);
    return colors;
}

}  // namespace

DisplayedPixmaps displayed_pixmaps(const PixmapModel& model, const Solution& solution,
                                   bool with_ambient) {
    const dvec3 light = with_ambient ? ambient(model, solution) : dvec3(0);
    return displayed(model, [&](std::size_t t) {
        return radiosity_at(model, solution, t) + model.rho[t] * light;
    });
}

DisplayedPixmaps displayed_irradiance(const PixmapModel& model, const Solution& solution,
                                      bool with_ambient) {
    const dvec3 light = with_ambient ? ambient(model, solution) : dvec3(0);
    return displayed(model, [&](std::size_t t) { return solution.H[t] + light; });
}

}  // namespace gw::radiosity
