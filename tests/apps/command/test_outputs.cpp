// Output that cannot be written: one line, exit code 1, nothing half written.
#include "tests/apps/scene_files.h"

namespace gw::apps {

using Outputs = SceneTest;

TEST_F(Outputs, MissingFolderAndFolderAsTarget) {
    std::filesystem::create_directory(in("folder"));
    expect_refused(1, {"render", "quad.obj", "-o", "missing/a.png"},
                   {"missing/a.png", "folder missing does not exist"});
    expect_refused(1, {"render", "quad.obj", "-o", "folder"}, {"folder: ", "it is a folder"});
    expect_refused(1, {"render", "quad.obj", "-o", "folder/"}, {"folder/: ", "it names a folder"});
    expect_refused(1, {"render", "quad.obj", "-o", "quad.obj/a.png"}, {"quad.obj is not a folder"});
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--manifest", "missing/m.json"},
                   {"missing does not exist"});
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--components", "missing/parts"},
                   {"missing/parts"});
    expect_refused(1, {"render", "quad.obj", "-o", "a.png", "--planes", "quad.obj"},
                   {"quad.obj: is not a folder"});
}

TEST_F(Outputs, UnknownExtension) {
    expect_refused(2, {"render", "quad.obj", "-o", "a.xyz"},
                   {"a.xyz", ".xyz", "expected .png, .exr, .tif"});
    expect_refused(2, {"render", "quad.obj", "-o", "a"},
                   {"a: has no extension", "expected .png, .exr, .tif"});
}

TEST_F(Outputs, FullDisk) {
    for (const std::string name : {"full.png", "full.exr", "full.tif", "full.ppm"}) {
        std::filesystem::create_symlink("/dev/full", in(name));
        expect_refused(1, {"render", "quad.obj", "-o", name, "--size", "16x16"},
                       {name, "No space left on device"});
    }
    std::filesystem::create_symlink("/dev/full", in("full.json"));
    expect_refused(
        1, {"render", "quad.obj", "-o", "a.png", "--size", "16x16", "--manifest", "full.json"},
        {"full.json", "No space left on device"});
}

TEST_F(Outputs, GrownBeyondTheLimitLeaveTheOldPicture) {
    for (const std::string name : {"a.png", "a.exr", "a.tif", "a.sgi", "a.rla"}) {
        write(name, "old");
        expect_refused(1, {"render", "quad.obj", "-o", name, "--size", "64x64"},
                       {name, "cannot be written"}, {.largest_file = 100});
        EXPECT_EQ(bytes_of(in(name)), "old");
    }
}

TEST_F(Outputs, AllOrNone) {
    expect_refused(
        1, {"render", "quad.obj", "-o", "a.png", "--planes", "planes", "--components", "parts"},
        {"cannot be written"}, {.largest_file = 10000});
}

TEST_F(Outputs, InterruptedLeaveNothing) {
    const auto before = names();
    // Far more work than half a second, so that the signal arrives while it is done.
    const Outcome outcome =
        gw({"render", "quad.obj", "-o", "a.png", "--size", "4096x4096", "--samples", "128"},
           {.interrupt_after_ms = 500});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(names(), before);
}

}  // namespace gw::apps
