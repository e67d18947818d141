#include "hiddensurface/structures/bsp_tree.h"

#include "hiddensurface/model/normal.h"
#include "hiddensurface/model/piece.h"

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {
namespace {

class BspBuilder {
public:
    BspBuilder(const std::vector<Polygon>& polygons, std::size_t candidates, const TreeSinks& sinks)
        : polygons_(polygons), candidates_(candidates), sinks_(sinks) {
        tolerance_ = world_tolerance(polygons);
    }

    Tree build(const std::vector<std::size_t>& order) {
        pending_.push_back({.pieces = pieces_of(polygons_, order)});
        while (!pending_.empty()) {
            Pending next = std::move(pending_.back());
            pending_.pop_back();
            if (!next.pieces.empty()) add_node(std::move(next));
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

    dvec4 plane(FacetIndex i) const {
        return unit_plane(polygons_[i.polygon].world_facets[i.facet]);
    }

    PlaneSide side(const TreePiece& piece, const dvec4& cut) {
        tree_.plane_tests += 1;
        return side_of(piece, cut, tolerance_);
    }

    std::size_t best(const std::vector<TreePiece>& pieces) {
        std::size_t best = 0, fewest = pieces.size();
        const std::size_t tried = std::min(candidates_, pieces.size());
        for (std::size_t c = 0; c < tried && tried > 1; ++c) {
            const std::size_t i = c * pieces.size() / tried;
            const dvec4 candidate = plane(pieces[i].of);
            std::size_t splits = 0;
            for (const TreePiece& piece : pieces)
                splits += side(piece, candidate) == PlaneSide::Both ? 1 : 0;
            if (splits < fewest) {
                fewest = splits;
                best = i;
            }
        }
        return best;
    }

    void add_node(Pending from) {
        std::vector<TreePiece>& pieces = from.pieces;
        const std::size_t first = best(pieces), number = tree_.nodes.size();
        TreeNode node{.plane = plane(pieces[first].of)};
        node.pieces.push_back(std::move(pieces[first]));
        pieces.erase(pieces.begin() + std::ptrdiff_t(first));
        Pending front{{}, number, true}, back{{}, number, false};
        for (TreePiece& piece : pieces) sort_in(std::move(piece), node, front.pieces, back.pieces);
        tree_.pieces += node.pieces.size();
        tree_.nodes.push_back(std::move(node));
        if (sinks_.on_node)
            sinks_.on_node({tree_, tree_.nodes.back(), number, from.parent, from.in_front,
                            front.pieces.size(), back.pieces.size()});
        if (from.parent != no_node) {
            TreeNode& parent = tree_.nodes[from.parent];
            (from.in_front ? parent.front : parent.back) = number;
        }
        pending_.push_back(std::move(back));
        pending_.push_back(std::move(front));
    }

    void sort_in(TreePiece piece, TreeNode& at, std::vector<TreePiece>& front,
                 std::vector<TreePiece>& back) {
        switch (side(piece, at.plane)) {
            case PlaneSide::On: at.pieces.push_back(std::move(piece)); return;
            case PlaneSide::Front: front.push_back(std::move(piece)); return;
            case PlaneSide::Back: back.push_back(std::move(piece)); return;
            case PlaneSide::Both: break;
        }
        const TreePiece& by = at.pieces.front();
        auto [behind, before] = cut_piece(piece, by.of, at.plane);
        tree_.splits += 1;
        if (sinks_.on_split) sinks_.on_split(piece, by, behind, before);
        front.push_back(std::move(before));
        back.push_back(std::move(behind));
    }

    const std::vector<Polygon>& polygons_;
    std::size_t candidates_;
    const TreeSinks& sinks_;
    double tolerance_ = 0;
    Tree tree_;
    std::vector<Pending> pending_;
};

dvec3 normal_of(const WorldFacet& facet) {
    dvec3 n(0);
    for (const Loop& part : facet.parts) n += polygon_normal(part);
    return n;
}

/// For corners whose areas add up to nothing: the normal of some triangle of them, or if all are on
/// one line, a direction across it.
dvec3 some_normal(const Loop& p) {
    dvec3 along(1, 0, 0);
    for (std::size_t k = 1; k < p.size(); ++k) {
        const dvec3 n = face_normal(p[0], p[k], p[(k + 1) % p.size()]);
        if (n != dvec3(0)) return n;
        if (p[k] != p[0]) along = p[k] - p[0];
    }
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(along[axis]) < std::abs(along[least])) least = axis;
    dvec3 other(0);
    other[least] = 1;
    return cross3(along, other);
}

}  // namespace

PlaneSide side_of(const TreePiece& piece, const dvec4& plane, double tolerance) {
    bool front = false, back = false;
    for (const Loop& part : piece.parts)
        for (const dvec3& p : part) {
            front = front || side(plane, p) > tolerance;
            back = back || side(plane, p) < -tolerance;
        }
    return front && back ? PlaneSide::Both
           : front       ? PlaneSide::Front
           : back        ? PlaneSide::Back
                         : PlaneSide::On;
}

std::vector<double> distances_of(const TreePiece& piece, const dvec4& plane) {
    std::vector<double> distances;
    for (const Loop& part : piece.parts)
        for (const dvec3& p : part) {
            const double d = side(plane, p), size = std::abs(plane.x * p.x) +
                                                    std::abs(plane.y * p.y) +
                                                    std::abs(plane.z * p.z) + std::abs(plane.w);
            distances.push_back(std::abs(d) > 0x1p-48 * size ? d : 0);
        }
    return distances;
}

std::pair<TreePiece, TreePiece> cut_piece(const TreePiece& piece, FacetIndex by,
                                          const dvec4& plane) {
    auto [behind, before] = divide(piece.parts, plane);
    std::pair<TreePiece, TreePiece> halves{{piece.of, std::move(behind), piece.cuts},
                                           {piece.of, std::move(before), piece.cuts}};
    halves.first.cuts.emplace_back(by, false);
    halves.second.cuts.emplace_back(by, true);
    return halves;
}

std::vector<TreePiece> pieces_of(const std::vector<Polygon>& polygons,
                                 const std::vector<std::size_t>& order) {
    std::vector<TreePiece> pieces;
    for (const std::size_t i : order)
        for (std::size_t k = 0; k < polygons[i].world_facets.size(); ++k)
            pieces.push_back({{i, k}, polygons[i].world_facets[k].parts, {}});
    return pieces;
}

bool has_area(const WorldFacet& facet) { return normal_of(facet) != dvec3(0); }

dvec4 unit_plane(const WorldFacet& facet) {
    dvec3 n = normal_of(facet);
    if (n == dvec3(0)) n = some_normal(facet.parts[0]);
    return plane_of(n / std::sqrt(dot3(n, n)), facet.parts[0][0]);
}

double world_tolerance(const std::vector<Polygon>& polygons) {
    double reach = 0;
    for (const Polygon& polygon : polygons)
        for (const dvec3& p : polygon.world)
            reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return reach * 1e-6;
}

Tree build_tree(const std::vector<Polygon>& polygons, const std::vector<std::size_t>& order,
                std::size_t candidates, const TreeSinks& sinks) {
    return BspBuilder(polygons, candidates, sinks).build(order);
}

std::uint64_t far_to_near(const Tree& tree, const dvec4& eye,
                          const std::function<void(const TreePiece&)>& visit,
                          const EyeSink& on_eye) {
    struct Open {
        const TreeNode* node;
        bool eye_in_front;
    };
    std::vector<Open> open;  // nodes whose far side is being visited
    std::uint64_t compared = 0;
    const auto descend_to_farthest = [&](std::size_t node) {
        while (node != no_node) {
            const TreeNode& n = tree.nodes[node];
            compared += 1;
            open.push_back({&n, dot4(n.plane, eye) >= 0});
            if (on_eye) on_eye(node, dot4(n.plane, eye));
            node = open.back().eye_in_front ? n.back : n.front;
        }
    };
    descend_to_farthest(tree.nodes.empty() ? no_node : 0);
    while (!open.empty()) {
        const auto [node, eye_in_front] = open.back();
        open.pop_back();
        // The first of several pieces in one plane is drawn last and stays visible, as in a Z-buffer
        // with z < Z.
        for (auto piece = node->pieces.rbegin(); piece != node->pieces.rend(); ++piece)
            visit(*piece);
        descend_to_farthest(eye_in_front ? node->front : node->back);
    }
    return compared;
}

}  // namespace gw::hiddensurface
