#include "scene/maps/cut_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace gw::scene {
namespace {

/// Weights of a triangle's corners in units of 1 / whole, so that sides and areas are exact.
using Weights = std::array<std::int64_t, 3>;
constexpr std::int64_t whole = std::int64_t{1} << 26;

struct Point {
    Weights w{};
    dvec2 p{0};  ///< in the plane of the map
};

struct Face {
    std::vector<Point> corners;
    std::size_t level = 0;
};

/// Twice the area, in the triangle's orientation.
std::int64_t area(const Weights& a, const Weights& b, const Weights& c) {
    return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

/// A corner of the mesh's triangle.
Weights corner_weights(std::size_t k) {
    Weights w{};
    w[k] = whole;
    return w;
}

/// A point within half a unit of a side is on it.
Weights rounded(const std::array<double, 3>& exact) {
    Weights w{};
    for (std::size_t k = 0; k < 3; ++k)
        w[k] = std::clamp<std::int64_t>(std::llround(exact[k] * double(whole)), 0, whole);
    const std::size_t most = std::size_t(std::ranges::max_element(w) - w.begin());
    w[most] = whole - w[(most + 1) % 3] - w[(most + 2) % 3];
    return w;
}

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

/// A triangle in the plane of the map.
class PlaneTriangle {
public:
    explicit PlaneTriangle(const std::array<dvec2, 3>& corners)
        : corners_(corners), area_(cross(corners[1] - corners[0], corners[2] - corners[0])) {}

    const std::array<dvec2, 3>& corners() const { return corners_; }
    bool has_area() const { return std::isfinite(1 / area_); }
    double weight(std::size_t k, const dvec2& p) const {
        const dvec2 &a = corners_[(k + 1) % 3], &b = corners_[(k + 2) % 3];
        return cross(a - p, b - p) / area_;
    }
    /// The linear function that has these values at its corners.
    Slope slope(const std::array<double, 3>& values) const {
        Slope slope{0, 0, 0};
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec2 &a = corners_[(k + 1) % 3], &b = corners_[(k + 2) % 3];
            slope.at_0 += values[k] * cross(a, b) / area_;
            slope.u += values[k] * (a.y - b.y) / area_;
            slope.v += values[k] * (b.x - a.x) / area_;
        }
        return slope;
    }
    std::vector<Point> clip(std::vector<dvec2> corners) const {
        for (std::size_t k = 0; k < 3; ++k)
            corners = clipped(
                corners, [&](const dvec2& p) { return weight(k, p); }, between);
        std::vector<Point> points;
        for (const dvec2& p : corners) {
            const Point point{rounded({weight(0, p), weight(1, p), weight(2, p)}), p};
            if (points.empty() || points.back().w != point.w) points.push_back(point);
        }
        while (points.size() > 1 && points.back().w == points.front().w) points.pop_back();
        return points;
    }

private:
    std::array<dvec2, 3> corners_;
    double area_;
};

/// Turned as the triangle is; without area it is empty.
void orient(Face& face) {
    std::int64_t sum = 0;
    for (std::size_t i = 2; i < face.corners.size(); ++i)
        sum += area(face.corners[0].w, face.corners[i - 1].w, face.corners[i].w);
    if (sum < 0) std::ranges::reverse(face.corners);
    if (sum == 0) face.corners.clear();
}

/// Points on the lines along one axis through the middles of texels, where sides of faces meet others'.
void insert_line_points(std::vector<Face>& faces, int axis) {
    const int across = 1 - axis;
    const auto along = [&](const Point& p) { return p.p[axis]; };
    const auto is_on_line = [&](const Point& p) { return p.p[across] == std::floor(p.p[across]); };
    std::map<double, std::vector<Point>> lines;
    for (const Face& face : faces)
        for (const Point& point : face.corners)
            if (is_on_line(point)) lines[point.p[across]].push_back(point);
    for (auto& [at, points] : lines) std::ranges::sort(points, {}, along);
    for (Face& face : faces) {
        std::vector<Point> corners;
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const Point &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
            corners.push_back(a);
            if (!is_on_line(a) || a.p[across] != b.p[across]) continue;
            const auto& points = lines.at(a.p[across]);
            const auto add = [&](const Point& point) {
                if (point.w != corners.back().w && point.w != a.w && point.w != b.w)
                    corners.push_back(point);
            };
            const double low = std::min(along(a), along(b)), high = std::max(along(a), along(b));
            const auto begin = std::ranges::upper_bound(points, low, {}, along),
                       end = std::ranges::lower_bound(points, high, {}, along);
            if (begin >= end) continue;
            if (along(a) < along(b))
                std::for_each(begin, end, add);
            else
                std::for_each(std::reverse_iterator(end), std::reverse_iterator(begin), add);
        }
        face.corners = std::move(corners);
    }
}

using Side = std::array<float, 6>;

