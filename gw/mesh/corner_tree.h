// A k-d tree of the corners of a polygon that may lie in an ear. Corners are removed, never added.
// Does not decide whether a corner lies in an ear: the caller does, exactly.
#pragma once

#include "gw/base/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gw {

class CornerTree {
public:
    /// `corners` are ordinals into `points`, which must outlive the tree.
    CornerTree(std::span<const vec2> points, std::vector<std::uint32_t> corners);

    /// Removes a corner, if the tree has it.
    void remove(std::uint32_t corner);

    /// Whether `blocks(corner)` is true for a corner inside or near the counter-clockwise triangle.
    /// Corners near its tip, triangle[1], are tested first: they block most often.
    template <class Blocks>
    bool any(const std::array<vec2, 3>& triangle, Blocks blocks) const {
        return !nodes_.empty() && any_below(0, triangle, blocks);
    }

private:
    struct Node {
        vec2 low, high;
        std::uint32_t first = 0, last = 0;  // into corners_
        std::uint32_t left = 0, right = 0;  // 0: a leaf
        std::uint32_t parent = 0;
        std::uint32_t alive = 0;
    };

    std::uint32_t build(std::uint32_t first, std::uint32_t last, std::uint32_t parent);
    void split(std::uint32_t node);
    static float distance(const Node& node,
                          vec2 point);  // the larger of the distances along x and y
    static bool apart(const Node& node, const std::array<vec2, 3>& triangle);

    template <class Blocks>
    bool any_below(std::uint32_t index, const std::array<vec2, 3>& triangle, Blocks& blocks) const {
        const Node& node = nodes_[index];
        if (node.alive == 0 || apart(node, triangle)) return false;
        if (node.left != 0) {
            const bool swap = distance(nodes_[node.right], triangle[1]) <
                              distance(nodes_[node.left], triangle[1]);
            return any_below(swap ? node.right : node.left, triangle, blocks) ||
                   any_below(swap ? node.left : node.right, triangle, blocks);
        }
        for (std::uint32_t i = node.first; i < node.last; ++i)
            if (leaf_of_[corners_[i]] != 0 && blocks(corners_[i])) return true;
        return false;
    }

    std::span<const vec2> points_;
    std::vector<std::uint32_t> corners_;
    std::vector<std::uint32_t> leaf_of_;  // by ordinal: leaf + 1, or 0
    std::vector<Node> nodes_;
};

}  // namespace gw
