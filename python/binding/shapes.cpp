// Shapes as meshes, within the limits of scene files.
#include "gw/error.h"
#include "python/binding/casters.h"
#include "python/binding/checked.h"
#include "python/binding/module.h"
#include "scene/toml/shape_table.h"

#include <algorithm>

namespace gw::python {
namespace {

namespace py = pybind11;

/// The limit of scene files.
constexpr double most_triangles = 1 << 25;

std::shared_ptr<Mesh> tessellated(const scene::Shape& shape, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const scene::ShapeParameter& parameter = shape.parameters[i];
        const auto check = parameter.integer ? check_whole : check_range;
        check(shape.name + ", " + parameter.name, values[i], parameter.low, parameter.high);
    }
    check_whole(shape.name + ", triangles", shape.triangles(values), 0, most_triangles);
    return std::const_pointer_cast<Mesh>(make_mesh(shape.make(values)));
}

const scene::Shape& shape_named(const std::string& name) {
    std::string known;
    for (const scene::Shape& shape : scene::shapes()) {
        if (shape.name == name) return shape;
        known += (known.empty() ? "" : ", ") + shape.name;
    }
    throw Error("no shape '" + name + "'; expected one of " + known);
}

std::shared_ptr<Mesh> by_name(const std::string& name, const py::kwargs& given) {
    const scene::Shape& shape = shape_named(name);
    std::vector<double> values;
    std::string known;
    for (const scene::ShapeParameter& parameter : shape.parameters) {
        known += (known.empty() ? "" : ", ") + parameter.name;
        values.push_back(parameter.value);
    }
    for (const auto& [key, value] : given) {
        const auto word = key.cast<std::string>();
        const auto found = std::ranges::find(shape.parameters, word, &scene::ShapeParameter::name);
        if (found == shape.parameters.end())
            throw py::type_error(name + " has no '" + word + "'; expected " + known);
        values[std::size_t(found - shape.parameters.begin())] = value.cast<double>();
    }
    return tessellated(shape, values);
}

std::shared_ptr<Mesh> box(const char* name, const dvec3& size, int segments) {
    return tessellated(shape_named(name), {size.x, size.y, size.z, double(segments)});
}

}  // namespace

void add_shapes(py::module_& m) {
    m.def("make_shape", &by_name, py::arg("shape"),
          "A shape of scene files by name, with its parameters there as keywords: "
          "make_shape(\"vase\", slices=32). docs/scenes.md lists them.");
    m.def(
        "make_box", [](const dvec3& size, int segments) { return box("box", size, segments); },
        py::arg("size") = dvec3(1), py::arg("segments") = 1,
        "A box about the origin; size in x, y, z.");
    m.def(
        "make_room", [](const dvec3& size, int segments) { return box("room", size, segments); },
        py::arg("size") = dvec3(1), py::arg("segments") = 1, "A box whose faces look inwards.");
    m.def(
        "make_rectangle",
        [](double width, double depth, int columns, int rows) {
            return tessellated(shape_named("rectangle"),
                               {width, depth, double(columns), double(rows)});
        },
        py::arg("width") = 1.0, py::arg("depth") = 1.0, py::arg("columns") = 1, py::arg("rows") = 1,
        "A rectangle in the plane y = 0, facing up.");
    m.def(
        "make_sphere",
        [](double radius, int slices, int stacks) {
            return tessellated(shape_named("sphere"), {radius, double(slices), double(stacks)});
        },
        py::arg("radius") = 1.0, py::arg("slices") = 32, py::arg("stacks") = 16,
        "A sphere about the origin.");
    m.def(
        "make_icosphere",
        [](double radius, int divisions) {
            return tessellated(shape_named("icosphere"), {radius, double(divisions)});
        },
        py::arg("radius") = 1.0, py::arg("divisions") = 2,
        "A sphere of 20 4^divisions nearly equal triangles.");
    m.def(
        "make_torus",
        [](double radius, double tube, int segments, int sides) {
            return tessellated(shape_named("torus"),
                               {radius, tube, double(segments), double(sides)});
        },
        py::arg("radius") = 1.0, py::arg("tube") = 0.3, py::arg("segments") = 32,
        py::arg("sides") = 16, "A ring about the y axis.");
    m.def(
        "make_teapot",
        [](int segments) { return tessellated(shape_named("teapot"), {double(segments)}); },
        py::arg("segments") = 8, "The Utah teapot.");
}

}  // namespace gw::python
