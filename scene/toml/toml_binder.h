// Binds the keys of a TOML table to the fields of a struct: one line for each key.
//     read_table(table, {key("eye", camera.eye), key("fov", camera.fov, {0.1, 179})});
// A key that is not in the list, a wrong type, a number out of range: each is an Error with file
// and line.
#pragma once

#include "gw/base/types.h"
#include "scene/toml/toml_value.h"
#include "scene/validate/rules.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gw::scene {

struct Key {
    std::string name;
    std::function<void(const TomlValue&)> read;
};

/// Throws Error if the value is not a table, or has an unknown key; the message names the nearest
/// known one.
void read_table(const TomlValue& table, const std::vector<Key>& keys);

/// One value as a C++ type. A float is the float32 nearest to the text.
float to_float(const TomlValue& value, Range range = {});
double to_double(const TomlValue& value, Range range = {});
int to_int(const TomlValue& value, Range range);
bool to_bool(const TomlValue& value);
std::string to_string(const TomlValue& value);
std::vector<std::string> to_strings(
    const TomlValue& value);  ///< one string, or an array of at least one
vec2 to_vec2(const TomlValue& value);
vec3 to_vec3(const TomlValue& value);
dvec3 to_dvec3(const TomlValue& value);
dvec3 to_placeable(const TomlValue& value);  ///< three numbers within `placeable`
/// Three numbers from 0, or one for all three.
vec3 to_color(const TomlValue& value);

/// Throws Error unless the value is an array of `count` numbers.
void expect_numbers(const TomlValue& value, std::size_t count);

Key key(std::string name, float& field, Range range = {});
Key key(std::string name, double& field, Range range = {});
Key key(std::string name, int& field, Range range);
Key key(std::string name, bool& field);
Key key(std::string name, std::string& field);
Key key(std::string name, std::vector<std::string>& field);
Key key(std::string name, vec2& field);
Key key(std::string name, vec3& field);
Key key(std::string name, dvec3& field);
Key color_key(std::string name, vec3& field);
Key place_key(std::string name, vec3& field);
Key place_key(std::string name, dvec3& field);

/// Appends a key for each value that a function of limits.h visits.
struct KeyList {
    std::vector<Key>& keys;

    template <class Number>
    void number(FieldName name, Number& field, Range range) const {
        keys.push_back(key(name.file, field, range));
    }
    template <class Vector>
    void place(FieldName name, Vector& field) const {
        keys.push_back(place_key(name.file, field));
    }
    void color(FieldName name, vec3& field) const { keys.push_back(color_key(name.file, field)); }
};

/// Throws Error with the line of the key, or of the table if it has no such key, if there is a fault.
void obey(const TomlValue& table, const std::optional<Fault>& fault);

/// A key that is one of several words.
template <typename Enum>
Key key(std::string name, Enum& field, std::vector<std::pair<std::string, Enum>> words);

/// The ordinal of the word. Throws Error naming the words if the value is none of them.
std::size_t to_word(const TomlValue& value, const std::vector<std::string>& words);

template <typename Enum>
Key key(std::string name, Enum& field, std::vector<std::pair<std::string, Enum>> words) {
    return {std::move(name), [&field, words = std::move(words)](const TomlValue& value) {
                std::vector<std::string> names;
                for (const auto& word : words) names.push_back(word.first);
                field = words[to_word(value, names)].second;
            }};
}

}  // namespace gw::scene
