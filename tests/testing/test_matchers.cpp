// Claims: each matcher for planes holds for its value and for no other, and says what it found.
#include <gtest/gtest.h>

#include "inspect/testing/failure_files.h"
#include "inspect/testing/matchers.h"

#include <cstdlib>
#include "tests/temporary_folder.h"

namespace gw::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// 3 x 2 pixels, all different from 0 at (2, 1).
Planes planes() {
    Planes p(3, 2);
    const std::size_t i = p.index(2, 1);
    p.color[i] = {1, 2, 3, 4};
    p.depth[i] = 70000;
    p.stencil[i] = 9;
    p.accum[i] = {-1, 0, 5, 6};
    return p;
}

std::string explanation(const PlanesMatcher& matcher, const Planes& p) {
    ::testing::StringMatchResultListener listener;
    EXPECT_FALSE(matcher.MatchAndExplain(p, &listener));
    return listener.str();
}

}  // namespace

TEST(Matchers, ReadAPixel) {
    EXPECT_THAT(planes(), HasColor(2, 1, {1, 2, 3, 4}));
    EXPECT_THAT(planes(), HasDepth(2, 1, 70000));
    EXPECT_THAT(planes(), HasStencil(2, 1, 9));
    EXPECT_THAT(planes(), HasAccum(2, 1, {-1, 0, 5, 6}));
    EXPECT_EQ(explanation(HasColor(2, 1, {1, 2, 3, 5}), planes()), "which is 1 2 3 4");
    EXPECT_EQ(explanation(HasDepth(2, 0, 70000), planes()), "which is 0");
    EXPECT_EQ(explanation(HasStencil(2, 1, 8), planes()), "which is 9");
    EXPECT_EQ(explanation(HasAccum(2, 1, {1, 0, 5, 6}), planes()), "which is -1 0 5 6");
    EXPECT_EQ(explanation(HasDepth(3, 0, 0), planes()), "which are 3 x 2");
}

TEST(Matchers, ComparePlanes) {
    Planes other = planes();
    EXPECT_THAT(other, PlanesEq(planes()));
    other.depth[0] = 7;
    EXPECT_THAT(other, PlaneEq(Plane::Color, planes()));
    EXPECT_EQ(explanation(PlaneEq(Plane::Depth, planes()), other),
              "where depth differs at 1 pixel, worst at (0, 0): expected 0, got 7");
    EXPECT_THAT(explanation(PlanesEq(planes()), other), HasSubstr("where depth differs"));
    EXPECT_EQ(explanation(PlaneEq(Plane::Depth, planes()), Planes(2, 3)),
              "which are 2 x 3, expected 3 x 2");
}

TEST(Matchers, LeavePicturesWhereTheyKnowTheProfile) {
    const TemporaryFolder folder;
    setenv("GW_TESTING_OUTPUT", folder.path().c_str(), 1);
    Planes other = planes();
    other.stencil[0] = 1;
    EXPECT_THAT(explanation(PlanesEq(planes(), vgx()), other), HasSubstr("stencil-difference.png"));
    EXPECT_TRUE(fs::exists(
        folder / "Matchers.LeavePicturesWhereTheyKnowTheProfile-planes-stencil-difference.png"));
}

TEST(Matchers, PrintPlanesInAFewWords) {
    EXPECT_EQ(::testing::PrintToString(planes()), "planes of 3 x 2 pixels");
}

TEST(Matchers, ReadDigests) {
    EXPECT_THAT(planes(), HasDigest(Plane::Depth, to_string(digest(planes(), Plane::Depth))));
    EXPECT_THAT(planes(), Not(HasDigest(Plane::Depth, to_string(digest(planes(), Plane::Color)))));
}

TEST(Matchers, CountCoveredPixels) {
    EXPECT_THAT(planes(), CoveredPixels(Plane::Color, Planes(3, 2), 1u));
    EXPECT_EQ(explanation(CoveredPixels(Plane::Color, Planes(3, 2), ::testing::Gt(1u)), planes()),
              "which is 1");
}

}  // namespace gw::testing
