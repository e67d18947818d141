#include "apps/view/viewed_scene.h"

#include "scene/validate/slivers.h"

namespace gw::apps {

ViewedScene load_viewed_scene(const PictureOptions& options, const std::filesystem::path& folder,
                              Session& session) {
    PictureOptions picture = options;
    picture.shadow.reset();  // the viewer changes shadows itself
    render::SceneInput input = read_input(picture, session);
    const bool has_no_light = input.scene.lights.empty();
    ViewedScene viewed{
        .file = picture.scene, .passes = input.passes, .origin = input.origin, .folder = folder};
    viewed.scene = ready_scene(picture, std::move(input));
    viewed.has_default_light = has_no_light && viewed.scene.lights.size() == 1;
    for (const Profile& profile : profiles()) viewed.profiles[profile.name] = profile;
    const Profile& profile = viewed.profiles[picture.profile] = load_profile(picture, session);
    if (!picture.quiet) {
        print_warnings_of(viewed.scene, picture.size, scene::DrawnBy::Passes);
        const scene::View view =
            scene::make_view(viewed.scene, picture.size.width, picture.size.height);
        print_warnings({scene::turned_slivers(viewed.scene, view, profile.subpixel_bits)});
    }
    viewed.inputs = session.inputs;
    return viewed;
}

}  // namespace gw::apps
