#include "hiddensurface/bsp_tree.h"

#include "hiddensurface/normal.h"
#include "hiddensurface/piece.h"

#include <algorithm>
#include <cmath>

namespace gw::hiddensurface {

namespace {

/// Positions are float32: corners of a plane polygon lie this near to its plane, as a part of the scene's
/// size.
constexpr double relative_tolerance = 1e-6;

enum class Place { On, Front, Back, Both };

class Builder {
public:
    Builder(const std::vector<Polygon>& polygons, std::size_t candidates, const SplitSink& on_split)
        : polygons_(polygons), candidates_(candidates), on_split_(on_split) {
        double reach = 0;
        for (const Polygon& polygon : polygons)
            for (const dvec3& p : polygon.world)
                reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
        tolerance_ = reach * relative_tolerance;
    }

    Tree build(const std::vector<std::size_t>& order) {
        std::vector<TreePiece> pieces;
        for (const std::size_t i : order)
            if (unit_plane(i) != dvec4(0)) pieces.push_back({i, polygons_[i].world_parts, {}});
        tree_.root = node(std::move(pieces));
        return std::move(tree_);
    }

private:
    /// 0 where the polygon has no area.
    dvec4 unit_plane(std::size_t i) const {
        const Loop& corners = polygons_[i].world;
        const dvec3 n = polygon_normal(corners);
        const double length = std::sqrt(dot3(n, n));
        return length > 0 ? plane_of(n / length, corners[0]) : dvec4(0);
    }

    Place place(const TreePiece& piece, const dvec4& plane) {
        tree_.plane_tests += 1;
        bool front = false, back = false;
        for (const Loop& part : piece.parts)
            for (const dvec3& p : part) {
                front = front || side(plane, p) > tolerance_;
                back = back || side(plane, p) < -tolerance_;
            }
        return front && back ? Place::Both : front ? Place::Front : back ? Place::Back : Place::On;
    }

    std::size_t best(const std::vector<TreePiece>& pieces) {
        std::size_t best = 0, fewest = pieces.size();
        const std::size_t tried = std::min(candidates_, pieces.size());
        for (std::size_t c = 0; c < tried && tried > 1; ++c) {
            const std::size_t i = c * pieces.size() / tried;
            const dvec4 plane = unit_plane(pieces[i].polygon);
            std::size_t cut = 0;
            for (const TreePiece& piece : pieces) cut += place(piece, plane) == Place::Both ? 1 : 0;
            if (cut < fewest) {
                fewest = cut;
                best = i;
            }
        }
        return best;
    }

    std::unique_ptr<TreeNode> node(std::vector<TreePiece> pieces) {
        if (pieces.empty()) return nullptr;
        auto out = std::make_unique<TreeNode>();
        tree_.nodes += 1;
        const std::size_t first = best(pieces);
        const std::size_t by = pieces[first].polygon;
        out->plane = unit_plane(by);
        out->pieces.push_back(std::move(pieces[first]));
        pieces.erase(pieces.begin() + std::ptrdiff_t(first));
        std::vector<TreePiece> front, back;
        for (TreePiece& piece : pieces) sort_in(std::move(piece), by, *out, front, back);
        tree_.pieces += out->pieces.size();
        pieces = {};
        out->front = node(std::move(front));
        out->back = node(std::move(back));
        return out;
    }

    void sort_in(TreePiece piece, std::size_t by, TreeNode& at, std::vector<TreePiece>& front,
                 std::vector<TreePiece>& back) {
        switch (place(piece, at.plane)) {
            case Place::On: at.pieces.push_back(std::move(piece)); return;
            case Place::Front: front.push_back(std::move(piece)); return;
            case Place::Back: back.push_back(std::move(piece)); return;
            case Place::Both: break;
        }
        auto [behind, before] = divide(piece.parts, at.plane);
        tree_.splits += 1;
        if (on_split_) on_split_(piece, by, behind, before);
        TreePiece other{piece.polygon, std::move(behind), piece.cuts};
        other.cuts.emplace_back(by, false);
        piece.parts = std::move(before);
        piece.cuts.emplace_back(by, true);
        front.push_back(std::move(piece));
        back.push_back(std::move(other));
    }

    const std::vector<Polygon>& polygons_;
    std::size_t candidates_;
    const SplitSink& on_split_;
    double tolerance_ = 0;
    Tree tree_;
};

std::uint64_t walk(const TreeNode* node, const dvec4& eye,
                   const std::function<void(const TreePiece&)>& visit) {
    if (!node) return 0;
    const bool in_front = dot4(node->plane, eye) >= 0;
    std::uint64_t compared = 1 + walk((in_front ? node->back : node->front).get(), eye, visit);
    for (const TreePiece& piece : node->pieces) visit(piece);
    compared += walk((in_front ? node->front : node->back).get(), eye, visit);
    return compared;
}

}  // namespace

Tree build_tree(const std::vector<Polygon>& polygons, const std::vector<std::size_t>& order,
                std::size_t candidates, const SplitSink& on_split) {
    return Builder(polygons, candidates, on_split).build(order);
}

std::uint64_t far_to_near(const Tree& tree, const dvec4& eye,
                          const std::function<void(const TreePiece&)>& visit) {
    return walk(tree.root.get(), eye, visit);
}

}  // namespace gw::hiddensurface
