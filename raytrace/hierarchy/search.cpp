// A ray against eight boxes, or eight triangles, at a time. No fused or approximate operation:
// every target gives the same bits.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/hierarchy/search.cpp"
#include <hwy/foreach_target.h>

#include "raytrace/hierarchy/hierarchy.h"

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace gw::raytrace::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, width_of_tree>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

inline V load(const float* p) { return hn::Load(D(), p); }
inline V all(float v) { return hn::Set(D(), v); }

/// Bit i of the result: lane i.
inline unsigned bits_of(M mask) {
#if HWY_TARGET == HWY_WASM  // Highway before 1.1 goes through memory
    return unsigned(wasm_i32x4_bitmask(mask.raw));
#else
    alignas(8) std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    return bytes[0];
#endif
}

/// Values computed once a ray.
struct Prepared {
    float low, high;           ///< high shrinks to the nearest hit
    float origin[3], over[3];  ///< over: 1 / direction, finite
    int near_side[3];          ///< of a box: 0 low, 1 high
    int kx, ky, kz;            ///< z: the direction's longest axis
    float sx, sy, sz;          ///< shear that turns the direction into +z
    std::uint32_t skip;
};

/// The margin of the boxes: more than three roundings here and those of a triangle's t.
constexpr float margin = 1.0f + 0x1p-18f;

/// The first of the longest, without branches, which would be taken at random.
inline int longest_axis(const vec3& v) {
    const float x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    const int of_xy = int(y > x), is_z = int(z > std::max(x, y));
    return of_xy * (1 - is_z) + 2 * is_z;
}

inline Prepared prepare(const HierarchyRay& ray) {
    Prepared r;
    r.low = ray.low;
    r.high = ray.high;
    r.skip = ray.skip;
    for (int k = 0; k < 3; ++k) {
        const float d = ray.direction[k];
        r.origin[k] = ray.origin[k];
        r.near_side[k] = std::signbit(d) ? 1 : 0;
        r.over[k] = 1.0f / (std::abs(d) < 1e-18f ? std::copysign(1e-18f, d) : d);
    }
    r.kz = longest_axis(ray.direction);
    r.kx = r.kz == 2 ? 0 : r.kz + 1;
    r.ky = r.kz == 0 ? 2 : r.kz - 1;
    const float dz = ray.direction[r.kz];
    r.sx = ray.direction[r.kx] / dz;
    r.sy = ray.direction[r.ky] / dz;
    r.sz = 1.0f / dz;
    return r;
}

/// The same in all lanes, for boxes; over_far with the margin.
struct InLanes {
    V low, origin[3], over[3], over_far[3];
};

inline InLanes in_lanes(const Prepared& r) {
    InLanes lanes;
    lanes.low = all(r.low);
    for (int k = 0; k < 3; ++k) {
        lanes.origin[k] = all(r.origin[k]);
        lanes.over[k] = all(r.over[k]);
        lanes.over_far[k] = all(r.over[k] * margin);
    }
    return lanes;
}

/// The boxes met: a bit for each, and where the ray enters them.
inline unsigned meet_boxes(const WideNode& node, const Prepared& r, const InLanes& lanes,
                           float* enter) {
    const D d;
    const V high = all(r.high * margin);
    unsigned met = 0;
    for (int i = 0; i < width_of_tree; i += int(hn::Lanes(d))) {
        V near[3], far[3];
        for (int k = 0; k < 3; ++k) {
            const int side = r.near_side[k];
            near[k] =
                hn::Mul(hn::Sub(load(node.bound[k][side] + i), lanes.origin[k]), lanes.over[k]);
            far[k] = hn::Mul(hn::Sub(load(node.bound[k][1 - side] + i), lanes.origin[k]),
                             lanes.over_far[k]);
        }
        const V from = hn::Max(hn::Max(near[0], near[1]), hn::Max(near[2], lanes.low));
        const V to = hn::Min(hn::Min(far[0], far[1]), hn::Min(far[2], high));
        hn::Store(from, d, enter + i);
        met |= bits_of(hn::Le(from, to)) << i;
    }
    return met;
}

