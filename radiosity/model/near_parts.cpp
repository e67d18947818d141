#include "radiosity/model/near_parts.h"

#include "radiosity/model/geometry.h"
#include "radiosity/model/patches.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

constexpr std::size_t most_near = 4;  ///< surfaces; Polygon2 has space for their sides

/// The height over a plane, on a facet: dot(side, (1, u, v)).
dvec3 side_of(const Facet& plane, const Facet& on) {
    return {dot3(plane.normal, on.origin) - plane.offset, dot3(plane.normal, on.du),
            dot3(plane.normal, on.dv)};
}

Polygon2 cut(Polygon2 polygon, const std::vector<dvec3>& sides) {
    for (const dvec3& side : sides) polygon = cut(polygon, side);
    return polygon;
}

/// A surface, and its region about the part: inside its plane, in front of all others.
struct NearRegion {
    NearTexels texels;
    Polygon2 polygon;
};

class Search {
public:
    Search(const PixmapModel& model, std::uint32_t facet, const Part& part, double reach)
        : model_(model),
          own_(model.facets[facet]),
          tolerance_(touching * model.extent),
          middle_(own_.at((part.low + part.high) / 2.0)),
          reach_(reach) {
        for (const dvec2& uv :
             {part.low, dvec2(part.high.x, part.low.y), part.high, dvec2(part.low.x, part.high.y)})
            corners_.push_back(own_.at(uv));
    }

    /// False if there are too many.
    bool find_regions() {
        for (std::uint32_t i = 0; i < model_.facets.size(); ++i)
            if (is_near(i))
                regions_.push_back({.texels = {.facet = i, .sides = {}}, .polygon = {}});
        if (regions_.size() > most_near) return false;
        for (NearRegion& region : regions_) find(region);
        return true;
    }

    /// Whether the regions belong to their facets wholly, so that nothing passes beside them.
    bool is_closed() const {
        return std::all_of(regions_.begin(), regions_.end(), [&](const NearRegion& region) {
            const double all = region.polygon.n < 3 ? 0 : area(region.polygon);
            double covered = 0;
            for (const Triangle2& t : model_.facets[region.texels.facet].triangles)
                covered += area_inside(t, region.texels);
            return covered >= all * (1 - 1e-4);
        });
    }

    /// Whether a surface may stand between the part and the regions. All that is in front of a
    /// plane is not hidden by it.
    bool is_hidden() const {
        double radius = 0;
        for (const dvec3& corner : corners_) radius = std::max(radius, length(corner - middle_));
        for (const NearRegion& region : regions_)
            for (int i = 0; i < region.polygon.n; ++i)
                radius = std::max(radius, length(at(region, i) - middle_));
        return std::any_of(model_.facets.begin(), model_.facets.end(), [&](const Facet& facet) {
            return is_within(facet, radius) && !is_all_before(facet);
        });
    }

    std::vector<NearTexels> texels() {
        std::vector<NearTexels> all;
        for (NearRegion& region : regions_)
            if (region.polygon.n >= 3) all.push_back(std::move(region.texels));
        return all;
    }

private:
    dvec3 at(const NearRegion& region, int corner) const {
        return model_.facets[region.texels.facet].at(region.polygon[corner]);
    }

    /// Above the part's plane, and nearer than this.
    bool is_within(const Facet& facet, double distance) const {
        if (&facet == &own_ || length(facet.center - middle_) - facet.radius > distance)
            return false;
        double high = 0;
        for (int k = 0; k < facet.corner_count; ++k)
            high = std::max(high, dot3(own_.normal, facet.corners[std::size_t(k)]) - own_.offset);
        if (high <= tolerance_) return false;
        return std::any_of(facet.triangles.begin(), facet.triangles.end(), [&](const auto& t) {
            return length(middle_ - nearest_point(middle_, facet.at(t[0]), facet.at(t[1]),
                                                  facet.at(t[2]))) < distance;
        });
    }

    bool is_near(std::uint32_t number) const {
        const Facet& facet = model_.facets[number];
        return dot3(facet.normal, middle_) - facet.offset > 0 && is_within(facet, reach_);
    }

    void find(NearRegion& region) const {
        NearTexels& texels = region.texels;
        const Facet& facet = model_.facets[texels.facet];
        const Pixmap& pixmap = model_.pixmaps[facet.pixmap];
        const double height = dot3(facet.normal, middle_) - facet.offset,
                     radius = std::sqrt(std::max(reach_ * reach_ - height * height, 0.0));
        const dvec2 foot = facet.texel_of(middle_),
                    half(radius * length(facet.grad_u), radius * length(facet.grad_v));
        const ivec2 low(static_cast<int>(std::floor(foot.x - half.x)),
                        static_cast<int>(std::floor(foot.y - half.y))),
            high(static_cast<int>(std::ceil(foot.x + half.x)),
                 static_cast<int>(std::ceil(foot.y + half.y)));
        texels.first = glm::max(low, ivec2(0));
        texels.end = glm::min(high, ivec2(pixmap.width, pixmap.height));
        texels.sides.push_back(side_of(own_, facet));
        for (const NearRegion& other : regions_)
            if (&other != &region)
                texels.sides.push_back(side_of(model_.facets[other.texels.facet], facet));
        Polygon2 box;
        for (const ivec2& corner : {low, ivec2(high.x, low.y), high, ivec2(low.x, high.y)})
            box.add(corner);
        region.polygon = cut(box, texels.sides);
    }

    static double area_inside(const Triangle2& triangle, const NearTexels& texels) {
        Polygon2 polygon;
        for (const dvec2& corner : triangle) polygon.add(corner);
        polygon = cut(cut_to_box(polygon, texels.first, texels.end), texels.sides);
        return polygon.n < 3 ? 0 : area(polygon);
    }

    bool is_all_before(const Facet& plane) const {
        const auto is_before = [&](const dvec3& p) {
            return dot3(plane.normal, p) - plane.offset >= -tolerance_;
        };
        return std::all_of(corners_.begin(), corners_.end(), is_before) &&
               std::all_of(regions_.begin(), regions_.end(), [&](const NearRegion& region) {
                   bool before = true;
                   for (int i = 0; i < region.polygon.n; ++i)
                       before = before && is_before(at(region, i));
                   return before;
               });
    }

    const PixmapModel& model_;
    const Facet& own_;
    const double tolerance_;
    const dvec3 middle_;
    const double reach_;
    std::vector<dvec3> corners_;
    std::vector<NearRegion> regions_;
};

}  // namespace

std::optional<NearPart> near_part_of(const PixmapModel& model, std::uint32_t facet,
                                     const Part& part, double reach) {
    Search search(model, facet, part, reach);
    if (!search.find_regions() || !search.is_closed() || search.is_hidden()) return std::nullopt;
    return NearPart{.facet = facet, .part = part, .texels = search.texels()};
}

}  // namespace gw::radiosity
