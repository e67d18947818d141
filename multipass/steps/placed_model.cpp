#include "multipass/steps/placed_model.h"

#include "gw/stages/texgen.h"
#include "gw/stages/vertex.h"
#include "scene/draw/draw_commands.h"

#include <glm/gtc/matrix_inverse.hpp>

namespace gw::multipass {
namespace {

MeshRef pick(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const MeshData& from = mesh.data();
    MeshData to;
    const auto copy = [](const auto& source, auto& target, std::uint32_t i) {
        if (!source.empty()) target.push_back(source[i]);
    };
    for (const std::uint32_t triangle : triangles)
        for (const std::uint32_t v : mesh.triangles()[triangle].vertex) {
            to.positions.push_back(from.positions[v]);
            copy(from.normals, to.normals, v);
            copy(from.texcoords, to.texcoords, v);
            copy(from.colors, to.colors, v);
        }
    return make_mesh(std::move(to));
}

/// The mesh with the coordinates that its map generates for the view vector (0, 0, 1).
MeshRef with_coordinates(const MappedMesh& map, const dmat4& eye_from_object) {
    MeshData data = map.mesh->data();
    const dmat3 normal_eye_from_object = glm::inverseTranspose(dmat3(eye_from_object));
    data.texcoords.resize(data.positions.size());
    for (std::size_t i = 0; i < data.positions.size(); ++i) {
        const dvec3 n = data.normals.empty() ? dvec3(0, 0, 1) : dvec3(data.normals[i]);
        data.texcoords[i] = vec2(
            texture_coordinates(map.lookup, {.p_eye4 = {0, 0, -1, 1},
                                             .p_eye = {0, 0, -1},
                                             .n_eye = normalized(normal_eye_from_object * n)}));
    }
    return make_mesh(std::move(data));
}

void generate_coordinates(PlacedModel& placed) {
    for (std::size_t i = 0; i < placed.model->parts.size(); ++i)
        for (const PassMap kind : {PassMap::Reflection, PassMap::Refraction})
            for (const MappedMesh& map : placed.model->parts[i].maps_for(kind))
                placed.generated.emplace(std::pair(i, &map),
                                         with_coordinates(map, placed.eye_from_object[i]));
}

}  // namespace

PlacedModel place_model(const PassModel& model, const scene::View& view) {
    PlacedModel placed{.model = &model, .view = view, .state = scene::view_state(view)};
    placed.eye_from_object.reserve(model.parts.size());
    for (const Part& part : model.parts) {
        placed.eye_from_object.push_back(scene::placed(*part.object, view).eye_from_object);
        placed.cull.push_back(scene::cull_of(*part.object));
    }
    for (const scene::Light& light : model.scene->lights)
        placed.lights.push_back(
            std::make_shared<const std::vector<Light>>(1, scene::eye_light(light, view)));
    std::vector<Light> every;
    for (const LightsRef& light : placed.lights) every.push_back(light->front());
    if (!every.empty())
        placed.every_light = std::make_shared<const std::vector<Light>>(std::move(every));
    placed.glare.resize(model.parts.size());
    if (scene::is_orthographic(view)) generate_coordinates(placed);
    return placed;
}

LightsRef lights_of(const PlacedModel& placed, const Part& part) {
    const auto& lights = placed.model->scene->lights;
    std::vector<Light> lit_by;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (scene::lights_object(lights[i], *part.object))
            lit_by.push_back(placed.lights[i]->front());
    if (lit_by.size() == lights.size()) return placed.every_light;
    return lit_by.empty() ? nullptr : std::make_shared<const std::vector<Light>>(std::move(lit_by));
}

const MeshRef& PortionMaker::picked(const MeshRef& mesh, std::span<const std::uint32_t> triangles) {
    MeshRef& made = picked_[{mesh, {triangles.begin(), triangles.end()}}];
    if (!made) made = pick(*mesh, triangles);
    return made;
}

Portion PortionMaker::portion_of(std::size_t index, std::span<const std::uint32_t> triangles) {
    Portion portion{.part = index};
    const auto add = [&](const MeshRef& mesh) {
        if (portion.of(mesh) == mesh) portion.meshes.emplace_back(mesh, picked(mesh, triangles));
    };
    const Part& part = placed_.model->parts[index];
    add(part.mesh);
    for (const auto& maps : *part.maps)
        for (const MappedMesh& map : maps) add(placed_.mesh_of(index, map));
    return portion;
}

}  // namespace gw::multipass
