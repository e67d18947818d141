// How GLX and EGL choose configurations: a table of attributes, and what a program requests of them.
// [GLX 1.4] and [EGL 1.5] table 3.4. Does not know configurations.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>

namespace gw::gl::x11 {

inline constexpr int dont_care = -1;  ///< GLX_DONT_CARE and EGL_DONT_CARE

/// How a requested value is compared, and the value if none is requested.
enum class Match { Exact, AtLeast, Mask, Ignored };
struct Criterion {
    int name;
    Match match;
    int initial = dont_care;
};

inline bool fits(Match match, int has, int requested) {
    if (requested == dont_care) return true;
    switch (match) {
        case Match::Exact: return has == requested;
        case Match::AtLeast: return has >= requested;
        case Match::Mask: return (has & requested) == requested;
        case Match::Ignored: return true;
    }
    return true;
}

/// The values of the criteria, of which the last is a configuration's number, by a list of names and
/// values up to the name `end`. None: an unknown name, or a value that is none of it.
template <std::size_t count, class IsValueOf>
std::optional<std::array<int, count>> request_of(const Criterion (&criteria)[count],
                                                 const int* list, int end, IsValueOf is_value_of) {
    std::array<int, count> request;
    for (std::size_t i = 0; i < count; ++i) request[i] = criteria[i].initial;
    for (; list != nullptr && list[0] != end; list += 2) {
        const auto* const found =
            std::find_if(std::begin(criteria), std::end(criteria),
                         [&](const Criterion& c) { return c.name == list[0]; });
        if (found == std::end(criteria) || !is_value_of(*found, list[1])) return {};
        request[std::size_t(found - criteria)] = list[1];
    }
    // A configuration that is named by its number is taken whatever else is requested.
    if (const int id = request.back(); id != dont_care) {
        request.fill(dont_care);
        request.back() = id;
    }
    return request;
}

}  // namespace gw::gl::x11
