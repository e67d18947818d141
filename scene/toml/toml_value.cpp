#include "scene/toml/toml_value.h"

#include "gw/error.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"
#include "scene/text/text_file.h"
#include "scene/toml/toml_text.h"

#include <algorithm>

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
    Converter(std::string file, std::string_view text)
        : file_(std::make_shared<const std::string>(std::move(file))) {
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            lines_.push_back(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }

    TomlValue convert(const toml::node& node, const std::string& key,
                      const std::string& name) const {
        TomlValue value;
        value.file = file_;
        value.key = key;
        value.name = name;
        value.line = std::max(1, static_cast<int>(node.source().begin.line));
        node.visit([&](const auto& typed) { fill(value, typed); });
        return value;
    }

private:
    void fill(TomlValue& value, const toml::value<bool>& node) const {
        value.kind = TomlKind::Boolean;
        value.boolean = *node;
    }
    void fill(TomlValue& value, const toml::value<std::int64_t>& node) const {
        value.kind = TomlKind::Integer;
        value.number = static_cast<double>(*node);
        value.text = number_at(node.source().begin);
    }
    void fill(TomlValue& value, const toml::value<double>& node) const {
        value.kind = TomlKind::Float;
        value.text = number_at(node.source().begin);
        value.number = read_double(value.text).value_or(*node);
    }
    void fill(TomlValue& value, const toml::value<std::string>& node) const {
        value.kind = TomlKind::String;
        value.text = *node;
    }
    template <typename DateOrTime>
    void fill(TomlValue& value, const DateOrTime&) const {
        value.kind = TomlKind::Date;
    }
    void fill(TomlValue& value, const toml::array& node) const {
        value.kind = TomlKind::Array;
        for (const toml::node& element : node)
            value.elements.push_back(convert(element, "", value.name));
    }
    void fill(TomlValue& value, const toml::table& node) const {
        value.kind = TomlKind::Table;
        const std::string prefix = value.name.empty() ? "" : value.name + ".";
        for (const auto& [key, child] : node) {
            const std::string name(key.str());
            value.elements.push_back(convert(child, name, prefix + name));
            value.elements.back().line = std::max(1, static_cast<int>(key.source().begin.line));
        }
        std::ranges::stable_sort(value.elements, {}, &TomlValue::line);
    }

    // Columns count characters, not bytes.
    std::string number_at(toml::source_position position) const {
        std::string_view line = lines_.at(position.line - 1);
        for (toml::source_index column = 1; column < position.column && !line.empty(); ++column) {
            line.remove_prefix(1);
            while (!line.empty() && (static_cast<unsigned char>(line[0]) & 0xc0) == 0x80)
                line.remove_prefix(1);
        }
        std::string number;
        for (const char c : line.substr(0, line.find_first_of(" \t\r,]}#")))
            if (c != '_' && !(c == '+' && number.empty())) number += c;
        return number;
    }

    std::shared_ptr<const std::string> file_;
    std::vector<std::string_view> lines_;
};

}  // namespace

TomlValue read_toml_text(const std::string& raw, const std::filesystem::path& name) {
    const std::string text = toml_text(name.string(), raw);
    try {
        return Converter(name.string(), text).convert(toml::parse(text, name.string()), "", "");
    } catch (const toml::parse_error& error) {
        throw Error(name.string(), static_cast<int>(error.source().begin.line),
                    printable(error.description(), 200));
    }
}

TomlValue read_toml_file(const std::filesystem::path& path) {
    return read_toml_text(read_text(path), path);
}

}  // namespace gw::scene