/// The points that cuts put on the sides of triangles, for all triangles of a side.
class SidePoints {
public:
    /// Adds the point at t / whole of the side from a to b.
    void add(const vec3& a, const vec3& b, std::int64_t t) {
        const bool forward = is_before(a, b);
        points_[forward ? key(a, b) : key(b, a)].insert(forward ? t : whole - t);
    }
    /// The points strictly between from and to, in this order.
    std::vector<std::int64_t> between(const vec3& a, const vec3& b, std::int64_t from,
                                      std::int64_t to) const {
        const bool forward = is_before(a, b);
        std::vector<std::int64_t> list;
        const auto found = points_.find(forward ? key(a, b) : key(b, a));
        if (found == points_.end()) return list;
        for (std::int64_t t : found->second) {
            if (!forward) t = whole - t;
            if (t > std::min(from, to) && t < std::max(from, to)) list.push_back(t);
        }
        std::ranges::sort(list);
        if (from > to) std::ranges::reverse(list);
        return list;
    }

private:
    static bool is_before(const vec3& a, const vec3& b) {
        return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
    }
    static Side key(const vec3& a, const vec3& b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }

    std::map<Side, std::set<std::int64_t>> points_;
};

/// A side of the triangle that has both points: it leads from corner k + 1 to corner k + 2.
std::optional<std::size_t> common_side(const Weights& a, const Weights& b) {
    for (std::size_t k = 0; k < 3; ++k)
        if (a[k] == 0 && b[k] == 0) return k;
    return std::nullopt;
}

class Cutter {
public:
    Cutter(const Mesh& mesh, const Map* map, ColorUse use, const OpacityLevels& levels,
           CutBudget& budget)
        : mesh_(mesh), use_(use), levels_(levels), budget_(budget), out_(levels.values.size()) {
        if (map) plane_.emplace(*map);
    }

    bool cut() {
        for (const Triangle& triangle : mesh_.triangles()) {
            std::vector<Face>& faces = faces_.emplace_back();
            if (!add_faces(triangle, faces)) return false;
            for (const Face& face : faces) count_ += face.corners.size() - 2;
            if (count_ > budget_.triangles) return false;
            if (faces.size() > 1) note_sides(triangle, faces);
        }
        for (std::size_t i = 0; i < faces_.size(); ++i)
            for (Face& face : faces_[i])
                if (levels_.values[face.level] > 0) emit(mesh_.triangles()[i], face);
        budget_.triangles -= std::min(budget_.triangles, count_);
        return true;
    }
    std::vector<MeshData> take() { return std::move(out_); }

private:
    const MeshData& data() const { return mesh_.data(); }
    const vec3& position(const Triangle& t, std::size_t k) const {
        return data().positions[t.vertex[k % 3]];
    }

    /// The corners in the plane of the map; without one, any.
    std::array<dvec2, 3> in_plane(const Triangle& triangle) const {
        std::array<dvec2, 3> corners{dvec2(0.25, 0.25), dvec2(0.75, 0.25), dvec2(0.25, 0.75)};
        for (std::size_t k = 0; plane_ && k < 3; ++k)
            corners[k] = plane_->at_texcoord(
                data().texcoords.empty() ? vec2(0) : data().texcoords[triangle.vertex[k]]);
        return corners;
    }

    bool add_faces(const Triangle& triangle, std::vector<Face>& faces) {
        std::array<double, 3> alpha{1, 1, 1};
        const bool by_colors = use_ == ColorUse::Opacity && !data().colors.empty();
        for (std::size_t k = 0; by_colors && k < 3; ++k)
            alpha[k] = std::clamp(double(data().colors[triangle.vertex[k]].w), 0.0, 1.0);
        const PlaneTriangle in_map(in_plane(triangle));
        std::vector<OpacityPiece> pieces;
        if (plane_ && !in_map.has_area()) {
            const dvec2 middle =
                (in_map.corners()[0] + in_map.corners()[1] + in_map.corners()[2]) / 3.0;
            const double mean = (alpha[0] + alpha[1] + alpha[2]) / 3;
            add_whole(levels_.of(mean * nearest_texel(middle)), faces);
            return true;
        }
        if (plane_) {
            if (!take_cells(in_map.corners()) ||
                !plane_->add_pieces(in_map.corners(), in_map.slope(alpha), levels_,
                                    budget_.triangles, pieces))
                return false;
        } else {
            const auto& c = in_map.corners();
            add_pieces({OpacityCorner{c[0], alpha[0]}, {c[1], alpha[1]}, {c[2], alpha[2]}}, levels_,
                       pieces);
        }
        for (const OpacityPiece& piece : pieces) {
            Face face{in_map.clip(piece.corners), piece.level};
            orient(face);
            if (!face.corners.empty()) faces.push_back(std::move(face));
        }
        const auto is_other = [&](const Face& face) { return face.level != faces[0].level; };
        if (faces.empty()) return true;  // less than a unit wide
        if (std::ranges::none_of(faces, is_other)) {
            const std::size_t level = faces[0].level;
            faces.clear();
            add_whole(level, faces);
        } else if (plane_) {
            insert_line_points(faces, 0);
            insert_line_points(faces, 1);
        }
        return true;
    }

