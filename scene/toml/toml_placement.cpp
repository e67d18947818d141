// translate, rotate, scale, matrix of an [[object]].
#include "scene/geometry/transform.h"
#include "scene/toml/toml_sections.h"

namespace gw::scene {
namespace {

/// A hundred turns: sines of larger angles lose their last digits.
constexpr Range turns{-36000, 36000};

dmat4 to_scaling(const TomlValue& value) {
    const dvec3 by = value.is_number() ? dvec3(to_double(value, placeable)) : to_placeable(value);
    if (by.x == 0 || by.y == 0 || by.z == 0)
        value.fail(value.name + " is 0; expected numbers other than 0");
    return scaling(by);
}

dmat4 to_axis_rotation(const TomlValue& table) {
    dvec3 axis(0);
    double degrees = 0;
    read_table(table, {{"axis", [&](const TomlValue& value) { axis = to_placeable(value); }},
                       key("degrees", degrees, turns)});
    if (axis == dvec3(0)) table.fail(table.name + ".axis is missing or 0; expected a direction");
    if (!table.find("degrees")) table.fail(table.name + ".degrees is missing; expected an angle");
    return rotation(axis, degrees);
}

// {axis, degrees}, an array of these in the order they act, or degrees about x, then y, then z.
dmat4 to_rotation(const TomlValue& value) {
    if (value.kind == TomlKind::Table) return to_axis_rotation(value);
    if (value.kind != TomlKind::Array)
        value.fail_expected("{axis, degrees} or degrees about x, y and z");
    if (value.elements.empty() || value.elements[0].kind != TomlKind::Table) {
        const dvec3 degrees = to_dvec3(value);
        for (const TomlValue& element : value.elements) to_double(element, turns);
        return rotation_xyz(degrees);
    }
    dmat4 all(1);
    for (const TomlValue& element : value.elements) all = to_axis_rotation(element) * all;
    return all;
}

// Row by row, as it is written on paper.
dmat4 to_matrix(const TomlValue& value) {
    expect_numbers(value, 16);
    dmat4 m;
    for (int i = 0; i < 16; ++i)
        m[i % 4][i / 4] = to_double(value.elements[std::size_t(i)], placeable);
    if (const auto fault = fault_of(m))
        value.fail(value.name + " is " + fault->is + "; expected " + fault->expected);
    return m;
}

Key pointer_key(std::string name, const TomlValue*& field) {
    return {std::move(name), [&field](const TomlValue& value) { field = &value; }};
}

}  // namespace

void add_placement_keys(std::vector<Key>& keys, Placement& placement) {
    keys.push_back(pointer_key("translate", placement.translate));
    keys.push_back(pointer_key("rotate", placement.rotate));
    keys.push_back(pointer_key("scale", placement.scale));
    keys.push_back(pointer_key("matrix", placement.matrix));
}

dmat4 world_from_object(const Placement& placement) {
    const auto& [translate, rotate, scale, matrix] = placement;
    if (matrix) {
        if (translate || rotate || scale)
            matrix->fail("matrix beside translate, rotate or scale; expected it alone");
        return to_matrix(*matrix);
    }
    dmat4 world(1);
    if (scale) world = to_scaling(*scale);
    if (rotate) world = to_rotation(*rotate) * world;
    if (translate) world = translation(to_placeable(*translate)) * world;
    return world;
}

}  // namespace gw::scene
