// The hierarchy of bounding volumes [L12]: triangles in a tree of eight children a node, tested by
// vectors. The result is the nearest triangle that the ray meets, of equally near ones the one with
// the smallest number. It does not depend on the vectors' width or the number of threads. Does not
// know scenes (world.h) and does not shade.
//
// The watertight test of Woop, Benthin and Wald 2013 decides for every triangle whether the ray
// meets it: the sign of each edge function is exact, so triangles that share a side leave no gap.
// Boxes have a margin wider than the rounding of both tests (Ize 2013), so the tree excludes no
// hit.
#pragma once

#include "raytrace/hierarchy/wide_tree.h"

#include <cstdint>
#include <optional>
#include <span>

namespace gw::raytrace {

/// A triangle, world space. A ray passes through triangles whose `number` it skips.
struct HierarchyTriangle {
    std::array<vec3, 3> corner;
    std::uint32_t number = 0;
};

inline constexpr std::uint32_t no_triangle = 0xffffffffu;

/// Meets triangles at low < t < high of origin + t direction, except those of number `skip`.
struct HierarchyRay {
    vec3 origin{0};
    float low = 0;
    vec3 direction{0};  ///< of any length but 0
    float high = 0;
    std::uint32_t skip = no_triangle;
};

struct HierarchyHit {
    float t = 0;
    std::uint32_t triangle = 0;  ///< index into the triangles that the hierarchy was made of
    bool operator==(const HierarchyHit&) const = default;
};

/// The work of searches [K4f]: the same for any vectors and number of threads.
struct SearchCounts {
    std::uint64_t boxes = 0;      ///< tested: eight a node, unused ones too
    std::uint64_t triangles = 0;  ///< tested in float32
    bool operator==(const SearchCounts&) const = default;
};

/// Decides about triangles that float32 cannot exclude: see Hierarchy::find.
class TriangleTest {
public:
    virtual ~TriangleTest() = default;
    /// Tests the triangle of this number, and remembers the nearest. Returns the t beyond which
    /// hits are ignored; negative: the search ends.
    virtual float test(std::uint32_t number) = 0;

    SearchCounts counts;  ///< of all searches with this test
};

class Hierarchy {
public:
    Hierarchy() = default;
    /// Corners are finite. Built by the surface area heuristic in bins (Wald 2007); `threads` as in
    /// parallel_for.
    explicit Hierarchy(std::span<const HierarchyTriangle> triangles, int threads = 0);

    std::optional<HierarchyHit> nearest(const HierarchyRay& ray) const;
    /// Whether the ray meets anything at all: for shadows.
    bool occluded(const HierarchyRay& ray) const;

    /// Gives every triangle to the test that the ray may meet if its numbers, and the triangle's
    /// corners, are rounded to float32. The order of triangles is not specified.
    void find(const HierarchyRay& ray, TriangleTest& test) const;

    const WideTree& tree() const { return tree_; }

private:
    WideTree tree_;
    float size_ = 0;  ///< the largest coordinate
};

}  // namespace gw::raytrace
