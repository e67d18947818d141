#include "radiosity/display/displayed_pixmaps.h"

#include "radiosity/model/geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gw::radiosity {
namespace {

constexpr double least_cos = 0.766044443;  // 40 degrees
constexpr double filter_reach = 1.5;       ///< texels beyond the border that filters can see

dvec3 space(const dvec2& v) { return {v.x, v.y, 0}; }

/// A point of a facet, or beside it in its plane.
struct Place {
    const Facet* facet = nullptr;
    dvec3 p{0};
};

class Seams {
public:
    Seams(const PixmapModel& model, const DisplayedPixmaps& own, const DisplayedPixmaps& before,
          DisplayedPixmaps& after)
        : model_(model),
          own_(own),
          before_(before),
          after_(after),
          facets_of_object_(model.drawn.objects.size()) {
        for (std::size_t i = 0; i < model.sources.size(); ++i) {
            std::vector<std::uint32_t>& facets = facets_of_object_[i];
            for (std::uint32_t facet : model.sources[i].facets)
                if (facet != no_facet) facets.push_back(facet);
            std::sort(facets.begin(), facets.end());
            facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
        }
    }

    void close() {
        for (const std::vector<std::uint32_t>& facets : facets_of_object_) {
            std::vector<std::uint32_t> pixmaps;
            for (std::uint32_t facet : facets) pixmaps.push_back(model_.facets[facet].pixmap);
            std::sort(pixmaps.begin(), pixmaps.end());
            pixmaps.erase(std::unique(pixmaps.begin(), pixmaps.end()), pixmaps.end());
            if (pixmaps.size() < 2) continue;
            for (std::uint32_t pixmap : pixmaps) close(pixmap, facets);
        }
    }

private:
    void close(std::uint32_t number, const std::vector<std::uint32_t>& facets) {
        const Pixmap& pixmap = model_.pixmaps[number];
        for (int y = -1; y <= pixmap.height; ++y)
            for (int x = -1; x <= pixmap.width; ++x) {
                const bool inside = x >= 0 && y >= 0 && x < pixmap.width && y < pixmap.height;
                const double own = inside ? std::min(model_.share[pixmap.texel(x, y)], 1.0) : 0;
                if (own > 1 - 1e-9) continue;
                const auto other = beyond(pixmap, {x + 0.5, y + 0.5}, facets);
                if (other)
                    after_.at(number, x, y) = own_.at(number, x, y) * own + *other * (1 - own);
            }
    }

    std::optional<dvec3> beyond(const Pixmap& pixmap, const dvec2& uv,
                                const std::vector<std::uint32_t>& facets) const {
        const Place own = place_of(pixmap, uv);
        if (!own.facet) return std::nullopt;
        double nearest = std::max(length(own.facet->du), length(own.facet->dv));
        Place other;
        for (std::uint32_t number : facets) {
            const Facet& facet = model_.facets[number];
            if (facet.pixmap == own.facet->pixmap ||
                dot3(facet.normal, own.facet->normal) < least_cos ||
                length(facet.center - own.p) - facet.radius > nearest)
                continue;
            for (const Triangle2& t : facet.triangles) {
                const dvec3 q =
                    nearest_point(own.p, facet.at(t[0]), facet.at(t[1]), facet.at(t[2]));
                if (length(q - own.p) >= nearest) continue;
                nearest = length(q - own.p);
                other = {&facet, q};
            }
        }
        if (!other.facet) return std::nullopt;
        return before_.at(other.facet->pixmap, other.facet->texel_of(other.p));
    }

    /// The position of a texel's middle in space, by the facet nearest to it; none if filters do
    /// not see it.
    Place place_of(const Pixmap& pixmap, const dvec2& uv) const {
        double nearest = filter_reach;
        Place place;
        for (std::uint32_t number : pixmap.facets) {
            const Facet& facet = model_.facets[number];
            if (uv.x < facet.low.x - nearest || uv.x > facet.high.x + nearest ||
                uv.y < facet.low.y - nearest || uv.y > facet.high.y + nearest)
                continue;
            for (const Triangle2& t : facet.triangles) {
                const double off = length(
                    space(uv) - nearest_point(space(uv), space(t[0]), space(t[1]), space(t[2])));
                if (off >= nearest) continue;
                nearest = off;
                place = {&facet, facet.at(uv)};
            }
        }
        return place;
    }

    const PixmapModel& model_;
    const DisplayedPixmaps& own_;     ///< nothing taken over
    const DisplayedPixmaps& before_;  ///< the colours that neighbours take over
    DisplayedPixmaps& after_;
    std::vector<std::vector<std::uint32_t>> facets_of_object_;
};

/// Fills texels that figures cover in part, or not at all, next to their pixmap's border. Their
/// uncovered share takes the colour of the same object's nearest point in another pixmap. It does
/// so if the surface bends by less than 40 degrees between the two, no farther away than a texel.
/// So no seam is seen from chart to chart of a sphere [F2.3]. Display only: nothing is computed
/// with it.
void close_seams(const PixmapModel& model, DisplayedPixmaps& colors) {
    // Twice: the colour that a texel takes over may itself come from a texel at a border.
    const DisplayedPixmaps own = colors;
    for (int round = 0; round < 2; ++round) {
        const DisplayedPixmaps before = colors;
        Seams(model, own, before, colors).close();
    }
}

}  // namespace

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

DisplayedPixmaps displayed_pixmaps(const PixmapModel& model, const Solution& solution,
                                   bool with_ambient) {
    const dvec3 light = with_ambient ? ambient(model, solution) : dvec3(0);
    DisplayedPixmaps colors(model);
    for (std::uint32_t p = 0; p < model.pixmaps.size(); ++p) {
        const Pixmap& pixmap = model.pixmaps[p];
        for (int y = -1; y <= pixmap.height; ++y)
            for (int x = -1; x <= pixmap.width; ++x) {
                const std::size_t t = model.nearest[pixmap.texel(
                    std::clamp(x, 0, pixmap.width - 1), std::clamp(y, 0, pixmap.height - 1))];
                colors.at(p, x, y) = radiosity_at(model, solution, t) + model.rho[t] * light;
            }
    }
    close_seams(model, colors);
    return colors;
}

}  // namespace gw::radiosity
