// The corners of a polygon that can stand in an ear's way, found by place: a k-d tree that only
// loses points.
// Does not decide what stands in the way: the caller does, exactly.
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

    /// Takes a corner out; nothing happens where it is not in.
    void remove(std::uint32_t corner);

    /// True as soon as `blocks(corner)` is, for the corners inside or near the counter-clockwise
    /// triangle; those near its tip, triangle[1], come first: they are most often in the way.
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
    static float distance(const Node& node, vec2 point);  // the larger of those along x and y
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
    std::vector<std::uint32_t> leaf_of_;  // by ordinal: leaf + 1, 0 where it is not in
    std::vector<Node> nodes_;
};

}  // namespace gw
