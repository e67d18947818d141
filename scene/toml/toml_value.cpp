#include "scene/toml/toml_value.h"

#include "gw/error.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/toml/toml_text.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

// toml++ asserts properties of the text that it checks and reports one line later. So [=] would end
// a debug build, and clang's release build would assume that there is no such text. Without NDEBUG
// its assumptions are assertions, and here assertions do nothing.
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

namespace gw::scene {

const TomlValue* TomlValue::find(std::string_view wanted) const {
    const auto found = std::ranges::find(elements, wanted, &TomlValue::key);
    return kind == TomlKind::Table && found != elements.end() ? &*found : nullptr;
}

void TomlValue::fail(std::string_view what) const { throw Error(*file, line, what); }

void TomlValue::fail_expected(std::string_view expected) const {
    std::string is(kind_text(kind));
    if (kind == TomlKind::String) is = "'" + printable(text) + "'";
    if (is_number()) is = text;
    if (kind == TomlKind::Boolean) is = boolean ? "true" : "false";
    fail(name + " is " + is + "; expected " + std::string(expected));
}

std::string_view kind_text(TomlKind kind) {
    switch (kind) {
        case TomlKind::Boolean: return "a boolean";
        case TomlKind::Integer: return "a whole number";
        case TomlKind::Float: return "a number";
        case TomlKind::String: return "a string";
        case TomlKind::Date: return "a date";
        case TomlKind::Array: return "an array";
        case TomlKind::Table: return "a table";
    }
    return "";
}

namespace {

// Converts toml++'s nodes.
class Converter {
public:
    /// `lines_before` are those of the file before the text.
    Converter(std::shared_ptr<const std::string> file, std::string_view text, int lines_before)
        : file_(std::move(file)), lines_before_(lines_before) {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            lines_.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    TomlValue convert(const toml::node& node, const std::string& key, const std::string& name) {
        TomlValue value;
        value.file = file_;
        value.key = key;
        value.name = name;
        value.line = line_of(node.source());
        node.visit([&](const auto& typed) { fill(value, typed); });
        return value;
    }

private:
    int line_of(const toml::source_region& source) {
        return lines_before_ + std::max(1, static_cast<int>(source.begin.line));
    }
    void fill(TomlValue& value, const toml::value<bool>& node) {
        value.kind = TomlKind::Boolean;
        value.boolean = *node;
    }
    void fill(TomlValue& value, const toml::value<std::int64_t>& node) {
        value.kind = TomlKind::Integer;
        value.number = static_cast<double>(*node);
        value.text = number_at(node.source().begin);
    }
    void fill(TomlValue& value, const toml::value<double>& node) {
        value.kind = TomlKind::Float;
        value.text = number_at(node.source().begin);
        value.number = read_double(value.text).value_or(*node);
    }
    void fill(TomlValue& value, const toml::value<std::string>& node) {
        value.kind = TomlKind::String;
        value.text = *node;
    }
    template <typename DateOrTime>
    void fill(TomlValue& value, const DateOrTime&) {
        value.kind = TomlKind::Date;
    }
    void fill(TomlValue& value, const toml::array& node) {
        value.kind = TomlKind::Array;
        for (const toml::node& element : node)
            value.elements.push_back(convert(element, "", value.name));
    }
    void fill(TomlValue& value, const toml::table& node) {
        value.kind = TomlKind::Table;
        const std::string prefix = value.name.empty() ? "" : value.name + ".";
        for (const auto& [key, child] : node) {
            const std::string name(key.str());
            value.elements.push_back(convert(child, name, prefix + name));
            value.elements.back().line = line_of(key.source());
        }
        std::ranges::stable_sort(value.elements, {}, &TomlValue::line);
    }

    std::string number_at(toml::source_position position) {
        const std::string_view line = lines_.at(position.line - 1);
        std::string number;
        for (const char c : line.substr(byte_at(position), line.size())) {
            if (std::string_view(" \t\r,]}#").find(c) != std::string_view::npos) break;
            if (c != '_' && !(c == '+' && number.empty())) number += c;
        }
        return number;
    }

    // Columns count characters, not bytes. Where they differ, the bytes are listed once.
    std::size_t byte_at(toml::source_position position) {
        const std::string_view line = lines_[position.line - 1];
        const auto [list, is_new] = bytes_.try_emplace(position.line);
        if (is_new && std::ranges::any_of(line, is_beyond_ascii))
            for (std::uint32_t byte = 0; byte < line.size(); ++byte)
                if ((static_cast<unsigned char>(line[byte]) & 0xc0) != 0x80)
                    list->second.push_back(byte);
        const std::size_t character = position.column - 1;
        if (list->second.empty()) return std::min(character, line.size());
        return character < list->second.size() ? list->second[character] : line.size();
    }

    std::shared_ptr<const std::string> file_;
    int lines_before_;
    std::vector<std::string_view> lines_;
    /// by line, of lines with numbers: the first byte of each character; empty for ASCII
    std::unordered_map<std::size_t, std::vector<std::uint32_t>> bytes_;
};

/// Converts a part of a file that is a TOML text itself. `text` has been through toml_text.
TomlValue parse(const std::shared_ptr<const std::string>& file, std::string_view text,
                int lines_before) {
    try {
        return Converter(file, text, lines_before).convert(toml::parse(text, *file), "", "");
    } catch (const toml::parse_error& error) {
        throw Error(*file, lines_before + static_cast<int>(error.source().begin.line),
                    printable(error.description(), 200));
    }
}

}  // namespace

TomlValue read_toml_text(const std::string& raw, const std::filesystem::path& name) {
    const auto file = std::make_shared<const std::string>(name.string());
    return parse(file, toml_text(*file, raw), 0);
}

TomlValue read_toml_file(const std::filesystem::path& path) {
    return read_toml_text(read_text(path), path);
}

namespace {

/// A piece is parsed at once: this many bytes, and the rest of a table.
constexpr std::size_t piece_size = 1 << 16;

enum class HeaderKind {
    Array,  ///< [[ARRAY]]
    Part,   ///< [ARRAY.x], [[ARRAY.x]]: of the last table
    Other,
    Unclear,  ///< perhaps ARRAY, written in another form
};

bool is_bare(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; }

HeaderKind kind_of_header(std::string_view line, std::string_view array) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.starts_with('[')) return HeaderKind::Unclear;
    const bool two = line.starts_with("[[");
    std::string_view key = line.substr(two ? 2 : 1);
    if (key.starts_with(array)) {
        const std::string_view after = key.substr(array.size());
        if (two && after.starts_with("]]")) return HeaderKind::Array;
        if (after.starts_with('.')) return HeaderKind::Part;
        return after.empty() || !is_bare(after[0]) ? HeaderKind::Unclear : HeaderKind::Other;
    }
    return key.empty() || !is_bare(key[0]) ? HeaderKind::Unclear : HeaderKind::Other;
}

}  // namespace

