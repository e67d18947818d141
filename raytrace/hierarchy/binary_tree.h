// A binary tree of boxes over triangles, built from the top, the same for any number of threads.
// Does not widen it (build_tree.cpp).
#pragma once

#include "raytrace/hierarchy/binned_split.h"

#include <vector>

namespace gw::raytrace {

/// A node over items first .. last - 1; `left` = 0: a leaf, else left + 1 is the right one.
struct BinaryNode {
    Box3 box;
    std::uint32_t first = 0, last = 0, left = 0;
};
using BinaryTree = std::vector<BinaryNode>;  ///< the first is the root

/// Orders the items so that those of a node stand together. Leaves have at most width_of_tree
/// items.
BinaryTree binary_tree(std::span<Item> items, int threads);

}  // namespace gw::raytrace
