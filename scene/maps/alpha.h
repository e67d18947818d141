// The alpha of textures. Does not read pictures.
#pragma once

#include "scene/scene.h"

#include <map>

namespace gw::scene {

/// The alphas of a texture's texels.
struct AlphaRange {
    double low = 1, high = 1, mean = 1;
    double between = 0;  ///< share of those from 1/16 to 15/16
    bool is_even() const { return low == high; }
    /// Whether it hides or shows, but for edges.
    bool is_mask() const { return low < high && between < 0.1; }
};
AlphaRange alpha_of(const Texture& texture);

/// Textures with alpha 1 in place of others, each made once.
class OpaqueTextures {
public:
    /// The texture itself if its alpha is 1, or if it is null.
    TextureRef of(const TextureRef& texture);

private:
    std::map<TextureRef, TextureRef> made_;
};

/// Puts what each map_d's channel chooses into the alpha of its texture.
void choose_opacity_channels(Scene& scene);

}  // namespace gw::scene
