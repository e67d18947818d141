#include "gw/mesh/ear_clipper.h"

#include "gw/mesh/corner_tree.h"
#include "gw/mesh/orient.h"

namespace gw {
namespace {

// The corners that may be cut off, from best to last resort. If a polygon does not cross itself,
// cuts of the first three kinds keep it so.
enum class Cut {
    Ear,          // a triangle inside the polygon, no corner on its open diagonal
    TouchingEar,  // the same, corners on the diagonal allowed
    Flat,         // no area: a straight corner, a spike, a repeated corner
    Convex,       // any corner that turns left: needed only if the polygon crosses itself
    Any,
};

// Whether c lies strictly inside the angle from `right` counter-clockwise to `left` (less than 180
// degrees) at p.
bool in_angle(vec2 right, vec2 p, vec2 left, vec2 c) {
    return orient(p, right, c) > 0 && orient(left, p, c) > 0;
}

// Whether a segment from q, a point of the closed triangle's border, to r enters the open triangle.
bool enters(const std::array<vec2, 3>& t, vec2 q, vec2 r) {
    for (unsigned k = 0; k < 3; ++k)
        if (q == t[k]) return in_angle(t[(k + 1) % 3], t[k], t[(k + 2) % 3], r);
    for (unsigned k = 0; k < 3; ++k)
        if (orient(t[k], t[(k + 1) % 3], q) == 0) return orient(t[k], t[(k + 1) % 3], r) > 0;
    return false;
}

class EarClipper {
public:
    explicit EarClipper(std::span<const vec2> points)
        : points_(points),
          next_(points.size()),
          previous_(points.size()),
          turn_(points.size()),
          ticket_(points.size(), 0),
          remaining_(static_cast<std::uint32_t>(points.size())),
          tree_(points, link()) {}

    std::vector<PolygonTriangle> run() {
        // Passes repeat while they cut, up to eight times, or more while they halve the polygon.
        // Then the next kind of cut is allowed.
        for (int cut = 0; remaining_ > 3; ++cut)
            for (int passes = 0; passes < 8; ++passes) {
                const std::uint32_t before = remaining_;
                pass(static_cast<Cut>(cut));
                if (remaining_ == before || remaining_ == 3) break;
                if (remaining_ < before / 2) passes = 0;
            }
        triangles_.push_back({{previous_[head_], head_, next_[head_]}});
        return std::move(triangles_);
    }

private:
    // Closes the ring. Returns the corners that do not turn left: only they can block an ear.
    std::vector<std::uint32_t> link() {
        std::vector<std::uint32_t> in_the_way;
        const std::uint32_t n = remaining_;
        for (std::uint32_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
            turn_[i] = orient(points_[previous_[i]], points_[i], points_[next_[i]]);
            if (turn_[i] <= 0) in_the_way.push_back(i);
        }
        return in_the_way;
    }

    // Tries every corner once, then the neighbours of each cut. Neighbours wait in the queue, so
    // ears are cut all around and not as one fan of slivers.
    void pass(Cut allowed) {
        queue_.clear();
        for (std::uint32_t i = 0, corner = head_; i < remaining_; ++i, corner = next_[corner])
            enqueue(corner);
        for (std::size_t i = 0; i < queue_.size() && remaining_ > 3; ++i) {
            const auto [corner, ticket] = queue_[i];
            if (ticket != ticket_[corner] || !may_cut(corner, allowed)) continue;
            cut_off(corner);
            enqueue(previous_[corner]);
            enqueue(next_[corner]);
        }
    }

    void enqueue(std::uint32_t corner) { queue_.push_back({corner, ++ticket_[corner]}); }

    bool may_cut(std::uint32_t corner, Cut allowed) const {
        if (allowed == Cut::Any) return true;
        if (turn_[corner] == 0) return allowed >= Cut::Flat;
        return turn_[corner] > 0 && (allowed >= Cut::Convex || is_ear(corner, allowed));
    }

    bool is_ear(std::uint32_t corner, Cut allowed) const {
        const std::uint32_t p = previous_[corner], n = next_[corner];
        const std::array<vec2, 3> t{points_[p], points_[corner], points_[n]};
        // If another corner is at this point, the triangle may lie outside the polygon.
        bool met = false;
        const bool blocked = tree_.any(t, [&](std::uint32_t q) {
            if (q == p || q == corner || q == n) return false;
            met = met || points_[q] == t[1];
            return in_the_way(t, q, allowed == Cut::Ear);
        });
        return !blocked && (!met || encloses((dvec2(t[0]) + dvec2(t[1]) + dvec2(t[2])) / 3.0));
    }

    // Whether the rest of the polygon winds round a point (not on its border) counter-clockwise.
    bool encloses(dvec2 point) const {
        int winding = 0;
        for (std::uint32_t i = 0, corner = head_; i < remaining_; ++i, corner = next_[corner]) {
            const dvec2 a = dvec2(points_[corner]) - point,
                        b = dvec2(points_[next_[corner]]) - point;
            const double side = a.x * b.y - a.y * b.x;
            if (a.y <= 0 && b.y > 0 && side > 0) ++winding;
            if (b.y <= 0 && a.y > 0 && side < 0) --winding;
        }
        return winding > 0;
    }

    // Whether corner q lies in the open triangle, or on its border with a side that leads inside.
    bool in_the_way(const std::array<vec2, 3>& t, std::uint32_t q, bool diagonal_too) const {
        const vec2 c = points_[q];
        const int side0 = orient(t[0], t[1], c), side1 = orient(t[1], t[2], c),
                  diagonal = orient(t[2], t[0], c);
        if (side0 < 0 || side1 < 0 || diagonal < 0) return false;
        if (side0 > 0 && side1 > 0 && diagonal > 0) return true;
        if (diagonal_too && diagonal == 0 && side0 > 0 && side1 > 0) return true;
        return enters(t, c, points_[previous_[q]]) || enters(t, c, points_[next_[q]]);
    }

    void cut_off(std::uint32_t corner) {
        const std::uint32_t p = previous_[corner], n = next_[corner];
        triangles_.push_back({{p, corner, n}});
        next_[p] = n;
        previous_[n] = p;
        ++ticket_[corner];
        tree_.remove(corner);
        turn_again(p);
        turn_again(n);
        head_ = n;
        --remaining_;
    }

    void turn_again(std::uint32_t corner) {
        turn_[corner] = orient(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
        if (turn_[corner] > 0) tree_.remove(corner);
    }

    struct Waiting {
        std::uint32_t corner, ticket;  // stale if the ticket is not the corner's latest
    };

    std::span<const vec2> points_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<int> turn_;
    std::vector<std::uint32_t> ticket_;
    std::uint32_t remaining_;
    std::uint32_t head_ = 0;
    std::vector<Waiting> queue_;
    std::vector<PolygonTriangle> triangles_;
    CornerTree tree_;
};

}  // namespace

std::vector<PolygonTriangle> clip_ears(std::span<const vec2> corners) {
    return EarClipper(corners).run();
}

}  // namespace gw
