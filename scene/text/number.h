// Numbers in text: the float32 nearest to the decimal, in any locale. Does not skip blanks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gw::scene {

enum class NumberFault { None, NotANumber, NotFinite, TooLarge };

/// The number at the beginning of a text: its value, the first character after it, its fault.
struct FloatText {
    float value = 0;
    const char* end = nullptr;
    NumberFault fault = NumberFault::None;
};

/// Reads the number at `begin`: "1", "-.5", "+1e-3". Numbers too small for a float become 0 with
/// their sign.
FloatText read_float(const char* begin, const char* end);

/// The double nearest to a text that is nothing but a finite decimal number.
std::optional<double> read_double(std::string_view text);

/// " is not a number", " is not finite", " is too large".
std::string_view fault_text(NumberFault fault);

/// The shortest text that reads back as the same double.
std::string number_text(double value);

}  // namespace gw::scene
