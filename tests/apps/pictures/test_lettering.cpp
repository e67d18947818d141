// Claims: every sign of ASCII has a shape of its own; text is clipped by the picture; captions are
// readable.
#include "apps/hidden/lettering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gw::apps {
namespace {

constexpr Color ink{255, 255, 255};

image::Picture black(int width, int height) {
    return {width, height, 3, 8, std::vector<std::uint16_t>(std::size_t(3 * width * height))};
}

std::vector<std::uint16_t> shape(char letter) {
    image::Picture picture = black(5, 9);
    write_text(picture, 0, 0, 1, ink, std::string(1, letter));
    return picture.values;
}

}  // namespace

TEST(Lettering, HasAShapeForEverySignOfAscii) {
    std::set<std::vector<std::uint16_t>> shapes;
    for (char letter = ' '; letter <= '~'; ++letter) shapes.insert(shape(letter));
    EXPECT_EQ(shapes.size(), 95u);
    shapes.insert(shape('\t'));
    shapes.insert(shape(char(0xe3)));
    EXPECT_EQ(shapes.size(), 96u);  // the same box
}

TEST(Lettering, IsUprightWithTheTopRowLast) {
    const auto l = shape('L');
    const auto at = [&](int x, int y_up) { return l[std::size_t(3 * (y_up * 5 + x))]; };
    for (int y = 0; y < 9; ++y) EXPECT_EQ(at(0, y), y < 2 ? 0 : 255);
    for (int x = 0; x < 5; ++x) {
        EXPECT_EQ(at(x, 2), 255);
        EXPECT_EQ(at(x, 8), x == 0 ? 255 : 0);
    }
}

TEST(Lettering, HasTailsBelowTheLine) {
    for (const char letter : std::string("gpqy")) {
        const auto dots = shape(letter);
        EXPECT_TRUE(std::any_of(dots.begin(), dots.begin() + 5 * 3, [](auto v) { return v > 0; }))
            << letter;
    }
    for (const char letter : std::string("abdehnoPx")) {
        const auto dots = shape(letter);
        EXPECT_TRUE(std::all_of(dots.begin(), dots.begin() + 2 * 5 * 3, [](auto v) {
            return v == 0;
        })) << letter;
    }
}

TEST(Lettering, LeavesOutWhatDoesNotFit) {
    image::Picture picture = black(20, 10), clipped = black(8, 5);
    write_text(picture, 0, 0, 2, ink, "MM");
    write_text(clipped, 0, 0, 2, ink, "MMMM");
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(clipped.values[std::size_t(3 * (y * 8 + x))],
                      picture.values[std::size_t(3 * ((y + 5) * 20 + x))]);
    image::Picture none = black(4, 4);
    write_text(none, -100, -100, 3, ink, "M");
    write_text(none, 100, 100, 3, ink, "M");
    EXPECT_EQ(none, black(4, 4));
}

TEST(Caption, KeepsThePictureBelowItAndTheSizeWhateverItSays) {
    image::Picture picture = black(160, 20);
    std::fill(picture.values.begin(), picture.values.end(), std::uint16_t{77});
    const image::Picture a = captioned(picture, {{{"short"}}, {}}),
                         b = captioned(picture, {{{std::string(500, 'x')}}, {{"second"}}});
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.values.size(), std::size_t(3 * a.width * a.height));
    EXPECT_TRUE(std::equal(picture.values.begin(), picture.values.end(), a.values.begin()));
    EXPECT_NE(a, b);
}

}  // namespace gw::apps
