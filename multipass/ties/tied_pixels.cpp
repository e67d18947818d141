#include "multipass/ties/tied_pixels.h"

#include "gw/stages/vertex.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gw::multipass {
namespace {

/// Pixels a side.
constexpr int cell = 8;
/// Jitter and snapping move a vertex less than this.
constexpr double slack = 2;

class Cells {
public:
    Cells(const scene::View& view)
        : columns_((view.width + cell - 1) / cell),
          rows_((view.height + cell - 1) / cell),
          tied_(std::size_t(columns_) * std::size_t(rows_)) {}

    void mark(int x, int y) { tied_[at(x / cell, y / cell)] = true; }

    /// Any in a box of window coordinates.
    bool any(const dvec2& low, const dvec2& high) const {
        const int x0 = column(low.x), x1 = column(high.x), y0 = row(low.y), y1 = row(high.y);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                if (tied_[at(x, y)]) return true;
        return false;
    }

private:
    std::size_t at(int x, int y) const {
        return std::size_t(y) * std::size_t(columns_) + std::size_t(x);
    }
    static int index(double v, int count) { return int(std::clamp(v / cell, 0.0, count - 1.0)); }
    int column(double x) const { return index(x, columns_); }
    int row(double y) const { return index(y, rows_); }

    int columns_, rows_;
    std::vector<bool> tied_;
};

/// Where a vertex is in the window; nowhere: before the near plane.
struct Place {
    dvec2 p{0};
    bool behind = false;
};

std::vector<Place> places(const PlacedModel& placed, std::size_t part) {
    const ViewportState& port = placed.state.viewport;
    const dmat4 clip_from_object = product(placed.state.projection, placed.eye_from_object[part]);
    std::vector<Place> out;
    for (const vec3& v : placed.model->parts[part].mesh->data().positions) {
        const dvec4 c = transform(clip_from_object, dvec4(dvec3(v), 1));
        if (!(c.z > -c.w) || !(c.w > 0))
            out.push_back({.behind = true});
        else
            out.push_back({{port.x + (c.x / c.w + 1) / 2 * port.width,
                            port.y + (c.y / c.w + 1) / 2 * port.height}});
    }
    return out;
}

bool may_touch(const Cells& cells, const std::vector<Place>& at, const Triangle& triangle) {
    const auto& [a, b, c] = triangle.vertex;
    if (at[a].behind || at[b].behind || at[c].behind) return true;
    const dvec2 low = glm::min(glm::min(at[a].p, at[b].p), at[c].p),
                high = glm::max(glm::max(at[a].p, at[b].p), at[c].p);
    return cells.any(low - slack, high + slack);
}

std::vector<std::uint32_t> triangles_near(const Cells& cells, const PlacedModel& placed,
                                          std::size_t part) {
    const std::vector<Place> at = places(placed, part);
    const auto triangles = placed.model->parts[part].mesh->triangles();
    std::vector<std::uint32_t> near_ties;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (may_touch(cells, at, triangles[i])) near_ties.push_back(i);
    return near_ties;
}

}  // namespace

TiedPixels tied_pixels(const PlacedModel& placed, std::span<const std::uint32_t> winners) {
    TiedPixels tied;
    Cells cells(placed.view);
    const auto width = std::size_t(placed.view.width);
    for (std::size_t i = 0; i < winners.size(); ++i) {
        if (winners[i] < 2) continue;
        const int x = int(i % width), y = int(i / width);
        cells.mark(x, y);
        tied.spans.push_back({.x = x, .y = y, .length = 1});
    }
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i) {
        const Part& part = placed.model->parts[i];
        if (part.translucent) continue;
        if (part.mesh->kind() != MeshKind::Triangles) {
            tied.portions.push_back({.part = i});
            continue;
        }
        const std::vector<std::uint32_t> near_ties = triangles_near(cells, placed, i);
        if (!near_ties.empty()) tied.portions.push_back(portion_of(placed, i, near_ties));
    }
    return tied;
}

}  // namespace gw::multipass
