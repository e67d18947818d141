// From a pass list to the passes that run, one after the other: light by light, map by map [K3p].
// Does not draw.
#pragma once

#include "multipass/frame/pass_model.h"
#include "multipass/passes/pass.h"

#include <optional>
#include <string>
#include <vector>

namespace gw::multipass {

/// One run of a pass.
struct Step {
    Pass pass;
    std::optional<std::size_t> light;  ///< of a pass of PassLights::Each
    std::size_t map = 0;               ///< which of the objects' maps of the pass's component

    bool operator==(const Step&) const = default;
};

/// Neighbouring passes of PassLights::Each run light by light: shadow, ambient, diffuse, specular
/// of the first light, then of the second. A pass whose component has several maps on some object
/// runs once for each. A shadow pass is left out for a light without shadow, and its light's passes
/// then need no stencil test.
std::vector<Step> schedule(const PassList& passes, const Model& model);

/// "diffuse lamp", with the light's name, and " map 2" for a repetition.
std::string name_of(const Step& step, const Model& model);

/// Whether the step adds anything to this part: it is among the pass's objects, lit by the light,
/// has the map that is asked for, and the parameters that the pass sets, times what the light
/// sends, are not all 0.
bool adds(const Step& step, const Part& part, const Model& model);

/// Whether the step draws this part: what it adds to; in a pass whose parameters are all 0 (for Z,
/// for fog, to dim) all of its objects; in a translucent pass too, since each dims what is behind
/// it, black where nothing is added.
bool concerns(const Step& step, const Part& part, const Model& model);

/// Whether the step has anything to do at all.
bool is_needed(const Step& step, const Model& model);

}  // namespace gw::multipass