/// Edge functions of one triangle whose float values were 0: products of float32 are exact in
/// double, so that the difference has the right sign.
inline void edges_in_double(const float* x, const float* y, float* edge) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        edge[i] = float(double(x[k]) * double(y[j]) - double(y[k]) * double(x[j]));
    }
}

/// Tests one triangle again, in double because an edge function is 0. Returns whether it is met,
/// and t.
inline bool meet_again(const V* x, const V* y, const V* z, const V* edge, int lane, float& t) {
    alignas(32) float lanes[width_of_tree];
    float fx[3], fy[3], fz[3], e[3];
    const auto take = [&](V v) {
        hn::Store(v, D(), lanes);
        return lanes[lane];
    };
    for (int c = 0; c < 3; ++c)
        fx[c] = take(x[c]), fy[c] = take(y[c]), fz[c] = take(z[c]), e[c] = take(edge[c]);
    if (e[0] == 0 || e[1] == 0 || e[2] == 0) edges_in_double(fx, fy, e);
    if ((e[0] < 0 || e[1] < 0 || e[2] < 0) && (e[0] > 0 || e[1] > 0 || e[2] > 0)) return false;
    const float sum = (e[0] + e[1]) + e[2];
    if (sum == 0) return false;
    t = ((e[0] * fz[0] + e[1] * fz[1]) + e[2] * fz[2]) / sum;
    return true;
}

/// Woop, Benthin, Wald 2013. Shrinks r.high and sets `found` to the nearest so far; any: the first
/// will do.
template <bool any>
inline bool meet_triangles(const TrianglePacket& packet, int count, Prepared& r,
                           HierarchyHit& found) {
    const D d;
    const V zero = hn::Zero(d);
    for (int i = 0; i < count; i += int(hn::Lanes(d))) {
        V x[3], y[3], z[3];
        for (int c = 0; c < 3; ++c) {
            const V along = hn::Sub(load(packet.corner[c][r.kz] + i), all(r.origin[r.kz]));
            x[c] = hn::Sub(hn::Sub(load(packet.corner[c][r.kx] + i), all(r.origin[r.kx])),
                           hn::Mul(all(r.sx), along));
            y[c] = hn::Sub(hn::Sub(load(packet.corner[c][r.ky] + i), all(r.origin[r.ky])),
                           hn::Mul(all(r.sy), along));
            z[c] = hn::Mul(all(r.sz), along);
        }
        const auto edge_of = [&](int a, int b) {
            return hn::Sub(hn::Mul(x[b], y[a]), hn::Mul(y[b], x[a]));
        };
        const V edge[3] = {edge_of(1, 2), edge_of(2, 0), edge_of(0, 1)};
        const V least = hn::Min(edge[0], hn::Min(edge[1], edge[2]));
        const V most = hn::Max(edge[0], hn::Max(edge[1], edge[2]));
        unsigned met = bits_of(hn::Or(hn::Ge(least, zero), hn::Le(most, zero)));
        met &= (1u << (count - i)) - 1;
        if (met == 0) continue;
        const V sum = hn::Add(hn::Add(edge[0], edge[1]), edge[2]);
        const V scaled = hn::Add(hn::Add(hn::Mul(edge[0], z[0]), hn::Mul(edge[1], z[1])),
                                 hn::Mul(edge[2], z[2]));
        alignas(32) float t_of[width_of_tree];
        hn::Store(hn::Div(scaled, sum), d, t_of);
        const auto is_zero = [&](const V& e) { return hn::Eq(e, zero); };
        const unsigned on_edge =
            met & bits_of(hn::Or(is_zero(edge[0]), hn::Or(is_zero(edge[1]), is_zero(edge[2]))));
        for (; met != 0; met &= met - 1) {
            const int lane = std::countr_zero(met);
            float t = t_of[lane];
            if ((on_edge >> lane & 1) && !meet_again(x, y, z, edge, lane, t)) continue;
            const std::size_t at = std::size_t(i + lane);
            if (!(t > r.low) || packet.number[at] == r.skip) continue;
            if constexpr (any) {
                if (t < r.high) return true;
            } else if (t < r.high || (t == r.high && packet.triangle[at] < found.triangle &&
                                      found.triangle != no_triangle)) {
                r.high = t;
                found = {t, packet.triangle[at]};
            }
        }
    }
    return false;
}