    static void add_whole(std::size_t level, std::vector<Face>& faces) {
        Face face{{}, level};
        for (std::size_t k = 0; k < 3; ++k) face.corners.push_back({corner_weights(k), {}});
        faces.push_back(std::move(face));
    }

    double nearest_texel(const dvec2& p) const {
        constexpr double far = 1e15;
        return plane_->texel(std::llround(std::clamp(p.x, -far, far)),
                             std::llround(std::clamp(p.y, -far, far)));
    }

    /// No more than the cells of the rectangle around it.
    bool take_cells(const std::array<dvec2, 3>& corners) {
        const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const double cells = (right - left + 2) * (high - low + 2);
        constexpr double far = 1e12;  // within it texels are whole numbers
        if (!(cells <= double(budget_.cells)) || std::max({-left, right, -low, high}) > far)
            return false;
        budget_.cells -= std::size_t(cells);
        return true;
    }

    void note_sides(const Triangle& triangle, const std::vector<Face>& faces) {
        for (const Face& face : faces)
            for (const Point& point : face.corners)
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::int64_t t = point.w[(k + 2) % 3];
                    if (point.w[k] == 0 && t > 0 && t < whole)
                        sides_.add(position(triangle, k + 1), position(triangle, k + 2), t);
                }
    }

    /// The face with the points that others put on its sides.
    std::vector<Weights> outline(const Triangle& triangle, const Face& face) const {
        std::vector<Weights> corners;
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const Weights &a = face.corners[i].w,
                          &b = face.corners[(i + 1) % face.corners.size()].w;
            corners.push_back(a);
            const auto side = common_side(a, b);
            if (!side) continue;
            const std::size_t from = (*side + 1) % 3, to = (*side + 2) % 3;
            for (const std::int64_t t :
                 sides_.between(position(triangle, from), position(triangle, to), a[to], b[to])) {
                Weights w{};
                w[from] = whole - t;
                w[to] = t;
                corners.push_back(w);
            }
        }
        return corners;
    }

    void emit(const Triangle& triangle, const Face& face) {
        const std::vector<Weights> corners = outline(triangle, face);
        const std::size_t n = corners.size();
        const auto fan_has_area = [&](std::size_t apex) {
            for (std::size_t i = 1; i + 1 < n; ++i)
                if (area(corners[apex], corners[(apex + i) % n], corners[(apex + i + 1) % n]) <= 0)
                    return false;
            return true;
        };
        MeshData& out = out_[face.level];
        for (std::size_t apex = 0; apex < n; ++apex)
            if (fan_has_area(apex)) {
                for (std::size_t i = 1; i + 1 < n; ++i)
                    for (const std::size_t k : {apex, (apex + i) % n, (apex + i + 1) % n})
                        add_vertex(triangle, corners[k], out);
                return;
            }
        Weights middle{};
        for (const Weights& w : corners)
            for (std::size_t k = 1; k < 3; ++k) middle[k] += w[k];
        middle[1] /= std::int64_t(n);
        middle[2] /= std::int64_t(n);
        middle[0] = whole - middle[1] - middle[2];
        for (std::size_t i = 0; i < n; ++i)
            for (const Weights& w : {middle, corners[i], corners[(i + 1) % n]})
                add_vertex(triangle, w, out);
    }

    // On a side one term is 0, so its other triangle, which has the corners in another order, adds the same.
    template <class Vector>
    static void add_mean(const std::vector<Vector>& values, const Triangle& triangle,
                         const Weights& w, std::vector<Vector>& out) {
        if (values.empty()) return;
        glm::vec<Vector::length(), double> v[3];
        for (std::size_t k = 0; k < 3; ++k)
            v[k] = glm::vec<Vector::length(), double>(values[triangle.vertex[k]]) * double(w[k]);
        out.push_back(Vector(((v[0] + v[1]) + v[2]) / double(whole)));
    }

    void add_vertex(const Triangle& triangle, const Weights& w, MeshData& out) const {
        add_mean(data().positions, triangle, w, out.positions);
        add_mean(data().normals, triangle, w, out.normals);
        add_mean(data().texcoords, triangle, w, out.texcoords);
        if (use_ == ColorUse::Color) add_mean(data().colors, triangle, w, out.colors);
    }

    const Mesh& mesh_;
    ColorUse use_;
    std::optional<OpacityPlane> plane_;
    const OpacityLevels& levels_;
    CutBudget& budget_;
    std::vector<std::vector<Face>> faces_;  ///< by triangle
    SidePoints sides_;
    std::vector<MeshData> out_;
    std::size_t count_ = 0;  ///< of triangles
};

}  // namespace

std::optional<std::vector<MeshData>> cut_by_opacity(const Mesh& mesh, const Map* map, ColorUse use,
                                                    const OpacityLevels& levels,
                                                    CutBudget& budget) {
    Cutter cutter(mesh, map, use, levels, budget);
    if (!cutter.cut()) return std::nullopt;
    return cutter.take();
}

}  // namespace gw::scene
