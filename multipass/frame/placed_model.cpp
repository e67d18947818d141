// Everything of the scene in eye space, once per view.
#include "multipass/frame/placed_model.h"

#include "scene/draw/draw_commands.h"

namespace gw::multipass {

Stage make_stage(const Model& model, const scene::View& view) {
    Stage stage{.model = &model, .view = view, .state = scene::view_state(view)};
    for (const Part& part : model.parts)
        stage.eye_from_object.push_back(scene::placed(*part.object, view).eye_from_object);
    for (const scene::Light& light : model.scene->lights)
        stage.lights.push_back(
            std::make_shared<const std::vector<Light>>(1, scene::eye_light(light, view)));
    stage.glare.resize(model.parts.size());
    return stage;
}

LightsRef lights_of(const Stage& stage, const Part& part) {
    const auto& lights = stage.model->scene->lights;
    std::vector<Light> lit_by;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (scene::lights_object(lights[i], *part.object))
            lit_by.push_back(stage.lights[i]->front());
    return lit_by.empty() ? nullptr : std::make_shared<const std::vector<Light>>(std::move(lit_by));
}

}  // namespace gw::multipass
