// Parts of C++20 that the library of Debian's Emscripten lacks: bit_cast, algorithms over ranges,
// and numbers of floating point as text. Included before every file. Has only the overloads that
// the layers call; does nothing for a library that has them.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <version>

#ifndef __cpp_lib_bit_cast
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

}  // namespace std
#endif

#ifndef __cpp_lib_ranges
namespace std::ranges {

template <class Range, class Value, class Projection = std::identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
    return std::find_if(std::begin(range), std::end(range),
                        [&](const auto& e) { return std::invoke(projection, e) == value; });
}
/// As a function: a predicate may be a member.
template <class Predicate>
auto called(Predicate& predicate) {
    return [&](const auto& e) -> bool { return std::invoke(predicate, e); };
}
template <class Range, class Predicate>
auto find_if(Range&& range, Predicate predicate) {
    return std::find_if(std::begin(range), std::end(range), called(predicate));
}
template <class Range, class Predicate>
bool any_of(const Range& range, Predicate predicate) {
    return std::any_of(std::begin(range), std::end(range), called(predicate));
}
template <class Range, class Predicate>
bool all_of(const Range& range, Predicate predicate) {
    return std::all_of(std::begin(range), std::end(range), called(predicate));
}
template <class Range, class Predicate>
bool none_of(const Range& range, Predicate predicate) {
    return std::none_of(std::begin(range), std::end(range), called(predicate));
}
template <class Range, class Predicate>
auto count_if(const Range& range, Predicate predicate) {
    return std::count_if(std::begin(range), std::end(range), called(predicate));
}
template <class Range, class Value>
void replace(Range& range, const Value& from, const Value& to) {
    std::replace(std::begin(range), std::end(range), from, to);
}
template <class Range, class Predicate, class Value>
void replace_if(Range& range, Predicate predicate, const Value& to) {
    std::replace_if(std::begin(range), std::end(range), called(predicate), to);
}
template <class Range>
void reverse(Range& range) {
    std::reverse(std::begin(range), std::end(range));
}
template <class Range, class Compare = std::ranges::less, class Projection = std::identity>
auto min_element(Range&& range, Compare = {}, Projection projection = {}) {
    return std::min_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(projection, a) < std::invoke(projection, b);
    });
}
template <class Range, class Compare = std::ranges::less, class Projection = std::identity>
auto max_element(Range&& range, Compare = {}, Projection projection = {}) {
    return std::max_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(projection, a) < std::invoke(projection, b);
    });
}
template <class Value>
struct MinMax {
    Value min, max;
};
template <class Range, class Compare = std::ranges::less, class Projection = std::identity>
auto minmax(const Range& range, Compare = {}, Projection projection = {}) {
    using Value = std::decay_t<decltype(*std::begin(range))>;
    return MinMax<Value>{*std::ranges::min_element(range, Compare{}, projection),
                         *std::ranges::max_element(range, Compare{}, projection)};
}
template <class Range, class Compare>
bool is_sorted(const Range& range, Compare before) {
    return std::is_sorted(std::begin(range), std::end(range), before);
}
template <class Range, class Compare = std::ranges::less, class Projection = std::identity>
void stable_sort(Range& range, Compare = {}, Projection projection = {}) {
    std::stable_sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(projection, a) < std::invoke(projection, b);
    });
}
template <class Range, class Compare = std::ranges::less, class Projection = std::identity>
void sort(Range& range, Compare = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) {
        return std::invoke(projection, a) < std::invoke(projection, b);
    });
}
template <class Range, class Output>
void copy(const Range& range, Output output) {
    std::copy(std::begin(range), std::end(range), output);
}
template <class Range, class Output, class Predicate>
void copy_if(const Range& range, Output output, Predicate predicate) {
    std::copy_if(std::begin(range), std::end(range), output, called(predicate));
}
template <class Range, class Output>
void move(Range& range, Output output) {
    std::move(std::begin(range), std::end(range), output);
}
template <class Range, class Value, class Projection = std::identity>
auto upper_bound(const Range& range, const Value& value, std::ranges::less = {},
                 Projection projection = {}) {
    return std::upper_bound(
        std::begin(range), std::end(range), value,
        [&](const Value& v, const auto& e) { return v < std::invoke(projection, e); });
}
template <class Range, class Value, class Projection = std::identity>
auto lower_bound(const Range& range, const Value& value, std::ranges::less = {},
                 Projection projection = {}) {
    return std::lower_bound(
        std::begin(range), std::end(range), value,
        [&](const auto& e, const Value& v) { return std::invoke(projection, e) < v; });
}

}  // namespace std::ranges
#endif

