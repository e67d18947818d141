// The table of calls names, for every fragment, the call of the program that made it.
#include "gl/drawable/call_trace.h"
#include "gl/record/call_table.h"
#include "inspect/replay/pixel_history.h"
#include "tests/gl/unit/support/window.h"

#include <gtest/gtest.h>

namespace gw::gl {
namespace {

class Keeper : public FrameLog {
public:
    explicit Keeper(inspect::Recording& to) : to_(to) {}
    void open(Drawable&) override {}
    void begin_frame(Drawable&) override {}
    void executed(Drawable&, const Execution& execution) override {
        to_.lists.push_back(execution.list);
        to_.calls.push_back(namer_.table_of(execution.calls));
    }
    void end_frame(Drawable&) override {}
    void close(Drawable&) override {}

private:
    inspect::Recording& to_;
    CallNamer namer_;
};

/// What is drawn while one lives is recorded, with calls from 0 on. Object coordinates are pixels.
class RecordedWindow {
public:
    RecordedWindow() : log_((start(recording_), true)) {
        use_pixel_coordinates(window_);
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();  // ends the frame
    }
    ~RecordedWindow() {
        calls_are_kept = false;
        set_frame_log(nullptr);
    }
    RecordedWindow(const RecordedWindow&) = delete;
    RecordedWindow& operator=(const RecordedWindow&) = delete;

    /// The calls of the fragments of a pixel.
    std::vector<std::string> calls(int x, int y, bool with_sources = false) {
        glFlush();
        inspect::Recording r = recording_;
        r.profile = opengl();
        r.width = r.height = 32;
        if (!with_sources) leave_out_sources(r);
        std::vector<std::string> all;
        for (const inspect::PixelEvent& e : inspect::pixel_history(r, x, y))
            if (e.fragment) all.push_back(e.call);
        return all;
    }
    std::string call(int x, int y) {
        const auto all = calls(x, y);
        return all.empty() ? "" : all.back();
    }
    const inspect::Recording& recording() const { return recording_; }

private:
    static void start(inspect::Recording& recording) {
        set_frame_log(std::make_unique<Keeper>(recording));
        calls_are_kept = true;
    }
    static void leave_out_sources(inspect::Recording& r) {
        for (inspect::CallTable& table : r.calls) {
            for (auto& run : table.runs) run.call.source = inspect::no_call;
            for (auto& list : table.lists) list.caller.source = inspect::no_call;
        }
    }

    inspect::Recording recording_;
    bool log_;
    Window window_;
};

/// Squares of 4 x 4 pixels at x = 0, 8, 16, ...
void quads(int count, int y) {
    glBegin(GL_QUADS);
    for (int i = 0; i < count; ++i) {
        const int x = 8 * i;
        glVertex2i(x, y);
        glVertex2i(x + 4, y);
        glVertex2i(x + 4, y + 4);
        glVertex2i(x, y + 4);
    }
    glEnd();
}

}  // namespace

TEST(Calls, NameTheVertexThatCompletesAPrimitiveOfAMergedMesh) {
    RecordedWindow window;
    quads(2, 0);  // calls 0 to 9
    quads(3, 8);  // calls 10 to 23
    EXPECT_EQ(window.call(1, 1), "call 4 glVertex2i, quad 0");
    EXPECT_EQ(window.call(9, 1), "call 8 glVertex2i, quad 1");
    EXPECT_EQ(window.call(1, 9), "call 14 glVertex2i, quad 0");
    EXPECT_EQ(window.call(17, 9), "call 22 glVertex2i, quad 2");
    std::size_t draws = 0;
    for (const Command& command : window.recording().lists.back().commands)
        draws += std::holds_alternative<Draw>(command);
    EXPECT_EQ(draws, 1u) << "the runs were not merged: the test says nothing";
}

TEST(Calls, CountFromZeroInEachFrame) {
    RecordedWindow window;
    for (int frame = 0; frame < 3; ++frame) {
        glColor3f(1, 1, 1);
        quads(1, 0);
        const std::vector<std::string> all(std::size_t(frame) + 1, "call 5 glVertex2i, quad 0");
        EXPECT_EQ(window.calls(1, 1), all);
    }
}

TEST(Calls, OfNestedListsNameEachList) {
    for (const int count : {2, 16}) {  // played call by call; sealed
        RecordedWindow window;
        glNewList(3, GL_COMPILE);  // its calls: 0 glColor3f, 1 glBegin, 2 glVertex2i, ...
        glColor3f(1, 0, 0);
        quads(count, 0);
        glEndList();
        glNewList(7, GL_COMPILE);
        glEnable(GL_DITHER);
        glCallList(3);
        glEndList();
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        glCallList(7);
        EXPECT_EQ(window.call(9, 1),
                  "call 0 glCallList, list 7: call 1 glCallList, list 3: call 9 glVertex2i, quad 1")
            << count;
        glPushMatrix();
        const GLubyte names[] = {7};
        glCallLists(1, GL_UNSIGNED_BYTE, names);
        EXPECT_EQ(
            window.call(1, 1),
            "call 1 glCallLists, list 7: call 1 glCallList, list 3: call 5 glVertex2i, quad 0")
            << count;
    }
}

TEST(Calls, OfARunAcrossAListNameBoth) {
    RecordedWindow window;
    glNewList(3, GL_COMPILE);
    glVertex2i(4, 0);
    glVertex2i(4, 4);
    glVertex2i(0, 4);
    glEndList();
    glClear(GL_COLOR_BUFFER_BIT);
    glFinish();
    glBegin(GL_QUADS);
    glVertex2i(0, 0);
    glCallList(3);
    glVertex2i(8, 0);
    glVertex2i(12, 0);
    glVertex2i(12, 4);
    glVertex2i(8, 4);
    glEnd();
    EXPECT_EQ(window.call(1, 1), "call 2 glCallList, list 3: call 2 glVertex2i, quad 0");
    EXPECT_EQ(window.call(9, 1), "call 6 glVertex2i, quad 1");
}

TEST(Calls, OfArraysAreOneCall) {
    RecordedWindow window;
    const GLint corners[] = {0, 0, 4, 0, 0, 4, 8, 0, 12, 0, 8, 4};
    const GLubyte indices[] = {0, 1, 2, 3, 4, 5};
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(2, GL_INT, 0, corners);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    EXPECT_EQ(window.call(9, 1), "call 2 glDrawArrays, triangle 1");
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, indices);
    EXPECT_EQ(window.call(9, 1), "call 0 glDrawElements, triangle 1");
    glNewList(5, GL_COMPILE);
    glColor3f(1, 1, 1);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    glEndList();
    glCallList(5);
    EXPECT_EQ(window.call(9, 1), "call 4 glCallList, list 5: call 1 glDrawArrays, triangle 1");
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 6; ++i) glArrayElement(i);
    glEnd();
    EXPECT_EQ(window.call(9, 1), "call 6 glArrayElement, triangle 1");
}

