// A window of IRIS GL without a screen, and the picture that is shown.
#pragma once

#include "irisgl/window/window.h"

#include "irisgl/state/program.h"

extern "C" {
#include "generated/irisgl/include/gl/functions.h"
}

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace gw::irisgl {

/// 16 x 16 pixels, an integer a pixel's centre; the window goes with the test.
class IrisGl : public ::testing::Test {
protected:
    void SetUp() override {
        unsetenv("DISPLAY");
        program().events = {};
        prefsize(16, 16);
        id = winopen("test");
        qreset();
    }
    void TearDown() override { winclose(id); }

    /// R | G << 8 | B << 16 as shown.
    static std::uint32_t shown(int x, int y) {
        gflush();
        const Planes& planes = current_window().shown();
        return packed(planes.color[planes.index(x, y)]) & 0xFFFFFF;
    }
    /// The index at a pixel.
    static int index_at(int x, int y) {
        short pixel = -1;
        rectread(short(x), short(y), short(x), short(y), &pixel);
        return pixel;
    }
    static int count_of(int index) {
        int count = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) count += index_at(x, y) == index;
        return count;
    }
    long id = 0;
};

}  // namespace gw::irisgl
