// The memory layout of the tree's nodes and leaves: eight boxes, or eight triangles, side by side
// for vectors. Does not build (build_tree.cpp) and does not search (search.cpp).
#pragma once

#include "gw/base/types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace gw::raytrace {

inline constexpr int width_of_tree = 8;

/// Eight boxes. Unused ones are empty (low = infinity, high = -infinity) and met by no ray.
struct alignas(32) WideNode {
    float bound[3][2][width_of_tree];  ///< axis; low, high; child
    std::uint32_t child[width_of_tree];
};
/// A child is a node's index. If the highest bit is set, it is a packet: its index in the low 28
/// bits, the number of its triangles less 1 in the three bits between.
inline constexpr std::uint32_t leaf_bit = 0x80000000u;
constexpr std::uint32_t leaf_of(std::size_t packet, std::size_t count) {
    return leaf_bit | static_cast<std::uint32_t>((count - 1) << 28 | packet);
}
constexpr std::uint32_t packet_of_leaf(std::uint32_t leaf) { return leaf & 0x0fffffffu; }
constexpr int count_of_leaf(std::uint32_t leaf) { return int(leaf >> 28 & 7) + 1; }

/// The deepest that a binary tree of triangles gets: beyond half of it ranges are halved by number.
inline constexpr int deepest = 96;

/// Up to eight triangles.
struct alignas(32) TrianglePacket {
    float corner[3][3][width_of_tree];  ///< corner; axis; triangle
    std::uint32_t triangle[width_of_tree];
    std::uint32_t number[width_of_tree];
};

struct WideTree {
    std::vector<WideNode> nodes;  ///< the first is the root
    std::vector<TrianglePacket> packets;
};

}  // namespace gw::raytrace
