// Claims: rotations are exact where they can be, right-handed, and orthogonal to the last bits
// elsewhere.
#include "scene/geometry/transform.h"

#include <glm/matrix.hpp>

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

/// What is flat in a turned place keeps a millionth of its size across, and is not mirrored.
TEST(Thickened, LeavesThicknessToWhatIsFlat) {
    const dmat4 turned = rotation_xyz({10, 20, 30}), other = rotation_xyz({-50, 5, 70});
    const dmat4 thick = thickened(turned * scaling({3, 0, 2}) * other);
    const double left = std::sqrt(9 + 4) * 1e-6;
    EXPECT_NEAR(glm::determinant(dmat3(thick)), 3 * left * 2, 1e-12);
    // Of a plane's two sides, one is the normal.
    const dvec3 normal(turned[1]),
        across = dvec3(thick * (glm::inverse(other) * dvec4(0, 1, 0, 0)));
    EXPECT_NEAR(length(across), left, 1e-12);
    EXPECT_NEAR(std::abs(dot3(across, normal)), left, 1e-12);
    for (const dvec3& kept :
         {dvec3(1, 2, 3), dvec3(1, 1, 1e-9), dvec3(1e-7, 1e-7, 1), dvec3(0), dvec3(0, 0, 1)})
        EXPECT_EQ(thickened(scaling(kept)), scaling(kept));
}

}  // namespace gw::scene
