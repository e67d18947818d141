// Claims: a reader finds in a file the values that the plane held.
#include "gw/base/arithmetic.h"
#include "gw/error.h"
#include "image/write.h"

#include "tests/image/files.h"
#include "tests/judge/judge.h"

namespace gw::image {
namespace {

// Every value of the plane's bits occurs (up to 4096 of them), in all three channels differently.
Picture sample_picture(int bits) {
    Picture picture{.width = 64, .height = 64, .channels = 3, .bits = bits, .values = {}};
    const unsigned max = (1u << bits) - 1, step = bits > 12 ? 16 : 1;
    for (unsigned i = 0; i < 64 * 64; ++i) {
        for (unsigned channel = 0; channel < 3; ++channel) {
            picture.values.push_back(static_cast<std::uint16_t>((i * step + channel * 5) & max));
        }
    }
    return picture;
}

template <class T>
std::vector<T> top_row_first(const Picture& picture) {
    std::vector<T> values;
    const int row = picture.width * picture.channels;
    for (int y = picture.height - 1; y >= 0; --y) {
        values.insert(values.end(), picture.values.begin() + y * row,
                      picture.values.begin() + (y + 1) * row);
    }
    return values;
}

}  // namespace

// The judge's libraries take most of a second to load: one test asks it about all formats.
TEST(LosslessFormats, HoldEightBitsAsTheyAre) {
    for (const char* extension : {"png", "tif", "ppm", "bmp", "tga", "sgi", "PNG"}) {
        SCOPED_TRACE(extension);
        const Folder folder;
        const auto file = folder / (std::string("picture.") + extension);
        write_picture(file, sample_picture(8));
        const auto found = judge::stored_in<std::uint8_t>(file);
        EXPECT_EQ(found.spec.format, judge::Sample::U8);
        EXPECT_EQ(found.spec.channels, 3);
        EXPECT_EQ(found.values, top_row_first<std::uint8_t>(sample_picture(8)));
        EXPECT_EQ(folder.names().size(), 1u);
    }
}

class DeepFormat : public testing::TestWithParam<std::pair<const char*, int>> {};
INSTANTIATE_TEST_SUITE_P(, DeepFormat,
                         testing::Values(std::pair("png", 12), std::pair("png", 16),
                                         std::pair("tif", 12), std::pair("tif", 16)));

TEST_P(DeepFormat, HoldsMoreBitsInSixteenAndGivesThemBack) {
    const auto [extension, bits] = GetParam();
    const Folder folder;
    const auto file = folder / (std::string("picture.") + extension);
    write_picture(file, sample_picture(bits));
    auto found = judge::stored_in<std::uint16_t>(file);
    EXPECT_EQ(found.spec.format, judge::Sample::U16);
    for (std::uint16_t& v : found.values) v = static_cast<std::uint16_t>(rescale(v, 16, bits));
    EXPECT_EQ(found.values, top_row_first<std::uint16_t>(sample_picture(bits)));
}

TEST(WritePicture, ScalesTwelveBitsToTheWholeRange) {
    const Folder folder;
    const Picture picture{
        .width = 3, .height = 1, .channels = 1, .bits = 12, .values = {0, 1, 4095}};
    write_picture(folder / "a.png", picture);
    EXPECT_EQ(judge::stored_in<std::uint16_t>(folder / "a.png").values,
              (std::vector<std::uint16_t>{0, 16, 65535}));
}

TEST(WritePicture, RoundsToEightBitsWhereTheFormatHasNoMore) {
    const Folder folder;
    // 128/65535 of 255 is 0.498, 129/65535 is 0.502
    const Picture picture{
        .width = 4, .height = 1, .channels = 1, .bits = 16, .values = {0, 128, 129, 65535}};
    write_picture(folder / "a.bmp", picture);
    const auto found = judge::stored_in<std::uint8_t>(folder / "a.bmp");
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(found.values[i * std::size_t(found.spec.channels)],
                  (std::vector<int>{0, 0, 1, 255})[i]);
    }
}

class ExrBits : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(, ExrBits, testing::Values(8, 12, 16));

