// Claims: EXPECT_PASSES_EQ holds for what a golden was made of and for nothing else; a failure
// names pass, plane, pixel and both values and leaves pictures that show them; goldens change only
// where asked.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "inspect/compare/verify.h"
#include "inspect/manifest/manifest_file.h"
#include "inspect/testing/expect_passes.h"
#include "inspect/testing/failure_files.h"
#include "inspect/testing/matchers.h"

#include <cstdlib>
#include <fstream>
#include "tests/temporary_folder.h"

namespace gw::testing {
namespace {

namespace fs = std::filesystem;

/// Two passes on 4 x 3 pixels: grey everywhere, then a rectangle of 2 x 1 pixels of this red.
CommandList two_passes(std::uint16_t red) {
    CommandList list;
    list.add(BeginPass{"background"});
    list.add(Clear{.planes = all_planes, .color = {0.2f, 0.2f, 0.2f, 1}});
    list.add(BeginPass{"mark"});
    const Rgba color{red, 0, 0, 255};
    list.add(WritePixels{.rect = {1, 1, 2, 1}, .colors = {color, color}});
    return list;
}

class ExpectPasses : public ::testing::Test {
protected:
    void SetUp() override {
        setenv("GW_TESTING_OUTPUT", (folder / "failures").c_str(), 1);
        unsetenv("GW_UPDATE_GOLDENS");
    }
    void TearDown() override { unsetenv("GW_UPDATE_GOLDENS"); }
    static inspect::Recording recording(std::uint16_t red) {
        return recording_of(two_passes(red), vgx(), 4, 3);
    }

    const TemporaryFolder folder;
    const fs::path golden = folder / "two.json";
};

std::string message_of(const ::testing::AssertionResult& result) {
    return result ? "" : result.message();
}

}  // namespace

TEST_F(ExpectPasses, HoldsForWhatTheGoldenWasMadeOf) {
    write_golden(recording(200), golden);
    EXPECT_PASSES_EQ(recording(200), golden);
    EXPECT_PASSES_EQ(two_passes(200), golden);
}

TEST_F(ExpectPasses, NamesPassPlanePixelAndBothValues) {
    write_golden(recording(200), golden);
    const std::string message = message_of(passes_eq(two_passes(201), golden));
    EXPECT_THAT(
        message,
        ::testing::HasSubstr(
            "pass 1 'mark', plane color, pixel 1 1: expected 200 0 0 255, got 201 0 0 255"));
    EXPECT_THAT(message, ::testing::HasSubstr("2 pixels of this plane differ"));
    EXPECT_THAT(message, ::testing::HasSubstr("is of another command list"));
}

TEST_F(ExpectPasses, LeavesActualExpectedAndDifference) {
    write_golden(recording(200), golden);
    const std::string message = message_of(passes_eq(two_passes(201), golden));
    for (const char* kind : {"actual", "expected", "difference"}) {
        const fs::path file =
            output_folder() / ("ExpectPasses.LeavesActualExpectedAndDifference-two-pass1-color-" +
                               std::string(kind) + ".png");
        EXPECT_TRUE(fs::exists(file)) << file;
        EXPECT_THAT(message, ::testing::HasSubstr(file.string()));
    }
}

TEST_F(ExpectPasses, LeavesARecordingForDiffAndPixel) {
    write_golden(recording(200), golden);
    const std::string message = message_of(passes_eq(two_passes(201), golden));
    const std::string base =
        (output_folder() / "ExpectPasses.LeavesARecordingForDiffAndPixel-two").string();
    EXPECT_THAT(message, ::testing::HasSubstr("gw diff " + golden.string() + " " + base + ".json"));
    EXPECT_THAT(message, ::testing::HasSubstr("gw pixel " + base + ".gwt 1 1"));
    const auto left = inspect::decode(inspect::read_recording_bytes(base + ".gwt"));
    EXPECT_EQ(encode(left), encode(recording(201)));
    const auto difference = first_difference(inspect::load_manifest(golden).manifest,
                                             inspect::load_manifest(base + ".json").manifest);
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->what, "plane color");
    EXPECT_FALSE(inspect::load_manifest(base + ".json").values.empty());
}

TEST_F(ExpectPasses, AMissingPassIsNamed) {
    write_golden(recording(200), golden);
    CommandList list = two_passes(200);
    list.commands.resize(2);
    EXPECT_THAT(message_of(passes_eq(list, golden)),
                ::testing::HasSubstr("missing: pass 1 'mark'"));
}

TEST_F(ExpectPasses, WithoutValuesTheActualPictureIsLeft) {
    write_golden(recording(200), golden);
    fs::remove(folder / "two.values");
    const std::string message = message_of(passes_eq(two_passes(201), golden));
    EXPECT_THAT(message, ::testing::HasSubstr("pass 1 'mark', plane color"));
    EXPECT_THAT(message, ::testing::HasSubstr("-actual.png"));
    EXPECT_THAT(message, ::testing::Not(::testing::HasSubstr("-expected.png")));
}

TEST_F(ExpectPasses, AMissingDamagedOrUnwritableFileIsAFailureThatSaysSo) {
    for (const std::string& missing : {message_of(passes_eq(two_passes(1), golden)),
                                       message_of(passes_eq(recording(1), golden))}) {
        EXPECT_THAT(missing, ::testing::HasSubstr("two.json"));
        EXPECT_THAT(missing, ::testing::HasSubstr("GW_UPDATE_GOLDENS=1"));
    }
    std::ofstream(golden) << "{ \"format\": 7";
    EXPECT_THAT(message_of(passes_eq(recording(1), golden)), ::testing::HasSubstr("two.json"));
    setenv("GW_UPDATE_GOLDENS", "1", 1);
    std::ofstream(folder / "file");
    EXPECT_THAT(message_of(passes_eq(recording(1), folder / "file" / "two.json")),
                ::testing::HasSubstr("file"));
}

TEST_F(ExpectPasses, UpdatingMakesTheGoldensFolder) {
    const fs::path deep = folder / "goldens" / "of lines" / "two.json";
    setenv("GW_UPDATE_GOLDENS", "1", 1);
    EXPECT_TRUE(passes_eq(recording(200), deep));
    unsetenv("GW_UPDATE_GOLDENS");
    EXPECT_PASSES_EQ(two_passes(200), deep);
}

TEST_F(ExpectPasses, AListThatIsNotValidIsAFailure) {
    write_golden(recording(200), golden);
    CommandList list = two_passes(200);
    list.add(Read{.rect = {0, 0, 100, 100}});
    EXPECT_THAT(message_of(passes_eq(list, golden)),
                ::testing::HasSubstr("list 0: command 4 (Read) of pass 'mark': rect = 0 0 100 100; "
                                     "expected one inside the window"));
}

TEST_F(ExpectPasses, GoldensChangeOnlyWhereAsked) {
    write_golden(recording(200), golden);
    EXPECT_FALSE(passes_eq(recording(201), golden));
    EXPECT_TRUE(passes_eq(recording(200), golden));
    setenv("GW_UPDATE_GOLDENS", "1", 1);
    EXPECT_TRUE(passes_eq(recording(201), golden));
    unsetenv("GW_UPDATE_GOLDENS");
    EXPECT_TRUE(passes_eq(recording(201), golden));
    EXPECT_FALSE(passes_eq(recording(200), golden));
}

TEST_F(ExpectPasses, TheMacroFailsTheTestWithThatMessage) {
    EXPECT_NONFATAL_FAILURE(EXPECT_PASSES_EQ(two_passes(1), "no/such/golden.json"),
                            "no/such/golden.json");
}

}  // namespace gw::testing
