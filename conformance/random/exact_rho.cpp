// Lists of other groups whose textures have exact_rho.
#include "conformance/cases.h"
#include "conformance/generate/mesh.h"

#include <array>
#include <memory>
#include <variant>
#include <vector>

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

/// A square over the window, of which one unit has a texture of 32 x 32 that is turned: 1 to 8
/// texels a pixel.
void draw_turned(Random& r, Case& out) {
    std::vector<std::uint16_t> rgba;
    for (int i = 0; i < 4 * 32 * 32; ++i) rgba.push_back(std::uint16_t(r.bits(16)));
    const std::size_t unit = std::size_t(r.below(3));
    const double turn = r.real(0, 1.5), scale = r.real(1, 8) / 64;
    MeshData square = rectangle(-1, -1, 1, 1);
    for (const vec3& p : square.positions) {
        const double u = p.x * out.width * scale, v = p.y * out.height * scale;
        square.more_texcoords[unit].st.push_back({float(u - turn * v), float(turn * u + v)});
    }
    MoreBindings more;
    more[unit].texture = make_whole_texture("turned", 32, 32, rgba);
    std::array<TextureState, max_texture_units - 1> units{};
    units[unit].min_filter = MinFilter::NearestMipmapLinear;
    units[unit].env = TexEnv::Replace;
    units[unit].exact_rho = true;
    State state;
    state.viewport = {0, 0, out.width, out.height};
    state.more_textures.units = std::make_shared<const decltype(units)>(units);
    out.list.add(SetState{state});
    out.list.add(Draw{.mesh = make_mesh(std::move(square)),
                      .more_maps = std::make_shared<const MoreBindings>(more)});
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
    if (out.profile.extensions.texture_units && r.chance(70)) draw_turned(r, out);
    return out;
}

}  // namespace gw::conformance
