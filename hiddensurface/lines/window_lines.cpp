#include "hiddensurface/lines/window_lines.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace gw::hiddensurface {
namespace {

class WindowLinesBuilder {
public:
    explicit WindowLinesBuilder(const Input& input)
        : largest_((std::int64_t{1} << input.profile.depth_bits) - 1) {
        for (std::size_t p = 0; p < input.polygons.size(); ++p)
            for (const WindowTriangle& t : input.polygons[p].triangles)
                add(t, p, input.polygons[p].id);
        // A side of two triangles of one polygon lies inside the polygon. A side in the near or far
        // plane was made by clipping.
        for (const auto& [of, times] : inside_) {
            WindowSide& s = scene_.sides[of.first];
            s.drawn = s.drawn || (times == 1 && !is_clipped(s));
        }
        scene_.faces_at.resize(scene_.corners.size());
        scene_.sides_at.resize(scene_.corners.size());
        for (std::size_t f = 0; f < scene_.faces.size(); ++f)
            for (const std::size_t c : scene_.faces[f].corner) scene_.faces_at[c].push_back(f);
        for (std::size_t s = 0; s < scene_.sides.size(); ++s)
            for (const std::size_t c : {scene_.sides[s].a, scene_.sides[s].b})
                scene_.sides_at[c].push_back(s);
    }
    WindowLines take() { return std::move(scene_); }

private:
    void add(const WindowTriangle& t, std::size_t polygon, std::uint32_t id) {
        WindowFace face{
            .corner = {corner(t.corners[0]), corner(t.corners[1]), corner(t.corners[2])}, .id = id};
        if (turn(t.corners[0], t.corners[1], t.corners[2]) < 0)
            std::swap(face.corner[1], face.corner[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t from = face.corner[k], to = face.corner[(k + 1) % 3];
            const std::size_t s = side(std::min(from, to), std::max(from, to), id);
            (from < to ? scene_.sides[s].left : scene_.sides[s].right) += 1;
            scene_.sides[s].faces.push_back(scene_.faces.size());
            inside_[{s, polygon}] += 1;
        }
        scene_.faces.push_back(face);
    }
    std::size_t corner(const GridPoint& p) {
        const auto [found, is_new] = corner_of_.try_emplace({p.x, p.y, p.z}, scene_.corners.size());
        if (is_new) scene_.corners.push_back(p);
        return found->second;
    }
    std::size_t side(std::size_t a, std::size_t b, std::uint32_t id) {
        const auto [found, is_new] = side_of_.try_emplace({a, b}, scene_.sides.size());
        if (is_new) scene_.sides.push_back({.a = a, .b = b, .faces = {}, .id = id});
        return found->second;
    }
    bool is_clipped(const WindowSide& s) const {
        const std::int64_t za = scene_.corners[s.a].z, zb = scene_.corners[s.b].z;
        return za == zb && (za == 0 || za == largest_);
    }

    std::int64_t largest_;
    WindowLines scene_;
    std::map<std::tuple<std::int64_t, std::int64_t, std::int64_t>, std::size_t> corner_of_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> side_of_;
    std::map<std::pair<std::size_t, std::size_t>, int> inside_;  ///< (side, polygon): triangles
};

/// Shortens a part to the points at which a linear value is above 0. It is `at_a` at 0 and `at_b` at
/// 1. False: nothing is left.
bool keep_positive(int128 at_a, int128 at_b, Part& part) {
    if (at_a <= 0 && at_b <= 0) return false;
    if (at_a >= 0 && at_b >= 0) return true;
    const double t = double(at_a) / double(at_a - at_b);
    (at_a < 0 ? part.first : part.second) =
        at_a < 0 ? std::max(part.first, t) : std::min(part.second, t);
    return part.first < part.second;
}

}  // namespace

WindowLines window_lines(const Input& input) { return WindowLinesBuilder(input).take(); }

int128 behind(const WindowLines& scene, const WindowFace& face, const GridPoint& p) {
    const GridPoint &p0 = scene.corners[face.corner[0]], &p1 = scene.corners[face.corner[1]],
                    &p2 = scene.corners[face.corner[2]];
    const int128 ux = p1.x - p0.x, uy = p1.y - p0.y, uz = p1.z - p0.z;
    const int128 vx = p2.x - p0.x, vy = p2.y - p0.y, vz = p2.z - p0.z;
    return (uy * vz - uz * vy) * (p.x - p0.x) + (uz * vx - ux * vz) * (p.y - p0.y) +
           (ux * vy - uy * vx) * (p.z - p0.z);
}

std::optional<Part> hidden_part(const WindowLines& scene, const WindowFace& face,
                                const GridPoint& a, const GridPoint& b) {
    Part part{0, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        const GridPoint &p = scene.corners[face.corner[k]],
                        &q = scene.corners[face.corner[(k + 1) % 3]];
        std::int64_t at_a = turn(p, q, a), at_b = turn(p, q, b);
        if (at_a == 0 && at_b == 0)  // along the outline
            at_a = at_b = (q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y);
        if (!keep_positive(at_a, at_b, part)) return std::nullopt;
    }
    if (!keep_positive(behind(scene, face, a), behind(scene, face, b), part)) return std::nullopt;
    return part;
}

Box box_of(std::initializer_list<GridPoint> points) {
    Box box{*points.begin(), *points.begin()};
    for (const GridPoint& p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y),
                    std::max(box.high.z, p.z)};
    }
    return box;
}

bool may_hide(const Box& front, const Box& line) {
    return front.low.x <= line.high.x && line.low.x <= front.high.x && front.low.y <= line.high.y &&
           line.low.y <= front.high.y && front.low.z <= line.high.z;
}

}  // namespace gw::hiddensurface
