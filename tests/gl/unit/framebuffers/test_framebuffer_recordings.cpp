// Recordings of framebuffer objects that begin in the middle of a program.
#include "gl/drawable/off_screen.h"
#include "gl/record/recording.h"
#include "gw/machine.h"
#include "inspect/recording/stream.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace gw::gl {

namespace {

/// An image of framebuffers, and the recording of their machine from frame 1 on.
class GlRecordings : public testing::Test {
protected:
    explicit GlRecordings(int samples = 0)
        : machine(std::make_shared<OffScreen>(opengl())),
          image(machine, {.width = 3, .height = 2, .depth_bits = 24, .samples = samples}, false) {}
    void begin_recording() {
        set_frame_log(std::make_unique<Recording>(file, opengl(), FrameRange{.first = 1}));
    }
    void end_recording() { set_frame_log(nullptr); }
    ~GlRecordings() override { end_recording(); }

    std::vector<Rgba> colors() const {
        std::vector<Rgba> out;
        for (std::uint16_t i = 0; i < 6; ++i)
            out.push_back({std::uint16_t(10 * i), std::uint16_t(200 - i), i, 255});
        return out;
    }

    const TemporaryFolder folder;
    const std::string file = folder / "late.gwt";
    const std::shared_ptr<OffScreen> machine;
    SurfaceImage image;
};

class GlRecordingsOfSamples : public GlRecordings {
protected:
    GlRecordingsOfSamples() : GlRecordings(4) {}
};

}  // namespace

// Frame 0 writes colours and depths, frame 1 one pixel of them; nothing is cleared.
TEST_F(GlRecordings, RestoreFramebufferObjectsThatWereDrawnToBefore) {
    begin_recording();
    machine->write({&image, Plane::Color}, colors(), {});
    machine->write({&image, Plane::Depth}, {}, {1, 2, 3, 4, 5, 0xFFFFFF});
    machine->finish();
    machine->use(machine->surface_of({&image, Plane::Color}, false));
    machine->add(WritePixels{.rect = {1, 1, 1, 1}, .colors = {{7, 8, 9, 10}}});
    machine->finish();
    const Readback color = machine->read_plane({&image, Plane::Color}, Cause::Read);
    const Readback depth = machine->read_plane({&image, Plane::Depth}, Cause::Read);
    const std::uint32_t color_at = image.surface(Plane::Color);
    const std::uint32_t depth_at = image.surface(Plane::Depth);
    end_recording();

    const auto recording = inspect::choose_window(inspect::read_recordings(file), machine->name());
    const auto replayed = make_reference(opengl(), 1, 1);
    for (const CommandList& list : recording.lists) replayed->execute(list);
    CommandList reads;
    reads.add(UseSurface{color_at});
    reads.add(Read{0, Plane::Color, {0, 0, 3, 2}});
    reads.add(UseSurface{depth_at});
    reads.add(Read{1, Plane::Depth, {0, 0, 3, 2}});
    replayed->execute(reads);
    EXPECT_EQ(replayed->readbacks().at(0), color);
    EXPECT_EQ(replayed->readbacks().at(1), depth);
    EXPECT_EQ(color.color[0], colors()[0]);
    EXPECT_EQ(color.color[4], (Rgba{7, 8, 9, 10}));
}

TEST_F(GlRecordings, WithoutAnyFrameSaySo) {
    begin_recording();
    machine->add(gw::Clear{.planes = mask_of(Plane::Color)});
    machine->finish();
    testing::internal::CaptureStderr();
    end_recording();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("no frame of GW_FRAMES was drawn"), std::string::npos) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

/// Their samples' values cannot be read apart: a warning, once.
TEST_F(GlRecordingsOfSamples, SayThatTheyBeginWithOneValueForAllSamples) {
    begin_recording();
    testing::internal::CaptureStderr();
    machine->write({&image, Plane::Color}, colors(), {});
    machine->finish();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "before frame 1";
    testing::internal::CaptureStderr();
    for (int frame = 1; frame < 3; ++frame) {
        machine->add(gw::Clear{.planes = mask_of(Plane::Color)});
        machine->finish();
    }
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_NE(said.find("begins with frame 1, with one value for all samples"), std::string::npos)
        << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
}

}  // namespace gw::gl
