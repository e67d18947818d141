// From a pass list to the sequence of passes that run: light by light, map by map [K3p]. Does not
// draw.
#pragma once

#include "multipass/passes/pass.h"
#include "multipass/steps/pass_model.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::multipass {

/// One run of a pass.
struct Step {
    Pass pass;                         ///< its names in order
    std::optional<std::size_t> light;  ///< of a pass of PassLights::Each
    std::size_t map = 0;               ///< which of the objects' maps of the pass's component
    /// of a pass of PassObjects::Glaring: the number of them, which share the strength
    std::size_t repeats = 1;

    bool operator==(const Step&) const = default;
};

/// Neighbouring passes of PassLights::Each run light by light: shadow, ambient, diffuse, specular
/// of the first light, then of the second. A pass whose component has several maps on an object
/// runs once for each map. A light without shadow has no shadow pass, and its passes no stencil
/// test.
std::vector<Step> schedule(const PassList& passes, const PassModel& model);

/// "diffuse lamp", with the light's name, and " map 2" for a repetition.
std::string name_of(const Step& step, const PassModel& model);

/// Whether the step adds anything to this part. The pass must have it among its objects, the light
/// must light it, and it must have the map. The parameters that the pass sets, times the light,
/// must not all be 0.
bool adds(const Step& step, const Part& part, const PassModel& model);

/// Whether the step draws this part: a part that it adds to. A pass whose parameters are all 0 (for
/// Z or fog) draws all of its objects. So does a translucent pass: each object dims the picture
/// behind it, and is black if the pass adds nothing to it.
bool concerns(const Step& step, const Part& part, const PassModel& model);

/// Whether the step clears, draws or acts at all.
bool is_needed(const Step& step, const PassModel& model);

}  // namespace gw::multipass
