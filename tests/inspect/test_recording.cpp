// Claim: a recording comes back from its bytes as it was, whatever its lists hold.
#include <gtest/gtest.h>

#include "gw/error.h"
#include "tests/inspect/same.h"

#include <flatbuffers/flatbuffers.h>

#include <cstring>

namespace gw::inspect {

TEST(Recording, ComesBackAsItWas) {
    for (const fuzz::Suite& suite : fuzz::suites())
        for (std::uint64_t i = 0; i < 60; ++i) {
            const Recording recording = recording_of(fuzz::make_case(suite, i));
            const Recording back = decode(encode(recording));
            EXPECT_EQ(back.producer, recording.producer);
            EXPECT_EQ(back.scene, recording.scene);
            EXPECT_EQ(back.renderer, recording.renderer);
            EXPECT_EQ(back.profile, recording.profile);
            EXPECT_EQ(back.width, recording.width);
            EXPECT_EQ(back.height, recording.height);
            EXPECT_EQ(back.sets, recording.sets);
            ASSERT_EQ(back.lists.size(), 1u);
            ASSERT_TRUE(same(back.lists[0], recording.lists[0])) << suite.name << " " << i;
        }
}

TEST(Recording, HasTheSameBytesEachTime) {
    for (const fuzz::Suite& suite : fuzz::suites()) {
        const Recording recording = recording_of(fuzz::make_case(suite, 0));
        EXPECT_EQ(encode(decode(encode(recording))), encode(recording)) << suite.name;
    }
}

/// The file's version.
std::uint32_t version_of(const Recording& recording) {
    const auto bytes = encode(recording);
    std::vector<std::uint64_t> aligned(bytes.size() / 8 + 1);
    std::memcpy(aligned.data(), bytes.data(), bytes.size());
    return flatbuffers::GetRoot<flatbuffers::Table>(aligned.data())
        ->GetField<std::uint32_t>(flatbuffers::FieldIndexToOffset(0), 0);
}

TEST(Recording, NeedsVersion2OnlyForWhatVersion1Lacks) {
    EXPECT_EQ(version_of(recording_of(Clear{})), 1u);
    EXPECT_EQ(version_of(recording_of(Clear{.accum = vec4(1)})), 2u);
    SetState unseen;
    EXPECT_EQ(version_of(recording_of(unseen)), 1u);
    unseen.state.edit().draw_buffer = DrawBuffer::None;
    EXPECT_EQ(version_of(recording_of(unseen)), 2u);
    Recording two = recording_of(Clear{});
    two.profile.color_planes = 2;
    EXPECT_EQ(version_of(two), 2u);
}

TEST(Recording, StoresEqualMeshesOnce) {
    const MeshData data{.positions = std::vector<vec3>(3000, vec3(1, 2, 3))};
    Recording recording = recording_of(Draw{.mesh = make_mesh(data)});
    const std::size_t one = encode(recording).size();
    recording.lists[0].add(Draw{.mesh = make_mesh(data)});
    EXPECT_LT(encode(recording).size(), one + 1000);
}

TEST(Recording, StoresTexelsOf16BitsExactly) {
    const std::vector<std::uint16_t> texels{0, 1, 2, 65535, 256, 257, 258, 1000};
    Draw draw{.mesh = make_mesh({})};
    draw.map.texture = make_texture("fine", 2, 1, texels);
    const Recording recording = recording_of(draw);
    const Recording back = decode(encode(recording));
    EXPECT_TRUE(same(back.lists[0], recording.lists[0]));
}

}  // namespace gw::inspect
