#include "scene/toml/shape_table.h"

#include "scene/shapes/lathe.h"
#include "scene/shapes/shapes.h"
#include "scene/text/suggest.h"
#include "scene/toml/height_field.h"

#include <algorithm>
#include <cmath>

namespace gw::scene {
namespace {

using Values = std::vector<double>;

int whole(double value) { return static_cast<int>(value); }

ShapeParameter size(const char* name, double value) { return {name, value, 1e-6, 1e6, false}; }
ShapeParameter number(const char* name, int value, int low, int high = 4096) {
    return {name, static_cast<double>(value), static_cast<double>(low), static_cast<double>(high),
            true};
}

Shape lathe(const char* name, LatheProfile (*profile)()) {
    return {name,
            {number("slices", 64, 3), number("segments", 12, 1, 256)},
            [profile](const Values& v) { return make_lathe(profile(), whole(v[0]), whole(v[1])); },
            [profile](const Values& v) { return 2 * double(profile().size()) * v[0] * v[1]; }};
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Shape> all_shapes() {
    return {
        lathe("bottle", bottle_profile),
        lathe("bowl", bowl_profile),
        {"box",
         {size("width", 1), size("height", 1), size("depth", 1), number("segments", 1, 1, 1024)},
         [](const Values& v) {
             return make_box({v[0], v[1], v[2]}, whole(v[3]));
         },
         [](const Values& v) { return 12 * v[3] * v[3]; },
         true},
        {"cone",
         {size("radius", 1), size("height", 2), number("slices", 64, 3), number("stacks", 8, 1),
          number("capped", 1, 0, 1)},
         [](const Values& v) { return make_cone(v[0], v[1], whole(v[2]), whole(v[3]), v[4] != 0); },
         [](const Values& v) { return 2 * v[2] * (v[3] + 1); }},
        {"cylinder",
         {size("radius", 1), size("height", 2), number("slices", 64, 3), number("stacks", 1, 1),
          number("capped", 1, 0, 1)},
         [](const Values& v) {
             return make_cylinder(v[0], v[1], whole(v[2]), whole(v[3]), v[4] != 0);
         },
         [](const Values& v) { return 2 * v[2] * (v[3] + 1); }},
        {"disc",
         {size("radius", 1), number("slices", 64, 3), number("rings", 1, 1)},
         [](const Values& v) { return make_disc(v[0], whole(v[1]), whole(v[2])); },
         [](const Values& v) { return 2 * v[1] * v[2]; }},
        lathe("goblet", goblet_profile),
        {"icosphere",
         {size("radius", 1), number("divisions", 4, 0, 9)},
         [](const Values& v) { return make_icosphere(v[0], whole(v[1])); },
         [](const Values& v) { return 20 * std::ldexp(1.0, 2 * whole(v[1])); }},
        lathe("pedestal", pedestal_profile),
        {"rectangle",
         {size("width", 1), size("depth", 1), number("columns", 1, 1), number("rows", 1, 1)},
         [](const Values& v) { return make_rectangle(v[0], v[1], whole(v[2]), whole(v[3])); },
         [](const Values& v) { return 2 * v[2] * v[3]; },
         true},
        {"room",
         {size("width", 1), size("height", 1), size("depth", 1), number("segments", 1, 1, 1024)},
         [](const Values& v) {
             return make_room({v[0], v[1], v[2]}, whole(v[3]));
         },
         [](const Values& v) { return 12 * v[3] * v[3]; },
         true},
        {"sphere",
         {size("radius", 1), number("slices", 64, 3), number("stacks", 32, 2)},
         [](const Values& v) { return make_sphere(v[0], whole(v[1]), whole(v[2])); },
         [](const Values& v) { return 2 * v[1] * v[2]; }},
        {"teapot",
         {number("segments", 12, 2, 256)},  // of 1 piece, the tip of the spout would be flat
         [](const Values& v) { return make_teapot(whole(v[0])); },
         [](const Values& v) { return 64 * v[0] * v[0]; }},
        {"torus",
         {size("radius", 1), size("tube", 0.25), number("segments", 96, 3), number("sides", 48, 3)},
         [](const Values& v) { return make_torus(v[0], v[1], whole(v[2]), whole(v[3])); },
         [](const Values& v) { return 2 * v[2] * v[3]; }},
        {"torus_knot",
         {number("p", 2, 1, 64), number("q", 3, 1, 64), size("radius", 1), size("tube", 0.2),
          number("segments", 256, 3), number("sides", 32, 3)},
         [](const Values& v) {
             return make_torus_knot(whole(v[0]), whole(v[1]), v[2], v[3], whole(v[4]), whole(v[5]));
         },
         [](const Values& v) { return 2 * v[4] * v[5]; }},
        lathe("vase", vase_profile),
    };
}

const Shape& to_shape(const TomlValue& value) {
    const auto found = std::ranges::find(shapes(), to_string(value), &Shape::name);
    if (found != shapes().end()) return *found;
    std::vector<std::string> known{height_field().name};
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

const std::vector<Shape>& shapes() {
    static const std::vector<Shape> all = all_shapes();
    return all;
}

void add_shape_keys(const TomlValue& table, std::vector<Key>& keys, TomlShape& shape) {
    const TomlValue* value = table.find("shape");
    if (!value) return;
    if (value->kind == TomlKind::String && value->text == height_field().name) {
        shape = {&height_field(), read_height_field(table)};
        for (const char* key : {"x", "z", "heights"})
            keys.push_back({key, [](const TomlValue&) {}});
        return;
    }
    const Shape& wanted = to_shape(*value);
    shape.shape = &wanted;
    for (const ShapeParameter& parameter : wanted.parameters)
        shape.parameters.push_back(parameter.value);
    for (std::size_t i = 0; i < wanted.parameters.size(); ++i)
        keys.push_back(parameter_key(wanted.parameters[i], shape.parameters[i]));
}

}  // namespace gw::scene
