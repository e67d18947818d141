// Structs described member by member, once for all that read, write, print or check them.
// state_fields.h has the tables. Does not know what a member means.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>

namespace gw {

/// The values that SetState accepts.
struct Bounds {
    enum class Check : unsigned char {
        Type,   ///< finite numbers, known enumerators, all other values
        Range,  ///< least .. most
        Rule,   ///< by a rule of its own (gw/validate/state.cpp)
    };
    Check check = Check::Type;
    int least = 0, most = 0;
    const char* words = "";  ///< for the manual
};
constexpr Bounds within(int least, int most) { return {Bounds::Check::Range, least, most, ""}; }
/// What its type allows, with restrictions of extensions or planes.
constexpr Bounds restricted(const char* words) { return {Bounds::Check::Type, 0, 0, words}; }
constexpr Bounds by_rule(const char* words) { return {Bounds::Check::Rule, 0, 0, words}; }

template <class Owner, class Value>
struct Field {
    using Member = Value;
    const char* name;
    Value Owner::*member;
    const char* rules;     ///< of the manual: "R4.3"; "" if it has fields of its own
    const char* sentence;  ///< Python's docstring
    Bounds bounds;
};
template <class Owner, class Value>
constexpr Field<Owner, Value> field(const char* name, Value Owner::*member, const char* rules,
                                    const char* sentence, const Bounds& bounds = {}) {
    return {name, member, rules, sentence, bounds};
}

/// The fields of a struct, a std::tuple in the order in which they are printed.
template <class Struct>
inline constexpr auto fields_of = std::tuple<>();
/// What a struct or an enumeration is, for Python.
template <class Type>
inline constexpr const char* sentence_of = "";

template <class Type>
concept Described = std::tuple_size_v<decltype(fields_of<Type>)>
!= 0;

/// visit(field), for each field of a struct.
template <class Struct, class Visit>
constexpr void for_each_field(const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, fields_of<Struct>);
}

/// The way to a value: "texture.coordinates.2.mode".
struct Path {
    const Path* group;
    const char* name;  ///< null: element `index` of `group`
    std::size_t index = 0;
    std::string str() const {
        const std::string own = name ? name : std::to_string(index);
        return group ? group->str() + "." + own : own;
    }
    /// "texture.coordinates", for all values of its elements.
    std::string without_elements() const {
        const Path* end = this;
        for (const Path* p = this; p; p = p->group)
            if (!p->name) end = p->group;
        return end->str();
    }
};

/// visit(path, value, field), for each value of a struct: fields of fields, elements of arrays. A
/// struct that `visit` takes as a whole is a value.
template <Described Struct, class Visit>
void for_each_value(const Struct& object, const Visit& visit, const Path* group = nullptr) {
    for_each_field<Struct>([&](const auto& field) {
        visit_value(object.*field.member, Path{group, field.name}, field, visit);
    });
}
template <class Value, class Field, class Visit>
void visit_value(const Value& value, const Path& path, const Field& field, const Visit& visit) {
    if constexpr (std::invocable<const Visit&, const Path&, const Value&, const Field&>)
        visit(path, value, field);
    else
        for_each_value(value, visit, &path);
}
template <Described Element, std::size_t size, class Field, class Visit>
void visit_value(const std::array<Element, size>& elements, const Path& path, const Field&,
                 const Visit& visit) {
    for (std::size_t i = 0; i < size; ++i) {
        const Path element{&path, nullptr, i};
        for_each_value(elements[i], visit, &element);
    }
}

/// A value without fields of its own.
template <class Type>
concept Plain = !Described<Type>;

}  // namespace gw
