// Lists that misuse samples: what each is refused with.
#pragma once

#include "tests/gw/surfaces/refused_surfaces.h"

namespace gw::test {

/// The messages of lists that misuse samples.
inline std::vector<std::string> refused_samples(const Refusal& refusal) {
    constexpr PlaneMask color = mask_of(Plane::Color);
    const auto make = [&](const Surface& s, const Profile& profile) {
        return refusal({MakeSurface{1, s}}, profile);
    };
    Profile without = opengl(), coarse = opengl();
    without.extensions.multisample = false;
    coarse.subpixel_bits = 2;
    const auto state = [&](const auto& change) {
        SetState set;
        change(set.state.edit().multisample);
        return refusal({set}, without);
    };
    // After surface 1 was made with 4 samples, and surface 2 with 8.
    const auto after = [&](std::vector<Command> commands) {
        commands.insert(commands.begin(), {MakeSurface{1, {4, 4, surface_planes, 0, 4}},
                                           MakeSurface{2, {4, 4, surface_planes, 0, 8}}});
        return refusal(commands, opengl());
    };
    Draw draw{.mesh = make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}})};
    draw.map.surface = SurfacePlane{1, Plane::Color};
    const Rect pixel{0, 0, 1, 1};
    return {
        make({1, 1, color, 0, 4}, without),
        make({1, 1, color, 0, 3}, opengl()),
        make({1, 1, color, 0, -2}, opengl()),
        make({1, 1, color, 0, 16}, opengl()),
        make({1, 1, color, 0, 2}, coarse),
        make({8192, 4097, color, 0, 2}, opengl()),
        state([](MultisampleState& m) { m.alpha_to_coverage = true; }),
        state([](MultisampleState& m) { m.alpha_to_one = true; }),
        state([](MultisampleState& m) { m.coverage_test = true; }),
        after({draw}),
        after({UseSurface{1}, Read{0, Plane::Color, pixel}}),
        after({UseSurface{1}, Copy{Plane::Depth, pixel}}),
        after({UseSurface{1}, CopyTexture{0, Plane::Color, pixel}}),
        after({UseSurface{1}, DrawPixels{.width = 1, .height = 1, .source = PixelSource{}}}),
        after({UseSurface{2}, Blit{.from_surface = 1}}),
        after({UseSurface{1}, Blit{.source = pixel, .target = {0, 0, 2, 1}}}),
        after({Blit{.from_surface = 1, .source = pixel, .target = {0, 0, 1, 2}}}),
    };
}

}  // namespace gw::test
