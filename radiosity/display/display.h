// Solved pixmaps as pictures [F2.3], drawn by the machine from any view without solving again: as
// textures, or as Gouraud-shaded triangle strips at the pixmaps' resolution. Does not write files;
// gamma is the output's.
#pragma once

#include "gw/command_list.h"
#include "radiosity/display/displayed_pixmaps.h"
#include "scene/draw/view.h"

#include <vector>

namespace gw::radiosity {

/// The frame buffer holds `scale` times the radiosity, clamped to 1. Sides of figures that do not
/// emit are not drawn. The colour plane is cleared to `background`.
struct Brightness {
    double scale = 1;
    vec3 background{0};
};

/// The scale that shows the scene's white as 1; 1 if its light has no unit.
inline double scale_of_white(const scene::Scene& scene) {
    return scene.white > 0 ? 1 / scene.white : 1;
}

/// Draws each pixmap as a bilinear texture, with the border of DisplayedPixmaps. In both lists the
/// identifier of a draw's polygons, shifted right by figure_shift, is its pixmap's number + 1. Drawn
/// with ColorSource::PolygonId (figures_of), the identifiers tell which figure a pixel shows.
CommandList texture_list(const PixmapModel& model, const DisplayedPixmaps& colors,
                         const scene::View& view, const Brightness& brightness);

/// Each triangle as one strip of rows, divided at least as finely as the pixmap (Fig. 4), colours
/// looked up bilinearly at the vertices. Triangles that share a side have the same vertices on it:
/// no gaps. Strips are made in parallel.
CommandList strip_list(const PixmapModel& model, const DisplayedPixmaps& colors,
                       const scene::View& view, const Brightness& brightness, int threads = 0);

inline constexpr int figure_shift = 20;
/// The list with identifiers in place of colours.
CommandList figures_of(CommandList list);

/// The texture of a pixmap, and the texture coordinates of texel coordinates.
TextureRef texture_of(const PixmapModel& model, std::uint32_t pixmap,
                      const DisplayedPixmaps& colors, double scale);
vec2 st_of(const Pixmap& pixmap, const dvec2& uv);

}  // namespace gw::radiosity
