// Recordings of framebuffer objects.
#include "gl/drawable/off_screen.h"
#include "gl/record/recording.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace gw::gl {

/// Their surfaces are not restored in the middle of a program: a warning, once.
TEST(GlRecordings, LeaveOutFramebufferObjectsThatWereDrawnToBefore) {
    const auto machine = std::make_shared<OffScreen>(opengl());
    const TemporaryFolder folder;
    Recording recording(folder / "left_out.gwt", opengl(), {.first = 1});
    testing::internal::CaptureStderr();
    recording.begin_frame(*machine);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "before frame 1";
    SurfaceImage image(machine, {.width = 2, .height = 2}, false);
    machine->use(machine->surface_of({&image, Plane::Color}, false));
    machine->finish();
    testing::internal::CaptureStderr();
    recording.begin_frame(*machine);
    recording.begin_frame(*machine);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("is not recorded"), std::string::npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

}  // namespace gw::gl
