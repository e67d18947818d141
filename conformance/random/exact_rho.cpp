// Lists of other groups whose textures have exact_rho.
#include "conformance/cases.h"

#include <array>
#include <memory>
#include <variant>

namespace gw::conformance {
namespace {

/// Also gives further units filters that need rho.
void set_exact_rho(Random& r, State& state) {
    state.texture.exact_rho = true;
    if (!state.more_textures.units) return;
    auto units = *state.more_textures.units;
    for (TextureState& unit : units) {
        unit.exact_rho = true;
        if (r.chance(70)) unit.min_filter = r.any(MinFilter::LinearMipmapLinear);
    }
    state.more_textures.units = std::make_shared<const decltype(units)>(units);
}

}  // namespace

Case exact_rho_case(Random& r) {
    constexpr std::array groups{texture_case, texture_sizes_case, texture_units_case, cubes_case,
                                volumes_case};
    Case out = groups[std::size_t(r.below(int(groups.size())))](r);
    for (Command& command : out.list.commands) {
        auto* set = std::get_if<SetState>(&command);
        if (!set || r.chance(20)) continue;
        State state = *set->state;
        set_exact_rho(r, state);
        set->state = state;
    }
    return out;
}

}  // namespace gw::conformance
