#include "raytrace/hierarchy/binary_tree.h"

#include "gw/base/parallel.h"
#include "raytrace/hierarchy/wide_tree.h"

#include <array>
#include <cmath>
#include <optional>

namespace gw::raytrace {
namespace {

/// What a node costs where a leaf, of up to eight triangles, costs 1.
constexpr float node_cost = 0.5f;
/// Ranges of at least this many triangles are halved level by level, those of a level in parallel;
/// what is left then is halved to its end, in parallel too.
constexpr std::size_t large = 1 << 13;

/// A node that may yet be halved.
struct Open {
    Range range;
    std::uint32_t node = 0;
    int depth = 0;
};

BinaryNode node_of(const Range& range) {
    return {range.box, static_cast<std::uint32_t>(range.first),
            static_cast<std::uint32_t>(range.last), 0};
}

/// The two sides of a range, where that pays or it is too long for a leaf.
std::optional<std::array<Range, 2>> halves(std::span<Item> items, const Range& range, int depth) {
    if (range.count() < 2) return std::nullopt;
    const Split split = depth < deepest / 2 ? best_split(items, range) : Split{};
    const bool pays = std::isfinite(split.cost) &&
                      node_cost * range.box.area() + split.cost < cost_of(range.box, range.count());
    if (range.count() <= std::size_t(width_of_tree) && !pays) return std::nullopt;
    return divide(items, range, split);
}

/// Adds two nodes below one, and lists them.
void add_children(BinaryTree& tree, const Open& parent, const std::array<Range, 2>& sides,
                  std::vector<Open>& open) {
    const auto left = static_cast<std::uint32_t>(tree.size());
    tree[parent.node].left = left;
    for (const std::uint32_t side : {0u, 1u}) tree.push_back(node_of(sides[side]));
    for (const std::uint32_t side : {1u, 0u})
        open.push_back({sides[side], left + side, parent.depth + 1});
}

/// The tree down to ranges that are not large; `small`: these.
BinaryTree top_of_tree(std::span<Item> items, int threads, std::vector<Open>& small) {
    const Range whole = whole_range(items);
    BinaryTree tree{node_of(whole)};
    std::vector<Open> level{{whole, 0, 0}};
    while (!level.empty()) {
        std::vector<std::optional<std::array<Range, 2>>> sides(level.size());
        parallel_for(level.size(), threads, [&](std::size_t i, int) {
            if (level[i].range.count() > large)
                sides[i] = halves(items, level[i].range, level[i].depth);
        });
        std::vector<Open> next;
        for (std::size_t i = 0; i < level.size(); ++i)
            if (sides[i])
                add_children(tree, level[i], *sides[i], next);
            else
                small.push_back(level[i]);
        level = std::move(next);
    }
    return tree;
}

/// The tree below a range; its root is the range's own node.
BinaryTree branch_of(std::span<Item> items, const Open& root) {
    BinaryTree tree{node_of(root.range)};
    tree.reserve(root.range.count());
    std::vector<Open> open{{root.range, 0, root.depth}};
    while (!open.empty()) {
        const Open next = open.back();
        open.pop_back();
        if (const auto sides = halves(items, next.range, next.depth))
            add_children(tree, next, *sides, open);
    }
    return tree;
}

/// Puts a tree in place of one of its leaves.
void graft(BinaryTree& tree, std::uint32_t at, const BinaryTree& branch) {
    const auto offset = static_cast<std::uint32_t>(tree.size()) - 1;
    const auto moved = [offset](BinaryNode node) {
        if (node.left) node.left += offset;
        return node;
    };
    tree[at] = moved(branch.front());
    for (std::size_t i = 1; i < branch.size(); ++i) tree.push_back(moved(branch[i]));
}

}  // namespace

BinaryTree binary_tree(std::span<Item> items, int threads) {
    std::vector<Open> small;
    BinaryTree tree = top_of_tree(items, threads, small);
    std::vector<BinaryTree> branches(small.size());
    parallel_for(small.size(), threads,
                 [&](std::size_t i, int) { branches[i] = branch_of(items, small[i]); });
    std::size_t size = tree.size();
    for (const BinaryTree& branch : branches) size += branch.size();
    tree.reserve(size);
    for (std::size_t i = 0; i < small.size(); ++i) {
        graft(tree, small[i].node, branches[i]);
        branches[i] = {};
    }
    return tree;
}

}  // namespace gw::raytrace
