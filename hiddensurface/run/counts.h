// What every algorithm counts, and means the same by. docs/lecture.md explains each.
// Does not count fragments itself: the machine does.
#pragma once

#include <cstdint>
#include <span>

namespace gw::hiddensurface {

struct Counts {
    std::uint64_t polygons = 0;  ///< in the window
    // Comparisons by kind, one for each question asked.
    std::uint64_t facings = 0;    ///< signs of D_f, of a polygon or of a plane seen from the eye
    std::uint64_t keys = 0;       ///< two distances of representative points, in a sort
    std::uint64_t extents = 0;    ///< two intervals in x, y or z
    std::uint64_t planes = 0;     ///< a polygon against a plane
    std::uint64_t overlaps = 0;   ///< two projections, or one and a window
    std::uint64_t crossings = 0;  ///< two ends of segments in x, in a sort
    std::uint64_t depths = 0;     ///< two depths at a pixel
    std::uint64_t rays = 0;       ///< a ray against a polygon
    // Work.
    /// swaps: neighbours exchanged, or polygons moved in the list
    std::uint64_t sorts = 0, swaps = 0;
    std::uint64_t splits = 0;     ///< polygons cut in two
    std::uint64_t undecided = 0;  ///< pairs for which no test and no cut gave an order
    std::uint64_t rejected = 0;   ///< cubes, polygons or fragments found hidden as a whole
    /// of a tree, of windows too; fragments of pixels, polygons seen
    std::uint64_t nodes = 0;
    std::uint64_t spans = 0;  ///< runs of pixels worked out
    /// memory beside the scene and the frame buffer, at most
    std::uint64_t peak_bytes = 0;
    // Of the machine.
    std::uint64_t fragments = 0;  ///< made
    std::uint64_t passed = 0;     ///< every test
    std::uint64_t pixels = 0;     ///< that show a polygon in the end
    std::uint64_t overdraw = 0;   ///< passed - pixels
    // Pixels that differ from the Z-buffer's.
    std::uint64_t ties = 0;  ///< the depth plane cannot tell which is nearer
    /// the centre is within one sub-pixel unit of an edge made by splitting
    std::uint64_t edges = 0;
    /// right in the scene; the snap to the sub-pixel grid turned the two over
    std::uint64_t snapped = 0;
    std::uint64_t wrong = 0;  ///< the others
    bool operator==(const Counts&) const = default;
};

struct CountName {
    const char* name;
    std::uint64_t Counts::*count;
};
/// All of them in this order, for tables, CSV and JSON.
std::span<const CountName> count_names();

}  // namespace gw::hiddensurface
