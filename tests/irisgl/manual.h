// A window for the rules of the reference manual.
#pragma once

#include "tests/irisgl/support.h"

namespace gw::irisgl {

class IrisGlManual : public IrisGl {
protected:
    void SetUp() override {
        IrisGl::SetUp();
        mmode(MSINGLE);
        ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    }
    void TearDown() override {
        glcompat(GLC_OLDPOLYGON, 1);
        IrisGl::TearDown();
    }
    static void rgb(std::uint32_t background = 0) {
        RGBmode();
        gconfig();
        cpack(background);
        clear();
    }
    /// A square of 8 x 8 pixels from (4, 4) on, by bgnpolygon, with texture coordinates.
    static void square(float z = 0) {
        const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        bgnpolygon();
        for (const auto& c : corners) {
            float t[2] = {c[0], c[1]}, v[3] = {4 + 8 * c[0], 4 + 8 * c[1], z};
            t2f(t);
            v3f(v);
        }
        endpolygon();
    }
};

inline constexpr std::uint32_t red = 0x0000FF, green = 0x00FF00, blue = 0xFF0000;

}  // namespace gw::irisgl
