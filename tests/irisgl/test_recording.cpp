// A recording names the calls of IRIS GL and keeps the colour map: what pixel histories say of
// programs, by hand.
#include "gl/drawable/call_trace.h"
#include "gl/drawable/settings.h"
#include "gl/record/recording.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"
#include "inspect/replay/shown_maps.h"
#include "tests/irisgl/support.h"
#include "tests/temporary_folder.h"

#include <memory>

namespace gw::irisgl {

/// What is drawn is recorded from the window's first call on: call 0 is qreset.
class IrisGlRecording : public IrisGl {
protected:
    void SetUp() override {
        gl::set_frame_log(
            std::make_unique<gl::Recording>(file_, gl::settings().profile, gl::FrameRange{}));
        gl::calls_are_kept = true;
        IrisGl::SetUp();
    }
    void TearDown() override {
        stop();
        IrisGl::TearDown();
    }
    static void stop() {
        gl::calls_are_kept = false;
        gl::set_frame_log(nullptr);
    }
    /// Of the window, or of planes above it; ends the recording.
    inspect::Recording recorded(const std::string& planes = "") {
        gflush();
        stop();
        return inspect::choose_window(inspect::read_recordings(file_),
                                      "window " + std::to_string(id) + planes);
    }
    /// The calls that touched a pixel, without their places in the program.
    static std::vector<std::string> calls(inspect::Recording r, int x, int y) {
        for (inspect::CallTable& table : r.calls) {
            for (auto& run : table.runs) run.call.source = inspect::no_call;
            for (auto& list : table.lists) list.caller.source = inspect::no_call;
        }
        std::vector<std::string> all;
        for (const inspect::PixelEvent& e : inspect::pixel_history(r, x, y))
            if (!e.call.empty()) all.push_back(e.call);
        return all;
    }
    /// The column of colours in a pixel's history, without its heading.
    static std::vector<std::string> colors(const inspect::Recording& r, int x, int y) {
        auto rows = inspect::history_rows(inspect::pixel_history(r, x, y));
        std::vector<std::string> all;
        for (std::size_t i = 1; i < rows.size(); ++i) all.push_back(rows[i][8]);
        return all;
    }

    using Words = std::vector<std::string>;

    const TemporaryFolder folder_;
    const std::string file_ = folder_ / "program.gwt";
};

TEST_F(IrisGlRecording, NamesTheCallThatDrew) {
    color(0);            // call 1
    clear();             // call 2
    color(5);            // call 3
    rectfi(1, 1, 4, 4);  // call 4
    long corners[4][2] = {{8, 1}, {12, 1}, {12, 5}, {8, 5}};
    polf2i(4, corners);  // call 5
    const inspect::Recording r = recorded();
    EXPECT_EQ(calls(r, 2, 2), (Words{"call 2 clear", "call 4 rectfi, polygon 0"}));
    EXPECT_EQ(calls(r, 10, 3), (Words{"call 2 clear", "call 5 polf2i, polygon 0"}));
}

// Corners at (1, 1) (1, 9) (9, 1) (9, 9): the first triangle has (3, 3), the second (7, 7).
TEST_F(IrisGlRecording, NamesAMeshesPrimitives) {
    color(5);                      // call 1
    bgntmesh();                    // call 2
    for (int i = 0; i < 4; ++i) {  // calls 3 to 6
        long corner[2] = {i < 2 ? 1 : 9, i % 2 == 0 ? 1 : 9};
        v2i(corner);
    }
    endtmesh();  // call 7
    const inspect::Recording r = recorded();
    EXPECT_EQ(calls(r, 3, 3), Words{"call 7 endtmesh, triangle 0"});
    EXPECT_EQ(calls(r, 7, 7), Words{"call 7 endtmesh, triangle 1"});
}

TEST_F(IrisGlRecording, NamesTheCallsOfObjects) {
    makeobj(3);          // call 1; its calls:
    color(5);            // call 2, 0 of the object
    rectfi(1, 1, 4, 4);  // call 3, 1 of the object
    closeobj();          // call 4
    makeobj(7);          // call 5
    callobj(3);          // call 6, 0 of the object
    closeobj();          // call 7
    callobj(7);          // call 8
    const inspect::Recording r = recorded();
    EXPECT_EQ(
        calls(r, 2, 2),
        Words{"call 8 callobj, object 7: call 0 callobj, object 3: call 1 rectfi, polygon 0"});
    delobj(3);
    delobj(7);
}

TEST_F(IrisGlRecording, CountsCallsFromZeroInEachFrame) {
    doublebuffer();
    gconfig();
    for (int frame = 0; frame < 2; ++frame) {
        swapbuffers();
        color(5);            // call 0
        rectfi(1, 1, 4, 4);  // call 1
        drawmode(OVERDRAW);  // other planes are drawn and shown meanwhile
        color(1);
        rectfi(1, 1, 4, 4);
        drawmode(NORMALDRAW);
        rectfi(8, 8, 9, 9);  // call 6
    }
    swapbuffers();
    const inspect::Recording r = recorded();
    EXPECT_EQ(calls(r, 2, 2), (Words{"call 1 rectfi, polygon 0", "call 1 rectfi, polygon 0"}));
    EXPECT_EQ(calls(r, 8, 8), (Words{"call 6 rectfi, polygon 0", "call 6 rectfi, polygon 0"}));
}

TEST_F(IrisGlRecording, NamesThePlaceInTheProgram) {
    rectfi(1, 1, 4, 4);
    const inspect::Recording r = recorded();
    const auto events = inspect::pixel_history(r, 2, 2);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].call.find("call 1 rectfi at "), 0u) << events[0].call;
    EXPECT_NE(events[0].call.find("test_irisgl"), std::string::npos) << events[0].call;
}

