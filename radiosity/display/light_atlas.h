// All pixmaps beside each other on a few pages, for programs that show light maps: each keeps the
// border of DisplayedPixmaps as its margin. Does not draw and does not write files.
#pragma once

#include "radiosity/display/displayed_pixmaps.h"

#include <cstddef>
#include <vector>

namespace gw::radiosity {

struct AtlasPage {
    int width = 0, height = 0;
};

/// The lower left texel of a pixmap's border on its page.
struct AtlasPlace {
    std::size_t page = 0;
    int x = 0, y = 0;
};

struct LightAtlas {
    std::vector<AtlasPage> pages;
    std::vector<AtlasPlace> places;  ///< of each pixmap, by its number

    /// Texture coordinates on the page, 0 .. 1, t upwards, of texel coordinates in the pixmap.
    vec2 st_of(std::uint32_t pixmap, const dvec2& uv) const;
};

/// No two pixmaps share a texel, nor their borders. Pages have sides of at most `most_side` texels,
/// unless a pixmap with its border is larger.
LightAtlas make_atlas(const PixmapModel& model, int most_side = 4096);

/// R, G, B of each texel of a page, bottom row first; 0 between pixmaps.
std::vector<float> page_colors(const LightAtlas& atlas, std::size_t page, const PixmapModel& model,
                               const DisplayedPixmaps& colors);

/// An object's triangles that lie on one page, each with corners of its own, in the world.
struct AtlasMesh {
    std::uint32_t object = 0;  ///< of the scene that the model was made of
    std::size_t page = 0;
    std::vector<vec3> positions;
    std::vector<vec2> st;         ///< on the page
    std::vector<vec2> texcoords;  ///< the object's own; 0 if it has none
};
std::vector<AtlasMesh> atlas_meshes(const LightAtlas& atlas, const scene::Scene& scene,
                                    const PixmapModel& model);

}  // namespace gw::radiosity
