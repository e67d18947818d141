// Runs an algorithm on a machine and compares its picture with the Z-buffer's. Tells why a pixel
// differs: a tie of depths, an edge made by splitting, the snap, or a mistake. Does not write files.
#pragma once

#include "gw/machine.h"
#include "hiddensurface/interface/algorithm.h"

#include <map>

namespace gw::hiddensurface {

enum class Difference : std::uint8_t {
    None,
    Tie,   ///< the Z-buffer cannot tell: see depths_tie
    Edge,  ///< the centre is within one sub-pixel unit of an edge made by splitting one of the two
    Snap,  ///< in the scene the shown one is not behind; the snap exchanged them: see snap_turned
    Wrong
};

/// Whether the depth plane cannot tell that `shown` is not the nearer one at a pixel that both
/// cover. The stored depths are equal, or they are neighbours only by rounding: on the exact planes
/// through the snapped corners, `shown` is not behind `other`.
bool depths_tie(const WindowTriangle& shown, const WindowTriangle& other, int x, int y);

/// Compares pictures of identifiers pixel by pixel.
class Differences {
public:
    /// `pieces` were drawn, cut or whole. Refers to the input.
    Differences(const Input& input, const std::vector<Piece>& pieces);

    /// Why pixel x, y differs, at which the algorithm shows `id` and the Z-buffer `expected`.
    Difference at(std::uint32_t id, std::uint32_t expected, int x, int y) const;

    /// Whether the shown one is behind by so little that the planes of the two count as one for an
    /// algorithm that decides in the world (world_tolerance).
    bool in_one_plane(std::uint32_t id, std::uint32_t expected, int x, int y) const;

private:
    struct Known {
        const Polygon* polygon = nullptr;
        std::vector<CutEdge> made;  ///< by splitting it
    };
    /// Only an algorithm that decides in the world can have such pixels: a tree built before the
    /// view is known does not know the grid. Without the snap the shown one is not behind, or one of
    /// the two does not cover the centre. And the snapped depths differ by no more than moving every
    /// corner by half a unit can explain.
    bool snap_turned(std::uint32_t id, const WindowTriangle& shown, std::uint32_t expected,
                     const WindowTriangle& other, int x, int y) const;
    /// The depth drawn at a point is the scene's at another point, at most half a unit away in x and
    /// y. This bounds their difference by the slopes of the scene's plane. The snapped plane of a
    /// facet seen almost edge-on has far smaller slopes.
    double snap_reach(const WorldFacet& facet) const;
    const WorldFacet& facet_of(std::uint32_t id, const WindowTriangle& t) const;
    /// z on the grid at a point of the window, without the snap, of the surface moved towards the
    /// eye.
    double scene_depth(const WorldFacet& facet, const dvec2& at, double towards_eye) const;
    bool covers_in_scene(const WorldFacet& facet, const dvec2& at) const;
    dvec2 middle_of(int x, int y) const;
    const WindowTriangle* covering(std::uint32_t id, int x, int y) const;
    bool near_made_edge(std::uint32_t id, const dvec2& center) const;

    const Input& input_;
    double tolerance_ = 0;  ///< of planes in the world
    std::map<std::uint32_t, Known> known_;
};

/// Wrong pixels of polygons whose planes count as one.
struct OnePlane {
    std::uint64_t pixels = 0, pairs = 0;
    std::pair<std::uint32_t, std::uint32_t> first;  ///< identifiers: shown, expected
};

struct Result {
    Counts counts;                        ///< of the algorithm, the machine and the comparison
    std::vector<std::uint32_t> ids;       ///< bottom row first
    std::vector<std::uint8_t> writes;     ///< the number of writes of each pixel, at most 255
    std::vector<Difference> difference;   ///< as `ids`; empty: not compared
    std::vector<std::uint32_t> expected;  ///< the Z-buffer's ids; empty: not compared
    std::vector<Piece> pieces;
    std::vector<Share> shares;
    OnePlane one_plane;  ///< counted by compare
};

/// Runs the algorithm, executes its list on a machine of the view's size and reads the pixels. A
/// second execution with a counting stencil gives `writes`.
Result run_on(Machine& machine, const Algorithm& algorithm, const Input& input, StepLog& log);

/// Compares with the Z-buffer's identifiers and counts ties, edges, snapped and wrong pixels in
/// result.counts.
void compare(Result& result, const std::vector<std::uint32_t>& z_buffer, const Input& input);

/// For people: a pair, its objects, the tolerance. `algorithms`: their names, which decide in the world.
std::string one_plane_warning(const std::string& algorithms, const Input& input,
                              const OnePlane& found);

/// The depth complexity: the number of polygons over each pixel, visible or not, at most 255.
std::vector<std::uint8_t> depth_complexity(const Input& input);

/// The identifiers of all polygons over each pixel, visible or not, in the order of the scene. Pixels
/// are in rows, bottom row first.
std::vector<std::vector<std::uint32_t>> polygons_over(const Input& input);

}  // namespace gw::hiddensurface
