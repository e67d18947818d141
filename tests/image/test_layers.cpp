// Claim: layers come back from a file bit for bit, or not at all.
#include "gw/error.h"
#include "image/layers.h"
#include "tests/image/files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace gw::image {
namespace {

Layers example() {
    const float tiny = std::numeric_limits<float>::denorm_min();
    return {.facts = {{"kind", "example"}, {"shots", "12"}},
            .layers = {{"floor",
                        2,
                        3,
                        {"R", "R.rest"},
                        {1, tiny, -2.5f, 3e38f, 0, -0.0f, 7, 8, 9, 10, 11, 12}},
                       {"a wall", 1, 1, {"R", "R.rest"}, {0.1f, 1e-9f}}}};
}

class LayersTest : public testing::Test {
protected:
    Folder folder;
    const std::filesystem::path file = folder / "layers.exr";
    void SetUp() override {
        OutputFile output(file);
        put_layers(output, example());
        output.commit();
    }
};

TEST_F(LayersTest, ComeBackBitForBit) { EXPECT_EQ(read_layers(file), example()); }

// OpenImageIO opens "a?b=c" as a with options.
TEST_F(LayersTest, ComeBackFromFilesAndFoldersOfAnyName) {
    for (const char* name : {"r?1", "a?b=c", "per%cent", "#1", "a b", "a:b", "a*b", "[x]"}) {
        std::filesystem::create_directory(folder / name);
        const auto odd = folder / name / (std::string(name) + ".exr");
        OutputFile output(odd);
        put_layers(output, example());
        output.commit();
        EXPECT_EQ(read_layers(odd), example()) << odd;
    }
}

TEST_F(LayersTest, CutShortAreRefusedWhereverTheCutIs) {
    const auto size = std::filesystem::file_size(file);
    for (auto cut = size - 1; cut > 0; cut -= std::min<std::uintmax_t>(cut, 97)) {
        std::filesystem::resize_file(file, cut);
        EXPECT_THROW(read_layers(file), Error) << cut << " of " << size;
    }
}

TEST_F(LayersTest, AreRefusedWhereThereIsNoFileOrAnother) {
    EXPECT_THROW(read_layers(file.string() + ".none"), Error);
    std::ofstream(file) << "not an EXR file";
    EXPECT_THROW(read_layers(file), Error);
}

}  // namespace
}  // namespace gw::image
