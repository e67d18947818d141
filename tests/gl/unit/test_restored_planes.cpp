// A recording that begins in the middle restores every plane of the machine.
#include "gl/record/restored_planes.h"

#include "gw/machine.h"
#include "gw/profile_text.h"

#include <gtest/gtest.h>

#include <random>

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

}  // namespace gw::gl
