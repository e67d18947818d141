// Claims: rotations are exact where they can be, right-handed, and orthogonal to the last bits
// elsewhere.
#include "scene/geometry/transform.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gw::scene {

TEST(Rotation, OfQuarterTurnsIsExact) {
    EXPECT_EQ(rotation({0, 0, 1}, 90) * dvec4(1, 2, 3, 1), dvec4(-2, 1, 3, 1));
    EXPECT_EQ(rotation({0, 7, 0}, 90) * dvec4(1, 2, 3, 1), dvec4(3, 2, -1, 1));
    EXPECT_EQ(rotation({0.1, 0, 0}, 180) * dvec4(1, 2, 3, 1), dvec4(1, -2, -3, 1));
    EXPECT_EQ(rotation({1, 2, 3}, 360), dmat4(1));
    EXPECT_EQ(rotation({-1, 0, 0}, 270), rotation({1, 0, 0}, 90));
}

TEST(Rotation, KeepsItsAxisAndLengths) {
    const dvec4 axis(1, 2, 2, 0);
    const dmat4 m = rotation(dvec3(axis), 37);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR((m * axis)[i], axis[i], 1e-15);
        EXPECT_NEAR(std::hypot(m[i].x, m[i].y, m[i].z), 1, 1e-15);
    }
}

TEST(Rotation, AboutXYZActsInThisOrder) {
    EXPECT_EQ(rotation_xyz({90, 0, 90}) * dvec4(0, 1, 0, 1), dvec4(0, 0, 1, 1));
    EXPECT_EQ(rotation_xyz({90, 90, 0}) * dvec4(0, 1, 0, 1), dvec4(1, 0, 0, 1));
}

TEST(Placement, TranslatesPointsOnly) {
    EXPECT_EQ(translation({1, 2, 3}) * dvec4(1, 1, 1, 1), dvec4(2, 3, 4, 1));
    EXPECT_EQ(translation({1, 2, 3}) * dvec4(1, 1, 1, 0), dvec4(1, 1, 1, 0));
    EXPECT_EQ(scaling({1, -2, 3}) * dvec4(1, 1, 1, 1), dvec4(1, -2, 3, 1));
}

}  // namespace gw::scene
