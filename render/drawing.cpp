#include "render/drawing.h"

#include "multipass/frame/driver.h"
#include "multipass/frame/scene_maps.h"
#include "multipass/frame/superpose.h"
#include "multipass/steps/schedule.h"
#include "render/options.h"
#include "scene/toml/read_profile.h"
#include "scene/validate/rules.h"
#include "scene/validate/slivers.h"

#include <fmt/format.h>

#include <algorithm>

namespace gw::render {
namespace {

DrawOptions draw_options(const Drawing& drawing) {
    const Request& request = drawing.request;
    DrawOptions options{.multipass = {.pass_list = drawing.pass_list,
                                      .translucency = request.translucency,
                                      .samples = request.samples,
                                      .weighted = request.weighted},
                        .rays = ray_options(request),
                        .traced = request.traced};
    options.rays.counts = drawing.counts;
    return options;
}

/// The options of the passes that draw scene maps.
multipass::Options map_options(const Drawing& drawing) {
    multipass::Options options = draw_options(drawing).multipass;
    if (drawing.renderer().pass_owner) options.pass_list = pass_list(drawing);
    return options;
}

/// Keeps the hierarchies.
std::function<void(const scene::View&)> rays_drawer(const Drawing& drawing, Machine& machine) {
    DrawOptions options = draw_options(drawing);
    options.rays.world = std::make_shared<raytrace::World>(drawing.scene, drawing.request.threads);
    return [&drawing, &machine, options](const scene::View& view) {
        drawing.renderer().draw(machine, drawing.scene, view, options);
    };
}

scene::CameraOverrides camera_in(const Request& request, const dvec3& origin) {
    scene::CameraOverrides camera = request.camera;
    if (camera.eye) *camera.eye -= origin;
    if (camera.at) *camera.at -= origin;
    return camera;
}

/// What the request says of the camera counts at all times of a film.
void keep_camera(scene::Film& film, const scene::CameraOverrides& camera) {
    film.pose = [camera, pose = film.pose](scene::Scene& scene, double time) {
        pose(scene, time);
        if (scene.camera) scene.camera = scene::override_camera(*scene.camera, camera);
    };
}

}  // namespace

scene::View Drawing::view() const {
    return scene::make_view(scene, request.size.width, request.size.height);
}

void check_samples(const Request& request, const Profile& profile) {
    // As many groups as a group has samples; with weights only one group.
    const int group = multipass::most_pictures(profile),
              most = request.weighted ? group : group * group;
    if (request.samples > most)
        throw OptionError(fmt::format(
            "samples '{}': more than profile {} superposes{}; expected "
            "1..{}",
            request.samples, profile.name, request.weighted ? " with weights" : "", most));
}

Profile load_profile(const Request& request) {
    const std::string& name = request.profile;
    const Profile profile = is_profile_file(name) ? scene::read_profile(name) : profile_named(name);
    check_samples(request, profile);
    return profile;
}

std::unique_ptr<Machine> make_machine(const Request& request, const Profile& profile) {
    const auto [width, height] = request.size;
    return request.machine == "reference"
               ? make_reference(profile, width, height)
               : make_fast(profile, width, height, {.threads = request.threads});
}

scene::Camera with_options(const scene::Camera& camera, const scene::CameraOverrides& options) {
    const scene::Camera out = scene::override_camera(camera, options);
    const auto fault = scene::fault_of(out);
    // The view may go along an up that nobody asked for: another one stands in.
    if (fault && (options.up || out.eye == out.at))
        throw OptionError(
            fmt::format("{} is {}; expected {}", fault->field.file, fault->is, fault->expected));
    return out;
}

scene::Scene scene_for(const Request& request, SceneInput input) {
    scene::Scene scene = std::move(input.scene);
    scene::add_defaults(scene, request.size.width, request.size.height);
    scene.camera = with_options(*scene.camera, camera_in(request, input.origin));
    for (scene::Light& light : scene.lights)
        if (request.shadow && light.shadow != scene::Shadow::None) light.shadow = *request.shadow;
    return scene;
}

Drawing make_drawing(const Request& request, const Profile& profile, SceneInput input) {
    check_samples(request, profile);
    std::optional<multipass::PassList> passes = std::move(input.passes);
    std::vector<scene::Film> films = std::move(input.films);
    const bool is_fitted = !input.scene.camera && !request.camera.eye && !request.camera.at;
    Drawing drawing{request, profile, scene_for(request, std::move(input))};
    drawing.films = std::move(films);
    for (scene::Film& film : drawing.films) keep_camera(film, camera_in(request, input.origin));
    drawing.is_fitted = is_fitted;
    if (drawing.renderer().pass_owner == multipass::Renderer::Multipass)
        drawing.pass_list = std::move(passes);
    return drawing;
}

std::vector<std::string> warnings(const Drawing& drawing) {
    std::vector<std::string> lines =
        scene::warnings_of(drawing.scene, drawing.view(), drawing.renderer().drawn_by);
    if (drawing.renderer().drawn_by != scene::DrawnBy::Rays)
        lines.push_back(
            scene::turned_slivers(drawing.scene, drawing.view(), drawing.profile.subpixel_bits));
    std::erase(lines, "");
    const std::string effects = left_out(drawing.renderer(), drawing.scene);
    if (!effects.empty()) lines.insert(lines.begin(), effects);
    return lines;
}

std::string empty_warning(const Drawing& drawing, Machine& machine) {
    return scene::empty_picture(drawing.scene, machine.planes().color, drawing.profile.color_bits);
}

itembuffer::Options ray_options(const Request& request) {
    return {.depth = request.depth, .shadow_maps = request.shadow_maps, .threads = request.threads};
}

multipass::PassList pass_list(const Drawing& drawing) {
    if (!drawing.renderer().pass_owner) return {};
    return pass_list(drawing.renderer(), drawing.scene, draw_options(drawing));
}

bool has_scene_maps(const Drawing& drawing) {
    return multipass::has_scene_maps(drawing.scene, map_options(drawing));
}

scene::Scene scene_with_maps(const Drawing& drawing, const scene::View& view, Machine& machine) {
    return multipass::with_scene_maps(machine, drawing.scene, view, map_options(drawing));
}

void draw(const Drawing& drawing, const scene::View& view, Machine& machine) {
    const auto draw_scene = [&](const scene::Scene& scene) {
        drawing.renderer().draw(machine, scene, view, draw_options(drawing));
    };
    if (has_scene_maps(drawing))
        draw_scene(scene_with_maps(drawing, view, machine));
    else
        draw_scene(drawing.scene);
}

std::function<void(const scene::View&)> view_drawer(const Drawing& drawing, Machine& machine) {
    const auto alone = [&](const scene::View& view) { draw(drawing, view, machine); };
    const auto owner = drawing.renderer().pass_owner;
    if (drawing.renderer().drawn_by == scene::DrawnBy::Rays && !has_scene_maps(drawing))
        return rays_drawer(drawing, machine);
    if (!owner || has_scene_maps(drawing)) return alone;
    const DrawOptions options = draw_options(drawing);
    multipass::Options passes = options.multipass;
    passes.renderer = *owner;
    passes.pass_list = pass_list(drawing);
    const bool traced = options.traced && owner == multipass::Renderer::Multipass;
    const std::shared_ptr<multipass::Driver> driver =
        traced ? itembuffer::make_driver(machine, drawing.scene, passes, options.rays)
               : std::make_unique<multipass::Driver>(machine, drawing.scene, passes);
    return [driver](const scene::View& view) { driver->draw(view); };
}

std::vector<multipass::ComponentImage> components(const Drawing& drawing, const scene::View& view,
                                                  Machine& machine) {
    // The maps show all components.
    const scene::Scene ready = scene_with_maps(drawing, view, machine);
    return multipass::component_images(
        multipass::component_lists(drawing.scene, pass_list(drawing)),
        [&](const multipass::ComponentList& list) {
            scene::Scene scene = ready;
            if (!list.background) scene.background = vec3(0);
            DrawOptions options = draw_options(drawing);
            options.multipass.pass_list = list.passes;
            options.rays.background = drawing.scene.background;
            drawing.renderer().draw(machine, scene, view, options);
            return machine.planes().color;
        });
}

std::map<std::string, PassSource> pass_sources(const Drawing& drawing) {
    std::map<std::string, PassSource> sources;
    if (!drawing.renderer().pass_owner) return sources;
    const multipass::PassList list = pass_list(drawing);
    const multipass::PassModel model = multipass::make_pass_model(drawing.scene);
    for (const multipass::Step& step : multipass::schedule(list, model)) {
        const auto row = std::ranges::find(list, step.pass.name, &multipass::Pass::name);
        sources[multipass::name_of(step, model)] = {multipass::to_string(step.pass.material),
                                                    std::size_t(row - list.begin())};
    }
    return sources;
}

std::map<std::string, std::string> parameter_sets(const Drawing& drawing) {
    std::map<std::string, std::string> sets;
    for (const auto& [pass, source] : pass_sources(drawing)) sets[pass] = source.set;
    return sets;
}

}  // namespace gw::render
