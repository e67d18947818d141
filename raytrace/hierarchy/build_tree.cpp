// Building the hierarchy: triangles are halved by the surface area heuristic in bins (Wald 2007)
// until eight or fewer are left. The binary tree is made wide by taking in the largest
// grandchildren (Wald, Benthin, Boulos 2008). Does not search (search.cpp).
#include "gw/base/parallel.h"
#include "raytrace/hierarchy/binned_split.h"
#include "raytrace/hierarchy/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace gw::raytrace {
namespace {

/// A node over items first .. last - 1; `left` = 0: a leaf, else left + 1 is the right one.
struct BinaryNode {
    Box3 box;
    std::uint32_t first = 0, last = 0, left = 0;
};
using BinaryTree = std::vector<BinaryNode>;  ///< the first is the root

/// The cost of a node, if a leaf of up to eight triangles costs 1.
constexpr float node_cost = 0.5f;
/// Ranges of at least this many triangles are halved level by level, those of a level in parallel.
/// Smaller ranges are then halved to the end, in parallel too.
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

/// The two sides of a range, if that pays or the range is too long for a leaf.
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

/// A binary tree of boxes over triangles, built from the top, the same for any number of threads.
/// Orders the items so that those of a node stand together. Leaves have at most width_of_tree
/// items.
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

/// Items, or packets, that a thread makes at a time.
constexpr std::size_t portion = 1 << 12;

/// make(i) for each i < count, in parallel.
template <class Make>
void in_portions(std::size_t count, int threads, const Make& make) {
    parallel_for((count + portion - 1) / portion, threads, [&](std::size_t part, int) {
        for (std::size_t i = part * portion; i < std::min(count, (part + 1) * portion); ++i)
            make(i);
    });
}

Item item_of(const HierarchyTriangle& t, std::size_t index) {
    Item item{.triangle = static_cast<std::uint32_t>(index)};
    for (const vec3& c : t.corner) item.box.add(c);
    for (int k = 0; k < 3; ++k) item.center[k] = item.box.low[k] * 0.5f + item.box.high[k] * 0.5f;
    return item;
}

/// Nodes of the binary tree that become the children of one wide node.
struct Children {
    std::array<std::uint32_t, width_of_tree> node{};
    std::size_t count = 1;
};

/// Up to eight descendants of a node, the largest opened first.
Children wide_children(const BinaryTree& tree, std::uint32_t index) {
    Children children{{index}, 1};
    std::array<float, width_of_tree> area{};  // of those that can be opened; -1 of leaves
    const auto area_of = [&](std::uint32_t node) {
        return tree[node].left ? tree[node].box.area() : -1.0f;
    };
    area[0] = area_of(index);
    while (children.count < std::size_t(width_of_tree)) {
        const auto end = area.begin() + std::ptrdiff_t(children.count);
        const auto at = std::size_t(std::max_element(area.begin(), end) - area.begin());
        if (area[at] < 0) break;
        const std::uint32_t left = tree[children.node[at]].left;
        for (std::size_t i = children.count; i > at + 1; --i) {
            children.node[i] = children.node[i - 1];
            area[i] = area[i - 1];
        }
        for (const std::size_t side : {0u, 1u}) {
            children.node[at + side] = left + static_cast<std::uint32_t>(side);
            area[at + side] = area_of(children.node[at + side]);
        }
        ++children.count;
    }
    return children;
}

/// The largest coordinate of a box.
float size_of(const Box3& box) {
    float size = 0;
    for (int axis = 0; axis < 3; ++axis)
        size = std::max({size, std::abs(box.low[axis]), std::abs(box.high[axis])});
    return size;
}

/// Widens the box by a few units in the last place of coordinates as large as `size`: a ray may run
/// in a box's face, and is rounded.
void set_bounds(WideNode& node, std::size_t child, const Box3& box, float size) {
    const float slack = size * 0x1p-22f + 0x1p-100f;
    for (int axis = 0; axis < 3; ++axis) {
        const float low = box.low[axis], high = box.high[axis];
        const bool empty = low > high;
        node.bound[axis][0][child] = empty ? low : low - slack;
        node.bound[axis][1][child] = empty ? high : high + slack;
    }
}

void fill_packet(std::span<const HierarchyTriangle> triangles, std::span<const Item> items,
                 TrianglePacket& packet) {
    for (std::size_t i = 0; i < std::size_t(width_of_tree); ++i) {
        packet.triangle[i] = packet.number[i] = no_triangle;
        if (i >= items.size()) continue;
        const HierarchyTriangle& t = triangles[items[i].triangle];
        packet.triangle[i] = items[i].triangle;
        packet.number[i] = t.number;
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                packet.corner[c][axis][i] = t.corner[std::size_t(c)][axis];
    }
}

/// The nodes of a wide tree, and which leaf of the binary one each packet is.
struct Widened {
    std::vector<WideNode> nodes;
    std::vector<std::uint32_t> leaves;
};

Widened widen(const BinaryTree& tree) {
    const float size = size_of(tree.front().box);
    Widened wide;
    wide.nodes.reserve(tree.size() / 5);
    wide.leaves.reserve(tree.size() / 2 + 1);
    wide.nodes.emplace_back();
    // binary node, its wide node
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
    const auto child_of = [&](std::uint32_t index) {
        if (tree[index].left) {
            wide.nodes.emplace_back();
            return static_cast<std::uint32_t>(wide.nodes.size() - 1);
        }
        wide.leaves.push_back(index);
        return leaf_of(wide.leaves.size() - 1, tree[index].last - tree[index].first);
    };
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        const Children children = wide_children(tree, from);
        for (std::size_t i = 0; i < std::size_t(width_of_tree); ++i) {
            const bool used = i < children.count;
            set_bounds(wide.nodes[to], i, used ? tree[children.node[i]].box : Box3{}, size);
            const std::uint32_t child = used ? child_of(children.node[i]) : 0;
            wide.nodes[to].child[i] = child;
            if (used && !(child & leaf_bit)) open.emplace_back(children.node[i], child);
        }
    }
    return wide;
}

WideTree build_tree(std::span<const HierarchyTriangle> triangles, int threads) {
    if (triangles.empty()) return {};
    std::vector<Item> items(triangles.size());
    in_portions(items.size(), threads, [&](std::size_t i) { items[i] = item_of(triangles[i], i); });
    const BinaryTree tree = binary_tree(items, threads);
    Widened wide = widen(tree);
    WideTree result{std::move(wide.nodes), std::vector<TrianglePacket>(wide.leaves.size())};
    in_portions(wide.leaves.size(), threads, [&](std::size_t i) {
        const BinaryNode& leaf = tree[wide.leaves[i]];
        fill_packet(triangles, std::span(items).subspan(leaf.first, leaf.last - leaf.first),
                    result.packets[i]);
    });
    return result;
}

}  // namespace

Hierarchy::Hierarchy(std::span<const HierarchyTriangle> triangles, int threads)
    : tree_(build_tree(triangles, threads)) {
    for (const HierarchyTriangle& t : triangles)
        for (const vec3& corner : t.corner)
            for (int k = 0; k < 3; ++k) size_ = std::max(size_, std::abs(corner[k]));
}

}  // namespace gw::raytrace
