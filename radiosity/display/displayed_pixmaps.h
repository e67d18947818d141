// The colours that pixmaps show [F2.3], with a border of one texel, so that filters have neighbours
// everywhere. Does not draw.
#pragma once

#include "radiosity/solver/solution.h"

namespace gw::radiosity {

/// Of all pixmaps, each (width + 2) x (height + 2).
class DisplayedPixmaps {
public:
    explicit DisplayedPixmaps(const PixmapModel& model);

    /// Of a pixmap, by its number: -1 <= x <= width, -1 <= y <= height.
    dvec3& at(std::uint32_t pixmap, int x, int y) { return colors_[index(pixmap, x, y)]; }
    const dvec3& at(std::uint32_t pixmap, int x, int y) const {
        return colors_[index(pixmap, x, y)];
    }

    /// Bilinear between the texels' middles, at texel coordinates inside the pixmap.
    dvec3 at(std::uint32_t pixmap, const dvec2& uv) const;

private:
    struct Place {
        std::size_t first = 0;
        int width = 0, height = 0;
    };
    std::size_t index(std::uint32_t pixmap, int x, int y) const {
        const Place& p = places_[pixmap];
        return p.first + std::size_t(y + 1) * std::size_t(p.width + 2) + std::size_t(x + 1);
    }
    std::vector<Place> places_;
    std::vector<dvec3> colors_;
};

/// The colour at each texel: its radiosity and, if `with_ambient`, the estimate of the light yet to
/// come [F1c]. Beyond a figure's border its nearest texel is repeated, so that nothing leaks in. If
/// a smooth surface continues in another pixmap, both have the same colours there (seams.h).
DisplayedPixmaps displayed_pixmaps(const PixmapModel& model, const Solution& solution,
                                   bool with_ambient);

/// Likewise the light that falls on each texel, in place of the light that it sends.
DisplayedPixmaps displayed_irradiance(const PixmapModel& model, const Solution& solution,
                                      bool with_ambient);

}  // namespace gw::radiosity
