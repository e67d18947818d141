// The pass lists of the paper's two renderers, and the list of each component's image. Does not
// draw.
#pragma once

#include "gw/profile.h"
#include "multipass/passes/pass.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace gw::multipass {

enum class Renderer { Hardware, Multipass };

/// How translucent objects (d < 1) are ordered [K3.4]. Sorted: their polygons, far to near, by
/// their centroids. Unsorted: as the scene has them; wrong if they overlap. Layers: pixel by pixel,
/// exactly (translucency.h).
enum class Translucency { Sorted, Unsorted, Layers };

/// Eq. 1 in one pass [K2], or eq. 2 and 4 component by component [K3, K3.2]. Includes the
/// translucent passes [K3.4] and the fog [K3.5] that the scene needs. If the scene's background is
/// not black, the depth pass also draws all shapes black: components are added to it.
PassList passes_for(const scene::Scene& scene, Renderer renderer,
                    Translucency translucency = Translucency::Sorted);

bool has_translucent(const scene::Scene& scene);

/// How often the glare pass is repeated [K3.3]: often enough that no part of an emitter's Ke times
/// strength is more than 1. 0: no object has glare.
int glare_images(const scene::Scene& scene);

/// A component's image (Fig. 4): its name and the passes that draw it alone.
struct ComponentList {
    std::string name;
    PassList passes;
    bool background = false;  ///< on the scene's background; else on black
    bool difference = false;  ///< the image is this picture less the one before it in the list
};

/// One for each component pass, in order, repeated glare passes being one; first the base, if the picture without components is not
/// black. Their images, added with saturation, are the picture of the whole list bit for bit.
///
/// If all components are added, each list draws one component alone: the order changes no saturated
/// sum. If translucent objects dim the picture behind them, an image is the increase of the picture
/// by its component: dimmed, rounded and saturated as in the picture.
std::vector<ComponentList> component_lists(const scene::Scene& scene, const PassList& passes);

/// A component's picture (Fig. 4).
struct ComponentImage {
    std::string name;
    std::vector<Rgba> color;  ///< bottom row first
};
/// The images of the lists, whose pictures `draw` returns.
std::vector<ComponentImage> component_images(
    const std::vector<ComponentList>& lists,
    const std::function<std::vector<Rgba>(const ComponentList&)>& draw);
/// Their sum, saturated.
std::vector<Rgba> sum_of(const std::vector<ComponentImage>& images, const Profile& profile);

/// Throws Error if glare takes more images than an accumulation buffer for `most` has place for.
void check_glare(const scene::Scene& scene, const PassList& passes, int most);

/// Throws Error if one pass with all lights has more lights on an object than the profile allows in
/// a pass. The message names the limit and the multi-pass renderer, which has none [K3p].
void check_lights(const scene::Scene& scene, const PassList& passes, const Profile& profile);

}  // namespace gw::multipass
