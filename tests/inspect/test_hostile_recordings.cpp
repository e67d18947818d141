// Claim: whatever bytes stand in a recording, decoding ends with a recording or with an Error that
// says why, and uses no more memory than the limits say.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "gw/machine.h"
#include "tests/inspect/same.h"

#include <cmath>
#include <limits>

namespace gw::inspect {
namespace {

std::string refusal(std::span<const std::uint8_t> bytes, const Limits& limits = {}) {
    try {
        decode(bytes, limits);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}
std::string refusal(const Recording& recording, const Limits& limits = {}) {
    return refusal(encode(recording), limits);
}

std::vector<std::uint8_t> some_recording(std::uint64_t index) {
    const auto& all = fuzz::suites();
    return encode(recording_of(fuzz::make_case(all[index % all.size()], index)));
}

MeshRef triangle() { return make_mesh({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}); }

}  // namespace

TEST(HostileRecording, CutShortIsRefused) {
    const auto bytes = some_recording(0);
    for (std::size_t size = 0; size < bytes.size(); size += size < 200 ? 1 : 37)
        ASSERT_NE(refusal(std::span(bytes).first(size)), "none") << size;
}

/// Longer than what fuzzers begin with: a mesh of 20,000 vertices, 2,000 commands, a long name.
TEST(HostileRecording, DamagedBytesOfALongOneNeverDoHarm) {
    Recording recording =
        recording_of(Draw{.mesh = make_mesh({.positions = std::vector<vec3>(19998, vec3(0.5f)),
                                             .polygon_ids = std::vector<std::uint32_t>(6666, 7)})});
    recording.scene = std::string(100000, 's');
    for (int i = 0; i < 1000; ++i) {
        recording.lists.emplace_back();
        recording.lists.back().add(BeginPass{"pass " + std::to_string(i)});
        recording.lists.back().add(Draw{.mesh = triangle()});
    }
    const auto bytes = encode(recording);
    ASSERT_GT(bytes.size(), 400000u);
    std::uint32_t seed = 7;
    const auto random = [&seed](std::size_t below) {
        seed = seed * 1664525 + 1013904223;
        return (seed >> 4) % below;
    };
    int refused = 0;
    for (int k = 0; k < 200; ++k) {
        auto damaged = bytes;
        for (int n = 0; n < 64; ++n)
            damaged[random(damaged.size())] = static_cast<std::uint8_t>(random(256));
        refused += refusal(damaged, {.decoded_bytes = 256 << 20}) != "none";
    }
    EXPECT_GT(refused, 100);
}

TEST(HostileRecording, OfAnotherKindIsRefusedByName) {
    EXPECT_EQ(refusal(std::vector<std::uint8_t>(100, 'x')),
              "not a recording; expected a file that gw record wrote");
}

TEST(HostileRecording, MasksWithBitsOfNoPlaneAreRefused) {
    Recording recording{.profile = vgx(), .width = 8, .height = 8};
    recording.lists = {{{BeginPass{"depth"}, Clear{.planes = 255}}}};
    EXPECT_EQ(refusal(recording),
              "list 0: command 1 (Clear) of pass 'depth': planes = 255; expected bits of four "
              "planes, 0 to 15");
    recording.lists = {{{BeginPass{"depth", 32}}}};
    EXPECT_EQ(refusal(recording),
              "list 0: command 0 (BeginPass) of pass 'depth': digests = 32; expected bits of four "
              "planes, 0 to 15");
}

TEST(HostileRecording, DamagedBytesNeverDoHarm) {
    std::uint32_t seed = 1;
    const auto random = [&seed](std::size_t below) {
        seed = seed * 1664525 + 1013904223;
        return (seed >> 8) % below;
    };
    int refused = 0, tried = 0;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const auto bytes = some_recording(i);
        for (int k = 0; k < 50; ++k) {
            auto damaged = bytes;
            for (std::size_t n = 1 + random(4); n > 0; --n)
                damaged[random(damaged.size())] = static_cast<std::uint8_t>(random(256));
            refused += refusal(damaged, {.decoded_bytes = 256 << 20}) != "none";
            ++tried;
        }
    }
    EXPECT_GT(refused, tried / 50);
    EXPECT_LT(refused, tried);
}

TEST(HostileRecording, NumbersThatAreNoneAreRefused) {
    Draw draw{.mesh = triangle()};
    draw.material.Kd.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refusal(recording_of(draw)),
              "list 0: command 0 (Draw): material = nan; expected a finite number");
    SetState set;
    set.state.edit().projection[2][1] = std::numeric_limits<double>::infinity();
    EXPECT_NE(refusal(recording_of(set)).find("projection = inf"), std::string::npos);
}