TEST(Calls, CompleteThePrimitivesOfEveryMode) {
    struct Case {
        GLenum mode;
        std::vector<int> completing;  ///< vertex of each primitive, of 7 vertices
    };
    const Case cases[] = {{GL_POINTS, {0, 1, 2, 3, 4, 5, 6}},
                          {GL_LINES, {1, 3, 5}},
                          {GL_LINE_STRIP, {1, 2, 3, 4, 5, 6}},
                          {GL_LINE_LOOP, {1, 2, 3, 4, 5, 6, 6}},
                          {GL_TRIANGLES, {2, 5}},
                          {GL_TRIANGLE_STRIP, {2, 3, 4, 5, 6}},
                          {GL_TRIANGLE_FAN, {2, 3, 4, 5, 6}},
                          {GL_QUADS, {3}},
                          {GL_QUAD_STRIP, {3, 5}},
                          {GL_POLYGON, {6}}};
    for (const auto& [mode, completing] : cases)
        for (const bool stippled : {false, true}) {
            RecordedWindow window;
            if (stippled) glEnable(GL_LINE_STIPPLE);
            glBegin(mode);
            for (int i = 0; i < 7; ++i) glVertex2i(3 * i + i % 2, 5 * (i % 3));
            glEnd();
            glFlush();
            const auto& runs = window.recording().calls.back().runs;
            std::vector<int> found;
            for (const inspect::CallRun& run : runs) {
                const auto next =
                    &run + 1 < runs.data() + runs.size() && (&run + 1)->command == run.command
                        ? (&run + 1)->first
                        : std::uint32_t(completing.size());
                if (!std::holds_alternative<Draw>(
                        window.recording().lists.back().commands[run.command]))
                    continue;
                for (std::uint32_t p = run.first; p < next; ++p)
                    found.push_back(int(run.call.number + run.step * (p - run.first)) -
                                    (stippled ? 2 : 1));
            }
            EXPECT_EQ(found, completing) << mode << " " << stippled;
        }
}

TEST(Calls, OfOtherCommandsNameTheirFunctions) {
    RecordedWindow window;
    glRecti(0, 0, 4, 4);
    EXPECT_EQ(window.call(1, 1), "call 0 glRecti, polygon 0");
    glRasterPos2i(0, 0);
    const GLubyte bits[] = {0xFF, 0, 0, 0, 0xFF, 0, 0, 0};
    glBitmap(8, 2, 0, 0, 0, 0, bits);
    EXPECT_EQ(window.call(1, 1), "call 1 glBitmap");
}

TEST(Calls, NameThePlaceInTheProgram) {
    RecordedWindow window;
    glRecti(0, 0, 4, 4);
    const auto calls = window.calls(1, 1, true);
    ASSERT_EQ(calls.size(), 1u);
    EXPECT_NE(calls[0].find("call 0 glRecti at "), std::string::npos) << calls[0];
    EXPECT_NE(calls[0].find("test_gl"), std::string::npos) << calls[0];
}

/// A frame of many vertices has few runs.
TEST(Calls, OfALongRunAreFew) {
    RecordedWindow window;
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i < 1000; ++i) {
        glNormal3f(0, 0, 1);
        glVertex2i(i % 32, i / 32);
    }
    glEnd();
    glFlush();
    EXPECT_LE(window.recording().calls.back().runs.size(), 4u);
}

}  // namespace gw::gl
