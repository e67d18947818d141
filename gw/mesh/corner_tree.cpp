#include "gw/mesh/corner_tree.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gw {
namespace {

constexpr std::uint32_t leaf_size = 8;

// True only if the whole box lies to the right of the line from a to b, rounding allowed for.
bool right_of(vec2 a, vec2 b, vec2 low, vec2 high) {
    const dvec2 along = dvec2(b) - dvec2(a);
    // the box's leftmost
    const dvec2 corner{along.y > 0 ? low.x : high.x, along.x > 0 ? high.y : low.y};
    const double left = along.x * (corner.y - a.y), right = along.y * (corner.x - a.x);
    return left - right < -8 * 0x1p-53 * (std::abs(left) + std::abs(right));
}

}  // namespace

CornerTree::CornerTree(std::span<const vec2> points, std::vector<std::uint32_t> corners)
    : points_(points), corners_(std::move(corners)), leaf_of_(points.size(), 0) {
    if (!corners_.empty()) build(0, static_cast<std::uint32_t>(corners_.size()), 0);
}

std::uint32_t CornerTree::build(std::uint32_t first, std::uint32_t last, std::uint32_t parent) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{.low = points_[corners_[first]],
              .high = points_[corners_[first]],
              .first = first,
              .last = last};
    for (std::uint32_t i = first; i < last; ++i) {
        node.low = glm::min(node.low, points_[corners_[i]]);
        node.high = glm::max(node.high, points_[corners_[i]]);
    }
    node.parent = parent;
    node.alive = last - first;
    nodes_.push_back(node);
    if (last - first > leaf_size)
        split(index);
    else
        for (std::uint32_t i = first; i < last; ++i) leaf_of_[corners_[i]] = index + 1;
    return index;
}

// Halves the corners at the median of the wider side.
void CornerTree::split(std::uint32_t index) {
    const Node node = nodes_[index];
    const int axis = node.high.x - node.low.x >= node.high.y - node.low.y ? 0 : 1;
    const std::uint32_t middle = node.first + (node.last - node.first) / 2;
    std::nth_element(
        corners_.begin() + node.first, corners_.begin() + middle, corners_.begin() + node.last,
        [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
    const std::uint32_t left = build(node.first, middle, index);
    const std::uint32_t right = build(middle, node.last, index);
    nodes_[index].left = left;
    nodes_[index].right = right;
}

void CornerTree::remove(std::uint32_t corner) {
    if (leaf_of_[corner] == 0) return;
    std::uint32_t index = leaf_of_[corner] - 1;
    leaf_of_[corner] = 0;
    for (;;) {
        --nodes_[index].alive;
        if (index == 0) return;
        index = nodes_[index].parent;
    }
}

float CornerTree::distance(const Node& node, vec2 point) {
    const vec2 outside = glm::max(node.low - point, point - node.high);
    return std::max(outside.x, outside.y);
}

bool CornerTree::apart(const Node& node, const std::array<vec2, 3>& t) {
    for (int axis = 0; axis < 2; ++axis) {
        if (std::max({t[0][axis], t[1][axis], t[2][axis]}) < node.low[axis]) return true;
        if (std::min({t[0][axis], t[1][axis], t[2][axis]}) > node.high[axis]) return true;
    }
    return right_of(t[0], t[1], node.low, node.high) || right_of(t[1], t[2], node.low, node.high) ||
           right_of(t[2], t[0], node.low, node.high);
}

}  // namespace gw
