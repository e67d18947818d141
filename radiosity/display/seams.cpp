#include "radiosity/display/seams.h"

#include "radiosity/model/geometry.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace gw::radiosity {
namespace {

constexpr double least_cos = 0.766044443;  // 40 degrees
constexpr double filter_reach = 1.5;       ///< texels beyond the border that filters can see
constexpr double fit_reach = 2.5;          ///< texels around a middle whose elements are fitted

dvec3 space(const dvec2& v) { return {v.x, v.y, 0}; }

/// A point of a facet, or beside it in its plane.
struct Place {
    const Facet* facet = nullptr;
    dvec3 p{0};
};

/// An element [F2] as its figure has it.
struct Element {
    dvec3 middle{0}, normal{0}, color{0};
    double area = 0;
    std::uint32_t pixmap = 0;
};

/// A paraboloid through colours over a surface's tangent plane, by least squares.
class Fit {
public:
    /// x and y: from the point that is asked for.
    void add(double x, double y, double weight, const dvec3& color) {
        const std::array<double, most> row{1, x, y, x * x, x * y, y * y};
        for (std::size_t i = 0; i < most; ++i) {
            for (std::size_t j = 0; j < most; ++j) moments_[i][j] += weight * row[i] * row[j];
            colors_[i] += weight * row[i] * color;
        }
        low_ = glm::min(low_, color);
        high_ = glm::max(high_, color);
        ++count_;
    }

    /// At the point, within the colours that were added: of the paraboloid; if they do not tell one,
    /// of a plane; else the mean.
    dvec3 value() const {
        for (const std::size_t terms : {most, std::size_t{3}})
            if (count_ >= 2 * terms)
                if (const auto value = solved(terms)) return glm::clamp(*value, low_, high_);
        return colors_[0] / moments_[0][0];
    }

private:
    static constexpr std::size_t most = 6;

    /// The first of the terms, by Gauss' elimination from the last one up.
    std::optional<dvec3> solved(std::size_t terms) const {
        auto m = moments_;
        auto c = colors_;
        for (std::size_t k = terms - 1; k > 0; --k) {
            constexpr double least = 1e-3;  // of what the others leave of a term
            if (!(m[k][k] > least * moments_[k][k])) return std::nullopt;
            for (std::size_t i = 0; i < k; ++i) {
                const double part = m[i][k] / m[k][k];
                for (std::size_t j = 0; j < k; ++j) m[i][j] -= part * m[k][j];
                c[i] -= part * c[k];
            }
        }
        if (!(m[0][0] > 0)) return std::nullopt;
        return c[0] / m[0][0];
    }

    std::array<std::array<double, most>, most> moments_{};
    std::array<dvec3, most> colors_{};
    std::size_t count_ = 0;
    dvec3 low_{std::numeric_limits<double>::infinity()}, high_ = -low_;
};

/// Two unit vectors across a unit normal.
std::pair<dvec3, dvec3> tangents(const dvec3& normal) {
    const dvec3 axis = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0),
                across = cross3(normal, axis), x = across / length(across);
    return {x, cross3(normal, x)};
}

/// The pixmaps of one object.
class Seams {
public:
    Seams(const PixmapModel& model, std::vector<std::uint32_t> pixmaps, DisplayedPixmaps& colors)
        : model_(model), pixmaps_(std::move(pixmaps)), colors_(colors) {
        for (std::uint32_t number : pixmaps_) add_elements(number);
        std::sort(elements_.begin(), elements_.end(),
                  [](const Element& a, const Element& b) { return a.middle.x < b.middle.x; });
    }

    void close() {
        for (std::uint32_t number : pixmaps_) close(number);
    }

private:
    void add_elements(std::uint32_t number) {
        const Pixmap& pixmap = model_.pixmaps[number];
        for (int y = 0; y < pixmap.height; ++y)
            for (int x = 0; x < pixmap.width; ++x) {
                const std::size_t first = pixmap.texel(x, y);
                if (model_.nearest[first] != first || model_.area[first] == 0) continue;
                Element e{.color = colors_.at(number, x, y), .pixmap = number};
                for (auto t = std::uint32_t(first); t != no_texel; t = model_.next_of_element[t]) {
                    e.middle += model_.area[t] * model_.middle[t];
                    e.area += model_.area[t];
                }
                e.middle /= e.area;
                e.normal = model_.facets[model_.facet_of[first]].normal;
                elements_.push_back(e);
            }
    }

    void close(std::uint32_t number) {
        const Pixmap& pixmap = model_.pixmaps[number];
        for (int y = -1; y <= pixmap.height; ++y)
            for (int x = -1; x <= pixmap.width; ++x) {
                const bool inside = x >= 0 && y >= 0 && x < pixmap.width && y < pixmap.height;
                if (inside && is_whole(pixmap.texel(x, y))) continue;
                const Place place = place_of(pixmap, {x + 0.5, y + 0.5});
                if (!place.facet) continue;
                if (const auto color = fitted(number, place)) colors_.at(number, x, y) = *color;
            }
    }

    /// Covered, and an element by itself: its colour is that of its middle.
    bool is_whole(std::size_t texel) const {
        return model_.share[texel] > 1 - 1e-9 && model_.nearest[texel] == texel &&
               model_.next_of_element[texel] == no_texel;
    }

    /// None if no other pixmap has an element near it.
    std::optional<dvec3> fitted(std::uint32_t number, const Place& place) const {
        const dvec3& normal = place.facet->normal;
        const double texel = std::sqrt(place.facet->texel_area), reach = fit_reach * texel;
        const auto [along, across] = tangents(normal);
        auto e =
            std::lower_bound(elements_.begin(), elements_.end(), place.p.x - reach,
                             [](const Element& element, double x) { return element.middle.x < x; });
        Fit fit;
        bool goes_on = false;
        for (; e != elements_.end() && e->middle.x <= place.p.x + reach; ++e) {
            const dvec3 d = e->middle - place.p;
            const double near = 1 - dot3(d, d) / (reach * reach);
            if (!(near > 0) || dot3(e->normal, normal) < least_cos) continue;
            goes_on = goes_on || e->pixmap != number;
            fit.add(dot3(along, d) / reach, dot3(across, d) / reach, e->area * near * near,
                    e->color);
        }
        if (!goes_on) return std::nullopt;
        return fit.value();
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
    const std::vector<std::uint32_t> pixmaps_;
    DisplayedPixmaps& colors_;
    std::vector<Element> elements_;  ///< by middle.x
};

}  // namespace

void close_seams(const PixmapModel& model, DisplayedPixmaps& colors) {
    for (const Source& source : model.sources) {
        std::vector<std::uint32_t> pixmaps;
        for (const std::uint32_t facet : source.facets)
            if (facet != no_facet) pixmaps.push_back(model.facets[facet].pixmap);
        std::sort(pixmaps.begin(), pixmaps.end());
        pixmaps.erase(std::unique(pixmaps.begin(), pixmaps.end()), pixmaps.end());
        if (pixmaps.size() > 1) Seams(model, std::move(pixmaps), colors).close();
    }
}

}  // namespace gw::radiosity
