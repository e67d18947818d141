// Claim: text from a file cannot control a terminal, nor hide or add lines.
#include "gw/error.h"
#include "gw/escape_controls.h"

#include <gtest/gtest.h>

namespace gw {

TEST(Shown, KeepsPrintableText) {
    for (const std::string text :
         {"", "plain ~", "größe 輪 🂡", "\u00a0", "\\x1b", "\xf4\x8f\xbf\xbf"})
        EXPECT_EQ(escape_controls(text), text);
}

TEST(Shown, OfEveryByteAlone) {
    for (int c = 0; c < 256; ++c) {
        const std::string text(1, char(c));
        const bool printable = c >= 0x20 && c < 0x7f;
        constexpr const char* digits = "0123456789abcdef";
        EXPECT_EQ(escape_controls(text),
                  printable ? text : std::string("\\x") + digits[c / 16] + digits[c % 16]);
        EXPECT_EQ(escape_controls(escape_controls(text)), escape_controls(text));
    }
}

TEST(Shown, HasNoControlsOfTwoBytesAndNoMarksOfDirection) {
    EXPECT_EQ(escape_controls("\u009b31m"), "\\xc2\\x9b31m");
    EXPECT_EQ(escape_controls("\u009f\u00a1"), "\\xc2\\x9f\u00a1");
    EXPECT_EQ(escape_controls("a\u2028b"), "a\\xe2\\x80\\xa8b");
    EXPECT_EQ(escape_controls("a\u2029b"), "a\\xe2\\x80\\xa9b");
    EXPECT_EQ(escape_controls("\u2027\u202a\u202e\u202f"),
              "\u2027\\xe2\\x80\\xaa\\xe2\\x80\\xae\u202f");
    EXPECT_EQ(escape_controls("\u061b\u061c\u200d\u200e\u200f\u2010"),
              "\u061b\\xd8\\x9c\u200d\\xe2\\x80\\x8e\\xe2\\x80\\x8f\u2010");
    EXPECT_EQ(escape_controls("\u2065\u2066\u2069\u206a"),
              "\u2065\\xe2\\x81\\xa6\\xe2\\x81\\xa9\u206a");
}

TEST(Shown, OfBytesThatAreNoUtf8) {
    EXPECT_EQ(escape_controls("\xc0\x9b"), "\\xc0\\x9b") << "longer than needed";
    EXPECT_EQ(escape_controls("\xe0\x9f\xbf"), "\\xe0\\x9f\\xbf") << "longer than needed";
    EXPECT_EQ(escape_controls("\xf0\x8f\xbf\xbf"), "\\xf0\\x8f\\xbf\\xbf") << "longer than needed";
    EXPECT_EQ(escape_controls("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair of UTF-16";
    EXPECT_EQ(escape_controls("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
    EXPECT_EQ(escape_controls("a\xe8\xbc"), "a\\xe8\\xbc") << "cut short";
    EXPECT_EQ(escape_controls("\xe8\xbc!"), "\\xe8\\xbc!") << "cut short by a character";
    EXPECT_EQ(escape_controls("\xf5\x80\x80\x80"), "\\xf5\\x80\\x80\\x80") << "beyond Unicode";
}

TEST(Shown, KeepsTheControlsThatItIsToldTo) {
    EXPECT_EQ(escape_controls("a\tb\nc\r\x1b", "\n\t"), "a\tb\nc\\x0d\\x1b");
}

TEST(Error, ShowsWhatItQuotes) {
    const std::string name("a\0b\n\x1b[2J", 8);
    EXPECT_STREQ(Error(name, 3, name).what(), "a\\x00b\\x0a\\x1b[2J:3: a\\x00b\\x0a\\x1b[2J");
}

}  // namespace gw
