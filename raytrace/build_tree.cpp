#include "raytrace/build_tree.h"

#include "gw/parallel.h"
#include "raytrace/box3.h"

#include <array>
#include <cmath>
#include <iterator>

namespace gw::raytrace {
namespace {

constexpr int bins = 16;
/// What a node costs where a packet costs 1.
constexpr float node_cost = 0.35f;
/// Ranges of at least this many triangles are halved before the threads begin.
constexpr std::size_t large = 1 << 13;

struct Item {
    Box3 box;
    vec3 center{0};
    std::uint32_t triangle = 0;
};

/// A node of the binary tree over items first .. last - 1; left = 0: a leaf.
struct BinaryNode {
    Box3 box, centers;
    std::size_t first = 0, last = 0;
    int depth = 0;
    std::uint32_t left = 0, right = 0;
};
using BinaryTree = std::vector<BinaryNode>;

Item item_of(const HierarchyTriangle& t, std::size_t index) {
    Item item{.triangle = static_cast<std::uint32_t>(index)};
    for (const vec3& c : t.corner) item.box.add(c);
    for (int k = 0; k < 3; ++k) item.center[k] = item.box.low[k] * 0.5f + item.box.high[k] * 0.5f;
    return item;
}

BinaryNode node_over(const std::vector<Item>& items, std::size_t first, std::size_t last, int depth) {
    BinaryNode node{.first = first, .last = last, .depth = depth};
    for (std::size_t i = first; i < last; ++i) {
        node.box.add(items[i].box);
        node.centers.add(items[i].center);
    }
    return node;
}

/// Where centres fall along an axis.
struct Bins {
    float low = 0, scale = 0;
    int of(float center) const { return std::min(bins - 1, static_cast<int>((center - low) * scale)); }
};

Bins bins_of(const Box3& centers, int axis) {
    const float extent = centers.high[axis] - centers.low[axis];
    return {centers.low[axis], extent > 0 ? float(bins) / extent : 0};
}

struct Split {
    float cost = std::numeric_limits<float>::infinity();  ///< area times packets, both sides
    int axis = 0, bin = 0;                                ///< bins up to `bin` go left
};

struct Sides {
    Box3 box;
    std::size_t count = 0;
    void add(const Sides& s) {
        box.add(s.box);
        count += s.count;
    }
    float cost() const { return box.area() * float((count + width_of_tree / 2 - 1) / (width_of_tree / 2)); }
};

using Histogram = std::array<Sides, bins>;

Split best_of_axis(const Histogram& h, int axis) {
    std::array<float, bins> right{};
    Sides sum;
    for (int b = bins - 1; b > 0; --b) {
        sum.add(h[std::size_t(b)]);
        right[std::size_t(b)] = sum.count ? sum.cost() : std::numeric_limits<float>::infinity();
    }
    Split best;
    Sides left;
    for (int b = 0; b + 1 < bins; ++b) {
        left.add(h[std::size_t(b)]);
        if (left.count == 0) continue;
        const float cost = left.cost() + right[std::size_t(b) + 1];
        if (cost < best.cost) best = {cost, axis, b};
    }
    return best;
}

Split best_split(const std::vector<Item>& items, const BinaryNode& node, const Box3& centers) {
    const std::array<Bins, 3> where{bins_of(centers, 0), bins_of(centers, 1), bins_of(centers, 2)};
    std::array<Histogram, 3> histogram;
    for (std::size_t i = node.first; i < node.last; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t a = std::size_t(axis);
            const auto bin = static_cast<std::size_t>(where[a].of(items[i].center[axis]));
            histogram[a][bin].box.add(items[i].box);
            histogram[a][bin].count += 1;
        }
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
        if (where[std::size_t(axis)].scale == 0) continue;
        const Split s = best_of_axis(histogram[std::size_t(axis)], axis);
        if (s.cost < best.cost) best = s;
    }
    return best;
}

/// Orders the node's items left side first; returns where the right side begins.
std::size_t divide(std::vector<Item>& items, const BinaryNode& node, const Box3& centers,
                   const Split& split) {
    const auto begin = items.begin() + std::ptrdiff_t(node.first),
               end = items.begin() + std::ptrdiff_t(node.last);
    if (!std::isfinite(split.cost)) return node.first + (node.last - node.first) / 2;
    const Bins where = bins_of(centers, split.axis);
    const auto middle = std::stable_partition(
        begin, end, [&](const Item& item) { return where.of(item.center[split.axis]) <= split.bin; });
    return std::size_t(middle - items.begin());
}

/// Halves tree[index] where that pays; returns whether it did.
bool halve(BinaryTree& tree, std::uint32_t index, std::vector<Item>& items) {
    const BinaryNode node = tree[index];
    const std::size_t count = node.last - node.first;
    if (count < 2) return false;
    const Split split = node.depth < deepest / 2 ? best_split(items, node, node.centers) : Split{};
    const float area = node.box.area();
    const bool pays =
        std::isfinite(split.cost) && node_cost * area + split.cost < Sides{node.box, count}.cost();
    if (count <= std::size_t(width_of_tree) && !pays) return false;
    const std::size_t middle = divide(items, node, node.centers, split);
    tree[index].left = static_cast<std::uint32_t>(tree.size());
    tree[index].right = tree[index].left + 1;
    tree.push_back(node_over(items, node.first, middle, node.depth + 1));
    tree.push_back(node_over(items, middle, node.last, node.depth + 1));
    return true;
}

/// Halves everything below tree[root] that has more than `enough` items.
void halve_all(BinaryTree& tree, std::uint32_t root, std::vector<Item>& items, std::size_t enough,
               std::vector<std::uint32_t>* left_over) {
    std::vector<std::uint32_t> open{root};
    while (!open.empty()) {
        const std::uint32_t index = open.back();
        open.pop_back();
        if (tree[index].last - tree[index].first <= enough) {
            if (left_over) left_over->push_back(index);
        } else if (halve(tree, index, items)) {
            open.push_back(tree[index].right);
            open.push_back(tree[index].left);
        }
    }
}

/// Puts a tree in place of one of its leaves.
void graft(BinaryTree& tree, std::uint32_t at, const BinaryTree& branch) {
    const auto offset = static_cast<std::uint32_t>(tree.size()) - 1;
    const auto moved = [offset](BinaryNode node) {
        if (node.left) node.left += offset, node.right += offset;
        return node;
    };
    tree[at] = moved(branch.front());
    for (std::size_t i = 1; i < branch.size(); ++i) tree.push_back(moved(branch[i]));
}

BinaryTree binary_tree(std::vector<Item>& items, int threads) {
    BinaryTree tree{node_over(items, 0, items.size(), 0)};
    std::vector<std::uint32_t> small;
    halve_all(tree, 0, items, large, &small);
    std::vector<BinaryTree> branches(small.size());
    parallel_for(small.size(), threads, [&](std::size_t i, int) {
        branches[i] = {tree[small[i]]};
        halve_all(branches[i], 0, items, 1, nullptr);
    });
    for (std::size_t i = 0; i < small.size(); ++i) graft(tree, small[i], branches[i]);
    return tree;
}

/// Up to eight descendants of a node, the largest opened first.
std::vector<std::uint32_t> wide_children(const BinaryTree& tree, std::uint32_t index) {
    std::vector<std::uint32_t> children{index};
    while (children.size() < std::size_t(width_of_tree)) {
        auto largest = children.end();
        for (auto c = children.begin(); c != children.end(); ++c)
            if (tree[*c].left &&
                (largest == children.end() || tree[*c].box.area() > tree[*largest].box.area()))
                largest = c;
        if (largest == children.end()) break;
        const BinaryNode& node = tree[*largest];
        *largest = node.left;
        children.insert(largest + 1, node.right);
    }
    return children;
}

/// Two units in the last place more on either side: a ray may run in a box's face.
void set_bounds(WideNode& node, std::size_t child, const Box3& box) {
    for (int axis = 0; axis < 3; ++axis) {
        const float low = box.low[axis], high = box.high[axis];
        const bool empty = low > high;
        node.bound[axis][0][child] = empty ? low : (low - std::abs(low) * 0x1p-22f) - 0x1p-100f;
        node.bound[axis][1][child] = empty ? high : (high + std::abs(high) * 0x1p-22f) + 0x1p-100f;
    }
}

TrianglePacket packet_of(std::span<const HierarchyTriangle> triangles, std::span<const Item> items) {
    TrianglePacket packet{};
    for (std::size_t i = 0; i < std::size_t(width_of_tree); ++i) {
        packet.triangle[i] = packet.polygon[i] = no_polygon;
        if (i >= items.size()) continue;
        const HierarchyTriangle& t = triangles[items[i].triangle];
        packet.triangle[i] = items[i].triangle;
        packet.polygon[i] = t.polygon;
        for (int c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis) packet.corner[c][axis][i] = t.corner[std::size_t(c)][axis];
    }
    return packet;
}

class Widener {
public:
    Widener(std::span<const HierarchyTriangle> triangles, const std::vector<Item>& items,
            const BinaryTree& tree)
        : triangles_(triangles), items_(items), tree_(tree) {}

