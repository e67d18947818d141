#include "radiosity/figures.h"

#include "gw/error.h"
#include "radiosity/coverage.h"
#include "radiosity/model_builder.h"
#include "radiosity/patches.h"

namespace gw::radiosity {

namespace {

void check_emission(const Model& model) {
    for (const Figure& figure : model.figures)
        if (figure.E != dvec3(0)) return;
    throw Error(
        "scene '" + model.drawn.name +
        "': nothing emits light; expected a material with Ke, or pixmap = {emission = ...} of an object");
}

}  // namespace

Model make_model(const scene::Scene& scene, const ModelOptions& options) {
    ModelBuilder builder(scene, options);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].mesh->kind() != MeshKind::Triangles) continue;  // lines, points have no area
        builder.begin(i);
        scene.objects[i].pixmap.given_st ? add_given(builder) : add_automatic(builder);
        builder.end();
    }
    check_emission(builder.model);
    cover_texels(builder.model);
    builder.model.patches = patches_of(builder.model, options.patch);
    return std::move(builder.model);
}

}  // namespace gw::radiosity
