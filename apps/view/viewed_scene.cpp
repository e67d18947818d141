#include "apps/view/viewed_scene.h"

#include "scene/toml/read_scene.h"

namespace gw::apps {
namespace {

/// Whether add_defaults added the only light, for a scene that has none.
bool has_default_light(const scene::Scene& scene, const std::filesystem::path& file) {
    return scene.lights.size() == 1 && scene.lights[0].name == "default" &&
           scene::read_scene(file).scene.lights.empty();
}

}  // namespace

ViewedScene load_viewed_scene(const PictureOptions& options, const std::filesystem::path& folder,
                              Session& session) {
    PictureOptions picture = options;
    picture.shadow.reset();  // the viewer changes shadows itself
    SceneWithPasses loaded = load_scene_with_passes(picture, session);
    ViewedScene viewed{.file = picture.scene,
                       .scene = std::move(loaded.scene),
                       .passes = std::move(loaded.passes),
                       .origin = loaded.origin,
                       .folder = folder};
    viewed.has_default_light = has_default_light(viewed.scene, picture.scene);
    for (const Profile& profile : profiles()) viewed.profiles[profile.name] = profile;
    viewed.profiles[picture.profile] = load_profile(picture, session);
    viewed.inputs = session.inputs;
    return viewed;
}

}  // namespace gw::apps
