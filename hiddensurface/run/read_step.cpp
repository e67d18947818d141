#include "hiddensurface/run/read_step.h"

#include "gw/error.h"
#include "scene/text/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace gw::hiddensurface {
namespace {

using Json = nlohmann::ordered_json;

constexpr double largest_number = 1e15;
constexpr std::int64_t largest_pixel = 65535;

/// For messages. Lists and objects may be nested deeply, so they are not printed.
std::string text_of_json(const Json& json) {
    return json.is_array()    ? "a list"
           : json.is_object() ? "an object"
                              : scene::printable(json.dump());
}

[[noreturn]] void refuse(const std::string& name, const Json& json, const std::string& expected) {
    throw Error(fmt::format("'{}' is {}; expected {}", name, text_of_json(json), expected));
}

std::int64_t whole_number(const Json& json, const std::string& name, std::int64_t high) {
    const bool fits = json.is_number_unsigned() && json.get<std::uint64_t>() <= std::uint64_t(high);
    if (!fits) refuse(name, json, fmt::format("a whole number 0..{}", high));
    return json.get<std::int64_t>();
}

double number(const Json& json, const std::string& name) {
    if (!json.is_number() || !(std::abs(json.get<double>()) <= largest_number))
        refuse(name, json, "a number of at most 1e15");
    return json.get<double>();
}

std::string word(const Json& json, const std::string& name) {
    if (!json.is_string()) refuse(name, json, "text");
    return json;
}

const Json& list(const Json& json, const std::string& name, std::size_t low, std::size_t high,
                 const char* expected) {
    if (!json.is_array() || json.size() < low || json.size() > high) refuse(name, json, expected);
    return json;
}
constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();

const Json& object(const Json& json, const std::string& name) {
    if (!json.is_object()) refuse(name, json, "an object");
    return json;
}

/// The value below `count` that has this name.
template <class Enum>
Enum enum_from(int count, const Json& json, const std::string& name) {
    std::string names;
    for (int i = 0; i < count; ++i) {
        const std::string known = name_of(static_cast<Enum>(i));
        if (json.is_string() && json.get_ref<const std::string&>() == known)
            return static_cast<Enum>(i);
        names += (i == 0 ? "" : ", ") + known;
    }
    refuse(name, json, "one of " + names);
}

/// "3", "3.1", "3ab".
std::string piece_name(const Json& json) {
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const std::string name = word(json, "pieces");
    auto at = std::find_if_not(name.begin(), name.end(), is_digit);
    bool fits = at != name.begin();
    if (at != name.end() && *at == '.') {
        const auto part = at + 1;
        at = std::find_if_not(part, name.end(), is_digit);
        fits = fits && at != part;
    }
    fits = fits && std::all_of(at, name.end(), [](char c) { return c == 'a' || c == 'b'; });
    if (!fits)
        throw Error("the piece '" + scene::printable(name) +
                    "'; expected a polygon's number and a letter a or b for each cut: \"3\", "
                    "\"3a\", \"3ab\"");
    return name;
}

dvec3 point_from(const Json& json, const std::string& name, const PictureGrid& grid) {
    list(json, name, 3, 3, "points [x, y, z]");
    return {number(json[0], name), double(grid.height) * grid.unit - number(json[1], name),
            number(json[2], name)};
}

std::vector<Loop> outline_from(const Json& json, const PictureGrid& grid) {
    const char* name = "outline";
    std::vector<Loop> loops;
    for (const Json& points :
         list(json, name, 1, any_size, "lists of points: [[[x, y, z], ...]]")) {
        loops.emplace_back();
        for (const Json& p : list(points, name, 3, any_size, "three points or more in each list"))
            loops.back().push_back(point_from(p, name, grid));
    }
    return loops;
}

template <class T>
std::vector<T> all_of_json(const Json& json) {
    return json.get<std::vector<T>>();
}

Value value_from(const Json& json, const std::string& name) {
    const auto is_whole = [](const Json& v) {
        return v.is_number_integer() && std::abs(v.get<double>()) <= largest_number;
    };
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_string()) return json.get<std::string>();
    if (is_whole(json)) return json.get<std::int64_t>();
    if (!json.is_array()) return number(json, name);
    if (std::all_of(json.begin(), json.end(), [](const Json& v) { return v.is_string(); }))
        return all_of_json<std::string>(json);
    if (std::all_of(json.begin(), json.end(), is_whole)) return all_of_json<std::int64_t>(json);
    for (const Json& v : json) number(v, name);
    return all_of_json<double>(json);
}

DrawnLine line_from(const Json& json, const PictureGrid& grid) {
    const Json none;
    const auto member = [&](const char* name) -> const Json& {
        const auto found = object(json, "line").find(name);
        return found != json.end() ? *found : none;
    };
    DrawnLine line{
        point_from(member("from"), "from", grid), point_from(member("to"), "to", grid), {}};
    for (const Json& part : list(member("visible"), "visible", 0, any_size, "a list")) {
        list(part, "visible", 2, 2, "parts [from, to]");
        line.visible.emplace_back(number(part[0], "visible"), number(part[1], "visible"));
    }
    return line;
}

