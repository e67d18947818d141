#include "radiosity/display/emissive_scene.h"

#include <map>

namespace gw::radiosity {
namespace {

/// The triangles of one of the scene's objects by the pixmap that they lie in, every corner a
/// vertex of its own.
std::map<std::uint32_t, MeshRef> parts_by_pixmap(const PixmapModel& model, std::size_t drawn,
                                                 const Mesh& mesh) {
    const Source& source = model.sources[drawn];
    const std::vector<vec3>& world = model.drawn.objects[drawn].mesh->data().positions;
    const auto triangles = mesh.triangles();
    std::map<std::uint32_t, MeshData> parts;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (source.facets[t] == no_facet) continue;
        const Facet& facet = model.facets[source.facets[t]];
        MeshData& data = parts[facet.pixmap];
        for (std::uint32_t v : triangles[t].vertex) {
            data.positions.push_back(mesh.data().positions[v]);
            if (!mesh.data().normals.empty()) data.normals.push_back(mesh.data().normals[v]);
            data.texcoords.push_back(
                st_of(model.pixmaps[facet.pixmap], facet.texel_of(dvec3(world[v]))));
        }
    }
    std::map<std::uint32_t, MeshRef> meshes;
    for (auto& [pixmap, data] : parts) meshes.emplace(pixmap, make_mesh(std::move(data)));
    return meshes;
}

scene::Material emissive(scene::Material material, const TextureRef& texture) {
    material.Ka = material.Kd = vec3(0);
    material.Ke = vec3(1);
    material.map_Ka.clear();
    material.map_Kd.clear();
    material.map_Ke = {
        scene::Map{.wrap_s = Wrap::Clamp, .wrap_t = Wrap::Clamp, .texture = texture}};
    return material;
}

/// Whether a triangle's front is seen.
bool faces(const scene::Camera& camera, const std::array<dvec3, 3>& p) {
    const dvec3 way = camera.ortho_height > 0 ? camera.eye - camera.at : camera.eye - p[0];
    return dot3(cross3(p[1] - p[0], p[2] - p[0]), way) > 0;
}

}  // namespace

scene::Scene emissive_scene(const scene::Scene& scene, const PixmapModel& model,
                            const DisplayedPixmaps& colors, double scale) {
    scene::Scene out = scene;
    out.objects.clear();
    // Lights of a scene with a white are in parts of it already.
    const double of_white = scene.white > 0 ? scale * scene.white : scale;
    for (scene::Light& light : out.lights) light.Is = light.Is.value_or(light.Id) * float(of_white);
    for (std::size_t i = 0; i < model.sources.size(); ++i) {
        const scene::Object& object = scene.objects[model.sources[i].object];
        for (auto& [pixmap, mesh] : parts_by_pixmap(model, i, *object.mesh)) {
            out.objects.push_back(object);
            out.objects.back().mesh = std::move(mesh);
            out.objects.back().material = out.materials.size();
            out.materials.push_back(emissive(scene.materials[object.material],
                                             texture_of(model, pixmap, colors, scale)));
        }
    }
    return out;
}

scene::Scene without_backs(scene::Scene scene, const scene::Camera& camera) {
    for (scene::Object& object : scene.objects) {
        MeshData data = object.mesh->data();  // triangles of their own corners
        for (std::size_t i = 0; i + 2 < data.positions.size(); i += 3) {
            std::array<dvec3, 3> world;
            for (std::size_t k = 0; k < 3; ++k)
                world[k] =
                    transform3(dmat3(object.world_from_object), dvec3(data.positions[i + k])) +
                    dvec3(object.world_from_object[3]);
            if (!faces(camera, world))
                data.positions[i + 1] = data.positions[i + 2] = data.positions[i];
        }
        object.mesh = make_mesh(std::move(data));
    }
    return scene;
}

}  // namespace gw::radiosity
