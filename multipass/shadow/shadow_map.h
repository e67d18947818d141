// Shadow maps [K3.2 a]: whether the light sees a visible point, by the light's own Z-buffer
// (Williams 1978). The machine draws the light's Z and the item buffer of the view; the host
// compares. Does not put the result into the stencil (shadow_passes.h), and needs no shadow
// texture: the VGX has none.
//
// The comparison does not use the visible point itself. It uses the point of the same face that the
// map sampled: the light's ray through the centre of the texel, cut with the plane of the item
// buffer's polygon. So even an oblique face does not shade itself. The bias covers rounding only.
// It is 2 units of Z, plus the slope of Z times a sixteenth of a texel: half a sub-pixel unit, by
// which snapping moves vertices. Besides, the point is lifted a quarter of a pixel towards the
// light.
#pragma once

#include "gw/command_list.h"
#include "gw/machine.h"
#include "multipass/steps/pass_model.h"
#include "scene/draw/view.h"
#include "scene/draw/world_triangles.h"

#include <cstdint>
#include <vector>

namespace gw::multipass {

/// The Z-buffer of a light, or of one of the six faces of its surroundings.
struct ShadowMap {
    scene::View view;                  ///< size x size texels
    std::vector<std::uint32_t> depth;  ///< bottom row first
};

/// The views from which a light's maps are drawn. Directional lights (for the whole scene) and
/// spots of at most 60 degrees to the side have one; others have six. They begin at a 4096th of the
/// bounds' farthest distance.
std::vector<scene::View> light_views(const scene::Light& light, const scene::Bounds& bounds,
                                     int size);
/// The same, but for views that begin nearer if an object of the scene that casts a shadow needs it,
/// down to a 65536th.
std::vector<scene::View> light_views(const scene::Light& light, const scene::Scene& scene,
                                     int size);

/// The side of the maps for a window: the power of two that is at least twice its longer side, at
/// most 4096.
int shadow_map_size(int width, int height);

/// Draws the Z of all parts that cast shadows from these views and reads it back, in several
/// windows if the maps are larger. Each window gets the parts that may be in it; empty ones are not
/// drawn.
std::vector<ShadowMap> draw_shadow_maps(Machine& machine, const PassModel& model,
                                        const std::vector<scene::View>& views, int width,
                                        int height);

}  // namespace gw::multipass
