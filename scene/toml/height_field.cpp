#include "scene/toml/height_field.h"

#include "scene/obj/normals.h"
#include "scene/obj/obj_data.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace gw::scene {
namespace {

constexpr std::size_t most_lines = 4096;

/// An array of `count` numbers, each rounded to float32.
std::vector<double> numbers_in(const TomlValue& value, std::size_t count) {
    expect_numbers(value, count);
    std::vector<double> numbers;
    for (const TomlValue& element : value.elements) numbers.push_back(to_float(element));
    return numbers;
}

const TomlValue& array_of(const TomlValue& table, const char* key) {
    const TomlValue* value = table.find(key);
    if (!value)
        table.fail("height_field has no " + std::string(key) + "; expected x, z and heights");
    if (value->kind != TomlKind::Array) value->fail_expected("an array");
    return *value;
}

std::vector<double> lines_of(const TomlValue& table, const char* key) {
    const TomlValue& value = array_of(table, key);
    const std::size_t count = value.elements.size();
    if (count < 2 || count > most_lines)
        value.fail(value.name + " has " + std::to_string(count) + " numbers; expected 2 to " +
                   std::to_string(most_lines));
    std::vector<double> numbers = numbers_in(value, count);
    if (!std::ranges::is_sorted(numbers, std::less_equal()))
        value.fail(value.name + " does not increase; expected each number above the last");
    return numbers;
}

MeshData make_height_field(const std::vector<double>& values) {
    const auto columns = std::uint32_t(values[0]), rows = std::uint32_t(values[1]);
    const double* const x = values.data() + 2;
    const double* const z = x + columns;
    const double* const heights = z + rows;
    ObjBuilder builder;
    for (std::uint32_t i = 0; i < columns * rows; ++i)
        builder.obj.positions.push_back(vec3(dvec3(x[i % columns], heights[i], z[i / columns])));
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t i = row * columns + column;
            for (const std::uint32_t corner : {i, i + columns, i + columns + 1, i + 1})
                builder.obj.corners.push_back({.v = corner});
            builder.add_face(4, 0);
        }
    add_normals(builder.obj, default_crease);
    return std::move(make_meshes(builder.obj).front());
}

}  // namespace

const Shape& height_field() {
    static const Shape shape{
        "height_field",
        {},
        make_height_field,
        [](const std::vector<double>& values) { return 2 * (values[0] - 1) * (values[1] - 1); },
        true};
    return shape;
}

std::vector<double> read_height_field(const TomlValue& table) {
    const std::vector<double> x = lines_of(table, "x"), z = lines_of(table, "z");
    const TomlValue& heights = array_of(table, "heights");
    if (heights.elements.size() != z.size())
        heights.fail(heights.name + " has " + std::to_string(heights.elements.size()) +
                     " rows; expected one for each of " + std::to_string(z.size()) + " z");
    std::vector<double> values{double(x.size()), double(z.size())};
    values.insert(values.end(), x.begin(), x.end());
    values.insert(values.end(), z.begin(), z.end());
    for (const TomlValue& row : heights.elements)
        for (const double height : numbers_in(row, x.size())) values.push_back(height);
    return values;
}

}  // namespace gw::scene
