#include "scene/toml_shape.h"

#include "scene/shape_table.h"
#include "scene/suggest.h"

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

Key parameter_key(const ShapeParameter& parameter, double& field) {
    const Range range{parameter.low, parameter.high};
    return {parameter.name, [&field, range, integer = parameter.integer](const TomlValue& value) {
                field = integer ? to_int(value, range) : to_double(value, range);
            }};
}

}  // namespace

void add_shape_keys(const TomlValue& table, std::vector<Key>& keys, TomlShape& shape) {
    const TomlValue* value = table.find("shape");
    if (!value) return;
    const Shape& wanted = to_shape(*value);
    shape.name = wanted.name;
    shape.make = wanted.make;
    for (const ShapeParameter& parameter : wanted.parameters) shape.parameters.push_back(parameter.value);
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
        keys.push_back(parameter_key(wanted.parameters[i], shape.parameters[i]));
}

}  // namespace gw::scene