TEST_F(IrisGlRecording, KnowsTheMap) {
    mapcolor(37, 200, 100, 50);
    mapcolor(0, 0, 0, 0);
    color(37);
    clear();
    const inspect::Recording r = recorded();
    EXPECT_EQ(colors(r, 3, 3), Words{"index 0 > 37 through map entry 37 (200 100 50)"});
    const inspect::ColorMap* const map = inspect::ShownMaps(r).last();
    ASSERT_NE(map, nullptr);
    EXPECT_EQ(map->entries.size(), 4096u);
    EXPECT_EQ(map->bits_in_r, 8);
}

// 0xFFF, with the bits 0x0F0 of 0x155, is 0xF5F = 3935.
TEST_F(IrisGlRecording, ShowsWhatAWriteMaskLeaves) {
    mapcolor(3935, 4, 5, 6);
    color(0xFFF);
    clear();
    writemask(0x0F0);
    color(0x155);
    rectfi(1, 1, 4, 4);
    writemask(0xFFF);
    const auto all = colors(recorded(), 2, 2);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1], "index 4095 > 3935 through map entry 3935 (4 5 6)");
}

// Indices 1000 to 1015 from column 0 to 15: column 5 has 1005.
TEST_F(IrisGlRecording, NamesTheIndicesOfAShadedPolygon) {
    mapcolor(1005, 9, 8, 7);
    shademodel(GOURAUD);
    bgnpolygon();
    for (const auto& [x, y] : {std::pair{0L, 0L}, {15L, 0L}, {15L, 12L}, {0L, 12L}}) {
        color(Colorindex(1000 + x));
        long corner[2] = {x, y};
        v2i(corner);
    }
    endpolygon();
    EXPECT_EQ(colors(recorded(), 5, 5), Words{"index 0 > 1005 through map entry 1005 (9 8 7)"});
}

TEST_F(IrisGlRecording, HasTheMapOfEachFramesEnd) {
    doublebuffer();
    gconfig();
    color(37);
    rectfi(1, 1, 4, 4);
    mapcolor(37, 1, 1, 1);
    swapbuffers();
    rectfi(1, 1, 4, 4);
    mapcolor(37, 2, 2, 2);
    swapbuffers();
    const inspect::Recording r = recorded();
    Words back;
    const auto rows = inspect::history_rows(inspect::pixel_history(r, 2, 2));
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i][5] == "written") back.push_back(rows[i][11]);
    EXPECT_EQ(back, (Words{"index 0 > 37 through map entry 37 (1 1 1)",
                           "index 37 through map entry 37 (2 2 2)"}));
}

