// A TOML file as plain values that know their file, line, key and, for numbers, their text. The
// only user of toml++ is toml_value.cpp. Does not know any key.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gw::scene {

enum class TomlKind { Boolean, Integer, Float, String, Date, Array, Table };

struct TomlValue {
    TomlKind kind = TomlKind::Table;
    bool boolean = false;
    std::string text;   ///< a string, or a number as it is written but for '_' and a leading '+'
    double number = 0;  ///< an integer's or float's value
    /// an array's, or a table's values in the order of the file
    std::vector<TomlValue> elements;

    std::string key;   ///< its own, in a table
    std::string name;  ///< with the tables around it, "camera.eye"; of the whole file: empty
    std::shared_ptr<const std::string> file;
    int line = 1;

    /// The value of a table's key, or null.
    const TomlValue* find(std::string_view wanted) const;
    bool is_number() const { return kind == TomlKind::Integer || kind == TomlKind::Float; }
    /// Throws Error "file:line: what".
    [[noreturn]] void fail(std::string_view what) const;
    /// Throws Error "file:line: camera.fov is 'wide'; expected a number".
    [[noreturn]] void fail_expected(std::string_view expected) const;
};

/// "a string", "a table", ...
std::string_view kind_text(TomlKind kind);

/// `name` stands for the file in messages. Throws Error where the text is not TOML.
TomlValue read_toml_text(const std::string& text, const std::filesystem::path& name);

/// Throws Error where read_text does and where the text is not TOML.
TomlValue read_toml_file(const std::filesystem::path& path);

}  // namespace gw::scene
