// docs/recordings.md, "What absent members mean": a file with as few members as can be.
#include "gw/error.h"
#include "inspect/recording/recording.h"
#include "tests/inspect/foreign_writer.h"

#include <gtest/gtest.h>

namespace gw::inspect {
namespace {

/// Which of a list's members are there.
struct Present {
    bool types = true, commands = true;
};

/// One list with these kinds of commands, all members absent.
std::vector<std::uint8_t> recording_of(const std::vector<std::uint8_t>& kinds,
                                       const Present& present = {}) {
    FlatBufferBuilder out;
    std::vector<Table> commands;
    for (std::size_t i = 0; i < kinds.size(); ++i) commands.push_back(table(out));
    const auto types = out.CreateVector(kinds);
    const auto tables = out.CreateVector(commands);
    const Table list = table(out, [&] {
        if (present.types) out.AddOffset(place(0), types);
        if (present.commands) out.AddOffset(place(1), tables);
    });
    const auto lists = out.CreateVector(std::vector<Table>{list});
    const auto meshes = out.CreateVector(std::vector<Table>{table(out)});
    const auto states = out.CreateVector(std::vector<Table>{table(out)});
    const Table p = profile(out);
    const Table recording = table(out, [&] {
        out.AddElement<std::uint32_t>(place(0), 1, 0);
        out.AddOffset(place(4), p);
        out.AddElement<std::int32_t>(place(5), 4, 0);
        out.AddElement<std::int32_t>(place(6), 4, 0);
        out.AddOffset(place(8), meshes);
        out.AddOffset(place(11), states);
        out.AddOffset(place(12), lists);
    });
    out.Finish(recording, "GWT1");
    return {out.GetBufferPointer(), out.GetBufferPointer() + out.GetSize()};
}

// [R15.1] [R15.2] [R15.3] [R15.4]
TEST(AbsentMembers, HaveTheValuesOfTheManual) {
    const Recording r = decode(recording_of({1, 2, 3, 4, 5, 6, 7, 8, 10}));
    ASSERT_EQ(r.lists.size(), 1u);
    const std::vector<Command>& c = r.lists[0].commands;
    ASSERT_EQ(c.size(), 9u);
    EXPECT_EQ(std::get<BeginPass>(c[0]), BeginPass{});
    EXPECT_EQ(std::get<Clear>(c[1]), Clear{});
    EXPECT_EQ(*std::get<SetState>(c[2]).state, State{});
    const Draw& draw = std::get<Draw>(c[3]);
    EXPECT_EQ(draw.eye_from_object, dmat4(1));
    EXPECT_EQ(draw.material, Material{});
    EXPECT_EQ(draw.material.Kd, vec3(0.8f));
    EXPECT_EQ(draw.lights, nullptr);
    EXPECT_FALSE(draw.map.enabled());
    EXPECT_EQ(draw.mesh->data(), MeshData{});
    EXPECT_EQ(std::get<WriteSpans>(c[4]), WriteSpans{});
    EXPECT_EQ(std::get<WritePixels>(c[5]), WritePixels{});
    EXPECT_EQ(std::get<Accumulate>(c[6]), Accumulate{});
    EXPECT_EQ(std::get<Copy>(c[7]), Copy{});
    EXPECT_EQ(std::get<Read>(c[8]), Read{});
    EXPECT_EQ(r.profile.name, "");
}

/// A list is empty if it has neither; one of them alone is damage.
TEST(AbsentMembers, OfAListAreKindsAndCommandsTogether) {
    EXPECT_EQ(decode(recording_of({1}, {})).lists[0].commands.size(), 1u);
    EXPECT_TRUE(decode(recording_of({1}, {false, false})).lists[0].commands.empty());
    EXPECT_THROW(decode(recording_of({1}, {false, true})), Error);
    EXPECT_THROW(decode(recording_of({1}, {true, false})), Error);
}

}  // namespace
}  // namespace gw::inspect
