#include "scene/text/suggest.h"
#include "scene/toml/shape_table.h"
#include "scene/toml/toml_sections.h"

#include <algorithm>

namespace gw::scene {
namespace {

const Shape& to_shape(const TomlValue& value) {
    const auto found = std::ranges::find(shapes(), to_string(value), &Shape::name);
    if (found != shapes().end()) return *found;
    std::vector<std::string> known;
    for (const Shape& shape : shapes()) known.push_back(shape.name);
    value.fail(unknown("shape", value.text, known));
}

// A whole number that is 0 or 1 is a switch: true and false are taken too.
double to_parameter(const TomlValue& value, const ShapeParameter& parameter) {
    const Range range{parameter.low, parameter.high};
    if (!parameter.integer) return to_double(value, range);
    if (value.kind == TomlKind::Boolean && range.low == 0 && range.high == 1) return value.boolean;
    return to_int(value, range);
}

Key parameter_key(const ShapeParameter& parameter, double& field) {
    return {parameter.name,
            [&](const TomlValue& value) { field = to_parameter(value, parameter); }};
}

}  // namespace

void add_shape_keys(const TomlValue& table, std::vector<Key>& keys, TomlShape& shape) {
    const TomlValue* value = table.find("shape");
    if (!value) return;
    const Shape& wanted = to_shape(*value);
    shape.shape = &wanted;
    for (const ShapeParameter& parameter : wanted.parameters)
        shape.parameters.push_back(parameter.value);
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
        keys.push_back(parameter_key(wanted.parameters[i], shape.parameters[i]));
}

}  // namespace gw::scene
