#include "hiddensurface/faces/face.h"

#include "hiddensurface/model/floor_div.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

namespace gw::hiddensurface {
namespace {

using Corner = std::pair<std::int64_t, std::int64_t>;  ///< x, y

std::array<GridPoint, 3> counter_clockwise(std::array<GridPoint, 3> t) {
    if (turn(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    return t;
}

/// The outline of the triangles: the sides that no other triangle has in the other direction,
/// joined. Empty if they are not one convex outline around all the triangles' area.
std::vector<GridPoint> convex_outline(std::span<const WindowTriangle> triangles) {
    std::map<Corner, std::vector<std::pair<GridPoint, GridPoint>>> from;
    std::int64_t area = 0;
    for (const WindowTriangle& triangle : triangles) {
        const auto t = counter_clockwise(triangle.corners);
        area += turn(t[0], t[1], t[2]);
        for (std::size_t i = 0; i < 3; ++i) {
            const GridPoint &a = t[i], &b = t[(i + 1) % 3];
            auto& back = from[{b.x, b.y}];
            const auto twin = std::find_if(back.begin(), back.end(),
                                           [&](const auto& side) { return side.second == a; });
            if (twin != back.end())
                back.erase(twin);
            else
                from[{a.x, a.y}].emplace_back(a, b);
        }
    }
    std::erase_if(from, [](const auto& sides) { return sides.second.empty(); });
    std::vector<GridPoint> outline;
    GridPoint at = from.begin()->second.front().first;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const auto next = from.find({at.x, at.y});
        if (next == from.end() || next->second.size() != 1) return {};
        outline.push_back(at);
        at = next->second.front().second;
    }
    std::int64_t outlined = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const GridPoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
        for (const GridPoint& c : outline)
            if (turn(a, b, c) < 0) return {};
        outlined += turn(outline[0], a, b);
    }
    return outlined == area ? outline : std::vector<GridPoint>();
}

/// The outline without corners on the line of their neighbours.
std::vector<GridPoint> without_straight_corners(const std::vector<GridPoint>& p) {
    std::vector<GridPoint> kept;
    for (std::size_t i = 0; i < p.size(); ++i)
        if (turn(p[(i + p.size() - 1) % p.size()], p[i], p[(i + 1) % p.size()]) != 0)
            kept.push_back(p[i]);
    return kept;
}

Side side_of(const GridPoint& a, const GridPoint& b, int s) {
    const std::int64_t dx = b.x - a.x, dy = b.y - a.y, one = std::int64_t{1} << s, half = one / 2;
    const bool owns_its_points = dy < 0 || (dy == 0 && dx < 0);  // left or top
    return {-dy * one, dx * one, dx * (half - a.y) - dy * (half - a.x) - (owns_its_points ? 0 : 1)};
}

ExactPlane exact_plane_of(const std::array<GridPoint, 3>& t, int s) {
    const auto& [p, q, r] = t;
    const int128 ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
    const int128 vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
    const int128 nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const std::int64_t one = std::int64_t{1} << s, half = one / 2;
    return {-nx * one, -ny * one, nz * p.z - nx * (half - p.x) - ny * (half - p.y), nz};
}

Rect bounds_of(const std::vector<GridPoint>& corners, int s, const Rect& window) {
    std::int64_t x0 = corners[0].x, x1 = x0, y0 = corners[0].y, y1 = y0;
    for (const GridPoint& p : corners) {
        x0 = std::min(x0, p.x);
        x1 = std::max(x1, p.x);
        y0 = std::min(y0, p.y);
        y1 = std::max(y1, p.y);
    }
    const auto pixel = [s](std::int64_t v, int least, int most) {
        return static_cast<int>(std::clamp<std::int64_t>(v >> s, least, most));
    };
    const int left = pixel(x0, window.x, window.x + window.width),
              low = pixel(y0, window.y, window.y + window.height);
    return {left, low, pixel(x1 + (1 << s), window.x, window.x + window.width) - left,
            pixel(y1 + (1 << s), window.y, window.y + window.height) - low};
}

Face make_face(const Input& input, std::size_t polygon, std::vector<GridPoint> outline,
               const WindowTriangle& triangle) {
    const int s = input.subpixel_bits();
    Face face{.polygon = polygon, .corners = without_straight_corners(outline)};
    for (std::size_t i = 0; i < face.corners.size(); ++i)
        face.sides.push_back(
            side_of(face.corners[i], face.corners[(i + 1) % face.corners.size()], s));
    face.plane = exact_plane_of(counter_clockwise(triangle.corners), s);
    face.bounds = bounds_of(face.corners, s, input.window());
    face.nearest = face.farthest = face.corners[0].z;
    for (const GridPoint& p : face.corners) {
        face.nearest = std::min(face.nearest, p.z);
        face.farthest = std::max(face.farthest, p.z);
    }
    return face;
}

}  // namespace

std::vector<Face> faces_of(const Input& input) {
    std::vector<Face> faces;
    for (std::size_t p = 0; p < input.polygons.size(); ++p) {
        const Polygon& polygon = input.polygons[p];
        const std::size_t before = faces.size();
        for (const Facet& facet : polygon.facets) {
            const auto triangles = std::span(polygon.triangles).subspan(facet.first, facet.count);
            if (auto outline = convex_outline(triangles); !outline.empty()) {
                faces.push_back(make_face(input, p, std::move(outline), triangles[0]));
                continue;
            }
            for (const WindowTriangle& t : triangles) {
                const auto corners = counter_clockwise(t.corners);
                faces.push_back(make_face(input, p, {corners.begin(), corners.end()}, t));
            }
        }
        for (std::size_t i = before; i < faces.size(); ++i)
            faces[i].name = name_of(polygon, i - before, faces.size() - before);
    }
    for (std::size_t i = 0; i < faces.size(); ++i) faces[i].place = i;
    return faces;
}

bool covers(const Face& face, int x, int y) {
    return std::all_of(face.sides.begin(), face.sides.end(),
                       [&](const Side& side) { return side.at(x, y) >= 0; });
}

Cover cover_of(const Face& face, const Rect& w) {
    const Rect& b = face.bounds;
    if (b.x >= w.x + w.width || w.x >= b.x + b.width || b.y >= w.y + w.height ||
        w.y >= b.y + b.height)
        return Cover::Disjoint;
    bool surrounds = true;
    for (const Side& side : face.sides) {
        int outside = 0;
        for (const int y : {w.y, w.y + w.height - 1})
            for (const int x : {w.x, w.x + w.width - 1}) outside += side.at(x, y) < 0 ? 1 : 0;
        if (outside == 4) return Cover::Disjoint;
        surrounds = surrounds && outside == 0;
    }
    return surrounds ? Cover::Surrounds : Cover::Intersects;
}

int depth_order(const Face& a, const Face& b, int x, int y) {
    // Below 2^118 on windows of 4096 pixels with 8 sub-pixel bits and 32 of depth.
    const int128 za = a.plane.scaled(x, y) * b.plane.n, zb = b.plane.scaled(x, y) * a.plane.n;
    return za < zb ? -1 : za > zb ? 1 : 0;
}

bool is_nearer(const Face& a, const Face& b, int x, int y) {
    const int order = depth_order(a, b, x, y);
    return order < 0 || (order == 0 && a.place < b.place);
}

bool is_nearer(const Face& a, const Face& b, const Rect& w, std::uint64_t& compared) {
    for (const int y : {w.y, w.y + w.height - 1})
        for (const int x : {w.x, w.x + w.width - 1}) {
            compared += 1;
            if (!is_nearer(a, b, x, y)) return false;
        }
    return true;
}

int first_nearer(const Face& a, const Face& b, const Run& run, std::uint64_t& compared) {
    int not_yet = run.x0, nearer = run.x1 - 1;
    while (nearer - not_yet > 1) {
        const int middle = not_yet + (nearer - not_yet) / 2;
        compared += 1;
        (is_nearer(a, b, middle, run.y) ? nearer : not_yet) = middle;
    }
    return nearer;
}

Run run_of(const Face& face, int y, int x0, int x1) {
    std::int64_t left = x0, right = x1;
    for (const Side& side : face.sides) {
        const std::int64_t rest = side.b * y + side.c;  // a x + rest >= 0
        if (side.a > 0) left = std::max(left, -floor_div(rest, side.a));
        if (side.a < 0) right = std::min(right, floor_div(rest, -side.a) + 1);
        if (side.a == 0 && rest < 0) return {y, x0, x0};
    }
    return {y, static_cast<int>(std::min(left, right)), static_cast<int>(right)};
}

}  // namespace gw::hiddensurface
