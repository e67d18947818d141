// The names of an enumeration's values, taken from the compiler: a list of them cannot fall behind.
// Enumerations count from 0 without gaps. Does not give other names (multipass/passes/tokens.h).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

namespace gw {

/// A value or a type as the compiler writes it: "gw::Wrap::Clamp"; "(gw::Wrap)9" if no enumerator
/// has the value.
template <auto value>
constexpr std::string_view spelled() {
    constexpr std::string_view text = __PRETTY_FUNCTION__, start = "value = ";
    constexpr std::size_t at = text.find(start) + start.size();
    return text.substr(at, text.find_first_of(";]", at) - at);
}
template <class Type>
constexpr std::string_view spelled() {
    constexpr std::string_view text = __PRETTY_FUNCTION__, start = "Type = ";
    constexpr std::size_t at = text.find(start) + start.size();
    return text.substr(at, text.find_first_of(";]", at) - at);
}
constexpr std::string_view without_scope(std::string_view name) {
    const std::size_t colons = name.rfind("::");
    return colons == name.npos ? name : name.substr(colons + 2);
}

/// "BlendState"
template <class Type>
inline constexpr std::string_view type_name = without_scope(spelled<Type>());

template <class Enum, std::size_t value = 0>
constexpr std::size_t count_enumerators() {
    if constexpr (spelled<static_cast<Enum>(value)>().starts_with('('))
        return value;
    else
        return count_enumerators<Enum, value + 1>();
}
template <class Enum>
inline constexpr std::size_t count_of = count_enumerators<Enum>();
template <class Enum>
inline constexpr Enum last_of = static_cast<Enum>(count_of<Enum> - 1);

/// The enumerators' names, in order from 0.
template <class Enum>
inline constexpr auto names_of = []<std::size_t... value>(std::index_sequence<value...>) {
    return std::array{without_scope(spelled<static_cast<Enum>(value)>())...};
}
(std::make_index_sequence<count_of<Enum>>());

/// "OneMinusSrcAlpha"; "" if no enumerator has the value.
template <class Enum>
constexpr std::string_view enumerator(Enum value) {
    const auto i = static_cast<std::size_t>(value);
    return i < count_of<Enum> ? names_of<Enum>[i] : std::string_view();
}

}  // namespace gw
