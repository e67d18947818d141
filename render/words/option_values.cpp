#include "render/words/option_values.h"

#include "gw/machine.h"
#include "scene/text/suggest.h"
#include "scene/validate/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace gw::render {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return number;
}

}  // namespace

OptionError::OptionError(const std::string& option, const std::string& word,
                         const std::string& expected)
    : Error(fmt::format("{} '{}': expected {}", option, scene::printable(word), expected)) {}

Size size_from(const std::string& option, const std::string& word) {
    const std::size_t x = std::min(word.find('x'), word.size());
    const auto width = parse<int>(std::string_view(word).substr(0, x));
    const auto height = parse<int>(std::string_view(word).substr(std::min(x + 1, word.size())));
    const auto fits = [](std::optional<int> side) {
        return side && *side >= 1 && *side <= max_window_size;
    };
    if (!fits(width) || !fits(height)) {
        throw OptionError(
            option, word,
            fmt::format("WIDTHxHEIGHT, both 1..{}, such as 640x480", max_window_size));
    }
    return {*width, *height};
}

int whole_number_from(const std::string& option, const std::string& word, int low, int high) {
    const auto number = parse<int>(word);
    if (!number || *number < low || *number > high) {
        throw OptionError(option, word, fmt::format("a whole number, {}..{}", low, high));
    }
    return *number;
}

std::pair<int, int> range_from(const std::string& option, const std::string& word, int low,
                               int high) {
    const std::size_t dash = std::min(word.find('-'), word.size());
    const auto first = parse<int>(std::string_view(word).substr(0, dash));
    const auto last =
        dash < word.size() ? parse<int>(std::string_view(word).substr(dash + 1)) : first;
    if (!first || !last || *first < low || *last < *first || *last > high)
        throw OptionError(option, word, fmt::format("A-B, A at most B, both {}..{}", low, high));
    return {*first, *last};
}

double number_from(const std::string& option, const std::string& word, double low, double high) {
    const auto number = parse<double>(word);
    if (!number || !(*number >= low && *number <= high)) {
        throw OptionError(option, word, fmt::format("a number, {}..{}", low, high));
    }
    return *number;
}

dvec3 point_from(const std::string& option, const std::string& word) {
    dvec3 point{0};
    std::string_view rest = word;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = i < 2 ? rest.find(',') : rest.size();
        const auto number =
            comma == rest.npos ? std::nullopt : parse<double>(rest.substr(0, comma));
        if (!number || !std::isfinite(*number))
            throw OptionError(option, word, "X,Y,Z, such as 0,1.5,-4");
        if (!scene::placeable.contains(*number))
            throw OptionError(option, word, scene::range_text("X,Y,Z", scene::placeable));
        point[i] = *number;
        if (i < 2) rest.remove_prefix(comma + 1);
    }
    return point;
}

std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

std::string one_of(const std::string& option, const std::string& word,
                   const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return word;
    throw OptionError(option, word, (known.size() == 1 ? "" : "one of ") + listed(known));
}

}  // namespace gw::render
