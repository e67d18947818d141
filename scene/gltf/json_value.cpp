#include "scene/gltf/json_value.h"

#include "gw/error.h"
#include "scene/text/number.h"
#include "scene/text/suggest.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

std::string value_text(const Json& json) {
    if (json.is_object()) return "an object";
    if (json.is_array()) return "an array";
    if (json.is_string()) return "'" + printable(json.get_ref<const std::string&>()) + "'";
    if (json.is_null()) return "null";
    if (json.is_boolean()) return json.get<bool>() ? "true" : "false";
    return number_text(json.get<double>());
}

/// "syntax error while parsing value": the library's words after its number and place.
std::string reason(const std::string& what) {
    const std::size_t at = what.find(": ");
    return printable(at == what.npos ? what : what.substr(at + 2), 200);
}

}  // namespace

JsonValue JsonValue::read(const std::string& file, std::string_view text) {
    try {
        auto json = std::make_shared<const Json>(Json::parse(text));
        JsonValue value(std::move(json), std::make_shared<const std::string>(file));
        if (!value.json_->is_object()) value.fail_expected("an object");
        return value;
    } catch (const Json::parse_error& error) {
        const std::size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n');
        throw Error(file, int(line), "is no JSON: " + reason(error.what()) + "; expected glTF 2.0");
    } catch (const Json::exception&) {
        throw Error(file, 0, "is no JSON: a number is beyond 1e308; expected glTF 2.0");
    }
}

JsonValue JsonValue::inner(const Json& json, std::string place) const {
    JsonValue value = *this;
    value.json_ = &json;
    value.place_ = std::move(place);
    return value;
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
    if (!json_->is_object()) fail_expected("an object");
    const auto found = json_->find(key);
    if (found == json_->end()) return std::nullopt;
    return inner(*found, place_.empty() ? key : place_ + "." + key);
}

JsonValue JsonValue::at(const std::string& key) const {
    if (auto value = find(key)) return *value;
    fail("has no " + key + "; expected one");
}

std::vector<std::string> JsonValue::keys() const {
    if (!json_->is_object()) fail_expected("an object");
    std::vector<std::string> keys;
    for (const auto& item : json_->items()) keys.push_back(item.key());
    return keys;
}

std::size_t JsonValue::size() const {
    if (!json_->is_array()) fail_expected("an array");
    return json_->size();
}

JsonValue JsonValue::operator[](std::size_t i) const {
    if (i >= size())
        fail("has " + std::to_string(size()) + " elements; expected at least " +
             std::to_string(i + 1));
    return inner((*json_)[i], place_ + "[" + std::to_string(i) + "]");
}

double JsonValue::number(Range range) const {
    const double value = json_->is_number() ? json_->get<double>() : std::nan("");
    if (!range.contains(value)) fail_expected(range_text("a number", range));
    return value;
}

std::size_t JsonValue::whole(std::size_t least, std::size_t most) const {
    const double value = json_->is_number() ? json_->get<double>() : -1;
    if (!(value >= double(least) && value <= double(most)) || value != std::floor(value))
        fail_expected(range_text("a whole number", {double(least), double(most)}));
    return std::size_t(value);
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean()) fail_expected("true or false");
    return json_->get<bool>();
}

const std::string& JsonValue::text() const {
    if (!json_->is_string()) fail_expected("a string");
    return json_->get_ref<const std::string&>();
}

void JsonValue::fail(std::string_view what) const {
    const std::string place = place_.empty() ? "" : printable(place_, 120) + " ";
    throw Error(*file_, 0, place + std::string(what));
}

void JsonValue::fail_expected(std::string_view expected) const {
    fail("is " + value_text(*json_) + "; expected " + std::string(expected));
}

}  // namespace gw::scene
