#include "scene/validate/slivers.h"

#include "gw/base/powers.h"
#include "scene/text/suggest.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace gw::scene {
namespace {

/// A vertex in sub-pixel units of the window, and snapped (R6.21). Not seen: at the eye's plane,
/// behind it, or far outside the window.
struct WindowVertex {
    dvec2 exact{0}, snapped{0};
    bool is_seen = false;
};

std::vector<WindowVertex> window_vertices(const Object& object, const View& view, double units) {
    std::vector<WindowVertex> all;
    for (const vec3& position : object.mesh->data().positions) {
        WindowVertex& v = all.emplace_back();
        const dvec4 world = object.world_from_object * dvec4(dvec3(position), 1);
        const dvec4 clip = view.clip_from_eye * (view.eye_from_world * world);
        v.is_seen = clip.w > 0 && std::abs(clip.x) <= 2 * clip.w && std::abs(clip.y) <= 2 * clip.w;
        v.exact = dvec2((clip.x / clip.w + 1) * view.width, (clip.y / clip.w + 1) * view.height) *
                  (units / 2);
        v.snapped = {std::floor(v.exact.x + 0.5), std::floor(v.exact.y + 0.5)};
    }
    return all;
}

/// R6.23
double area2(const dvec2& p, const dvec2& q, const dvec2& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// The sides of the box of a triangle.
std::pair<dvec2, dvec2> box_of(const dvec2& p, const dvec2& q, const dvec2& r) {
    return {glm::min(p, glm::min(q, r)), glm::max(p, glm::max(q, r))};
}

/// Whether a clockwise triangle does, in units of a pixel.
bool covers_a_center(const dvec2& p, const dvec2& q, const dvec2& r, double units) {
    const auto [low, high] = box_of(p, q, r);
    const auto first = [&](double v) { return (std::ceil(v / units - 0.5) + 0.5) * units; };
    for (double y = first(low.y); y <= high.y; y += units)
        for (double x = first(low.x); x <= high.x; x += units) {
            const dvec2 c(x, y);
            if (area2(p, q, c) <= 0 && area2(q, r, c) <= 0 && area2(r, p, c) <= 0) return true;
        }
    return false;
}

bool has_turned(std::span<const Triangle> triangles, const std::vector<WindowVertex>& vertices,
                double units) {
    const auto corner = [&](const Triangle& t, std::size_t k) -> const WindowVertex& {
        return vertices[t.vertex[k]];
    };
    double sum = 0;
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            if (!corner(t, k).is_seen) return false;
        sum += area2(corner(t, 0).exact, corner(t, 1).exact, corner(t, 2).exact);
    }
    return std::ranges::any_of(triangles, [&](const Triangle& t) {
        // Counter-clockwise, if the polygon is.
        const WindowVertex &p = corner(t, 0), &q = corner(t, sum < 0 ? 2 : 1),
                           &r = corner(t, sum < 0 ? 1 : 2);
        const auto [low, high] = box_of(p.exact, q.exact, r.exact);
        return area2(p.snapped, q.snapped, r.snapped) < 0 &&
               area2(p.exact, q.exact, r.exact) > -std::max(high.x - low.x, high.y - low.y) &&
               covers_a_center(p.snapped, q.snapped, r.snapped, units);
    });
}

}  // namespace

std::string turned_slivers(const Scene& scene, const View& view, int subpixel_bits) {
    const double units = power_of_two(subpixel_bits);
    for (const Object& object : scene.objects) {
        if (object.mesh->data().primitive != Primitive::Polygons) continue;
        const std::span<const Triangle> all = object.mesh->triangles();
        std::vector<WindowVertex> vertices;
        for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
            while (end < all.size() && all[end].polygon == all[begin].polygon) ++end;
            if (end - begin < 3) continue;
            if (vertices.empty()) vertices = window_vertices(object, view, units);
            if (has_turned(all.subspan(begin, end - begin), vertices, units))
                return "object '" + printable(object.name) + "' has a polygon with " +
                       std::to_string(end - begin + 2) +
                       " corners, so many on a line that pixels there may have the colour of its "
                       "back; expected fewer on a line, or a renderer by rays";
        }
    }
    return {};
}

}  // namespace gw::scene