// Colours that cycle: nothing is drawn, another map is shown.
TEST_F(IrisGlRecording, HasAFrameForEachMapThatIsShownWithoutDrawing) {
    doublebuffer();
    gconfig();
    color(37);
    clear();
    mapcolor(37, 1, 1, 1);
    swapbuffers();
    mapcolor(37, 2, 2, 2);
    gsync();
    gsync();  // the same
    mapcolor(37, 3, 3, 3);
    mapcolor(37, 4, 4, 4);
    const inspect::Recording r = recorded();
    Words shown;
    const inspect::ShownMaps maps(r);
    for (std::size_t i = 0; const inspect::PassRange& pass : inspect::pass_ranges(r))
        shown.push_back(pass.name + ": " + std::to_string(maps.of_pass(i++)->entry(37)[0]));
    EXPECT_EQ(shown, (Words{"frame 0: 1", "frame 1: 2", "frame 2: 4"}));
    EXPECT_EQ(colors(r, 3, 3).size(), 2u) << "cleared and exchanged";
}

TEST_F(IrisGlRecording, HasMapsOfPlanesAboveThatAreShownWithoutDrawing) {
    overlay(2);
    gconfig();
    drawmode(OVERDRAW);
    color(2);
    mapcolor(2, 1, 1, 1);
    rectfi(1, 1, 4, 4);
    drawmode(NORMALDRAW);
    clear();
    gsync();
    drawmode(OVERDRAW);
    mapcolor(2, 2, 2, 2);
    drawmode(NORMALDRAW);
    const inspect::Recording r = recorded(" overlay");
    ASSERT_EQ(inspect::pass_ranges(r).size(), 2u);
    EXPECT_EQ(inspect::ShownMaps(r).of_pass(0)->entry(2)[0], 1);
    EXPECT_EQ(inspect::ShownMaps(r).last()->entry(2)[0], 2);
}

// The listener comes in the middle of a program, as on a page: no map has changed since.
TEST_F(IrisGlRecording, MakesNoFrameOfTheFirstMapThatItHearsOf) {
    stop();
    doublebuffer();
    gconfig();
    mapcolor(37, 1, 1, 1);
    color(37);
    clear();
    swapbuffers();
    gl::set_frame_log(
        std::make_unique<gl::Recording>(file_, gl::settings().profile, gl::FrameRange{}));
    gsync();
    rectfi(1, 1, 4, 4);
    swapbuffers();
    mapcolor(37, 2, 2, 2);
    gsync();
    const inspect::Recording r = recorded();
    Words passes;
    for (const auto& row : inspect::pass_ranges(r)) passes.push_back(row.name);
    EXPECT_EQ(passes, (Words{"before frame 1", "frame 1", "frame 2"}));
}

TEST_F(IrisGlRecording, NamesThePlanesAboveTheWindow) {
    overlay(2);
    gconfig();
    drawmode(OVERDRAW);
    mapcolor(2, 1, 2, 3);
    color(2);
    rectfi(1, 1, 4, 4);
    gflush();
    color(0);
    rectfi(1, 1, 4, 4);
    drawmode(NORMALDRAW);
    EXPECT_EQ(colors(recorded(" overlay"), 2, 2),
              (Words{"overlay index 0 > 2 through map entry 2 (1 2 3)",
                     "overlay index 2 > 0, which shows what is below"}));
}

TEST_F(IrisGlRecording, HasNoMapInRgbMode) {
    RGBmode();
    gconfig();
    cpack(0xFF030201);
    rectfi(1, 1, 4, 4);
    const inspect::Recording r = recorded();
    EXPECT_EQ(inspect::ShownMaps(r).last(), nullptr);
    EXPECT_EQ(colors(r, 2, 2), Words{"0 0 0 0 > 1 2 3 255"});
}

}  // namespace gw::irisgl
