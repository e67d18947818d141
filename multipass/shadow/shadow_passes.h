// Shadow volumes counted in the stencil buffer [K3.2 b]: afterwards exactly the lit pixels have
// stencil 0. Does not make the volumes (shadow_volume.h) and does not draw light.
//
// The count of a pixel is the number of volumes around the visible point: faces behind it (Z
// compare fails) that lead out of a volume, less those that lead in. So the eye may be inside a
// volume, and the near plane may cut one. The view's far plane lies behind all volumes (enclosing).
//
// If the eye is surely outside a volume (is_outside), faces in front of the visible point give the
// same count: those that lead in, less those that lead out. For all faces of a closed surface add
// up to 0 on every pixel. No cap is in front: the front cap has the Z of the body itself, and the
// far cap lies beyond everything. So only the sides are drawn. Pixels of the background become 0.
//
// The VGX has neither wrapping operations nor two-sided stencil: all increments come first, then
// all decrements, so no count saturates at 0. A count that reaches the largest stencil value may
// have lost increments: a pass whose name ends with overflow_suffix counts those pixels for the
// driver.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "multipass/shadow/shadow_volume.h"
#include "multipass/steps/placed_model.h"

#include <span>
#include <string>
#include <vector>

namespace gw::multipass {

struct CountRules {
    int stencil_bits = 8;
    /// The Z-buffer holds every body that casts a shadow: volumes that the eye is outside of are
    /// counted in front. Not with `one_by_one`.
    bool in_front = false;
    bool zero_or_one = false;  ///< counts become 0 or 1 in the end
    /// Counts become 0 or 1 after every volume: only a single volume can be too deep.
    bool one_by_one = false;
};

/// The stencil of one light. Volumes are by part.
void add_shadow_volumes(CommandList& list, const PlacedModel& placed, const std::string& name,
                        const std::vector<ShadowVolume>& volumes, const CountRules& rules);

/// Ends the names of passes whose `written` counts pixels that may have overflowed.
inline constexpr std::string_view overflow_suffix = " overflow";
bool any_overflow(std::span<const PassReport> passes);

/// The stencil of one light from the host: a value per pixel, bottom row first.
void add_shadow_mask(CommandList& list, const PlacedModel& placed, const std::string& name,
                     const std::vector<std::uint32_t>& mask);

}  // namespace gw::multipass
