#include "hiddensurface/structures/clusters.h"

#include "hiddensurface/model/normal.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>

namespace gw::hiddensurface {
namespace {

constexpr std::size_t largest_cluster = 512;  ///< faces: each is compared with each
constexpr std::size_t tried_first = 16;       ///< planes of faces tried before all of them

/// Whether a piece has points in front of a face's plane and behind it.
struct Reach {
    bool front = false, back = false;
};

/// Greatest number first. Sides are numbered 2 i (front) and 2 i + 1.
std::vector<RankedSide> in_order(const std::vector<std::size_t>& priority) {
    std::vector<RankedSide> sides;
    for (std::size_t a = priority.size(); a-- > 0;)
        sides.push_back({a / 2, a % 2 == 0, priority[a]});
    std::stable_sort(sides.begin(), sides.end(), [](const RankedSide& a, const RankedSide& b) {
        return a.priority > b.priority;
    });
    return sides;
}

class Priorities {
public:
    Priorities(const std::vector<TreePiece>& pieces, const std::vector<dvec4>& planes,
               double tolerance, std::uint64_t& tests)
        : n_(pieces.size()), reach_(n_ * n_) {
        for (const dvec4& plane : planes) normals_.push_back(dvec3(plane));
        for (std::size_t i = 0; i < n_; ++i)
            for (std::size_t k = 0; k < i; ++k) {
                tests += 2;
                reach_[i * n_ + k] = reach_of(side_of(pieces[i], planes[k], tolerance));
                reach_[k * n_ + i] = reach_of(side_of(pieces[k], planes[i], tolerance));
                cyclic_ = across(reach_[i * n_ + k]) && across(reach_[k * n_ + i]);
                if (cyclic_) return;  // they pierce, or would pierce if they were larger
            }
    }

    /// The sides with their priorities. None: there is a cycle.
    std::optional<std::vector<RankedSide>> ranked() const {
        if (cyclic_) return std::nullopt;
        std::vector<std::size_t> hiders(2 * n_), priority(2 * n_, 1), free;
        for (std::size_t a = 0; a < 2 * n_; ++a)
            for (std::size_t b = 0; b < 2 * n_; ++b) hiders[b] += may_hide(a, b) ? 1 : 0;
        for (std::size_t a = 0; a < 2 * n_; ++a)
            if (hiders[a] == 0) free.push_back(a);
        for (std::size_t next = 0; next < free.size(); ++next) {
            const std::size_t a = free[next];
            for (std::size_t b = 0; b < 2 * n_; ++b) {
                if (!may_hide(a, b)) continue;
                priority[b] = std::max(priority[b], priority[a] + 1);
                if (--hiders[b] == 0) free.push_back(b);
            }
        }
        if (free.size() < 2 * n_) return std::nullopt;
        return in_order(priority);
    }

private:
    static Reach reach_of(PlaneSide side) {
        return {side == PlaneSide::Front || side == PlaneSide::Both,
                side == PlaneSide::Back || side == PlaneSide::Both};
    }
    static bool across(const Reach& reach) { return reach.front && reach.back; }

    /// Side a may hide b if a has a point in front of b's side, and b has one behind a's: on the line
    /// through the two points is an eye that sees a before b. Of two sides in one plane, the scene's
    /// first is seen.
    bool may_hide(std::size_t a, std::size_t b) const {
        const std::size_t i = a / 2, k = b / 2;
        if (i == k) return false;
        const Reach &of_a = reach_[i * n_ + k], &of_b = reach_[k * n_ + i];
        const bool a_front = a % 2 == 0, b_front = b % 2 == 0;
        if (!of_a.front && !of_a.back && !of_b.front && !of_b.back)
            return i < k && (dot3(normals_[i], normals_[k]) > 0) == (a_front == b_front);
        return (b_front ? of_a.front : of_a.back) && (a_front ? of_b.back : of_b.front);
    }

    std::size_t n_;
    std::vector<Reach> reach_;  ///< of piece i at the plane of k: i n + k
    std::vector<dvec3> normals_;
    bool cyclic_ = false;  ///< two faces are each across the other's plane
};

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Separation {
    dvec4 plane{0};
    std::optional<TreePiece> by;  ///< the face of the plane; none: it lies between faces
    std::size_t cost = none;
};

class ClusterBuilder {
public:
    ClusterBuilder(const std::vector<Polygon>& polygons, const SplitSink& on_split)
        : polygons_(polygons), on_split_(on_split), tolerance_(world_tolerance(polygons)) {}

