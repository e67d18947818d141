// The plane of a map's texels, divided into pieces of one level of opacity each. Between the middles of
// four texels lie four triangles around their mean, and opacity is linear on each. Does not know
// meshes.
#pragma once

#include "gw/base/types.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gw::scene {

/// Opacity in steps: `bounds` ascend, and level k reaches from bounds[k - 1] up to bounds[k].
struct OpacityLevels {
    std::vector<double> bounds;
    std::vector<double> values;  ///< of each level; one more than there are bounds

    std::size_t of(double opacity) const;
};
/// 0 below the cutoff, 1 from there on.
OpacityLevels mask_levels(double cutoff);
/// Sixteenths, to nearest.
OpacityLevels blend_levels();

/// A function of the plane: at 0, and its change with u and v.
struct Slope {
    double at_0 = 1, u = 0, v = 0;
    double at(const dvec2& p) const { return at_0 + (u * p.x + v * p.y); }
};

/// Convex.
struct OpacityPiece {
    std::vector<dvec2> corners;
    std::size_t level = 0;
};

/// A corner of a triangle on which opacity is linear.
struct OpacityCorner {
    dvec2 p{0};
    double opacity = 0;
};
/// Adds the triangle's parts of each level.
void add_pieces(const std::array<OpacityCorner, 3>& triangle, const OpacityLevels& levels,
                std::vector<OpacityPiece>& pieces);

/// The alpha of a map's texels, repeated as the map says. The middle of texel i, j is at (i, j).
class OpacityPlane {
public:
    /// The map must have a texture and outlive the plane.
    explicit OpacityPlane(const Map& map);

    /// From texture coordinates of a mesh, with the map's scale and offset.
    dvec2 at_texcoord(const vec2& st) const;
    double texel(std::int64_t i, std::int64_t j) const;

    /// Adds the pieces that cover a triangle, and more around it: squares of one level and parts of
    /// cells between texels. On lines through the middles of texels, pieces meet others' sides.
    /// `factor` multiplies the alpha. False if they are more than `most`.
    bool add_pieces(const std::array<dvec2, 3>& triangle, const Slope& factor,
                    const OpacityLevels& levels, std::size_t most,
                    std::vector<OpacityPiece>& pieces) const;

private:
    const Map& map_;
    const TextureLevel& level_;
};

/// The part of a convex polygon where `inside` is not negative. `inside` is linear.
template <class Corner, class Inside, class Between>
std::vector<Corner> clipped(const std::vector<Corner>& corners, const Inside& inside,
                            const Between& between) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &p = corners[i], &q = corners[(i + 1) % corners.size()];
        const double a = inside(p), b = inside(q);
        if (a >= 0) kept.push_back(p);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(between(p, q, a / (a - b)));
    }
    return kept;
}
/// At t from p to q.
inline dvec2 between(const dvec2& p, const dvec2& q, double t) { return p + t * (q - p); }

}  // namespace gw::scene
