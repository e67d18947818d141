#include "scene/text/number.h"

#include <charconv>
#include <cmath>

namespace gw::scene {
namespace {

// from_chars says "out of range" for numbers too large and for numbers too small alike.
FloatText out_of_range(const char* begin, const char* end) {
    const bool negative = *begin == '-';
    double value = 0;
    const auto result = std::from_chars(begin, end, value);
    bool small = std::abs(value) < 1;
    if (result.ec != std::errc{}) {
        const std::string_view text(begin, std::size_t(result.ptr - begin));
        small = text.find_first_of("eE") < text.size() - 1 && text.find('-', 1) != text.npos;
    }
    if (!small) return {0, result.ptr, NumberFault::TooLarge};
    return {negative ? -0.0f : 0.0f, result.ptr, NumberFault::None};
}

}  // namespace

FloatText read_float(const char* begin, const char* end) {
    if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
    FloatText text;
    const auto result = std::from_chars(begin, end, text.value);
    text.end = result.ptr;
    if (result.ec == std::errc::invalid_argument) text.fault = NumberFault::NotANumber;
    if (result.ec == std::errc::result_out_of_range) return out_of_range(begin, end);
    if (!std::isfinite(text.value)) text.fault = NumberFault::NotFinite;
    return text;
}

std::optional<double> read_double(std::string_view text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size() ||
        !std::isfinite(value))
        return {};
    return value;
}

std::string_view fault_text(NumberFault fault) {
    switch (fault) {
        case NumberFault::None: return "";
        case NumberFault::NotANumber: return " is not a number";
        case NumberFault::NotFinite: return " is not finite";
        case NumberFault::TooLarge: return " is too large";
    }
    return "";
}

std::string number_text(double value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return std::string(buffer, result.ptr);
}

}  // namespace gw::scene