    ClusterTree build() {
        std::vector<std::size_t> order(polygons_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        pending_.push_back({.pieces = pieces_of(polygons_, order)});
        while (!pending_.empty()) {
            Pending next = std::move(pending_.back());
            pending_.pop_back();
            add_node(std::move(next));
        }
        return std::move(tree_);
    }

private:
    /// Pieces that become a subtree on one side of a node; without a parent: the root.
    struct Pending {
        std::vector<TreePiece> pieces;
        std::size_t parent = no_node;
        bool in_front = false;
    };

    dvec4 plane(const TreePiece& piece) const {
        return unit_plane(polygons_[piece.of.polygon].world_facets[piece.of.facet]);
    }

    void add_node(Pending from) {
        const std::size_t number = tree_.nodes.size();
        tree_.nodes.emplace_back();
        if (from.parent != no_node) {
            ClusterNode& parent = tree_.nodes[from.parent];
            (from.in_front ? parent.front : parent.back) = number;
        }
        std::vector<TreePiece>& pieces = from.pieces;
        ClusterNode& node = tree_.nodes.back();
        if (pieces.size() <= largest_cluster && make_cluster(pieces, node)) return;
        Separation best = between(pieces);
        if (best.cost == none) best = by_a_face(pieces);
        if (best.cost == none) {
            make_convex(pieces, node);
            return;
        }
        tree_.separations += 1;
        node.plane = best.plane;
        Pending front{{}, number, true}, back{{}, number, false};
        for (TreePiece& piece : pieces) sort_in(std::move(piece), best, front.pieces, back.pieces);
        pending_.push_back(std::move(back));
        pending_.push_back(std::move(front));
    }

    Priorities priorities(const std::vector<TreePiece>& pieces) {
        std::vector<dvec4> planes;
        for (const TreePiece& piece : pieces) planes.push_back(plane(piece));
        tree_.comparison_bytes = std::max<std::uint64_t>(
            tree_.comparison_bytes, pieces.size() * pieces.size() * sizeof(Reach));
        return {pieces, planes, tolerance_, tree_.plane_tests};
    }

    bool make_cluster(std::vector<TreePiece>& pieces, ClusterNode& out) {
        auto sides = priorities(pieces).ranked();
        if (!sides) return false;
        finish(pieces, std::move(*sides), out);
        return true;
    }

    /// Of faces whose planes have no other in front: a convex solid, or all in one plane. Only inner
    /// sides are hidden, by outer ones, so no face is compared with another.
    void make_convex(std::vector<TreePiece>& pieces, ClusterNode& out) {
        const dvec4 first = plane(pieces.front());
        const bool solid = std::any_of(pieces.begin(), pieces.end(), [&](const TreePiece& piece) {
            return side_of(piece, first, tolerance_) == PlaneSide::Back;
        });
        tree_.plane_tests += pieces.size();
        std::vector<std::size_t> priority(2 * pieces.size(), 1);
        for (std::size_t inner = 1; solid && inner < priority.size(); inner += 2)
            priority[inner] = 2;
        finish(pieces, in_order(priority), out);
    }

    void finish(std::vector<TreePiece>& pieces, std::vector<RankedSide> sides, ClusterNode& out) {
        tree_.clusters += 1;
        tree_.pieces += pieces.size();
        out.pieces = std::move(pieces);
        out.sides = std::move(sides);
    }

    /// The plane across an axis, in a gap between faces, that leaves the most even halves.
    Separation between(const std::vector<TreePiece>& pieces) {
        Separation best;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<std::pair<double, double>> reach;
            for (const TreePiece& piece : pieces) reach.push_back(extent(piece, axis));
            std::stable_sort(reach.begin(), reach.end());
            double high = reach[0].second;
            for (std::size_t i = 1; i < reach.size(); high = std::max(high, reach[i].second), ++i) {
                tree_.plane_tests += 1;
                const std::size_t cost = std::max(i, reach.size() - i);
                if (reach[i].first <= high + 2 * tolerance_ || cost >= best.cost) continue;
                dvec3 n(0);
                n[axis] = 1;
                best = {dvec4(n, -0.5 * (high + reach[i].first)), std::nullopt, cost};
            }
        }
        return best;
    }