TEST_P(ExrBits, HoldFractionsThatGiveEveryValueBack) {
    const int bits = GetParam();
    const Folder folder;
    write_picture(folder / "picture.exr", sample_picture(bits));
    const auto found = judge::stored_in<float>(folder / "picture.exr");
    EXPECT_EQ(found.spec.format, bits == 8 ? judge::Sample::Half : judge::Sample::Float);
    const auto max = static_cast<float>((1 << bits) - 1);
    std::vector<std::uint16_t> values;
    for (float v : found.values) values.push_back(static_cast<std::uint16_t>(std::lround(v * max)));
    EXPECT_EQ(values, top_row_first<std::uint16_t>(sample_picture(bits)));
}

TEST(UsualFormats, AreReadableWithTheirSizeForEveryNumberOfBits) {
    for (const char* extension : {"png", "exr", "tif", "tiff", "jpg", "bmp", "tga", "ppm", "hdr",
                                  "dpx", "webp", "gif", "sgi", "rla", "iff", "jp2", "fits"})
        for (const int bits : {8, 12, 16}) {
            SCOPED_TRACE(extension);
            const Folder folder;
            const auto file = folder / (std::string("picture.") + extension);
            write_picture(file, sample_picture(bits));
            const auto found = judge::stored_in<float>(file);
            EXPECT_EQ(found.spec.width, 64);
            EXPECT_EQ(found.spec.height, 64);
            EXPECT_EQ(folder.names(), std::vector<std::string>{file.filename().string()});
        }
}

TEST(WritePicture, GivesTheSameBytesForTheSamePictureLater) {
    const Folder folder;
    const char* extensions[] = {"png", "exr", "tif", "jpg", "ppm"};
    for (const char* extension : extensions)
        write_picture(folder / std::string("first.").append(extension), sample_picture(8));
    ::sleep(1);  // some writers like to add the time
    for (const char* extension : extensions) {
        write_picture(folder / std::string("second.").append(extension), sample_picture(8));
        EXPECT_TRUE(bytes_of(folder / std::string("first.").append(extension)) ==
                    bytes_of(folder / std::string("second.").append(extension)))
            << extension;
    }
}

TEST(WritePicture, RefusesAnUnknownExtensionAndListsUsualOnes) {
    for (const char* name : {"picture.xyz", "picture", "picture.null", "picture.term", ".png"}) {
        const Folder folder;
        try {
            write_picture(folder / name, sample_picture(8));
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("expected .png, .exr, .tif"),
                      std::string::npos);
        }
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(PutValues, GivesTheSameBytesForTheSameValuesLater) {
    const Folder folder;
    const auto write = [&](const char* name) {
        OutputFile file(folder / name);
        put_values(file,
                   {.width = 1, .height = 1, .channels = {"Z"}, .values = std::vector<float>{1}});
        file.commit();
        return bytes_of(folder / name);
    };
    const std::string first = write("first.exr");
    ::sleep(1);
    EXPECT_TRUE(first == write("second.exr"));
}

TEST(PutValues, HoldsAllThirtyTwoBits) {
    const Folder folder;
    const std::vector<std::uint32_t> depth{0, 1, 0xfffffffe, 0xffffffff, 1u << 24, (1u << 24) + 1};
    OutputFile file(folder / "depth.exr");
    put_values(file, {.width = 3, .height = 2, .channels = {"Z"}, .values = depth});
    file.commit();
    const auto found = judge::stored_in<std::uint32_t>(folder / "depth.exr");
    EXPECT_EQ(found.spec.format, judge::Sample::U32);
    EXPECT_EQ(found.values,
              (std::vector<std::uint32_t>{0xffffffff, 1u << 24, (1u << 24) + 1, 0, 1, 0xfffffffe}));
}

TEST(PutValues, HoldsSignedSumsAsFloats) {
    const Folder folder;
    OutputFile file(folder / "accum.exr");
    const std::vector<float> accum{-32768, 32767, 0, 255, 1, 2, 3, 4};
    put_values(file, {.width = 2, .height = 1, .channels = {"R", "G", "B", "A"}, .values = accum});
    file.commit();
    EXPECT_EQ(judge::stored_in<float>(folder / "accum.exr").values, accum);
}

}  // namespace gw::image
