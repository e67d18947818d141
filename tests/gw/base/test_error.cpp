#include <gtest/gtest.h>

#include "gw/error.h"

namespace gw {

TEST(Error, NamesFileAndLine) {
    EXPECT_STREQ(Error("rings.mtl", 12, "Kd has two numbers; expected three").what(),
                 "rings.mtl:12: Kd has two numbers; expected three");
}

TEST(Error, LineZeroMeansTheWholeFile) {
    EXPECT_STREQ(Error("rings.obj", 0, "is empty; expected a mesh").what(),
                 "rings.obj: is empty; expected a mesh");
}

TEST(Error, KeepsAPlainMessageAsItIs) {
    EXPECT_STREQ(Error("no such profile: vgy").what(), "no such profile: vgy");
}

}  // namespace gw
