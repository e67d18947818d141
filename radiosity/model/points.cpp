#include "radiosity/model/points.h"

#include "radiosity/model/geometry.h"

#include <algorithm>
#include <cmath>

namespace gw::radiosity {
namespace {

/// The covered area of a part: its world area, and the middle of the facet that covers most.
struct Covered {
    const Facet* facet = nullptr;
    double area = 0;         ///< world, all facets
    double facet_share = 0;  ///< of the part, in texels, by `facet`
    dvec2 middle{0};
    bool whole(const Part& part) const { return facet && facet_share >= part.area() * (1 - 1e-9); }
};

Covered covered(const PixmapModel& model, const Pixmap& pixmap, const Part& part) {
    Covered best;
    for (std::uint32_t number : pixmap.facets) {
        const Facet& facet = model.facets[number];
        if (facet.low.x >= part.high.x || facet.high.x <= part.low.x ||
            facet.low.y >= part.high.y || facet.high.y <= part.low.y)
            continue;
        double share = 0, largest = 0;
        dvec2 sum(0), middle_of_largest(0);
        for (const Triangle2& triangle : facet.triangles) {
            Polygon2 polygon;
            for (const dvec2& uv : triangle) polygon.add(uv);
            polygon = cut_to_box(polygon, part.low, part.high);
            const double a = polygon.n < 3 ? 0 : area(polygon);
            if (!(a > 1e-12)) continue;
            const dvec2 c = centroid(polygon);
            share += a;
            sum += a * c;
            if (a > largest) middle_of_largest = c;
            largest = std::max(largest, a);
        }
        best.area += share * facet.texel_area;
        if (share <= best.facet_share) continue;
        best.facet = &facet;
        best.facet_share = share;
        // The mean of several pieces may lie outside the figure.
        best.middle = largest > 0.5 * share ? middle_of_largest : sum / share;
    }
    return best;
}

/// In texels. Curved figures touch others in points, near which no part would be small enough: a
/// texel is.
double smallest_part(const Pixmap& pixmap, const PointOptions& options) {
    if (pixmap.facets.size() > 1) return options.smallest_part;
    return (pixmap.whole ? 1 : 0.5) *
           std::min(options.smallest_part,
                    std::min(pixmap.width, pixmap.height) * options.smallest_of_pixmap);
}

class Points {
public:
    Points(const PixmapModel& model, const Patch& patch, const PointOptions& options)
        : model_(model),
          patch_(patch),
          pixmap_(model.pixmaps[patch.pixmap]),
          options_(options),
          smallest_part_(smallest_part(pixmap_, options)) {
        const Part whole{{patch.x, patch.y}, {patch.x + patch.width, patch.y + patch.height}};
        add(whole, covered(model, pixmap_, whole), -1);
    }
    Shooting shooting;

private:
    /// patch_quarter: that has the part; -1: the part is the whole patch.
    void add(const Part& part, const Covered& found, int patch_quarter) {
        if (!found.facet) return;
        const dvec2 size = part.high - part.low, middle = (part.low + part.high) / 2.0;
        const double extent =
            std::max(length(found.facet->du) * size.x, length(found.facet->dv) * size.y);
        const bool is_near = near_something(found.facet->at(found.middle), *found.facet, extent);
        const bool split_for_shadows = divides_for_shadows(part);
        const std::optional<NearPart> near =
            is_near && !split_for_shadows ? near_part(part, found, extent) : std::nullopt;
        const bool split = split_for_shadows || (is_near && !near && is_divisible(part));
        const dvec2 offset = size / (2 * std::sqrt(3.0));
        for (int quarter = 0; quarter < 4; ++quarter) {
            const dvec2 sign(quarter & 1 ? 1 : -1, quarter & 2 ? 1 : -1);
            const Part q{
                {quarter & 1 ? middle.x : part.low.x, quarter & 2 ? middle.y : part.low.y},
                {quarter & 1 ? part.high.x : middle.x, quarter & 2 ? part.high.y : middle.y}};
            const Covered in_quarter = covered(model_, pixmap_, q);
            if (!in_quarter.facet) continue;
            const int in = patch_quarter < 0 ? quarter : patch_quarter;
            if (split) {
                add(q, in_quarter, in);
                continue;
            }
            const dvec2 uv = found.whole(part) ? middle + sign * offset : in_quarter.middle;
            add_point(in_quarter, uv, extent * std::sqrt(in_quarter.facet_share / q.area()));
            shooting.points.back().quarter = in;
            if (!near) continue;
            shooting.points.back().near_part = std::uint32_t(shooting.near_parts.size());
            shooting.near_parts.push_back({near->facet, q, 0, near->texels});
        }
    }

