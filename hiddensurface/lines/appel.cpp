// Appel's quantitative invisibility: A. Appel, "The notion of quantitative invisibility and the
// machine rendering of solids", Proc. ACM National Conference 1967, pp. 387-393.
//
// The quantitative invisibility of a point is the number of faces that hide it; the visible parts
// of a line have the number 0. Along a line it changes only where the line passes behind a contour:
// a side with more or fewer faces beyond it than before it. At a common corner the number is carried
// from one line of a connected figure to the next, and only the faces at that corner are tested. So
// all faces are counted for one line of a figure; for the others only contours are crossed.
//
// Claims: right for any faces, open or closed, convex or not. Appel has no faces that pierce each
// other. Here a line is also compared with every face whose box meets its own, and the number
// changes where the line goes through a face. If a contour runs exactly through a corner or along a
// line in the window, the number cannot be carried. Then the line is compared with every face
// (`starts`).
//
// Does not draw the lines in which faces pierce each other: no polygon has them as a side.
#include "hiddensurface/lines/window_lines.h"

#include <algorithm>
#include <deque>

namespace gw::hiddensurface {
namespace {

/// The number changes by `delta` at t of the line.
struct Change {
    double t;
    int delta;
};

/// Places nearer than this are one that was computed from different sides.
constexpr double same_place = 1e-12;

class Appel {
public:
    Appel(const Input& input, StepLog& log)
        : scene_(window_lines(input)),
          log_(log),
          known_(scene_.corners.size()),
          seen_(scene_.sides.size()) {
        for (const WindowFace& f : scene_.faces)
            face_boxes_.push_back(box_of({at(f.corner[0]), at(f.corner[1]), at(f.corner[2])}));
        for (std::size_t s = 0; s < scene_.sides.size(); ++s) {
            side_boxes_.push_back(box_of({at(scene_.sides[s].a), at(scene_.sides[s].b)}));
            if (scene_.sides[s].is_contour()) contours_.push_back(s);
        }
        output_.counts.faces = scene_.faces.size();
        output_.counts.peak_bytes = scene_.corners.size() * sizeof(GridPoint) +
                                    scene_.faces.size() * (sizeof(WindowFace) + sizeof(Box)) +
                                    scene_.sides.size() * (sizeof(WindowSide) + sizeof(Box));
        log.watch(watched(output_.counts));
    }

    /// Draws every connected figure, beginning with its first side.
    LineOutput run() {
        for (std::size_t s = 0; s < scene_.sides.size(); ++s) {
            queue_.push_back(s);
            while (!queue_.empty()) {
                const std::size_t next = queue_.front();
                queue_.pop_front();
                if (!seen_[next] && scene_.sides[next].drawn) draw(next);
            }
        }
        return std::move(output_);
    }

private:
    const GridPoint& at(std::size_t corner) const { return scene_.corners[corner]; }

    void draw(std::size_t s) {
        seen_[s] = true;
        const WindowSide& side = scene_.sides[s];
        const GridPoint &a = at(side.a), &b = at(side.b);
        if (a.x == b.x && a.y == b.y) return;  // seen end on
        Line line{side.id, to_dvec3(a), to_dvec3(b), {}};
        Values values;
        const bool is_carried = carried(s, line, values);
        if (!is_carried) compared(s, line, values);
        output_.counts.lines += 1;
        output_.counts.parts += line.visible.size();
        log_line(line, is_carried ? "carried" : "compared", std::move(values), log_);
        output_.lines.push_back(std::move(line));
        for (const std::size_t corner : {side.a, side.b})
            for (const std::size_t next : scene_.sides_at[corner])
                if (!seen_[next]) queue_.push_back(next);
    }

    /// Finds the visible parts from the number at one of the line's corners. False: no such number.
    bool carried(std::size_t s, Line& line, Values& values) {
        const WindowSide& side = scene_.sides[s];
        const bool forward = known_[side.a].has_value();
        if (!forward && !known_[side.b]) return false;
        const std::size_t from = forward ? side.a : side.b, to = forward ? side.b : side.a;
        const auto begins = hiding_at(from, to), ends = hiding_at(to, from);
        std::vector<Change> changes;
        if (!begins || !ends || !contours_crossed(s, from, to, changes) ||
            !faces_pierced(s, from, to, changes))
            return false;
        std::stable_sort(changes.begin(), changes.end(),
                         [](const Change& x, const Change& y) { return x.t < y.t; });
        int number = *known_[from] + *begins;
        if (log_.on()) values = values_of(number, changes, !forward);
        std::vector<Part> hidden;
        double since = 0;
        const auto until = [&](double t) {
            if (number > 0) hidden.emplace_back(since, t);
            since = t;
        };
        for (const Change& change : changes) {
            until(change.t);
            number += change.delta;
        }
        until(1);
        if (!known_[to]) known_[to] = number - *ends;
        line.visible = rest_of(std::move(hidden));
        if (!forward) turn_round(line);
        return true;
    }

