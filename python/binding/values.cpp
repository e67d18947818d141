// Meshes, textures, materials and lights.
#include "gw/material.h"
#include "gw/mesh.h"
#include "gw/texture.h"
#include "python/binding/arrays.h"
#include "python/binding/fields.h"
#include "python/binding/interpreter/warn.h"
#include "python/binding/module.h"
#include "scene/validate/warnings_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gw::python {
namespace {

/// NumPy's numbers are doubles as a rule, and the machine's floats.
void warn_of_rounding(const py::object& object) {
    const auto wide = array_from<Input<double>>(object, "positions");
    double largest = 0, low[3] = {}, high[3] = {};
    for (py::ssize_t i = 0; i < wide.size(); ++i) {
        const double v = wide.data()[i];
        const int k = int(i % 3);
        largest = std::max(largest, std::abs(v - double(float(v))));
        low[k] = i < 3 ? v : std::min(low[k], v);
        high[k] = i < 3 ? v : std::max(high[k], v);
    }
    const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
    if (side == 0 || !(largest * 4096 > side)) return;
    warn({fmt::format(
        "positions: float32 moves them by up to {:.3g} in a mesh {:.3g} wide; expected "
        "coordinates near 0, placed by a matrix (world_from_object)",
        largest, side)});
}

/// Bytes are 0 .. 255, as in textures.
std::vector<vec4> vertex_colors(const py::object& object) {
    std::vector<vec4> colors = elements_of<vec4, float>(object, 4, "colors");
    if (object.is_none()) return colors;
    if (array_from(object, "colors").dtype().is(py::dtype::of<std::uint8_t>())) {
        for (vec4& color : colors) color /= 255.0f;
        return colors;
    }
    float most = 0;
    for (const vec4& color : colors) most = std::max({most, color.x, color.y, color.z, color.w});
    if (most > scene::in_bytes)
        warn({fmt::format("colors: {:.9g}; expected 0 to 1, or bytes (uint8) of 0 to 255", most)});
    return colors;
}

MeshRef mesh_of(Primitive primitive, const py::object& positions, const py::object& normals,
                const py::object& texcoords, const py::object& colors, const py::object& indices,
                const py::object& polygon_sizes, const py::object& polygon_ids,
                const py::object& edge_flags) {
    MeshData data;
    data.primitive = primitive;
    data.positions = elements_of<vec3, float>(positions, 3, "positions");
    if (!positions.is_none()) warn_of_rounding(positions);
    data.normals = elements_of<vec3, float>(normals, 3, "normals");
    data.texcoords = elements_of<vec2, float>(texcoords, 2, "texcoords");
    data.colors = vertex_colors(colors);
    data.indices = whole_numbers_of<std::uint32_t>(indices, "indices");
    data.polygon_sizes = whole_numbers_of<std::uint32_t>(polygon_sizes, "polygon_sizes");
    data.polygon_ids = whole_numbers_of<std::uint32_t>(polygon_ids, "polygon_ids");
    data.edge_flags = whole_numbers_of<std::uint8_t>(edge_flags, "edge_flags");
    return make_mesh(std::move(data));
}

py::array mesh_view(const py::object& self, const auto& values, int channels) {
    const auto count = py::ssize_t(values.size());
    if (channels == 1) return view_of<std::uint32_t>(values.data(), {count}, self);
    return view_of<float>(values.data(), {count, channels}, self);
}

void add_mesh(py::module_& m) {
    add_enum<Primitive>(m, "Primitive", "glBegin's modes.",
                        {{"Points", Primitive::Points},
                         {"Lines", Primitive::Lines},
                         {"LineStrip", Primitive::LineStrip},
                         {"Triangles", Primitive::Triangles},
                         {"TriangleStrip", Primitive::TriangleStrip},
                         {"TriangleFan", Primitive::TriangleFan},
                         {"Quads", Primitive::Quads},
                         {"Polygons", Primitive::Polygons}});
    const auto get = [](auto member, int channels) {
        return [member, channels](const py::object& self) {
            return mesh_view(self, self.cast<const Mesh&>().data().*member, channels);
        };
    };
    py::class_<Mesh, std::shared_ptr<Mesh>>(m, "Mesh", "Immutable vertices and primitives.")
        .def(
            py::init([](Primitive primitive, const py::object& positions, const py::object& normals,
                        const py::object& texcoords, const py::object& colors,
                        const py::object& indices, const py::object& polygon_sizes,
                        const py::object& polygon_ids, const py::object& edge_flags) {
                return std::const_pointer_cast<Mesh>(
                    mesh_of(primitive, positions, normals, texcoords, colors, indices,
                            polygon_sizes, polygon_ids, edge_flags));
            }),
            py::arg("primitive"), py::arg("positions"), py::kw_only(),
            py::arg("normals") = py::none(), py::arg("texcoords") = py::none(),
            py::arg("colors") = py::none(), py::arg("indices") = py::none(),
            py::arg("polygon_sizes") = py::none(), py::arg("polygon_ids") = py::none(),
            py::arg("edge_flags") = py::none(),
            "Arrays in object space: positions and normals (n, 3), texcoords (n, 2), colors (n, "
            "4); whole numbers: indices, the size and identifier of each polygon, edge flags.")
        .def_property_readonly(
            "primitive", [](const Mesh& mesh) { return mesh.data().primitive; }, "glBegin's mode.")
        .def_property_readonly("positions", get(&MeshData::positions, 3), "A view, (n, 3).")
        .def_property_readonly("normals", get(&MeshData::normals, 3), "A view, (n, 3) or empty.")
        .def_property_readonly("texcoords", get(&MeshData::texcoords, 2),
                               "A view, (n, 2) or empty.")
        .def_property_readonly("colors", get(&MeshData::colors, 4), "A view, (n, 4) or empty.")
        .def_property_readonly("indices", get(&MeshData::indices, 1), "A view, (n,) or empty.")
        .def_property_readonly("polygon_sizes", get(&MeshData::polygon_sizes, 1), "A view.")
        .def_property_readonly("polygon_ids", get(&MeshData::polygon_ids, 1), "A view.")
        .def_property_readonly("polygon_count", &Mesh::polygon_count, "Polygons, lines or points.")
        .def_property_readonly("vertex_count", &Mesh::vertex_count, "Vertices.");
}

TextureRef texture_of(const std::string& name, const py::array& texels) {
    if (texels.ndim() != 3 || texels.shape(2) != 4)
        throw Error("texels: an array of shape " + shape_text(texels) +
                    "; expected (height, width, 4), the bottom row first");
    const int height = length_of(texels, 0, "texels"), width = length_of(texels, 1, "texels");
    const py::dtype type = texels.dtype();
    if (type.equal(py::dtype::of<std::uint8_t>())) {
        const auto bytes = array_from<Input<std::uint8_t>>(texels, "texels");
        return make_texture8(name, width, height, {bytes.data(), std::size_t(bytes.size())});
    }
    if (!type.equal(py::dtype::of<std::uint16_t>()))
        throw Error("texels: an array of type " + py::str(py::object(type)).cast<std::string>() +
                    "; expected uint8 or uint16");
    const auto words = array_from<Input<std::uint16_t>>(texels, "texels");
    return make_texture(name, width, height, {words.data(), std::size_t(words.size())});
}

void add_texture(py::module_& m) {
    py::class_<Texture, std::shared_ptr<Texture>>(m, "Texture", "An immutable pyramid of images.")
        .def(py::init([](const py::array& texels, const std::string& name) {
                 return std::const_pointer_cast<Texture>(texture_of(name, texels));
             }),
             py::arg("texels"), py::arg("name") = "",
             "Texels (height, width, 4) of uint8 or uint16, the bottom row first.")
        .def_property_readonly(
            "name", [](const Texture& t) { return t.name; }, "For messages.")
        .def_property_readonly("width", &Texture::width, "Texels.")
        .def_property_readonly("height", &Texture::height, "Texels.")
        .def_property_readonly(
            "levels",
            [](const py::object& self) {
                py::list levels;
                for (const TextureLevel& level : self.cast<const Texture&>().levels)
                    levels.append(view_of<std::uint16_t>(level.rgba.data(),
                                                         rows(level.height, level.width, 4), self));
                return levels;
            },
            "Views, (height, width, 4) of 16 bits.");
}

}  // namespace

