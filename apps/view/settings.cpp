#include "apps/view/settings.h"

#include "apps/picture/saved_options.h"
#include "render/options.h"

namespace gw::apps {

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
    for (const render::Option& option : render::options())
        if (const std::string word = option.word(picture); is_saved(option.name) && !word.empty())
            view.options.emplace_back(option.name, word);
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
