#include "scene/toml/toml_binder.h"

#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gw::scene {

void read_table(const TomlValue& table, const std::vector<Key>& keys) {
    if (table.kind != TomlKind::Table) table.fail_expected("a table");
    for (const TomlValue& value : table.elements) {
        const auto found = std::ranges::find(keys, value.key, &Key::name);
        if (found != keys.end()) {
            found->read(value);
            continue;
        }
        std::vector<std::string> known;
        for (const Key& key : keys) known.push_back(key.name);
        value.fail(unknown("key", value.key, known, table.name));
    }
}

namespace {

void expect_number(const TomlValue& value, Range range, std::string_view what = "a number") {
    if (!value.is_number() || !range.contains(value.number))
        value.fail_expected(range_text(what, range));
}

// toml++ reads doubles; a double rounded again is not always the float nearest to the text.
float nearest_float(const TomlValue& value) {
    const char* const end = value.text.data() + value.text.size();
    const FloatText text = read_float(value.text.data(), end);
    if (text.fault == NumberFault::TooLarge) value.fail_expected("a number that a float32 holds");
    const bool decimal = text.fault == NumberFault::None && text.end == end;
    return decimal ? text.value : static_cast<float>(value.number);
}

}  // namespace

float to_float(const TomlValue& value, Range range) {
    expect_number(value, range);
    return nearest_float(value);
}

double to_double(const TomlValue& value, Range range) {
    expect_number(value, range);
    return value.number;
}

int to_int(const TomlValue& value, Range range) {
    expect_number(value, range, "a whole number");
    if (value.number != std::floor(value.number))
        value.fail_expected(range_text("a whole number", range));
    return static_cast<int>(value.number);
}

bool to_bool(const TomlValue& value) {
    if (value.kind != TomlKind::Boolean) value.fail_expected("true or false");
    return value.boolean;
}

std::string to_string(const TomlValue& value) {
    if (value.kind != TomlKind::String) value.fail_expected("a string");
    return value.text;
}

std::vector<std::string> to_strings(const TomlValue& value) {
    if (value.kind == TomlKind::String) return {value.text};
    if (value.kind != TomlKind::Array) value.fail_expected("a string or an array of strings");
    if (value.elements.empty()) value.fail(value.name + " is empty; expected at least one string");
    std::vector<std::string> strings;
    for (const TomlValue& element : value.elements) strings.push_back(to_string(element));
    return strings;
}

void expect_numbers(const TomlValue& value, std::size_t count) {
    const std::string expected = "an array of " + std::to_string(count) + " numbers";
    if (value.kind != TomlKind::Array) value.fail_expected(expected);
    if (value.elements.size() != count)
        value.fail(value.name + " has " + std::to_string(value.elements.size()) +
                   " elements; expected " + expected);
    for (const TomlValue& element : value.elements) expect_number(element, {});
}

vec2 to_vec2(const TomlValue& value) {
    expect_numbers(value, 2);
    return {to_float(value.elements[0]), to_float(value.elements[1])};
}

vec3 to_vec3(const TomlValue& value) {
    expect_numbers(value, 3);
    return {to_float(value.elements[0]), to_float(value.elements[1]), to_float(value.elements[2])};
}

dvec3 to_dvec3(const TomlValue& value) {
    expect_numbers(value, 3);
    return {to_double(value.elements[0]), to_double(value.elements[1]),
            to_double(value.elements[2])};
}

dvec3 to_placeable(const TomlValue& value) {
    const dvec3 v = to_dvec3(value);
    for (const TomlValue& element : value.elements) to_double(element, placeable);
    return v;
}

vec3 to_color(const TomlValue& value) {
    if (value.is_number()) return vec3(to_float(value, not_negative));
    if (value.kind != TomlKind::Array) value.fail_expected("a number or an array of 3 numbers");
    expect_numbers(value, 3);
    for (const TomlValue& element : value.elements) expect_number(element, not_negative);
    return to_vec3(value);
}

// In a list this short everybody sees the word that was meant.
constexpr std::size_t few_words = 4;

std::size_t to_word(const TomlValue& value, const std::vector<std::string>& words) {
    std::string expected;
    for (const std::string& word : words)
        expected += (expected.empty() ? "'" : word == words.back() ? " or '" : ", '") + word + "'";
    const auto found = std::ranges::find(words, value.text);
    if (value.kind == TomlKind::String && found == words.end() && words.size() > few_words)
        expected += "; the nearest is '" + nearest(value.text, words) + "'";
    if (value.kind != TomlKind::String || found == words.end()) value.fail_expected(expected);
    return std::size_t(found - words.begin());
}

Key key(std::string name, float& field, Range range) {
    return {std::move(name),
            [&field, range](const TomlValue& value) { field = to_float(value, range); }};
}
Key key(std::string name, double& field, Range range) {
    return {std::move(name),
            [&field, range](const TomlValue& value) { field = to_double(value, range); }};
}
Key key(std::string name, int& field, Range range) {
    return {std::move(name),
            [&field, range](const TomlValue& value) { field = to_int(value, range); }};
}
Key key(std::string name, bool& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_bool(value); }};
}
Key key(std::string name, std::string& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_string(value); }};
}
Key key(std::string name, std::vector<std::string>& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_strings(value); }};
}
Key key(std::string name, vec2& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_vec2(value); }};
}
Key key(std::string name, vec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_vec3(value); }};
}
Key key(std::string name, dvec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_dvec3(value); }};
}
Key color_key(std::string name, vec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_color(value); }};
}
Key place_key(std::string name, vec3& field) {
    return {std::move(name), [&field](const TomlValue& value) {
                field = to_vec3(value);
                to_placeable(value);
            }};
}
Key place_key(std::string name, dvec3& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = to_placeable(value); }};
}

void obey(const TomlValue& table, const std::optional<Fault>& fault) {
    if (!fault) return;
    const TomlValue* const value = table.find(fault->field.file);
    (value ? *value : table)
        .fail(table.name + "." + fault->field.file + " is " + fault->is + "; expected " +
              fault->expected);
}

}  // namespace gw::scene
