#include "apps/view/settings.h"

#include <fmt/format.h>

namespace gw::apps {
namespace {

const char* word_of(multipass::Translucency translucency) {
    switch (translucency) {
        case multipass::Translucency::Sorted: return "sorted";
        case multipass::Translucency::Unsorted: return "unsorted";
        case multipass::Translucency::Layers: return "layers";
    }
    return "";
}

const char* word_of(scene::Shadow shadow) {
    switch (shadow) {
        case scene::Shadow::None: return "none";
        case scene::Shadow::Volume: return "volume";
        case scene::Shadow::Map: return "map";
    }
    return "";
}

}  // namespace

scene::Scene scene_of(scene::Scene scene, const Settings& settings) {
    scene.camera = settings.camera;
    const auto shadow = settings.picture.shadow;
    for (scene::Light& light : scene.lights)
        if (shadow && light.shadow != scene::Shadow::None) light.shadow = *shadow;
    scene::switch_off(scene, settings.lights_off);
    if (!settings.fog) scene.fog.reset();
    return scene;
}

scene::SavedView saved(const Settings& settings, const std::filesystem::path& base) {
    const PictureOptions& picture = settings.picture;
    scene::SavedView view{.base = base,
                          .camera = settings.camera,
                          .fog = settings.fog,
                          .lights_off = settings.lights_off,
                          .light = {},
                          .options = {}};
    view.options = {{"renderer", picture.renderer},
                    {"size", fmt::format("{}x{}", picture.size.width, picture.size.height)},
                    {"profile", picture.profile},
                    {"samples", std::to_string(picture.samples)},
                    {"averaging", picture.weighted ? "weighted" : "simple"},
                    {"translucency", word_of(picture.translucency)},
                    {"reflections", picture.traced ? "rays" : "maps"},
                    {"depth", std::to_string(picture.rays.depth)},
                    {"reflected-shadows", picture.rays.shadow_maps ? "maps" : "rays"}};
    if (picture.shadow) view.options.emplace_back("shadow", word_of(*picture.shadow));
    return view;
}

std::string key_of(const Settings& settings) {
    scene::SavedView view = saved(settings, "");
    view.camera = {};
    return scene::to_toml(view);
}

std::vector<LessWork> less_work(const Settings& settings) {
    std::vector<LessWork> steps{{settings, ""}};
    const auto add = [&](Settings less, const char* left_out) {
        const std::string before = steps.back().left_out;
        steps.push_back({std::move(less), before + (before.empty() ? "" : ", ") + left_out});
    };
    if (settings.picture.samples > 1) {
        Settings less = settings;
        less.picture.samples = 1;
        less.picture.weighted = false;
        add(less, "1 sample");
    }
    const std::string& renderer = settings.picture.renderer;
    const bool by_rays = renderer == "raytrace" || renderer == "adaptive";
    if (by_rays || (renderer == "multipass" && settings.picture.traced)) {
        Settings less = steps.back().settings;
        less.picture.renderer = "multipass";
        less.picture.traced = false;
        add(less, "no rays");
    }
    if (renderer != "hardware") {
        Settings less = steps.back().settings;
        less.picture.renderer = "hardware";
        add(less, "one pass");
    }
    return steps;
}

}  // namespace gw::apps
