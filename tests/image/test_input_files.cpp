// Claim: no output replaces a file that the same run reads, by whatever name.
#include "gw/error.h"
#include "image/output/output_set.h"

#include "tests/image/files.h"

namespace gw::image {
namespace {

std::string refusal(const InputFiles& inputs, const std::filesystem::path& target) {
    OutputSet output(inputs);
    try {
        output.add(target);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST(InputFiles, AreNotReplacedByAnyOfTheirNames) {
    const Folder folder;
    write_file(folder / "scene.toml", "mine");
    std::filesystem::create_symlink("scene.toml", folder / "link");
    std::filesystem::create_hard_link(folder / "scene.toml", folder / "same");
    std::filesystem::create_directory(folder / "sub");
    InputFiles inputs;
    inputs.add(folder / "scene.toml");
    for (const char* name : {"scene.toml", "link", "same", "./scene.toml", "sub/../scene.toml"})
        EXPECT_EQ(refusal(inputs, folder / name),
                  (folder / name).string() +
                      ": cannot be written: this command reads it; expected another name");
    EXPECT_EQ(refusal(inputs, folder / "other"), "none");
    EXPECT_EQ(bytes_of(folder / "scene.toml"), "mine");
}

TEST(InputFiles, ThatAreMissingOrNoFilesForbidNothing) {
    const Folder folder;
    InputFiles inputs;
    inputs.add(folder / "missing");
    inputs.add("/dev/null");
    inputs.add(folder.path());
    EXPECT_EQ(refusal(inputs, folder / "missing"), "none");
    EXPECT_EQ(refusal(inputs, "/dev/null"), "none");
}

TEST(OutputSet, HasEachFileOnce) {
    const Folder folder;
    write_file(folder / "real", "old");
    std::filesystem::create_symlink("real", folder / "link");
    OutputSet output;
    output.add(folder / "a");
    output.add(folder / "real");
    EXPECT_THROW(output.add(folder / "a"), Error);
    EXPECT_THROW(output.add(folder / "./a"), Error);
    EXPECT_THROW(output.add(folder / "link"), Error);
    output.add("/dev/null");
    output.add("/dev/null");
}

}  // namespace gw::image
