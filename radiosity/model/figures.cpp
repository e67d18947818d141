#include "radiosity/model/figures.h"

#include "gw/error.h"
#include "radiosity/model/model_builder.h"
#include "radiosity/model/patches.h"
#include "radiosity/model/texel_coverage.h"

namespace gw::radiosity {
namespace {

/// The objects as one mesh; polygon identifiers are facets, which ascend from object to object.
scene::Scene joined(const scene::Scene& drawn) {
    MeshData whole;
    for (const scene::Object& object : drawn.objects) {
        const auto first = static_cast<std::uint32_t>(whole.positions.size());
        const MeshData& mesh = object.mesh->data();
        whole.positions.insert(whole.positions.end(), mesh.positions.begin(), mesh.positions.end());
        whole.polygon_ids.insert(whole.polygon_ids.end(), mesh.polygon_ids.begin(),
                                 mesh.polygon_ids.end());
        for (const std::uint32_t vertex : mesh.indices) whole.indices.push_back(first + vertex);
    }
    scene::Scene scene;
    scene.name = drawn.name;
    scene.materials = drawn.materials;
    scene.objects.push_back({.name = drawn.name, .mesh = make_mesh(std::move(whole))});
    return scene;
}

}  // namespace

void check_emission(const PixmapModel& model) {
    for (const Figure& figure : model.figures)
        if (figure.E != dvec3(0)) return;
    throw Error("scene '" + model.drawn.name +
                "': nothing emits light; expected a material with Ke, or pixmap = {emission = ...} "
                "of an object");
}

PixmapModel make_model(const scene::Scene& scene, const ModelOptions& options) {
    ModelBuilder builder(scene, options);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        // lines, points have no area
        if (scene.objects[i].mesh->kind() != MeshKind::Triangles) continue;
        builder.begin(i);
        scene.objects[i].pixmap.given_st ? add_given(builder) : add_automatic(builder);
        builder.end();
    }
    cover_texels(builder.model);
    builder.model.patches = patches_of(builder.model, options.patch);
    builder.model.joined = joined(builder.model.drawn);
    return std::move(builder.model);
}

}  // namespace gw::radiosity