#if !defined(__cpp_lib_to_chars)
namespace std {

namespace gw_library {

/// The end of a number that from_chars accepts, without a sign +; `begin` if there is none.
inline const char* end_of_number(const char* begin, const char* end) {
    const char* at = begin;
    const auto digits = [&] {
        const char* const from = at;
        while (at != end && *at >= '0' && *at <= '9') ++at;
        return at - from;
    };
    const auto word = [&](const char* wanted) {
        const char* c = at;
        for (; *wanted != 0 && c != end && (*c | 32) == *wanted; ++wanted) ++c;
        if (*wanted == 0) at = c;
        return *wanted == 0;
    };
    if (at != end && *at == '-') ++at;
    if (word("infinity") || word("inf") || word("nan")) return at;
    auto count = digits();
    if (at != end && *at == '.') {
        ++at;
        count += digits();
        if (count == 0) return begin;
    }
    if (count == 0) return begin;
    const char* const mantissa = at;
    if (at != end && (*at | 32) == 'e') {
        ++at;
        if (at != end && (*at == '+' || *at == '-')) ++at;
        if (digits() == 0) at = mantissa;
    }
    return at;
}

template <class Float>
from_chars_result read(const char* begin, const char* end, Float& value,
                       Float (*convert)(const char*, char**)) {
    const char* const stop = end_of_number(begin, end);
    if (stop == begin) return {begin, errc::invalid_argument};
    const string text(begin, stop);
    const Float read = convert(text.c_str(), nullptr);
    const auto exponent = text.find_first_of("eE");
    const bool has_digits = text.find_first_of("123456789") < exponent;
    const bool lost = (read == 0 && has_digits) || (std::isinf(read) && has_digits);
    if (lost) return {stop, errc::result_out_of_range};
    value = read;
    return {stop, errc{}};
}

}  // namespace gw_library

inline from_chars_result from_chars(const char* begin, const char* end, double& value) {
    return gw_library::read<double>(begin, end, value, std::strtod);
}
inline from_chars_result from_chars(const char* begin, const char* end, float& value) {
    return gw_library::read<float>(begin, end, value, std::strtof);
}

/// The shortest text that reads back as the value; positional if that is not longer.
inline to_chars_result to_chars(char* begin, char* end, double value) {
    char shortest[40] = "";
    int digits = 0;
    for (; digits < 17; ++digits) {
        std::snprintf(shortest, sizeof shortest, "%.*e", digits, value);
        if (std::strtod(shortest, nullptr) == value) break;
    }
    if (!std::isfinite(value))
        std::snprintf(shortest, sizeof shortest, "%s",
                      std::isnan(value) ? "nan" : (value < 0 ? "-inf" : "inf"));
    string text = shortest;
    if (const auto e = text.find('e'); e != text.npos) {
        const int exponent = std::atoi(text.c_str() + e + 1);
        char fixed[400];
        std::snprintf(fixed, sizeof fixed, "%.*f", std::max(0, digits - exponent), value);
        if (std::char_traits<char>::length(fixed) <= text.size()) text = fixed;
    }
    if (end - begin < ptrdiff_t(text.size())) return {end, errc::value_too_large};
    return {std::copy(text.begin(), text.end(), begin), errc{}};
}

}  // namespace std
#endif
