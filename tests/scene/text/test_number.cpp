// Claims: decimals become the nearest float32; texts that are no finite number are refused.
#include "scene/text/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace gw::scene {
namespace {

FloatText read(const std::string& text) {
    FloatText result = read_float(text.data(), text.data() + text.size());
    EXPECT_LE(result.end, text.data() + text.size());
    return result;
}

}  // namespace

TEST(ReadFloat, RoundsToTheNearestFloatNotThroughDouble) {
    // 1 + 2^-24 + 2^-60: rounded to double first, it would be a tie and go down to 1.
    EXPECT_EQ(read("1.00000005960464477626").value, std::bit_cast<float>(0x3f800001u));
    EXPECT_EQ(read("0.1").value, std::bit_cast<float>(0x3dcccccdu));
    EXPECT_EQ(read("16777217").value, 16777216.0f);  // a tie goes to even
    EXPECT_EQ(read("1.17549421e-38").value, std::bit_cast<float>(0x007fffffu));
}

TEST(ReadFloat, TakesTheFormsFoundInFiles) {
    EXPECT_EQ(read("-.5").value, -0.5f);
    EXPECT_EQ(read("+1.").value, 1.0f);
    EXPECT_EQ(read("1E+2").value, 100.0f);
    EXPECT_EQ(read("1e-7").value, 1e-7f);
}

TEST(ReadFloat, MakesZeroOfWhatIsTooSmallWithItsSign) {
    for (const char* text : {"-1e-50", "-1e-400", "-1E-999999"}) {
        EXPECT_EQ(read(text).fault, NumberFault::None) << text;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(read(text).value), 0x80000000u) << text;
    }
}

TEST(ReadFloat, SaysWhatIsWrong) {
    EXPECT_EQ(read("abc").fault, NumberFault::NotANumber);
    EXPECT_EQ(read("").fault, NumberFault::NotANumber);
    EXPECT_EQ(read("+-1").fault, NumberFault::NotANumber);
    EXPECT_EQ(read("nan").fault, NumberFault::NotFinite);
    EXPECT_EQ(read("-inf").fault, NumberFault::NotFinite);
    EXPECT_EQ(read("3.5e38").fault, NumberFault::TooLarge);
    EXPECT_EQ(read("-1e400").fault, NumberFault::TooLarge);
}

TEST(ReadFloat, StopsAfterTheNumber) {
    const std::string text = "12abc";
    EXPECT_EQ(read_float(text.data(), text.data() + text.size()).end - text.data(), 2);
}

TEST(ReadDouble, TakesFiniteDecimalsOnly) {
    EXPECT_EQ(read_double("0.1"), 0.1);
    EXPECT_EQ(read_double("-1e300"), -1e300);
    for (const char* text : {"", "x", "1x", "0x10", "nan", "inf", "1e400"})
        EXPECT_EQ(read_double(text), std::nullopt) << text;
}

TEST(NumberText, IsTheShortest) {
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(179), "179");
}

}  // namespace gw::scene