TEST(HostileRecording, SizesBeyondTheMachineAreRefused) {
    Recording recording = recording_of(Draw{.mesh = triangle()});
    recording.width = 5000;
    EXPECT_NE(refusal(recording).find("window of 5000"), std::string::npos);
    recording.width = 1;
    recording.profile.color_bits = 99;
    EXPECT_NE(refusal(recording).find("color_bits"), std::string::npos);
}

TEST(HostileRecording, MemoryOfTheMachineIsBounded) {
    Recording recording = recording_of(Draw{.mesh = triangle()});
    recording.width = recording.height = 4096;
    for (std::uint32_t slot = 0; slot < 256; ++slot)
        recording.lists[0].add(CopyTexture{.slot = slot, .rect = {0, 0, 4096, 4096}});
    EXPECT_EQ(refusal(recording),
              "list 0: texture slots, surfaces and read-backs of more than 1024 MB; expected less");
    recording.lists[0].commands.clear();
    for (std::uint32_t key = 0; key < 1000; ++key)
        recording.lists[0].add(Read{.key = key, .rect = {0, 0, 4096, 4096}});
    EXPECT_EQ(refusal(recording),
              "list 0: texture slots, surfaces and read-backs of more than 1024 MB; expected less");
    recording.lists[0].commands.clear();
    recording.profile = opengl();
    const Surface large{8192, 4096, mask_of(Plane::Depth)};
    for (std::uint32_t number = 1; number < 3; ++number)
        recording.lists[0].add(MakeSurface{number, large});
    EXPECT_EQ(refusal(recording),
              "list 0: texture slots, surfaces and read-backs of more than 1024 MB; expected less");
    std::get<MakeSurface>(recording.lists[0].commands[1]).number = 1;
    EXPECT_EQ(refusal(recording), "none") << "one number, one surface";
    recording.lists[0].commands.clear();
    for (int i = 0; i < 1000; ++i) recording.lists[0].add(Read{.rect = {0, 0, 4096, 4096}});
    EXPECT_EQ(refusal(recording), "none") << "one key, one rectangle";
}

TEST(HostileRecording, PairsOfTexelsAreMemoryToo) {
    Recording recording = recording_of(Draw{.mesh = triangle()});
    recording.width = recording.height = 4096;
    for (std::uint32_t slot = 0; slot < 3; ++slot)
        recording.lists[0].add(CopyTexture{.slot = slot, .rect = {0, 0, 4096, 4096}});
    const auto draw_wrapped = [&](Wrap wrap_s, Wrap wrap_t) {
        State state;
        state.texture.wrap_s = wrap_s, state.texture.wrap_t = wrap_t;
        recording.lists[0].add(SetState{state});
        recording.lists[0].add(Draw{.mesh = triangle(), .map = {.slot = 1}});
    };
    for (int i = 0; i < 3; ++i) draw_wrapped(Wrap::Repeat, Wrap::Repeat);
    draw_wrapped(Wrap::Clamp, Wrap::Repeat);
    EXPECT_EQ(refusal(recording), "none") << "three slots of 256 MB, two times 128 MB of pairs";
    draw_wrapped(Wrap::Clamp, Wrap::Clamp);
    EXPECT_EQ(refusal(recording),
              "list 0: texture slots, surfaces and read-backs of more than 1024 MB; expected less");
}

TEST(HostileRecording, WhatIsDecodedIsBoundedHoweverOftenTheFileRefersToIt) {
    Recording recording = recording_of(Draw{.mesh = triangle()});
    recording.lists[0].commands.assign(10000, SetState{});
    EXPECT_EQ(refusal(recording), "none");
    EXPECT_EQ(refusal(recording, {.decoded_bytes = 1 << 20}),
              "list 0: commands, meshes and maps of more than 1 MB; expected less");
}

TEST(HostileRecording, PrimitivesAreBoundedByTheWindow) {
    Recording recording = recording_of(Draw{.mesh = triangle()});
    recording.width = recording.height = 128;
    EXPECT_EQ(refusal(recording, {.geometry = 4}), "none");
    EXPECT_EQ(refusal(recording, {.geometry = 3}),
              "list 0: 1 primitives in one draw; expected at most 0 in this window");
}

TEST(HostileRecording, ListsAreCheckedOneAfterTheOther) {
    Recording recording = recording_of(CopyTexture{.slot = 3, .rect = {0, 0, 1, 1}});
    Draw draw{.mesh = triangle()};
    draw.map.slot = 3;
    recording.lists.push_back({{draw}});
    EXPECT_EQ(refusal(recording), "none");
    std::swap(recording.lists[0], recording.lists[1]);
    EXPECT_EQ(refusal(recording),
              "list 0: command 0 (Draw): texture slot 3 is empty; expected a CopyTexture before");
}

}  // namespace gw::inspect
