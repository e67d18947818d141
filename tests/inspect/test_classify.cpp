// Claim: a pixel of another renderer that differs is a rounding, an edge, or neither.
#include <gtest/gtest.h>

#include "inspect/compare/classify.h"

namespace gw::inspect {
namespace {

/// 6 x 3 pixels: columns 0 .. 2 are near and grey, 3 .. 5 far and black.
Planes half() {
    Planes p(6, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            p.color[p.index(x, y)] = {100, 100, 100, 255};
            p.depth[p.index(x, y)] = 5000;
        }
    return p;
}

}  // namespace

TEST(Classify, SamePlanesDoNotDiffer) {
    for (const Plane plane : {Plane::Color, Plane::Depth, Plane::Stencil})
        EXPECT_EQ(classify(half(), half(), plane), Differences());
}

TEST(Classify, FewUnitsAreARounding) {
    Planes theirs = half();
    theirs.color[theirs.index(1, 1)] = {104, 96, 100, 255};
    theirs.depth[theirs.index(1, 1)] = 5256;
    EXPECT_EQ(classify(half(), theirs, Plane::Color), (Differences{.rounding = 1, .worst = 8}));
    EXPECT_EQ(classify(half(), theirs, Plane::Depth), (Differences{.rounding = 1, .worst = 256}));
}

TEST(Classify, ANeighboursValueIsAnEdge) {
    Planes theirs = half();
    theirs.color[theirs.index(3, 1)] = {100, 101, 100, 255};  // covered there, not here
    theirs.color[theirs.index(2, 0)] = {};                    // the other way round
    EXPECT_EQ(classify(half(), theirs, Plane::Color), (Differences{.edge = 2, .worst = 556}));
}

TEST(Classify, AnythingElseIsOther) {
    Planes theirs = half();
    theirs.color[theirs.index(1, 1)] = {105, 100, 100, 255};
    theirs.depth[theirs.index(5, 1)] = 5000;
    theirs.stencil[theirs.index(0, 0)] = 1;
    EXPECT_EQ(classify(half(), theirs, Plane::Color), (Differences{.other = 1, .worst = 5}));
    EXPECT_EQ(classify(half(), theirs, Plane::Depth), (Differences{.other = 1, .worst = 5000}));
    EXPECT_EQ(classify(half(), theirs, Plane::Stencil), (Differences{.other = 1, .worst = 1}));
}

}  // namespace gw::inspect
