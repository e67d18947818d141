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

/// `name` stands for the file in messages. Throws Error if the text is not TOML.
TomlValue read_toml_text(const std::string& text, const std::filesystem::path& name);

/// Throws Error as read_text does, and if the text is not TOML.
TomlValue read_toml_file(const std::filesystem::path& path);

/// A file whose tables [[ARRAY]] are read a few at a time: toml++ takes a kilobyte for a table of
/// five keys, and a scene may have a million. Throws Error as read_toml_file does.
class TomlTables {
public:
    TomlTables(const std::filesystem::path& path, std::string_view array);

    /// The file with the first tables of the array: one of them, or all.
    const TomlValue& rest() const { return rest_; }

    /// The other tables of the array come in this many pieces, in the order of the file.
    std::size_t pieces() const { return pieces_.size(); }
    std::vector<TomlValue> further(std::size_t piece) const;

private:
    struct Piece {
        std::size_t begin = 0, end = 0;  ///< in text_
        int lines_before = 0, lines = 0;
    };
    bool cut(const std::vector<std::size_t>& headers);
    int count_lines(std::size_t begin, std::size_t end) const;

    std::shared_ptr<const std::string> file_;
    std::string array_, text_;
    std::vector<Piece> pieces_;
    TomlValue rest_;
};

}  // namespace gw::scene
