// Members that a foreign writer may give and our own never does: they have their effect, or they are
// refused.
#include "gw/error.h"
#include "inspect/recording/part.h"
#include "inspect/recording/recording.h"
#include "tests/inspect/foreign_writer.h"

#include <gtest/gtest.h>

namespace gw::inspect {
namespace {

/// Members of a texture beside its texels, in the schema's order.
struct Given {
    int width = 4, height = 1, values = 16;
    int level_count = 0;
    std::uint8_t format = 0;
    int dimensions = 2;
    bool border = false;
};

std::vector<std::uint8_t> recording_of(const Given& given) {
    FlatBufferBuilder out;
    const auto texels =
        out.CreateVector(std::vector<std::uint8_t>(std::size_t(given.values), std::uint8_t(37)));
    const Table texture = table(out, [&] {
        out.AddElement<std::int32_t>(place(1), given.width, 0);
        out.AddElement<std::int32_t>(place(2), given.height, 0);
        out.AddOffset(place(3), texels);
        out.AddElement<std::int32_t>(place(5), given.level_count, 0);
        out.AddElement<std::uint8_t>(place(6), given.format, 0);
        out.AddElement<std::int32_t>(place(7), given.dimensions, 2);
        out.AddElement<std::uint8_t>(place(8), given.border, 0);
    });
    const auto textures = out.CreateVector(std::vector<Table>{texture});
    const Table p = profile(out);
    const Table recording = table(out, [&] {
        out.AddElement<std::uint32_t>(place(0), 2, 0);
        out.AddOffset(place(4), p);
        out.AddElement<std::int32_t>(place(5), 4, 0);
        out.AddElement<std::int32_t>(place(6), 4, 0);
        out.AddOffset(place(9), textures);
    });
    out.Finish(recording, "GWT1");
    return {out.GetBufferPointer(), out.GetBufferPointer() + out.GetSize()};
}

std::string refusal(const Given& given) {
    try {
        decode(recording_of(given));
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

// [R10.23]
TEST(ForeignTexture, HasFormatDimensionsAndBorderOnlyWithGivenLevels) {
    EXPECT_EQ(refusal({}), "none");
    const std::string expected =
        "texture 0: a format, one dimension or a border without given levels; expected level_count 1 "
        "or more";
    EXPECT_EQ(refusal({.format = 1}), expected);
    EXPECT_EQ(refusal({.dimensions = 1}), expected);
    EXPECT_EQ(refusal({.dimensions = 3}), expected);
    EXPECT_EQ(refusal({.border = true}), expected);
    EXPECT_EQ(refusal({.level_count = 1, .format = 1, .dimensions = 1}), "none");
    EXPECT_EQ(refusal({.values = 24, .level_count = 1, .dimensions = 1, .border = true}), "none");
}

// [R5.8]
TEST(ForeignTexture, HasAsManyTexelsAsItsLevels) {
    EXPECT_EQ(refusal({.height = 4, .values = 80, .level_count = 2}), "none");
    EXPECT_EQ(refusal({.height = 4, .values = 84, .level_count = 2}),
              "texture 0: 84 values of 2 levels; expected 80");
    EXPECT_EQ(refusal({.height = 4, .values = 76, .level_count = 2}),
              "texture 0: level 1 of 16 values; 12 are left");
    EXPECT_NE(refusal({.values = 20}), "none");
    EXPECT_NE(refusal({.values = 12}), "none");
}

/// docs/recordings.md, "Streams": only Open has a heading.
TEST(ForeignStream, NeedsAProfileOnlyWhereAMachineBegins) {
    constexpr std::uint8_t proceed = 0, open = 1, close = 2;
    const auto refusal_of = [](std::uint8_t event) -> std::string {
        FlatBufferBuilder out;
        const auto window = out.CreateString("w");
        const Table part = table(out, [&] {
            out.AddElement<std::uint32_t>(place(0), 2, 0);
            out.AddOffset(place(13), window);
            out.AddElement<std::uint8_t>(place(14), event, 0);
        });
        out.Finish(part, "GWT1");
        DecodedValues values;
        try {
            decode_part({out.GetBufferPointer(), out.GetSize()}, values, {});
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(refusal_of(proceed), "none");
    EXPECT_EQ(refusal_of(close), "none");
    EXPECT_EQ(refusal_of(open), "a recording without a profile");
}

}  // namespace gw::inspect