// Each piece is a TOML text of its own, with the same errors: it begins at an [[ARRAY]], and the
// headers in it are [[ARRAY]] or belong to one.
TomlTables::TomlTables(const std::filesystem::path& path, std::string_view array)
    : file_(std::make_shared<const std::string>(path.string())), array_(array) {
    std::vector<std::size_t> headers;
    text_ = toml_text(*file_, read_text(path), &headers);
    if (!cut(headers)) pieces_.clear();
    std::string rest;
    std::size_t at = 0;
    for (const Piece& piece : pieces_) {
        rest.append(text_, at, piece.begin - at);
        rest.append(std::size_t(piece.lines), '\n');
        at = piece.end;
    }
    rest_ = parse(file_, rest.append(text_, at), 0);
}

bool TomlTables::cut(const std::vector<std::size_t>& headers) {
    enum class Place { Outside, First, Further } place = Place::Outside;
    bool is_first = true;
    const auto close = [&](std::size_t end) {
        if (place != Place::Further) return;
        Piece& piece = pieces_.back();
        piece.end = end;
        piece.lines = count_lines(piece.begin, end);
    };
    int lines = 0;
    std::size_t counted = 0;
    for (const std::size_t at : headers) {
        const HeaderKind kind = kind_of_header(std::string_view(text_).substr(at), array_);
        if (kind == HeaderKind::Unclear) return false;
        if (kind == HeaderKind::Part && place == Place::Outside) return false;
        if (kind == HeaderKind::Part) continue;
        if (kind == HeaderKind::Array && place == Place::Further &&
            at - pieces_.back().begin < piece_size)
            continue;
        close(at);
        place = kind == HeaderKind::Other ? Place::Outside
                : is_first                ? Place::First
                                          : Place::Further;
        if (kind == HeaderKind::Array) is_first = false;
        if (place != Place::Further) continue;
        lines += count_lines(counted, at);
        counted = at;
        pieces_.push_back({.begin = at, .lines_before = lines});
    }
    close(text_.size());
    return true;
}

int TomlTables::count_lines(std::size_t begin, std::size_t end) const {
    return static_cast<int>(std::count(text_.begin() + std::ptrdiff_t(begin),
                                       text_.begin() + std::ptrdiff_t(end), '\n'));
}

std::vector<TomlValue> TomlTables::further(std::size_t i) const {
    const Piece& piece = pieces_.at(i);
    const auto text = std::string_view(text_).substr(piece.begin, piece.end - piece.begin);
    TomlValue table = parse(file_, text, piece.lines_before);
    return std::move(table.elements.at(0).elements);
}

}  // namespace gw::scene