    WideTree widen() {
        wide_.nodes.emplace_back();
        std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};  // binary node, its wide node
        while (!open.empty()) {
            const auto [from, to] = open.back();
            open.pop_back();
            const auto children = wide_children(tree_, from);
            for (std::size_t i = 0; i < std::size_t(width_of_tree); ++i) {
                set_bounds(wide_.nodes[to], i, i < children.size() ? tree_[children[i]].box : Box3{});
                wide_.nodes[to].child[i] = 0;
                if (i >= children.size()) continue;
                const std::uint32_t child = child_of(children[i]);
                wide_.nodes[to].child[i] = child;
                if (!(child & leaf_bit)) open.emplace_back(children[i], child);
            }
        }
        return std::move(wide_);
    }

private:
    std::uint32_t child_of(std::uint32_t index) {
        const BinaryNode& node = tree_[index];
        if (node.left) {
            wide_.nodes.emplace_back();
            return static_cast<std::uint32_t>(wide_.nodes.size() - 1);
        }
        wide_.packets.push_back(
            packet_of(triangles_, std::span(items_).subspan(node.first, node.last - node.first)));
        return leaf_of(wide_.packets.size() - 1, node.last - node.first);
    }

    std::span<const HierarchyTriangle> triangles_;
    const std::vector<Item>& items_;
    const BinaryTree& tree_;
    WideTree wide_;
};

}  // namespace

WideTree build_tree(std::span<const HierarchyTriangle> triangles, int threads) {
    if (triangles.empty()) return {};
    std::vector<Item> items(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) items[i] = item_of(triangles[i], i);
    const BinaryTree tree = binary_tree(items, threads);
    return Widener(triangles, items, tree).widen();
}

}  // namespace gw::raytrace
