// Feedback and picking: numbers by hand.
#include "tests/irisgl/support.h"

#include "irisgl/include/gl/feed.h"

#include <vector>

namespace gw::irisgl {

class IrisGlFeedback : public IrisGl {
protected:
    /// What `draw` gives back.
    template <class Draw>
    static std::vector<float> given(const Draw& draw, long size = 200) {
        std::vector<float> buffer(std::size_t(size) + 1, -77);
        feedback(buffer.data(), size);
        draw();
        const long count = endfeedback(buffer.data());
        EXPECT_EQ(buffer.back(), -77) << "beyond the buffer";
        buffer.resize(std::size_t(count));
        return buffer;
    }
    /// The places of the vertices after the word and the count.
    static std::vector<float> places(const std::vector<float>& numbers) {
        std::vector<float> out;
        for (std::size_t i = 2; i + 9 <= numbers.size(); i += 9)
            out.insert(out.end(), {numbers[i], numbers[i + 1]});
        return out;
    }
};

TEST_F(IrisGlFeedback, APointHasNineNumbersOfItsPixelDepthAndColour) {
    const auto numbers = given([] {
        color(5);
        pnt2i(3, 4);
    });
    const std::vector<float> expected{95, 9, 3, 4, 0, 5, 5, 5, 5, 0, 0};
    EXPECT_EQ(numbers, expected);
    EXPECT_EQ(count_of(5), 0);
}

TEST_F(IrisGlFeedback, LinesPolygonsAndMarksComeInTheirOrder) {
    const auto numbers = given([] {
        passthrough(7);
        move2i(1, 2);
        draw2i(6, 2);
        cmov2i(4, 5);
        rectfi(2, 3, 5, 6);
    });
    ASSERT_EQ(numbers.size(), 3u + 20 + 5 + 38);
    EXPECT_EQ(numbers[0], float(FB_PASSTHROUGH));
    EXPECT_EQ(numbers[2], 7);
    EXPECT_EQ(numbers[3], float(FB_LINE));
    EXPECT_EQ(numbers[4], 18);
    EXPECT_EQ(numbers[23], float(FB_CMOV));
    EXPECT_EQ(numbers[24], 3);
    EXPECT_EQ(numbers[25], 4);
    EXPECT_EQ(numbers[26], 5);
    EXPECT_EQ(numbers[28], float(FB_POLYGON));
    EXPECT_EQ(numbers[29], 36);
    const std::vector<float> corners{2, 3, 5, 3, 5, 6, 2, 6};
    EXPECT_EQ(places({numbers.begin() + 28, numbers.end()}), corners);
}

// Window coordinates of the edge are -0.5 and 15.5: pixels' middles are whole numbers.
TEST_F(IrisGlFeedback, WhatIsOutsideTheViewportIsCutOff) {
    const auto numbers = given([] {
        move2i(-10, 4);
        draw2i(30, 4);
        pnt2i(40, 4);
    });
    const std::vector<float> ends{-0.5f, 4, 15.5f, 4};
    EXPECT_EQ(places(numbers), ends);
}

TEST_F(IrisGlFeedback, TheDepthIsThatOfLsetdepth) {
    const auto numbers = given([] {
        lsetdepth(0, 1000);
        ortho(-0.5f, 15.5f, -0.5f, 15.5f, 0, 4);
        pnt(3, 4, -2);
    });
    EXPECT_FLOAT_EQ(numbers[4], 500);
}

TEST_F(IrisGlFeedback, RgbModeGivesBytes) {
    RGBmode();
    const auto numbers = given([] {
        cpack(0xFF3366CC);
        pnt2i(3, 4);
    });
    EXPECT_FLOAT_EQ(numbers[5], 0xCC);
    EXPECT_FLOAT_EQ(numbers[6], 0x66);
    EXPECT_FLOAT_EQ(numbers[7], 0x33);
}

TEST_F(IrisGlFeedback, ABufferThatOverflowsIsFullAndNoMore) {
    const auto numbers = given(
        [] {
            for (int i = 0; i < 100; ++i) rectfi(1, 1, 5, 5);
        },
        20);
    EXPECT_EQ(numbers.size(), 20u);
    EXPECT_EQ(endfeedback(nullptr), 0);
}

TEST_F(IrisGlFeedback, PickingInsideFeedbackIsRefused) {
    short names[8] = {};
    given([&] { pick(names, 8); });
    EXPECT_EQ(endpick(names), 0);
}

// Nested names: a hit has all names of the stack.
TEST_F(IrisGlFeedback, SelectingNamesTheWholeStackOfEachHit) {
    short names[20] = {};
    gselect(names, 20);
    ortho2(2.5f, 8.5f, 2.5f, 8.5f);
    initnames();
    loadname(1);
    pushname(2);
    pnt2i(4, 4);
    popname();
    loadname(3);
    pnt2i(12, 4);
    loadname(4);
    pnt2i(5, 5);
    EXPECT_EQ(endselect(names), 2);
    const short expected[] = {2, 1, 2, 1, 4};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(names[i], expected[i]) << i;
}

// "-n if the buffer is too small for all hits": those that fit are there.
TEST_F(IrisGlFeedback, ABufferTooSmallForTheHitsGivesANegativeCount) {
    short names[5] = {0, 0, 0, 0, -9};
    gselect(names, 4);
    ortho2(-0.5f, 15.5f, -0.5f, 15.5f);
    initnames();
    for (short i = 1; i < 6; ++i) {
        loadname(i);
        pnt2i(4, 4);
    }
    EXPECT_EQ(endselect(names), -2);
    EXPECT_EQ(names[3], 2);
    EXPECT_EQ(names[4], -9);
}

}  // namespace gw::irisgl