/// Gives the triangles to the test that the ray meets, or passes by no more than `rounding`.
/// Shrinks r.high; it is less than r.low when no triangle matters any more.
inline void find_triangles(const TrianglePacket& packet, int count, Prepared& r, float rounding,
                           TriangleTest& test) {
    const D d;
    for (int i = 0; i < count; i += int(hn::Lanes(d))) {
        V x[3], y[3], sum = hn::Zero(d);
        for (int c = 0; c < 3; ++c) {
            const V along = hn::Sub(load(packet.corner[c][r.kz] + i), all(r.origin[r.kz]));
            x[c] = hn::Sub(hn::Sub(load(packet.corner[c][r.kx] + i), all(r.origin[r.kx])),
                           hn::Mul(all(r.sx), along));
            y[c] = hn::Sub(hn::Sub(load(packet.corner[c][r.ky] + i), all(r.origin[r.ky])),
                           hn::Mul(all(r.sy), along));
            sum = hn::Add(sum, hn::Add(hn::Abs(x[c]), hn::Abs(y[c])));
        }
        const auto edge_of = [&](int a, int b) {
            return hn::Sub(hn::Mul(x[b], y[a]), hn::Mul(y[b], x[a]));
        };
        const V edge[3] = {edge_of(1, 2), edge_of(2, 0), edge_of(0, 1)};
        const V least = hn::Min(edge[0], hn::Min(edge[1], edge[2]));
        const V most = hn::Max(edge[0], hn::Max(edge[1], edge[2]));
        const V slack = hn::Mul(sum, all(rounding));
        unsigned met = bits_of(hn::Or(hn::Ge(least, hn::Neg(slack)), hn::Le(most, slack)));
        met &= (1u << (count - i)) - 1;
        for (; met != 0; met &= met - 1) {
            const std::size_t at = std::size_t(i + std::countr_zero(met));
            if (packet.number[at] == r.skip) continue;
            r.high = test.test(packet.number[at]);
            if (r.high < r.low) return;
        }
    }
}

/// A child to visit, and where the ray enters it.
struct Visit {
    std::uint32_t child;
    float enter;
};

/// Every level leaves at most seven children behind.
constexpr int stack_size = deepest * (width_of_tree - 1) + 1;

/// Children to visit later, the next one last.
struct TraversalStack {
    Visit visit[stack_size];
    int count = 0;

    void add(const WideNode& node, int i, const float* enter) {
        visit[count++] = {node.child[i], enter[i]};
    }
    /// Before those from `bottom` on that the ray enters earlier.
    void add_in_order(const WideNode& node, int i, const float* enter, int bottom) {
        int at = count++;
        for (; at > bottom && visit[at - 1].enter < enter[i]; --at) visit[at] = visit[at - 1];
        visit[at] = {node.child[i], enter[i]};
    }
};

/// The child to visit next, of those met, which are one at least; the others are visited later, the
/// nearest first. Mostly there are one or two.
inline std::uint32_t nearest_child(const WideNode& node, unsigned met, const float* enter,
                                   TraversalStack& stack) {
    const int first = std::countr_zero(met);
    met &= met - 1;
    if (met == 0) return node.child[first];
    const int second = std::countr_zero(met);
    met &= met - 1;
    if (met == 0) {
        if (enter[second] < enter[first]) {
            stack.add(node, first, enter);
            return node.child[second];
        }
        stack.add(node, second, enter);
        return node.child[first];
    }
    const int bottom = stack.count;
    stack.add(node, first, enter);
    stack.add_in_order(node, second, enter, bottom);
    for (; met != 0; met &= met - 1) stack.add_in_order(node, std::countr_zero(met), enter, bottom);
    return stack.visit[--stack.count].child;
}

