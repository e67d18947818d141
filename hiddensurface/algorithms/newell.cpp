// Newell, Newell and Sancha's algorithm [L5]. Polygons are sorted by their farthest corners. Five
// tests ask whether the farthest may be drawn before those it overlaps in depth. If not, the two are
// exchanged; if neither may come first, one is split by the other's plane. Decides in the window,
// after perspective, on facets: a quadrilateral that the snap has bent counts as the two triangles
// that the machine draws.
#include "hiddensurface/model/piece.h"
#include "hiddensurface/run/algorithm.h"

#include <algorithm>

namespace gw::hiddensurface {
namespace {

struct Item {
    Piece piece;
    const Facet* facet = nullptr;
    std::array<std::pair<double, double>, 3> extents;  ///< x, y, z
    bool moved = false;
};

Item make_item(Piece piece, const Facet& facet) {
    Item item{std::move(piece), &facet, {}, false};
    for (int axis = 0; axis < 3; ++axis) item.extents[std::size_t(axis)] = extent(item.piece, axis);
    return item;
}

bool nearer(const Item& a, const Item& b) { return a.extents[2].second < b.extents[2].second; }

class Newell {
public:
    Newell(const Input& input, StepLog& log)
        : input_(input),
          log_(log),
          output_{.list = begin_picture(input, "Newell, Newell, Sancha")} {
        for (std::size_t i = 0; i < input.polygons.size(); ++i)
            for (const Facet& facet : input.polygons[i].facets)
                list_.push_back(make_item(whole(i, facet), facet));
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
    /// After a draw or a cut, no polygon counts as moved any more: all go back to their places.
    void restore_order() {
        for (Item& item : list_) item.moved = false;
        sort();
    }

    void sort() {
        output_.counts.sorts += 1;
        std::stable_sort(list_.begin(), list_.end(), [&](const Item& a, const Item& b) {
            output_.counts.keys += 1;
            return nearer(a, b);
        });
        log_order();
    }

    void log_order() {
        if (!log_.on()) return;
        Step step{Level::Polygon, Action::Sort, {}, "farthest corner", "far to near"};
        for (std::size_t i = list_.size(); i-- > 0;) step.polygons.push_back(polygon(list_[i]).id);
        log_.add(std::move(step));
    }

    /// False: the list has changed; begin again with its new farthest polygon.
    bool farthest_may_be_drawn() {
        const std::size_t p = list_.size() - 1;
        for (std::size_t q = p; q-- > 0;) {
            output_.counts.extents += 1;
            if (list_[q].extents[2].second <= list_[p].extents[2].first) {
                if (list_[q].moved) continue;
                break;  // nor do those after it reach this far
            }
            if (may_precede(list_[p], list_[q])) continue;
            if (!list_[q].moved && other_first(list_[p], list_[q])) return move_to_end(q);
            if (cut(p, q) || cut(q, p) || cut_in_cycle(p)) return false;
            output_.counts.undecided += 1;
            log({list_[p], list_[q]}, "split", "none possible");
        }
        return true;
    }

    /// The five tests: whether p may be drawn before q.
    bool may_precede(const Item& p, const Item& q) {
        return apart(p, q, 0, "1: x extents") || apart(p, q, 1, "2: y extents") ||
               behind(p, q, "3: ") || before(q, p, "4: ") || disjoint(p, q);
    }

    /// Tests 3 and 4 the other way round: whether q may be drawn before p.
    bool other_first(const Item& p, const Item& q) {
        return behind(q, p, "3': ") || before(p, q, "4': ");
    }

    bool apart(const Item& p, const Item& q, std::size_t axis, const char* test) {
        output_.counts.extents += 1;
        const bool yes = !overlap(p.extents[axis], q.extents[axis]);
        log({p, q}, test, yes ? "disjoint" : "overlap");
        return yes;
    }

    /// All of a lies behind b's plane.
    bool behind(const Item& a, const Item& b, const char* number) {
        output_.counts.planes += 1;
        const bool yes = sides(a.piece, b.facet->plane).first >= -b.facet->tolerance;
        if (log_.on()) log({a, b}, std::string(number) + "behind the plane", yes ? "yes" : "no");
        return yes;
    }

    /// All of a lies before b's plane.
    bool before(const Item& a, const Item& b, const char* number) {
        output_.counts.planes += 1;
        const bool yes = sides(a.piece, b.facet->plane).second <= b.facet->tolerance;
        if (log_.on()) log({a, b}, std::string(number) + "before the plane", yes ? "yes" : "no");
        return yes;
    }

    bool disjoint(const Item& p, const Item& q) {
        output_.counts.overlaps += 1;
        const bool yes = !projections_overlap(p.piece, q.piece);
        log({p, q}, "5: projections", yes ? "disjoint" : "overlap");
        return yes;
    }

    bool move_to_end(std::size_t q) {
        output_.counts.swaps += 1;
        if (log_.on()) decide({list_[q]}, "order", "to the far end");
        list_[q].moved = true;
        std::rotate(list_.begin() + std::ptrdiff_t(q), list_.begin() + std::ptrdiff_t(q) + 1,
                    list_.end());
        log_order();
        return false;
    }

    /// p and the facets moved before it form a cycle, though each pair may have an order. A facet of
    /// the cycle crosses the plane of another. Otherwise a BSP tree of the cycle would cut nothing,
    /// and its order would satisfy every pair: no cycle. So a cut is always found, but for rounding,
    /// whose limits are Facet::tolerance and `border`.
    bool cut_in_cycle(std::size_t p) {
        std::vector<std::size_t> cycle{p};
        for (std::size_t i = p; i-- > 0;)
            if (list_[i].moved) cycle.push_back(i);
        for (const std::size_t i : cycle)
            for (const std::size_t j : cycle)
                if (i != j && cut(i, j)) return true;
        return false;
    }

    /// Cuts item i by item j's plane; the pieces take their places in the list.
    bool cut(std::size_t i, std::size_t j) {
        const auto pieces = split(list_[i].piece, *list_[i].facet, *list_[j].facet);
        if (!pieces) return false;
        output_.counts.splits += 1;
        if (log_.on())
            log_.add({Level::Polygon,
                      Action::Split,
                      {polygon(list_[i]).id, polygon(list_[j]).id},
                      "by the second's plane",
                      "",
                      -1,
                      {},
                      pieces->first.parts,
                      pieces->second.parts});
        const Facet& facet = *list_[i].facet;
        list_.erase(list_.begin() + std::ptrdiff_t(i));
        list_.push_back(make_item(pieces->first, facet));
        list_.push_back(make_item(pieces->second, facet));
        restore_order();
        return true;
    }

    const Polygon& polygon(const Item& item) const { return input_.polygons[item.piece.polygon]; }

    void log(std::initializer_list<std::reference_wrapper<const Item>> items,
             const std::string& test, const char* result) {
        if (log_.on()) log_.add({Level::Polygon, Action::Compare, ids(items), test, result});
    }
    void decide(std::initializer_list<std::reference_wrapper<const Item>> items, const char* test,
                const char* result) {
        log_.add({Level::Polygon, Action::Decide, ids(items), test, result});
    }
    std::vector<std::uint32_t> ids(
        std::initializer_list<std::reference_wrapper<const Item>> items) const {
        std::vector<std::uint32_t> found;
        for (const Item& item : items) found.push_back(polygon(item).id);
        return found;
    }

    const Input& input_;
    StepLog& log_;
    Output output_;
    std::vector<Item> list_;  ///< nearest first: the farthest is at the end
};

}  // namespace

Algorithm newell() {
    return {.name = "newell",
            .title = "Newell, Newell and Sancha: five tests and splitting [L5]",
            .claim = Claim::Always,
            .growth = {GrowthLaw::Superlinear, 25},
            .run = [](const Input& input, StepLog& log) { return Newell(input, log).run(); }};
}

}  // namespace gw::hiddensurface
