// Textures with a square of texels for each triangle of a mesh: maps that a mesh's own coordinates
// cannot look up. Does not read pictures.
#pragma once

#include "scene/scene.h"
#include "scene/text/warnings.h"

#include <cstddef>
#include <vector>

namespace gw::scene {

/// Squares of texels, side by side, one for each triangle. The corners of a triangle are the middles of
/// three texels, so a bilinear filter reads no other patch; the margin is for smaller levels.
struct Patches {
    std::size_t side, columns = 1, rows = 1;

    Patches(std::size_t triangles, std::size_t side) : side(side) {
        while (columns * columns < triangles) columns *= 2;
        while (columns * rows < triangles) rows *= 2;
    }
    std::size_t width() const { return columns * side; }
    std::size_t height() const { return rows * side; }
    std::size_t margin() const { return side / 32; }
    /// From corner 0 to another one, in texels.
    double span() const { return double(side - 1 - 2 * margin()); }
    /// The first texel of a patch.
    std::size_t column(std::size_t triangle) const { return triangle % columns * side; }
    std::size_t row(std::size_t triangle) const { return triangle / columns * side; }
    /// The coordinates of corner 0, 1 or 2.
    vec2 st(std::size_t triangle, std::size_t corner) const {
        const double first = double(margin()) + 0.5;
        const double s = double(column(triangle)) + first + (corner == 1 ? span() : 0);
        const double t = double(row(triangle)) + first + (corner == 2 ? span() : 0);
        return {float(s / double(width())), float(t / double(height()))};
    }
};

/// The largest side, a power of two, with which the patches are at most 2048 texels wide and high and
/// `texels` in all; 0 if that is less than 4.
std::size_t patch_side(std::size_t triangles, std::size_t texels);

/// Where a map lies on a mesh whose own coordinates are those of patches.
struct PatchedLookup {
    Patches patches;
    std::vector<vec2> st;  ///< of each corner of each triangle
};

/// Each map with such a look-up becomes a texture of these patches. A texel is the mean of the map on
/// its square. Warns of a triangle with more than twice as many texels as a patch has.
void resample_patched(Scene& scene, Warnings& warnings);

}  // namespace gw::scene