void add_values(py::module_& m) {
    add_mesh(m);
    add_texture(m);
    Fields<Material>(m, "Material", "A surface's parameters in the papers' words [K2].")
        .field("Ka", &Material::Ka, "Ambient.")
        .field("Kd", &Material::Kd, "Diffuse.")
        .field("Ks", &Material::Ks, "Specular.")
        .field("Ke", &Material::Ke, "Emission.")
        .field("Ns", &Material::Ns, "Exponent of the highlight, 0 .. 10000.")
        .field("alpha", &Material::alpha, "Of the lit colour.");
    Fields<Light>(m, "Light", "A light in eye space; directional if position[3] is 0.")
        .field("position", &Light::position, "x, y, z, w.")
        .field("Ia", &Light::Ia, "Ambient.")
        .field("Id", &Light::Id, "Diffuse.")
        .field("Is", &Light::Is, "Specular.")
        .field("spot_direction", &Light::spot_direction, "Of the cone.")
        .field("spot_exponent", &Light::spot_exponent, "0 .. 128.")
        .field("spot_cos_cutoff", &Light::spot_cos_cutoff, "-1: no cone.")
        .field("constant_attenuation", &Light::constant_attenuation, "Of distance 0.")
        .field("linear_attenuation", &Light::linear_attenuation, "Per unit.")
        .field("quadratic_attenuation", &Light::quadratic_attenuation, "Per unit squared.");
}

}  // namespace gw::python
