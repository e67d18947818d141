// Lists that misuse surfaces: what each is refused with. Does not know the manual's page:
// tests/gw/manual/test_refusal_messages.cpp does.
#pragma once

#include "gw/machine.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gw::test {

/// What the message of a list is, without its head: of refused lists on a window of 16 x 16 pixels.
using Refusal = std::function<std::string(std::vector<Command>, const Profile&)>;

/// The messages of lists that misuse surfaces.
inline std::vector<std::string> refused_surfaces(const Refusal& refusal) {
    const MeshRef mesh = make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    // After surface 1 was made with these planes.
    const auto refused_after = [&](PlaneMask planes, std::vector<Command> commands) {
        commands.insert(commands.begin(), MakeSurface{1, {4, 4, planes, 16}});
        return refusal(commands, opengl());
    };
    const auto refused_map = [&](const SurfacePlane& map, std::uint32_t used = 0) {
        Draw draw{.mesh = mesh};
        draw.map.surface = map;
        return refused_after(mask_of(Plane::Color), {UseSurface{used}, draw});
    };
    Profile shadows = opengl();
    shadows.extensions.shadow_texture = true;
    SetState compare;
    compare.state.edit().texture.shadow_compare = true;
    Draw compared{.mesh = mesh};
    compared.map.surface = SurfacePlane{1, Plane::Color};
    Draw twice = compared;
    twice.map.slot = 1;
    Draw on_unit_1{.mesh = mesh};
    MoreBindings maps;
    maps[0].surface = SurfacePlane{1, Plane::Color};
    on_unit_1.more_maps = std::make_shared<const MoreBindings>(maps);
    const PlaneMask color = mask_of(Plane::Color), depth = mask_of(Plane::Depth);
    const auto make = [&](std::uint32_t number, const Surface& s) {
        return refusal({MakeSurface{number, s}}, opengl());
    };
    const auto viewport = [&](ViewportState v) {
        SetState set;
        set.state.edit().viewport = v;
        return refusal({set}, opengl());
    };
    return {
        refusal({UseSurface{}}, vgx()),
        refusal({MakeSurface{1, {1, 1, color}}}, vgx()),
        refusal({Blit{}}, vgx()),
        viewport({0, 0, 8193, 1}),
        viewport({0, 0, 1, 8193}),
        refusal({Read{0, Plane::Color, {0, 0, 8193, 0}}}, opengl()),
        refusal({Read{0, Plane::Color, {0, 0, 0, -1}}}, opengl()),
        refused_after(color, {twice}),
        refused_map({0, Plane::Color}),
        refused_map({1, Plane::Color}, 1),
        refused_map({1, Plane::Depth}),
        refused_map({2, Plane::Color}),
        refusal({MakeSurface{1, {4, 4, color}}, compare, compared}, shadows),
        refusal({MakeSurface{1, {4, 4, color}}, UseSurface{1}, on_unit_1}, opengl()),
        refused_after(depth, {UseSurface{1}, Read{0, Plane::Color, {0, 0, 1, 1}}}),
        refused_after(depth, {UseSurface{1}, Copy{Plane::Stencil}}),
        refused_after(color, {UseSurface{1}, CopyTexture{0, Plane::Depth, {0, 0, 1, 1}}}),
        refused_after(color, {UseSurface{1}, Accumulate{}}),
        refused_after(color, {UseSurface{1}, SwapBuffers{}}),
        refused_after(color, {UseSurface{1}, MakeSurface{1, {1, 1, color}}}),
        make(0, {1, 1, color}),
        make(1024, {1, 1, color}),
        make(1, {8193, 1, color}),
        make(1, {1, 0, color}),
        make(1, {1, 1, color, 15}),
        make(1, {1, 1, 0}),
        make(1, {1, 1, 8}),
        refusal({UseSurface{1024}}, opengl()),
        refusal({UseSurface{1}}, opengl()),
        refusal({Blit{.from_surface = 9}}, opengl()),
        refusal({Blit{.source = {-8193, 0, 1, 1}}}, opengl()),
        refusal({Blit{.target = {0, 0, 1, -1}}}, opengl()),
        refusal({Blit{.filter = MagFilter(2)}}, opengl()),
        refused_after(depth, {Blit{.from_surface = 1, .planes = depth}}),
    };
}

}  // namespace gw::test