    /// The invisibility from the line's beginning to its end, and the places at which it changes:
    /// not those at which the line passes from behind one face to behind its neighbour. `backward`:
    /// both were found from the end.
    static Values values_of(int number, const std::vector<Change>& changes, bool backward = false) {
        std::vector<std::int64_t> numbers{number};
        std::vector<double> at;
        for (std::size_t i = 0; i < changes.size();) {
            const double t = changes[i].t;
            for (; i < changes.size() && changes[i].t - t <= same_place; ++i)
                number += changes[i].delta;
            if (number == numbers.back()) continue;
            numbers.push_back(number);
            at.push_back(backward ? 1 - t : t);
        }
        if (backward) {
            std::reverse(numbers.begin(), numbers.end());
            std::reverse(at.begin(), at.end());
        }
        return {{"invisibility", numbers}, {"changes", at}};
    }

    /// The ends of hidden parts, ascending.
    static std::vector<Change> changes_at(const std::vector<Part>& hidden) {
        std::vector<Change> changes;
        for (const Part& part : hidden) {
            if (part.first > 0) changes.push_back({part.first, 1});
            if (part.second < 1) changes.push_back({part.second, -1});
        }
        std::stable_sort(changes.begin(), changes.end(),
                         [](const Change& x, const Change& y) { return x.t < y.t; });
        return changes;
    }

    static void turn_round(Line& line) {
        std::reverse(line.visible.begin(), line.visible.end());
        for (Part& part : line.visible) part = {1 - part.second, 1 - part.first};
    }

    /// Finds the visible parts by comparing the line with every face.
    void compared(std::size_t s, Line& line, Values& values) {
        const WindowSide& side = scene_.sides[s];
        output_.counts.starts += 1;
        output_.counts.planes += scene_.faces.size();
        std::vector<Part> hidden;
        int begins = 0, ends = 0;
        bool carries_a = true, carries_b = true;
        for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
            carries_a = carries_a && !touches(f, side.a);
            carries_b = carries_b && !touches(f, side.b);
            const auto part = hidden_part(scene_, scene_.faces[f], at(side.a), at(side.b));
            if (!part) continue;
            begins += part->first == 0 ? 1 : 0;
            ends += part->second == 1 ? 1 : 0;
            hidden.push_back(*part);
        }
        if (log_.on()) values = values_of(begins, changes_at(hidden));
        line.visible = rest_of(std::move(hidden));
        const auto at_a = hiding_at(side.a, side.b), at_b = hiding_at(side.b, side.a);
        if (carries_a && at_a) known_[side.a] = begins - *at_a;
        if (carries_b && at_b) known_[side.b] = ends - *at_b;
    }

    /// True if the corner, not the face's own, lies on the face, or in the window on its border and
    /// not before it.
    bool touches(std::size_t f, std::size_t corner) {
        const WindowFace& face = scene_.faces[f];
        if (has_corner(face, corner)) return false;
        bool border = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t t =
                turn(at(face.corner[k]), at(face.corner[(k + 1) % 3]), at(corner));
            if (t < 0) return false;
            border = border || t == 0;
        }
        const int depth = sign(behind(scene_, face, at(corner)));
        return depth == 0 || (border && depth > 0);
    }
    static bool has_corner(const WindowFace& face, std::size_t corner) {
        return std::find(face.corner.begin(), face.corner.end(), corner) != face.corner.end();
    }

    /// The number of faces at a corner that hide the beginning of the side from there to `to`. None:
    /// the side runs along one of them in the window, behind it.
    std::optional<int> hiding_at(std::size_t corner, std::size_t to) {
        int count = 0;
        for (const std::size_t f : scene_.faces_at[corner]) {
            const WindowFace& face = scene_.faces[f];
            if (has_corner(face, to)) continue;
            output_.counts.planes += 1;
            if (behind(scene_, face, at(to)) <= 0) continue;
            const auto k = std::size_t(std::find(face.corner.begin(), face.corner.end(), corner) -
                                       face.corner.begin());
            const std::int64_t right = turn(at(corner), at(face.corner[(k + 1) % 3]), at(to)),
                               left = turn(at(face.corner[(k + 2) % 3]), at(corner), at(to));
            if (right < 0 || left < 0) continue;
            if (right == 0 || left == 0) return std::nullopt;
            count += 1;
        }
        return count;
    }

    /// False: they touch in the window, and the number cannot be told from the crossings alone.
    bool contours_crossed(std::size_t s, std::size_t from, std::size_t to,
                          std::vector<Change>& changes) {
        const GridPoint &a = at(from), &b = at(to);
        for (const std::size_t c : contours_) {
            if (c == s) continue;
            output_.counts.extents += 1;
            if (!may_hide(side_boxes_[c], side_boxes_[s])) continue;
            const WindowSide& contour = scene_.sides[c];
            const bool at_a = contour.a == from || contour.a == to,
                       at_b = contour.b == from || contour.b == to;
            output_.counts.crossings += 1;
            const std::size_t before = changes.size();
            if (at_a || at_b) {
                const GridPoint &common = at(at_a ? contour.a : contour.b),
                                &end = at(at_a ? contour.b : contour.a);
                const GridPoint& other = (at_a ? contour.a : contour.b) == from ? b : a;
                if (runs_along(common, end, other)) return false;
            } else if (!cross(contour, a, b, changes)) {
                return false;
            }
            if (changes.size() > before) log_change(s, from, contour.id, "contour", changes.back());
        }
        return true;
    }

