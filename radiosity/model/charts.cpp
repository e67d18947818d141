#include "radiosity/model/charts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gw::radiosity {
namespace {

constexpr double least_cos_at_edge = 0.906307787;   // 25 degrees
constexpr double least_cos_to_first = 0.766044443;  // 40 degrees
constexpr double planar_cos = 1 - 1e-9;

/// A side of a triangle, its ends in ascending order.
struct Side {
    std::uint32_t a, b, triangle;
    auto operator<=>(const Side&) const = default;
};

class Charts {
public:
    explicit Charts(const Surface& surface)
        : surface_(surface), chart_(surface.triangles.size(), none) {
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
            const dvec3 cross = surface.cross(t);
            const double twice_area = length(cross);
            const bool solid = surface.solid(t);
            normals_.push_back(solid ? cross / twice_area : dvec3(0));
            if (!solid) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [a, b] =
                    std::minmax(surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]);
                sides_.push_back({a, b, t});
            }
        }
        std::sort(sides_.begin(), sides_.end());
    }

    std::vector<Chart> all() {
        std::vector<Chart> found;
        for (std::uint32_t t = 0; t < chart_.size(); ++t) {
            if (normals_[t] == dvec3(0) || chart_[t] != none) continue;
            found.push_back(grow(t, static_cast<std::uint32_t>(found.size())));
        }
        return found;
    }

    Chart of(std::vector<std::uint32_t> triangles) {
        for (const std::uint32_t t : triangles) chart_[t] = 0;
        Chart chart{.triangles = std::move(triangles)};
        finish(chart, chart.triangles.front(), 0);
        return chart;
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;

    bool fits(std::uint32_t t, std::uint32_t from, std::uint32_t first) const {
        return chart_[t] == none && dot3(normals_[t], normals_[from]) >= least_cos_at_edge &&
               dot3(normals_[t], normals_[first]) >= least_cos_to_first;
    }

    template <class Visit>
    void for_each_neighbour(std::uint32_t t, Visit visit) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] =
                std::minmax(surface_.triangles[t][k], surface_.triangles[t][(k + 1) % 3]);
            for (auto s = std::lower_bound(sides_.begin(), sides_.end(), Side{a, b, 0});
                 s != sides_.end() && s->a == a && s->b == b; ++s)
                if (s->triangle != t) visit(s->triangle, *s);
        }
    }

    Chart grow(std::uint32_t first, std::uint32_t number) {
        Chart chart;
        chart.triangles.push_back(first);
        chart_[first] = number;
        for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
            const std::uint32_t from = chart.triangles[i];
            for_each_neighbour(from, [&](std::uint32_t t, const Side&) {
                if (!fits(t, from, first)) return;
                chart_[t] = number;
                chart.triangles.push_back(t);
            });
        }
        std::sort(chart.triangles.begin(), chart.triangles.end());
        finish(chart, first, number);
        return chart;
    }

    void finish(Chart& chart, std::uint32_t first, std::uint32_t number) const {
        dvec3 sum(0);
        chart.planar = true;
        for (std::uint32_t t : chart.triangles) {
            sum += surface_.cross(t);
            chart.planar = chart.planar && dot3(normals_[t], normals_[first]) >= planar_cos;
        }
        chart.normal = sum / length(sum);
        chart.along = longest_border(chart, number);
        chart.along -= dot3(chart.along, chart.normal) * chart.normal;
        chart.along /= length(chart.along);
    }

    // A rectangle is then parallel to its pixmap, and all its texels are whole.
    dvec3 longest_border(const Chart& chart, std::uint32_t number) const {
        dvec3 longest(0);
        for (std::uint32_t t : chart.triangles) {
            const auto& corner = surface_.triangles[t];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corner[k], b = corner[(k + 1) % 3];
                const dvec3 side = surface_.points[b] - surface_.points[a];
                if (dot3(side, side) <= dot3(longest, longest) * (1 + 1e-6)) continue;
                bool inner = false;
                for_each_neighbour(t, [&](std::uint32_t other, const Side& s) {
                    inner = inner || (chart_[other] == number && s.a == std::min(a, b) &&
                                      s.b == std::max(a, b));
                });
                if (!inner) longest = side;
            }
        }
        return longest == dvec3(0) ? any_side(chart) : longest;
    }

    dvec3 any_side(const Chart& chart) const {  // a closed chart there is not, but a doubled one
        const auto& [a, b, c] = surface_.triangles[chart.triangles.front()];
        return surface_.points[b] - surface_.points[a];
    }

    const Surface& surface_;
    std::vector<dvec3> normals_;
    std::vector<std::uint32_t> chart_;
    std::vector<Side> sides_;
};

}  // namespace

std::vector<Chart> charts(const Surface& surface) { return Charts(surface).all(); }

Chart chart_of(const Surface& surface, std::vector<std::uint32_t> triangles) {
    return Charts(surface).of(std::move(triangles));
}

}  // namespace gw::radiosity
