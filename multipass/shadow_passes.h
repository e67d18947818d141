// Shadow volumes counted in the stencil buffer [K3.2 b]: afterwards the stencil is 0 exactly where the light
// arrives. Does not make the volumes (shadow_volume.h) and does not draw light.
//
// The count of a pixel is the number of volumes around the visible point: faces behind it (Z compare fails)
// that lead out of a volume less those that lead in. Counting behind needs no care for an eye inside a volume
// or a near plane that cuts one; the view's far plane lies behind all volumes (enclosing). The VGX has
// neither wrapping operations nor two sides: all increments come first, then all decrements, so that no count
// saturates at 0; one that reaches the largest stencil value may have lost increments, and is counted
// (overflow_pass_name) for the driver to see.
#pragma once

#include "gw/command_list.h"
#include "gw/counters.h"
#include "multipass/stage.h"

#include <span>
#include <string>
#include <vector>

namespace gw::multipass {

struct CountRules {
    int stencil_bits = 8;
    bool zero_or_one = false;  ///< counts become 0 or 1 in the end
    bool one_by_one = false;   ///< ... and after every volume, so that only one volume alone can be too deep
};

/// The stencil of one light. Volumes are by part; null: none.
void add_shadow_volumes(CommandList& list, const Stage& stage, const std::string& name,
                        const std::vector<MeshRef>& volumes, const CountRules& rules);

/// Ends the names of passes whose `written` counts pixels that may have overflowed.
inline constexpr std::string_view overflow_suffix = " overflow";
bool any_overflow(std::span<const PassReport> passes);

/// The stencil of one light from the host: a value for every pixel, bottom row first.
void add_shadow_mask(CommandList& list, const Stage& stage, const std::string& name,
                     const std::vector<std::uint32_t>& mask);

}  // namespace gw::multipass
