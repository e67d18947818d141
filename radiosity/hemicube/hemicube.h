// The hemicube's five ID buffers [F2.2], drawn by the machine with the figures themselves, and the
// form factors of its pixels.
// Does not map pixels to texels (scan.h does).
#pragma once

#include "gw/machine.h"
#include "radiosity/model/pixmap_model.h"
#include "radiosity/model/points.h"
#include "scene/draw/view.h"

#include <memory>
#include <span>
#include <vector>

namespace gw::radiosity {

inline constexpr int hemicube_faces = 5;  ///< the top first, then the sides

/// Five views from a point, turned about its normal: the horizon is the middle row of each side.
struct Hemicube {
    dvec3 position{0}, normal{0};
    std::array<scene::View, hemicube_faces> views;
};

/// `turn` in degrees. Nothing nearer than `near_plane` is seen.
Hemicube hemicube_at(const dvec3& position, const dvec3& normal, double turn, double near_plane,
                     double far_plane, int size);

/// The pixels of a face, as the machine reads them back: packed colours. Their low 24 bits are the
/// identifier, facet + 1, or 0 for no facet. Rows from the bottom; of a side only those over the
/// horizon.
struct IdBuffer {
    int size = 0, rows = 0;
    CacheAlignedVector<std::uint32_t> pixels;
    std::vector<char> present;  ///< by identifier: whether any pixel has it
};
/// A pixel that sees nothing, and one that sees a facet.
inline constexpr std::uint32_t nothing = 0;
constexpr std::uint32_t pixel_of(std::uint32_t facet) { return 0xFF000000 | (facet + 1); }
/// present[id] becomes 1 for the identifier, the low 24 bits, of every packed colour; `row` is the
/// number of pixels in a row.
void mark_present_ids(std::span<const std::uint32_t> pixels, std::size_t row, char* present);
using IdBuffers = std::array<IdBuffer, hemicube_faces>;

/// Draws with a machine of its own, the fast one if none is given. Not for two threads at a time.
class HemicubePainter {
public:
    /// size x size pixels, even, 2 .. max_window_size.
    explicit HemicubePainter(int size);
    /// On a machine of id_profile(), square.
    explicit HemicubePainter(std::unique_ptr<Machine> machine);
    void draw(const PixmapModel& model, const Hemicube& hemicube, IdBuffers& buffers);

private:
    std::unique_ptr<Machine> machine_;
};

/// The machine that ID buffers are drawn with: ideal's 8 sub-pixel bits and 32 bits of Z, 8 bits of
/// colour.
Profile id_profile();

/// The form factor of every pixel of a hemicube: the exact integral of cos / (pi r^2) over the pixel,
/// in closed form. The hemicube has side 2 around a point: top at distance 1, sides 1 high. `size`
/// pixels across, even. Rows from the horizon up (sides) or from one side to the other
/// (top).
struct DeltaFormFactors {
    int size = 0;
    std::vector<double> top;   ///< size x size
    std::vector<double> side;  ///< size x size / 2: all four sides are alike
};

DeltaFormFactors delta_form_factors(int size);

}  // namespace gw::radiosity
