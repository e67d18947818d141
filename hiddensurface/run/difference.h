// Why a pixel differs from the Z-buffer's: a tie of depths, an edge that splitting made, the snap,
// or wrong. Does not run algorithms.
#pragma once

#include "hiddensurface/run/algorithm.h"

#include <map>

namespace gw::hiddensurface {

enum class Difference : std::uint8_t {
    None,
    Tie,  ///< the Z-buffer cannot tell: see depths_tie
    /// the centre is within one sub-pixel unit of an edge that splitting made, of one of the two
    Edge,
    /// in the scene the shown one is not behind; the snap to the grid turned them over: see
    Snap,
    ///< snap_turned
    Wrong
};

/// Whether the depth plane cannot tell that `shown` is not the nearer one at a pixel that both
/// cover: the stored depths are equal, or they are neighbours by rounding only, for on the exact
/// planes through the snapped corners `shown` is not behind `other`.
bool depths_tie(const WindowTriangle& shown, const WindowTriangle& other, int x, int y);

/// Compares pictures of identifiers pixel by pixel.
class Differences {
public:
    /// `pieces`: what was drawn, cut or whole. Refers to the input.
    Differences(const Input& input, const std::vector<Piece>& pieces);

    /// At pixel x, y, where the algorithm shows `id` and the Z-buffer `expected`.
    Difference at(std::uint32_t id, std::uint32_t expected, int x, int y) const;

private:
    struct Known {
        const Polygon* polygon = nullptr;
        std::vector<CutEdge> made;  ///< by splitting it
    };
    /// Only an algorithm that decides in the world can have such pixels: a tree built before the
    /// view is known knows nothing of the grid. Without the snap the shown one is not behind, or
    /// one of the two does not cover the centre; and the snapped depths are no farther apart than
    /// half a unit at every corner moves.
    bool snap_turned(std::uint32_t id, const WindowTriangle& shown, std::uint32_t expected,
                     const WindowTriangle& other, int x, int y) const;
    /// The depth drawn at a point is the scene's at another point, half a unit away in x and in y
    /// at most. So this is how far the two are apart, by the slopes of the scene's plane: those of
    /// the snapped plane of a facet that is seen almost from its edge are far smaller.
    double snap_reach(const WorldFacet& facet) const;
    const WorldFacet& facet_of(std::uint32_t id, const WindowTriangle& t) const;
    /// z on the grid at a point of the window, without the snap; the surface moved towards the eye.
    double scene_depth(const WorldFacet& facet, const dvec2& at, double towards_eye) const;
    bool covers_in_scene(const WorldFacet& facet, const dvec2& at) const;
    dvec2 middle_of(int x, int y) const;
    const WindowTriangle* covering(std::uint32_t id, int x, int y) const;
    bool near_made_edge(std::uint32_t id, const dvec2& center) const;

    const Input& input_;
    double tolerance_ = 0;  ///< of planes in the world
    std::map<std::uint32_t, Known> known_;
};

}  // namespace gw::hiddensurface
