// Shadow volumes counted in the stencil buffer [K3.2 b]: afterwards the stencil is 0 exactly where
// the light arrives. Does not make the volumes (shadow_volume.h) and does not draw light.
//
// The count of a pixel is the number of volumes around the visible point: faces behind it (Z
// compare fails) that lead out of a volume less those that lead in. Counting behind needs no care
// for an eye inside a volume or a near plane that cuts one; the view's far plane lies behind all
// volumes (enclosing).
//
// Where the eye is surely outside a volume (is_outside), the faces in front of the visible point
// that lead in less those that lead out are as many, since all faces of a closed surface add up to
// 0 on every pixel. No cap is among them: the front cap has the very Z of the body, and what is
// seen is not farther; the far cap lies beyond everything. So the sides alone are drawn. Pixels
// that show nothing are set back to 0.
//
// The VGX has neither wrapping operations nor two sides: all increments come first, then all
// decrements, so that no count saturates at 0; one that reaches the largest stencil value may have
// lost increments, and is counted (overflow_suffix) for the driver to see.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "multipass/frame/placed_model.h"
#include "multipass/shadow/shadow_volume.h"

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
    /// ... and after every volume, so that only one volume alone can be too deep
    bool one_by_one = false;
};

/// The stencil of one light. Volumes are by part.
void add_shadow_volumes(CommandList& list, const Stage& stage, const std::string& name,
                        const std::vector<ShadowVolume>& volumes, const CountRules& rules);

/// Ends the names of passes whose `written` counts pixels that may have overflowed.
inline constexpr std::string_view overflow_suffix = " overflow";
bool any_overflow(std::span<const PassReport> passes);

/// The stencil of one light from the host: a value for every pixel, bottom row first.
void add_shadow_mask(CommandList& list, const Stage& stage, const std::string& name,
                     const std::vector<std::uint32_t>& mask);

}  // namespace gw::multipass