/// The same in any order.
inline std::uint32_t last_child(const WideNode& node, unsigned met, const float* enter,
                                TraversalStack& stack) {
    int last = std::countr_zero(met);
    for (met &= met - 1; met != 0; met &= met - 1) {
        stack.add(node, last, enter);
        last = std::countr_zero(met);
    }
    return node.child[last];
}

template <bool any>
inline HierarchyHit search(const WideTree& tree, const HierarchyRay& ray) {
    HierarchyHit found{0, no_triangle};
    if (tree.nodes.empty()) return found;
    Prepared r = prepare(ray);
    const InLanes lanes = in_lanes(r);
    alignas(32) float enter[width_of_tree];
    TraversalStack stack;
    std::uint32_t child = 0;
    for (;;) {
        if (child & leaf_bit) {
            if (meet_triangles<any>(tree.packets[packet_of_leaf(child)], count_of_leaf(child), r,
                                    found))
                return {0, 0};
        } else {
            const WideNode& node = tree.nodes[child];
            if (const unsigned met = meet_boxes(node, r, lanes, enter); met != 0) {
                child = any ? last_child(node, met, enter, stack)
                            : nearest_child(node, met, enter, stack);
                continue;
            }
        }
        do {
            if (stack.count == 0) return found;
            --stack.count;
        } while (!any && stack.visit[stack.count].enter > r.high * margin);
        child = stack.visit[stack.count].child;
    }
}

void find(const WideTree& tree, const HierarchyRay& ray, float rounding, TriangleTest& test) {
    if (tree.nodes.empty()) return;
    Prepared r = prepare(ray);
    const InLanes lanes = in_lanes(r);
    alignas(32) float enter[width_of_tree];
    TraversalStack stack;
    std::uint32_t child = 0;
    for (;;) {
        if (child & leaf_bit) {
            test.counts.triangles += std::uint64_t(count_of_leaf(child));
            find_triangles(tree.packets[packet_of_leaf(child)], count_of_leaf(child), r, rounding,
                           test);
            if (r.high < r.low) return;
        } else {
            test.counts.boxes += width_of_tree;
            const WideNode& node = tree.nodes[child];
            if (const unsigned met = meet_boxes(node, r, lanes, enter); met != 0) {
                child = nearest_child(node, met, enter, stack);
                continue;
            }
        }
        do {
            if (stack.count == 0) return;
            --stack.count;
        } while (stack.visit[stack.count].enter > r.high * margin);
        child = stack.visit[stack.count].child;
    }
}

HierarchyHit nearest(const WideTree& tree, const HierarchyRay& ray) {
    return search<false>(tree, ray);
}
bool any(const WideTree& tree, const HierarchyRay& ray) {
    return search<true>(tree, ray).triangle != no_triangle;
}

}  // namespace gw::raytrace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace gw::raytrace {

HWY_EXPORT(find);
HWY_EXPORT(nearest);
HWY_EXPORT(any);

std::optional<HierarchyHit> Hierarchy::nearest(const HierarchyRay& ray) const {
    const HierarchyHit hit = HWY_DYNAMIC_DISPATCH(nearest)(tree_, ray);
    if (hit.triangle == no_triangle) return std::nullopt;
    return hit;
}

void Hierarchy::find(const HierarchyRay& ray, TriangleTest& test) const {
    // Of corners and rays, after the shear, which makes coordinates at most three times as large.
    float size = size_;
    for (int k = 0; k < 3; ++k) size = std::max(size, std::abs(ray.origin[k]));
    HWY_DYNAMIC_DISPATCH(find)(tree_, ray, size * 0x1p-20f, test);
}

bool Hierarchy::occluded(const HierarchyRay& ray) const {
    return HWY_DYNAMIC_DISPATCH(any)(tree_, ray);
}

}  // namespace gw::raytrace

#endif  // HWY_ONCE