NamedOutline made_from(const Json& json, const PictureGrid& grid) {
    if (!json.is_object() || !json.contains("name") || !json.contains("outline"))
        throw Error(R"('made' lacks a name or an outline; expected {"name": "3a", "outline": )"
                    "[[[x, y, z], ...]]} for each piece");
    return {piece_name(json["name"]), outline_from(json["outline"], grid)};
}

Painted painted_from(const Json& json, const PictureGrid& grid) {
    const char* name = "painted";
    list(json, name, 4, 4, "lists [row, first pixel, pixel after the last, polygon]");
    const auto pixel = [&](std::size_t i) {
        return int(whole_number(json[i], name, largest_pixel));
    };
    constexpr std::int64_t largest_id = std::numeric_limits<std::uint32_t>::max();
    return {{grid.height - 1 - pixel(0), pixel(1), pixel(2)},
            std::uint32_t(whole_number(json[3], name, largest_id))};
}

Rect window_from(const Json& json, const PictureGrid& grid) {
    const char* name = "window";
    list(json, name, 4, 4, "[left, top, width, height] in pixels");
    const auto pixel = [&](std::size_t i) {
        return int(whole_number(json[i], name, largest_pixel));
    };
    return {pixel(0), grid.height - pixel(1) - pixel(3), pixel(2), pixel(3)};
}

/// Test and result of a step that does not name them.
std::pair<const char*, const char*> default_words(const Step& step) {
    switch (step.action) {
        case Action::Compare: return {"compare", "done"};
        case Action::Decide: return {"decide", "done"};
        case Action::Sort: return {"distance", "sorted"};
        case Action::Split: return {"split", "in parts"};
        case Action::Draw: return {"draw", step.pieces.empty() ? "pixels" : "piece"};
    }
    return {};
}

void set_member(Step& step, const std::string& name, const Json& json, const PictureGrid& grid) {
    if (name == "step")
        whole_number(json, name, std::int64_t(largest_number));
    else if (name == "level")
        step.level = enum_from<Level>(4, json, name);
    else if (name == "kind")
        step.action = enum_from<Action>(5, json, name);
    else if (name == "test")
        step.test = word(json, name);
    else if (name == "result")
        step.result = word(json, name);
    else if (name == "pieces")
        for (const Json& piece : list(json, name, 0, any_size, "a list of names"))
            step.pieces.push_back(piece_name(piece));
    else if (name == "decisive" && json.is_boolean())
        step.decisive = json;
    else if (name == "decisive")
        refuse(name, json, "true or false");
    else if (name == "window")
        step.window = window_from(json, grid);
    else if (name == "values")
        for (const auto& [key, value] : object(json, name).items())
            step.values.emplace_back(key, value_from(value, key));
    else if (name == "painted")
        for (const Json& run : list(json, name, 0, any_size, "a list"))
            step.painted.push_back(painted_from(run, grid));
    else if (name == "made")
        for (const Json& piece : list(json, name, 0, any_size, "a list"))
            step.made.push_back(made_from(piece, grid));
    else if (name == "line")
        step.line = line_from(json, grid);
    else if (name == "counts")
        for (const auto& [key, count] : object(json, name).items())
            step.counts.emplace_back(key, whole_number(count, key, std::int64_t(largest_number)));
    else
        throw Error("unknown member '" + scene::printable(name) +
                    "'; expected step, level, kind, test, result, pieces, values, decisive, "
                    "window, painted, made, line or counts");
}

}  // namespace

Json json_of_line(const std::string& line) {
    try {
        return Json::parse(line);
    } catch (const Json::parse_error& error) {
        const bool at_end = error.byte > line.size();
        throw Error(
            at_end
                ? std::string("the line ends too early; expected a whole object of JSON")
                : fmt::format("not JSON at column {} ('{}'); expected a step as an object of JSON",
                              error.byte, scene::printable(line.substr(error.byte - 1, 20))));
    } catch (const Json::exception&) {
        throw Error("a number is too large; expected numbers of at most 1e15");
    }
}

Step step_of(const Json& json, const PictureGrid& grid) {
    if (!json.is_object())
        throw Error("a line with " + text_of_json(json) + "; expected a step as an object of JSON");
    if (!json.contains("kind"))
        throw Error("a step without 'kind'; expected compare, decide, sort, split or draw");
    Step step;
    for (const auto& [name, value] : json.items()) set_member(step, name, value, grid);
    const auto [test, result] = default_words(step);
    if (step.test.empty()) step.test = test;
    if (step.result.empty()) step.result = result;
    return step;
}

Step step_of_line(const std::string& line, const PictureGrid& grid) {
    return step_of(json_of_line(line), grid);
}

}  // namespace gw::hiddensurface
