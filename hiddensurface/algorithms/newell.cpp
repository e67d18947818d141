// Newell, Newell and Sancha's algorithm [L5]. Polygons are sorted by their farthest corners. Five
// tests ask whether the farthest may be drawn before those it overlaps in depth. If not, the two are
// exchanged; if neither may come first, one is split by the other's plane. Sorts whole plane
// polygons: a polygon whose corners are not in one plane counts as the triangles that the machine
// draws. Extents and projections are compared in the window, after perspective; the sides of planes,
// and cuts, in the world. All of it is decided before the snap, which bends polygons.
#include "hiddensurface/faces/world_piece.h"
#include "hiddensurface/lines/world_lines.h"
#include "hiddensurface/structures/merge_sort.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

struct Item {
    TreePiece world;
    Piece piece;                                       ///< as drawn
    Piece outline;                                     ///< in the window, without the snap
    std::array<std::pair<double, double>, 3> extents;  ///< x, y, z
    bool moved = false;
};

bool nearer(const Item& a, const Item& b) { return a.extents[2].second < b.extents[2].second; }

class Newell {
public:
    Newell(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Newell, Newell, Sancha")},
          window_(input),
          tolerance_(world_tolerance(input.polygons)) {
        log.watch(watched(output_.counts));
        for (std::size_t i = 0; i < input.polygons.size(); ++i)
            for (TreePiece& piece : pieces_of(input.polygons, {i})) add(std::move(piece));
        sort();
    }

    Output run() {
        while (!list_.empty()) {
            output_.counts.peak_bytes =
                std::max<std::uint64_t>(output_.counts.peak_bytes, list_.size() * sizeof(Item));
            if (!farthest_may_be_drawn()) continue;
            draw_piece(input_, list_.back().piece, output_, log_);
            list_.pop_back();
            if (std::any_of(list_.begin(), list_.end(),
                            [](const Item& item) { return item.moved; }))
                restore_order();
        }
        return std::move(output_);
    }

private:
    /// Unless it is outside the window.
    void add(TreePiece world) {
        Item item{std::move(world), {}, {}, {}, false};
        item.piece = window_piece(input_, item.world);
        item.outline.parts = outline_of(item.world);
        if (item.piece.parts.empty() || item.outline.parts.empty()) return;
        for (int axis = 0; axis < 3; ++axis)
            item.extents[std::size_t(axis)] = extent(item.outline, axis);
        list_.push_back(std::move(item));
    }

    /// The parts beyond the near plane.
    std::vector<Loop> outline_of(const TreePiece& piece) const {
        std::vector<Loop> parts = divide(piece.parts, near_plane_of(input_.view)).second;
        for (Loop& part : parts)
            for (dvec3& p : part) p = window_.on_grid(p);
        return parts;
    }

    /// After a draw or a cut, no polygon counts as moved any more: all go back to their places.
    void restore_order() {
        for (Item& item : list_) item.moved = false;
        sort();
    }

    void sort() {
        output_.counts.sorts += 1;
        merge_sort(list_.begin(), list_.end(), [&](const Item& a, const Item& b) {
            output_.counts.keys += 1;
            return nearer(a, b);
        });
        log_order("sorted");
    }

    /// False: the list has changed; begin again with its new farthest polygon.
    bool farthest_may_be_drawn() {
        const std::size_t p = list_.size() - 1;
        for (std::size_t q = p; q-- > 0;) {
            if (apart_in_depth(list_[p], list_[q])) {
                if (list_[q].moved) continue;
                break;  // nor do those after it reach this far
            }
            if (may_precede(list_[p], list_[q])) continue;
            if (!list_[q].moved && other_first(list_[p], list_[q])) return move_to_end(q);
            if (list_[q].moved) log_cycle(p);
            if (cut(p, q) || cut(q, p) || cut_in_cycle(p)) return false;
            output_.counts.undecided += 1;
            if (log_.on())
                log_.add({.action = Action::Decide,
                          .test = "split",
                          .result = "none",
                          .pieces = {list_[p].piece.name, list_[q].piece.name},
                          .decisive = true});
        }
        return true;
    }

    /// All of q is nearer than all of p.
    bool apart_in_depth(const Item& p, const Item& q) {
        output_.counts.extents += 1;
        const bool yes = q.extents[2].second <= p.extents[2].first;
        log_extents(p, q, 2, "z-extents", yes);
        return yes;
    }

    /// The five tests: whether p may be drawn before q.
    bool may_precede(const Item& p, const Item& q) {
        return apart(p, q, 0, "1-x-extents") || apart(p, q, 1, "2-y-extents") ||
               behind(p, q, "3-behind") || before(q, p, "4-before") || disjoint(p, q);
    }

    /// Tests 3 and 4 the other way round: whether q may be drawn before p.
    bool other_first(const Item& p, const Item& q) {
        return behind(q, p, "3'-behind") || before(p, q, "4'-before");
    }

    bool apart(const Item& p, const Item& q, std::size_t axis, const char* test) {
        output_.counts.extents += 1;
        const bool yes = !overlap(p.extents[axis], q.extents[axis]);
        log_extents(p, q, axis, test, yes);
        return yes;
    }

    const WorldFacet& facet(const Item& item) const { return facet_of(input_, item.world.of); }

    /// All of a lies in b's plane or behind it, seen from the eye.
    bool behind(const Item& a, const Item& b, const char* test) { return side(a, b, true, test); }
    /// All of a lies in b's plane or before it.
    bool before(const Item& a, const Item& b, const char* test) { return side(a, b, false, test); }

    bool side(const Item& a, const Item& b, bool is_behind, const char* test) {
        output_.counts.planes += 1;
        const dvec4 plane = unit_plane(facet(b));
        const bool eye_in_front = is_before(plane, input_.view);
        const PlaneSide side = side_of(a.world, plane, tolerance_);
        const PlaneSide wanted = eye_in_front == is_behind ? PlaneSide::Back : PlaneSide::Front;
        const bool yes = side == wanted || side == PlaneSide::On;
        if (log_.on())
            log_.add({.test = test,
                      .result = yes ? "yes" : "no",
                      .pieces = {a.piece.name, b.piece.name},
                      .values = {{"behind", distances_of(a.world, eye_in_front ? -plane : plane)},
                                 {"tolerance", tolerance_}}});
        return yes;
    }

    bool disjoint(const Item& p, const Item& q) {
        output_.counts.overlaps += 1;
        const bool yes = !projections_overlap(p.outline, q.outline);
        if (log_.on())
            log_.add({.test = "5-projections",
                      .result = yes ? "yes" : "no",
                      .pieces = {p.piece.name, q.piece.name}});
        return yes;
    }

    bool move_to_end(std::size_t q) {
        output_.counts.swaps += 1;
        list_[q].moved = true;
        std::rotate(list_.begin() + std::ptrdiff_t(q), list_.begin() + std::ptrdiff_t(q) + 1,
                    list_.end());
        log_order("moved");
        return false;
    }

    /// p and the polygons moved before it form a cycle, though each pair may have an order. A polygon
    /// of the cycle crosses the plane of another. Otherwise a BSP tree of the cycle would cut nothing,
    /// and its order would satisfy every pair: no cycle. So a cut is always found, but for rounding,
    /// whose limits are `tolerance_` and `border`.
    bool cut_in_cycle(std::size_t p) {
        const std::vector<std::size_t> cycle = cycle_of(p);
        for (const std::size_t i : cycle)
            for (const std::size_t j : cycle)
                if (i != j && cut(i, j)) return true;
        return false;
    }

    std::vector<std::size_t> cycle_of(std::size_t p) const {
        std::vector<std::size_t> cycle{p};
        for (std::size_t i = p; i-- > 0;)
            if (list_[i].moved) cycle.push_back(i);
        return cycle;
    }

    /// Cuts item i by item j's plane; the pieces take their places in the list.
    bool cut(std::size_t i, std::size_t j) {
        const TreePiece& by = list_[j].world;
        const dvec4 plane = unit_plane(facet(list_[j]));
        if (side_of(list_[i].world, plane, tolerance_) != PlaneSide::Both) return false;
        auto [back, front] = cut_piece(list_[i].world, by.of, plane);
        if (back.parts.empty() || front.parts.empty()) return false;
        output_.counts.splits += 1;
        log_cut(list_[i], list_[j], front, back);
        list_.erase(list_.begin() + std::ptrdiff_t(i));
        add(std::move(front));
        add(std::move(back));
        restore_order();
        return true;
    }

    void log_order(const char* result) {
        if (!log_.on()) return;
        Step step{
            .action = Action::Sort, .test = "farthest-corner", .result = result, .decisive = true};
        std::vector<double> z;
        std::vector<std::string> moved;
        for (std::size_t i = list_.size(); i-- > 0;) {
            step.pieces.push_back(list_[i].piece.name);
            z.push_back(list_[i].extents[2].second);
            if (list_[i].moved) moved.push_back(list_[i].piece.name);
        }
        step.values = {{"z", z}, {"marked", moved}};
        log_.add(std::move(step));
    }

    void log_extents(const Item& p, const Item& q, std::size_t axis, const char* test, bool yes) {
        if (!log_.on()) return;
        const auto reach = [&](const Item& item) {
            const auto [low, high] = item.extents[axis];
            return axis == 1 ? std::vector{from_top(input_, high), from_top(input_, low)}
                             : std::vector{low, high};
        };
        log_.add({.test = test,
                  .result = yes ? "yes" : "no",
                  .pieces = {p.piece.name, q.piece.name},
                  .values = {{"first_reach", reach(p)}, {"second_reach", reach(q)}}});
    }

    /// Distances have the sign of test 3: above 0 is behind.
    void log_cut(const Item& item, const Item& by, const TreePiece& front, const TreePiece& back) {
        if (!log_.on()) return;
        const dvec4 plane = unit_plane(facet(by));
        const dvec4 behind = is_before(plane, input_.view) ? -plane : plane;
        const auto made = [&](const TreePiece& part) -> NamedOutline {
            return {name_of(input_.polygons, part), window_piece(input_, part).parts};
        };
        log_.add({.action = Action::Split,
                  .test = "split",
                  .result = "seen-plane",
                  .pieces = {item.piece.name, by.piece.name},
                  .values = {{"behind", distances_of(item.world, behind)}},
                  .decisive = true,
                  .made = {made(front), made(back)}});
    }

    void log_cycle(std::size_t p) {
        if (!log_.on()) return;
        Step step{.action = Action::Decide, .test = "marks", .result = "cycle", .decisive = true};
        for (const std::size_t i : cycle_of(p)) step.pieces.push_back(list_[i].piece.name);
        log_.add(std::move(step));
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    WorldLines window_;
    double tolerance_ = 0;
    std::vector<Item> list_;  ///< nearest first: the farthest is at the end
};

}  // namespace

Algorithm newell() {
    return {.name = "newell",
            .title = "Newell, Newell and Sancha: five tests and splitting [L5]",
            .claim = Claim::Always,
            .in_world = true,
            .growth = {GrowthLaw::Superlinear, 25},
            .run = [](const Input& input, StepLog& log) { return Newell(input, log).run(); }};
}

}  // namespace gw::hiddensurface
