// Figures and their pixmaps [F2, F2.1], on which radiosity is computed. Plain data, world space.
// Holds no energy (solution.h does) and does not know how ST were found (figures.h does).
//
// A figure is a surface with one pixmap. It consists of facets: plane pieces on which ST are one
// affine map. So a pixel of an ID buffer maps to its texel by one homography. A planar figure is
// one facet, a curved one has a facet for each triangle. A texel is an element, a block of texels a
// patch. The geometry is never subdivided.
#pragma once

#include "gw/base/types.h"
#include "scene/scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gw::radiosity {

/// In texels: (0, 0) is the lower left corner of a pixmap, (width, height) the upper right one.
using Triangle2 = std::array<dvec2, 3>;

struct Facet {
    std::uint32_t pixmap = 0, figure = 0;
    dvec3 normal{0};                   ///< unit, on the side that emits
    double offset = 0;                 ///< dot3(normal, p) = offset on the plane
    dvec3 origin{0}, du{0}, dv{0};     ///< p = origin + u du + v dv
    dvec3 grad_u{0}, grad_v{0};        ///< u = dot3(grad_u, p - origin)
    double texel_area = 0;             ///< world area of one whole texel
    dvec2 low{0}, high{0};             ///< bounds in texels
    std::vector<Triangle2> triangles;  ///< in texels
    std::array<dvec3, 4> corners{};    ///< of the region that an ID buffer is scanned in [F2.2]
    int corner_count = 0;              ///< 3 or 4
    dvec3 center{0};                   ///< of a sphere around it
    double radius = 0;

    dvec3 at(const dvec2& uv) const { return origin + (uv.x * du + uv.y * dv); }
    dvec2 texel_of(const dvec3& p) const {
        return {dot3(grad_u, p - origin), dot3(grad_v, p - origin)};
    }
};

struct Pixmap {
    std::string name;
    int width = 0, height = 0;
    std::size_t first = 0;  ///< of its texels in the arrays of PixmapModel; row 0 is t = 0
    std::vector<std::uint32_t> facets;  ///< that lie in it, ascending
    bool whole = false;                 ///< every texel is an element
    std::size_t count() const { return std::size_t(width) * std::size_t(height); }
    /// Its number among all texels.
    std::size_t texel(int x, int y) const { return first + pixel_index(x, y, width); }
};

struct Figure {
    std::string name;          ///< its object's
    std::uint32_t object = 0;  ///< index into Scene::objects
    std::uint32_t pixmap = 0;
    dvec3 rho{0};  ///< scene::reflectance_of its material
    dvec3 E{0};    ///< emitted radiant exitance: the pixmap's emission, or the material's Ke
};

/// A block of texels, which shoots as a whole [F2].
struct Patch {
    std::uint32_t pixmap = 0;
    int x = 0, y = 0, width = 0, height = 0;
    double area = 0;
    bool emits = false;
};

inline constexpr std::uint32_t no_texel = 0xffffffff;

/// The source of a drawn object: an object of the scene, and the facet of each of its triangles.
struct Source {
    std::uint32_t object = 0;
    std::vector<std::uint32_t> facets;  ///< no_facet: no area
};
inline constexpr std::uint32_t no_facet = 0xffffffff;

/// The light that a lamp without area sends straight to the texels.
struct DirectLight {
    std::string name;      ///< of all lights of this name together
    std::vector<dvec3> H;  ///< irradiance of each texel
    dvec3 emitted{0};      ///< flux, all that the lamps send
    dvec3 escaped{0};      ///< flux that meets no texel
};

struct PixmapModel {
    std::vector<Figure> figures;
    std::vector<Facet> facets;
    std::vector<Pixmap> pixmaps;
    std::vector<Patch> patches;  ///< those with an area

    /// Of all texels of all pixmaps. A texel that no figure covers has area 0.
    std::vector<double> area, share;      ///< world area; the covered part of the texel, 0 .. 1
    std::vector<dvec3> rho, E;            ///< means over the figures that cover the texel
    std::vector<dvec3> middle;            ///< of the covered part, if the texel has an area
    std::vector<std::uint32_t> facet_of;  ///< that covers most of the texel; none: no_facet

    /// Elements [F2]: a texel at a figure's border, of which little is covered, receives light as
    /// one with its nearest neighbour. Light that falls on texel t goes to element nearest[t],
    /// which is named after its first texel; the others follow by next_of_element.
    std::vector<std::uint32_t> nearest, next_of_element;
    std::vector<double> element_area;  ///< at the first texel

    /// the figures for id_pass: polygon identifier = facet, world coordinates
    scene::Scene drawn;
    std::vector<Source> sources;  ///< of drawn.objects
    /// drawn's objects as one, for hemicubes: planned once, not once an object
    scene::Scene joined;
    std::vector<std::string> without_area;  ///< objects, which have no figure
    double extent = 0;                      ///< diagonal of the scene's bounds
    /// of lights in candela; empty until direct_light.h fills it in
    std::vector<DirectLight> direct;

    std::size_t texel_count() const { return area.size(); }
};

/// visit(number) of each texel.
template <class Visit>
void for_each_texel(const PixmapModel& model, const Patch& patch, Visit visit) {
    const Pixmap& pixmap = model.pixmaps[patch.pixmap];
    for (int y = patch.y; y < patch.y + patch.height; ++y)
        for (int x = patch.x; x < patch.x + patch.width; ++x) visit(pixmap.texel(x, y));
}

}  // namespace gw::radiosity
