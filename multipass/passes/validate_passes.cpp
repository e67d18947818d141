#include "multipass/passes/validate_passes.h"

#include "multipass/passes/catalogue.h"
#include "multipass/passes/tokens.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::multipass {
namespace {

using Fault = std::optional<ListFault>;

bool needs_light(const Pass& pass) {
    const Parameter none;
    return pass.material.Ka != none || pass.material.Kd != none || pass.material.Ks != none;
}

/// A pass that draws no objects has a name, an action and lights; a traced component is also
/// blended.
Fault fault_of_action(const Pass& pass, std::size_t i) {
    if (pass.action == PassAction::Draw) return std::nullopt;
    Pass bare{.name = pass.name, .action = pass.action};
    bare.lights = pass.lights;
    if (pass.action == PassAction::Trace) {
        bare.blend = pass.blend;
        bare.fog = pass.fog;
    }
    if (pass != bare)
        return ListFault{
            i, "action",
            fmt::format("a pass of action '{}' draws nothing; expected name and lights only",
                        token(pass.action))};
    const bool by_light = pass.lights == PassLights::Each || pass.lights == PassLights::First;
    if (pass.action == PassAction::Shadow && !by_light)
        return ListFault{i, "lights",
                         "a shadow pass has no light; expected lights = 'each' or 'first'"};
    return std::nullopt;
}

Fault fault_of_pass(const Pass& pass, std::size_t i) {
    if (pass.name.view().empty()) return ListFault{i, "name", "pass has no name; expected one"};
    if (const Fault fault = fault_of_action(pass, i)) return fault;
    if (pass.lights == PassLights::None && needs_light(pass))
        return ListFault{
            i, "lights",
            fmt::format("pass '{}' reflects light (Ka, Kd, Ks) but has none; expected lights = "
                        "'each', 'first' or 'all'",
                        pass.name.view())};
    return std::nullopt;
}

/// Layers are sorted once, so all their passes run together.
Fault fault_of_layers(const PassList& passes) {
    const auto first = std::find_if(passes.begin(), passes.end(), is_layer_pass);
    const auto end = std::find_if_not(first, passes.end(), is_layer_pass);
    const auto again = std::find_if(end, passes.end(), is_layer_pass);
    if (again == passes.end()) return std::nullopt;
    return ListFault{
        std::size_t(again - passes.begin()), "depth",
        fmt::format("pass '{}' draws translucent objects under Equal, but not next to the others "
                    "that do; expected all of them together",
                    again->name.view())};
}

}  // namespace

Fault first_fault(const PassList& passes) {
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (const Fault fault = fault_of_pass(passes[i], i)) return fault;
    if (!passes.empty() && passes[0].clear != picture)
        return ListFault{
            0, "clear",
            "the first pass does not clear all planes; expected clear = ['color', 'depth', 'stencil']"};
    return fault_of_layers(passes);
}

}  // namespace gw::multipass
