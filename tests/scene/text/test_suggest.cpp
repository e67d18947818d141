// Claims: the nearest known name is the one with the fewest edits, and messages stay on one short
// line.
#include "scene/text/suggest.h"

#include <gtest/gtest.h>

namespace gw::scene {

TEST(EditDistance, CountsEditsAndSwapsOfNeighbours) {
    EXPECT_EQ(edit_distance("", ""), 0);
    EXPECT_EQ(edit_distance("", "fov"), 3);
    EXPECT_EQ(edit_distance("fov", "fow"), 1);
    EXPECT_EQ(edit_distance("fov", "fvo"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("Kd", "kd"), 1);
}

TEST(Nearest, IsTheFirstOfThoseEquallyNear) {
    EXPECT_EQ(nearest("map_Kf", {"map_Ka", "map_Kd", "refl"}), "map_Ka");
    EXPECT_EQ(nearest("rfl", {"map_Ka", "map_Kd", "refl"}), "refl");
    EXPECT_EQ(nearest("x", {}), "");
}

TEST(Unknown, NamesTheNearest) {
    EXPECT_EQ(unknown("material", "rde", {"blue", "red"}),
              "unknown material 'rde'; the nearest known is 'red'");
    EXPECT_EQ(unknown("key", "fvo", {"fov"}, "camera"),
              "unknown key 'fvo' in camera; the nearest known is 'fov'");
    EXPECT_EQ(unknown("material", "rde", {}), "unknown material 'rde'; none is known");
}

TEST(Printable, KeepsAMessageOnOneShortLine) {
    EXPECT_EQ(printable("a\nb\tc"), "a\\x0ab\\x09c");
    EXPECT_EQ(printable("größe", 3), "gr...") << "characters stay whole";
    EXPECT_EQ(printable("größe", 4), "grö...");
    EXPECT_EQ(printable(std::string(41, 'x')), std::string(40, 'x') + "...");
}

}  // namespace gw::scene