    /// The step tells it from the line's beginning, wherever the number was carried from.
    void log_change(std::size_t s, std::size_t from, std::uint32_t by, const char* test,
                    Change change) {
        if (!log_.wants(Level::Span)) return;
        if (from != scene_.sides[s].a) change = {1 - change.t, -change.delta};
        log_.add({.level = Level::Span,
                  .test = test,
                  .result = change.delta > 0 ? "more" : "fewer",
                  .pieces = {std::to_string(scene_.sides[s].id), std::to_string(by)},
                  .values = {{"change", std::int64_t(change.delta)}, {"at", change.t}},
                  .decisive = true});
    }

    /// True if both leave one corner in the same direction in the window.
    static bool runs_along(const GridPoint& common, const GridPoint& p, const GridPoint& q) {
        return turn(common, p, q) == 0 &&
               (p.x - common.x) * (q.x - common.x) + (p.y - common.y) * (q.y - common.y) > 0;
    }

    /// A contour without a common corner.
    bool cross(const WindowSide& contour, const GridPoint& a, const GridPoint& b,
               std::vector<Change>& changes) {
        const GridPoint &c = at(contour.a), &d = at(contour.b);
        const int128 oa = turn(c, d, a), ob = turn(c, d, b), oc = turn(a, b, c), od = turn(a, b, d);
        if (sign(oa) * sign(ob) > 0 || sign(oc) * sign(od) > 0) return true;
        if (oa == 0 || ob == 0 || oc == 0 || od == 0) return false;
        // z of both at the crossing, times positive (oa - ob) (oc - od).
        const int128 of_line = a.z * (oa - ob) + (b.z - a.z) * oa,
                     of_contour = c.z * (oc - od) + (d.z - c.z) * oc;
        const int order =
            sign(of_contour * (oa - ob) - of_line * (oc - od)) * sign(oa - ob) * sign(oc - od);
        if (order == 0) return false;
        const int delta = oa > 0 ? contour.right - contour.left : contour.left - contour.right;
        if (order < 0) changes.push_back({double(oa) / double(oa - ob), delta});
        return true;
    }

    /// False: the line touches a face's border, or the face with its end.
    bool faces_pierced(std::size_t s, std::size_t from, std::size_t to,
                       std::vector<Change>& changes) {
        const GridPoint &a = at(from), &b = at(to);
        for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
            output_.counts.extents += 1;
            if (!may_hide(face_boxes_[f], side_boxes_[s]) ||
                face_boxes_[f].high.z < side_boxes_[s].low.z)
                continue;
            const WindowFace& face = scene_.faces[f];
            // meets the plane at that corner
            if (has_corner(face, from) || has_corner(face, to)) continue;
            output_.counts.planes += 1;
            const int128 ga = behind(scene_, face, a), gb = behind(scene_, face, b);
            if (sign(ga) * sign(gb) > 0 || (ga == 0 && gb == 0)) continue;
            const int inside = place(face, a, b, ga, gb);
            if (inside == 0 || (inside > 0 && (ga == 0 || gb == 0))) return false;
            if (inside < 0) continue;
            changes.push_back({double(ga) / double(ga - gb), gb > 0 ? 1 : -1});
            log_change(s, from, face.id, "pierced", changes.back());
        }
        return true;
    }

    /// The point in which the line goes through the plane: 1 inside the face, 0 on its border, -1
    /// outside.
    int place(const WindowFace& face, const GridPoint& a, const GridPoint& b, int128 ga,
              int128 gb) const {
        int least = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const GridPoint &p = at(face.corner[k]), &q = at(face.corner[(k + 1) % 3]);
            const int128 fa = turn(p, q, a), fb = turn(p, q, b);
            least = std::min(least, sign(fa * (ga - gb) + ga * (fb - fa)) * sign(ga - gb));
        }
        return least;
    }

    WindowLines scene_;
    StepLog& log_;
    LineOutput output_;
    std::vector<Box> face_boxes_, side_boxes_;
    std::vector<std::size_t> contours_;
    /// By corner: the number of faces that hide it and are not at it.
    std::vector<std::optional<int>> known_;
    std::vector<bool> seen_;
    std::deque<std::size_t> queue_;
};

}  // namespace

LineAlgorithm appel() {
    return {
        .name = "appel",
        .title = "Appel 1967: quantitative invisibility",
        .claim =
            "right for any faces, also if they go through each other; does not draw the lines in which they do",
        .growth = {GrowthLaw::Superlinear, 4, Sampling::Joined},
        .run = [](const Input& input, StepLog& log) { return Appel(input, log).run(); }};
}

}  // namespace gw::hiddensurface