    void add_point(const Covered& found, const dvec2& uv, double size) {
        const dvec3 p = found.facet->at(uv);
        shooting.points.push_back({p, found.facet->normal, found.area / patch_.area, size,
                                   nearest(p, *found.facet, nearest_known * size)});
    }

    std::optional<NearPart> near_part(const Part& part, const Covered& found, double extent) const {
        if (!options_.near_parts || !found.whole(part)) return std::nullopt;
        const auto facet = static_cast<std::uint32_t>(found.facet - model_.facets.data());
        return near_part_of(model_, facet, part, extent / options_.nearness);
    }

    /// The distance of the nearest surface above own's plane; infinite if it is more than `most`.
    double nearest(const dvec3& p, const Facet& own, double most) const {
        double least = std::numeric_limits<double>::infinity();
        for (const Facet& facet : model_.facets) {
            if (&facet == &own || length(facet.center - p) - facet.radius > most) continue;
            if (rise(facet, p, own) <= touching * model_.extent) continue;
            const double d = distance(p, facet);
            if (d <= most) least = std::min(least, d);
        }
        return least;
    }

    /// How far a facet's corners rise above own's plane.
    static double rise(const Facet& facet, const dvec3& p, const Facet& own) {
        double high = 0;
        for (int k = 0; k < facet.corner_count; ++k)
            high = std::max(high, dot3(own.normal, facet.corners[std::size_t(k)] - p));
        return high;
    }

    static double distance(const dvec3& p, const Facet& facet) {
        double least = std::numeric_limits<double>::infinity();
        for (const Triangle2& t : facet.triangles)
            least = std::min(least, length(p - nearest_point(p, facet.at(t[0]), facet.at(t[1]),
                                                             facet.at(t[2]))));
        return least;
    }

    static double longest(const Part& part) {
        return std::max(part.high.x - part.low.x, part.high.y - part.low.y);
    }
    bool is_divisible(const Part& part) const { return longest(part) / 2 >= smallest_part_; }
    bool divides_for_shadows(const Part& part) const {
        return patch_.emits && longest(part) > options_.emitter_part && is_divisible(part);
    }

    bool near_something(const dvec3& p, const Facet& own, double extent) const {
        for (const Facet& facet : model_.facets) {
            if (&facet == &own ||
                length(facet.center - p) - facet.radius > extent / options_.nearness)
                continue;
            if (dot3(facet.normal, p) - facet.offset <= 0) continue;  // shows its back
            const double high = rise(facet, p, own);
            if (high <= touching * model_.extent) continue;
            const double d = distance(p, facet);
            const double seen = extent > d ? 1 : std::min(1.0, high / d);
            if (extent * seen > options_.nearness * d) return true;
        }
        return false;
    }

    const PixmapModel& model_;
    const Patch& patch_;
    const Pixmap& pixmap_;
    const PointOptions& options_;
    const double smallest_part_;
};

}  // namespace

Shooting shooting_of(const PixmapModel& model, const Patch& patch, const PointOptions& options) {
    Shooting shooting = Points(model, patch, options).shooting;
    double sum = 0;
    for (const ShootPoint& point : shooting.points) sum += point.share;
    std::array<double, 4> quarters{};
    for (ShootPoint& point : shooting.points) {
        point.share /= sum;
        quarters[std::size_t(point.quarter)] += point.share;
        if (point.near_part != no_part) shooting.near_parts[point.near_part].share = point.share;
    }
    shooting.has_quarters = std::min(patch.width, patch.height) > 1 &&
                            std::all_of(quarters.begin(), quarters.end(),
                                        [](double share) { return std::abs(share - 0.25) < 1e-9; });
    return shooting;
}

std::vector<ShootPoint> points_of(const PixmapModel& model, const Patch& patch,
                                  const PointOptions& options) {
    return shooting_of(model, patch, options).points;
}

}  // namespace gw::radiosity