    static std::pair<double, double> extent(const TreePiece& piece, int axis) {
        std::pair<double, double> reach{piece.parts[0][0][axis], piece.parts[0][0][axis]};
        for (const Loop& part : piece.parts)
            for (const dvec3& p : part)
                reach = {std::min(reach.first, p[axis]), std::max(reach.second, p[axis])};
        return reach;
    }

    /// The plane of a face that cuts few others and leaves even halves. Tries some faces, and all if
    /// none of these divides.
    Separation by_a_face(const std::vector<TreePiece>& pieces) {
        Separation best;
        const std::size_t tried = std::min(tried_first, pieces.size());
        for (std::size_t c = 0; c < tried; ++c) consider(pieces, c * pieces.size() / tried, best);
        for (std::size_t i = 0; i < pieces.size() && best.cost == none; ++i)
            consider(pieces, i, best);
        return best;
    }

    void consider(const std::vector<TreePiece>& pieces, std::size_t face, Separation& best) {
        const dvec4 by = plane(pieces[face]);
        std::size_t front = 0, back = 0, cut = 0;
        for (const TreePiece& piece : pieces) {
            const PlaneSide side = side_of(piece, by, tolerance_);
            tree_.plane_tests += 1;
            front += side == PlaneSide::Front ? 1 : 0;
            cut += side == PlaneSide::Both ? 1 : 0;
            back += side == PlaneSide::Back || side == PlaneSide::On ? 1 : 0;
        }
        const std::size_t cost = 8 * cut + std::max(front, back);
        if (front + cut > 0 && back + cut > 0 && cost < best.cost) best = {by, pieces[face], cost};
    }

    /// A piece in the plane goes behind it.
    void sort_in(TreePiece piece, const Separation& at, std::vector<TreePiece>& front,
                 std::vector<TreePiece>& back) {
        tree_.plane_tests += 1;
        const PlaneSide side = side_of(piece, at.plane, tolerance_);
        if (side != PlaneSide::Both) {
            (side == PlaneSide::Front ? front : back).push_back(std::move(piece));
            return;
        }
        auto [behind, before] = cut_piece(piece, at.by.value().of, at.plane);
        tree_.splits += 1;
        if (on_split_) on_split_(piece, at.by.value(), behind, before);
        front.push_back(std::move(before));
        back.push_back(std::move(behind));
    }

    const std::vector<Polygon>& polygons_;
    const SplitSink& on_split_;
    double tolerance_;
    ClusterTree tree_;
    std::vector<Pending> pending_;
};

/// Visits the cluster's sides that the eye sees. Returns the number of signs of D_f.
std::uint64_t visit_cluster(const ClusterNode& cluster, const std::vector<Polygon>& polygons,
                            const dvec4& eye,
                            const std::function<void(const TreePiece&, const RankedSide&)>& visit) {
    std::vector<bool> before;
    for (const TreePiece& piece : cluster.pieces)
        before.push_back(
            dot4(unit_plane(polygons[piece.of.polygon].world_facets[piece.of.facet]), eye) >= 0);
    for (const RankedSide& side : cluster.sides)
        if (side.front == before[side.piece]) visit(cluster.pieces[side.piece], side);
    return cluster.pieces.size();
}

}  // namespace

ClusterTree build_clusters(const std::vector<Polygon>& polygons, const SplitSink& on_split) {
    return ClusterBuilder(polygons, on_split).build();
}

std::uint64_t far_to_near(const ClusterTree& tree, const std::vector<Polygon>& polygons,
                          const dvec4& eye,
                          const std::function<void(const TreePiece&, const RankedSide&)>& visit,
                          const EyeSink& on_eye) {
    std::uint64_t asked = 0;
    std::vector<std::size_t> open{0};  // the farthest last
    while (!open.empty()) {
        const std::size_t number = open.back();
        const ClusterNode& node = tree.nodes[number];
        open.pop_back();
        if (node.front == no_node) {
            asked += visit_cluster(node, polygons, eye, visit);
            continue;
        }
        asked += 1;
        const double distance = dot4(node.plane, eye);
        const bool in_front = distance >= 0;
        if (on_eye) on_eye(number, distance);
        open.push_back(in_front ? node.front : node.back);
        open.push_back(in_front ? node.back : node.front);
    }
    return asked;
}

}  // namespace gw::hiddensurface
