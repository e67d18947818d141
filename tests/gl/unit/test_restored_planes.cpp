// A recording that begins in the middle restores every plane of the machine.
#include "gl/record/restored_planes.h"

#include "gw/machine.h"
#include "gw/profile_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace gw::gl {

namespace {

/// Planes of random values, the accumulation buffer's of both signs.
Planes random_planes(const Profile& p, int width, int height, std::uint32_t seed) {
    std::mt19937 random(seed);
    Planes planes(width, height, p.color_planes);
    const auto below = [&](int bits) { return random() >> (32 - bits); };
    for (std::vector<Rgba>* colors : {&planes.color, &planes.back})
        for (Rgba& color : *colors)
            for (auto& channel : color) channel = static_cast<std::uint16_t>(below(p.color_bits));
    for (auto& depth : planes.depth) depth = below(p.depth_bits);
    for (auto& stencil : planes.stencil) stencil = static_cast<std::uint8_t>(below(p.stencil_bits));
    for (auto& sum : planes.accum)
        for (auto& channel : sum)
            channel = std::int32_t(below(p.accum_bits - 1)) - (1 << (p.accum_bits - 2));
    return planes;
}

}  // namespace

TEST(RestoredPlanes, AreThoseOfTheMachineOnEveryProfile) {
    for (const Profile& profile : profiles()) {
        const Planes planes = random_planes(profile, 13, 7, 5);
        gw::State state;
        state.depth.func = CompareFunc::Greater;
        for (const bool fast : {false, true}) {
            const auto machine = fast ? make_fast(profile, 13, 7) : make_reference(profile, 13, 7);
            machine->execute(restoring_list(planes, profile, "before frame 3", state));
            EXPECT_EQ(machine->planes(), planes) << profile.name;
            EXPECT_EQ(machine->passes().front().name, "before frame 3");
        }
        EXPECT_EQ(
            *std::get<SetState>(restoring_list(planes, profile, "", state).commands.back()).state,
            state);
    }
}

TEST(RestoredPlanes, OfANewMachineAreWrittenNowhereButInColour) {
    const CommandList list = restoring_list(Planes(5, 4, 2), opengl(), "", {});
    for (const Command& command : list.commands)
        if (const auto* write = std::get_if<WritePixels>(&command)) {
            EXPECT_EQ(write->plane, Plane::Color);
        }
}

namespace {

/// Values of one kind for a rectangle of a surface.
Readback random_values(std::mt19937& random, Plane plane, const Rect& rect, int bits) {
    Readback out{.plane = plane, .rect = rect};
    for (std::size_t i = 0; i < rect.area(); ++i) {
        const auto value = [&] { return std::uint32_t(random()) >> (32 - bits); };
        if (plane != Plane::Color) {
            out.values.push_back(value());
            continue;
        }
        Rgba& color = out.color.emplace_back();
        for (auto& channel : color) channel = static_cast<std::uint16_t>(value());
    }
    return out;
}

/// What Reads of the same rectangles give. Equal samples are their own mean.
std::vector<Readback> read_again(Machine& machine, std::uint32_t number, Surface surface,
                                 const std::vector<Readback>& parts) {
    constexpr std::uint32_t one_sample = 9;
    const Rect all{0, 0, surface.width, surface.height};
    surface.samples = 0;
    CommandList list;
    list.add(SetState{gw::State()});
    list.add(UseSurface{0});
    list.add(MakeSurface{one_sample, surface});
    list.add(UseSurface{one_sample});
    list.add(Blit{.from_surface = number, .planes = surface.planes, .source = all, .target = all});
    for (std::size_t i = 0; i < parts.size(); ++i)
        list.add(Read{std::uint32_t(i), parts[i].plane, parts[i].rect});
    machine.execute(list);
    std::vector<Readback> out;
    for (std::size_t i = 0; i < parts.size(); ++i)
        out.push_back(machine.readbacks().at(std::uint32_t(i)));
    return out;
}

}  // namespace

// Surface 2 is wider than one command's rectangle; 3 has samples, 4 depths of 16 bits alone.
TEST(RestoredPlanes, OfSurfacesAreThoseOfTheMachine) {
    constexpr PlaneMask all = surface_planes, depth = mask_of(Plane::Depth);
    std::map<std::uint32_t, SurfaceValues> surfaces{
        {2, {{.width = 4100, .height = 2, .planes = all, .depth_bits = 32}, {}}},
        {3, {{.width = 5, .height = 3, .planes = all, .depth_bits = 24, .samples = 4}, {}}},
        {4, {{.width = 3, .height = 7, .planes = depth, .depth_bits = 16}, {}}}};
    std::mt19937 random(11);
    for (auto& [number, values] : surfaces)
        for (int x = 0; x < values.surface.width; x += 4096)
            for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil}) {
                if (!values.surface.has(plane)) continue;
                const Rect rect{x, 0, std::min(values.surface.width - x, 4096),
                                values.surface.height};
                const int bits = plane == Plane::Depth ? values.surface.depth_bits : 8;
                values.parts.push_back(random_values(random, plane, rect, bits));
            }
    gw::State state;
    state.depth.func = CompareFunc::Greater;
    for (const bool fast : {false, true}) {
        const auto machine = fast ? make_fast(opengl(), 1, 1) : make_reference(opengl(), 1, 1);
        const CommandList list = restoring_list(surfaces, "before frame 3", 4, state);
        machine->execute(list);
        EXPECT_EQ(*std::get<SetState>(list.commands.back()).state, state);
        CommandList used;  // a Read of what only surface 4 has
        used.add(Read{9, Plane::Depth, {2, 6, 1, 1}});
        EXPECT_NO_THROW(machine->execute(used));
        for (const auto& [number, values] : surfaces)
            EXPECT_EQ(read_again(*machine, number, values.surface, values.parts), values.parts)
                << number;
    }
}

}  // namespace gw::gl
