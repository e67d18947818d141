#include "apps/render/frame_files.h"

#include "apps/command/command_recorder.h"
#include "apps/command/terminal.h"
#include "apps/figures/folder_index.h"
#include "apps/recordings/recording_files.h"
#include "apps/render/scene_warnings.h"
#include "image/planes.h"
#include "image/write.h"
#include "inspect/manifest/json_of.h"
#include "inspect/manifest/manifest.h"
#include "inspect/replay/forwarding_machine.h"
#include "multipass/frame/driver.h"
#include "multipass/frame/scene_maps.h"
#include "multipass/steps/schedule.h"
#include "scene/draw/draw_commands.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <set>

namespace gw::apps {
namespace {

image::Picture picture_of(const Drawing& drawing, const std::vector<Rgba>& color,
                          const image::Tone& tone) {
    const Size size = drawing.options.size;
    return image::toned(
        image::picture_of(color, size.width, size.height, drawing.profile.color_bits), tone);
}

// A component's name as the name of a file: "diffuse lamp 1" becomes "diffuse_lamp_1".
std::string file_name(std::string name, std::set<std::string>& taken) {
    for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    }
    std::string unique = name;
    for (int i = 2; !taken.insert(unique).second; ++i) unique = name + "_" + std::to_string(i);
    return unique;
}

// The scene's own passes replace those of multipass.
DrawOptions options_of(const Drawing& drawing) {
    DrawOptions options = draw_options(drawing.options);
    if (drawing.renderer.passes == multipass::Renderer::Multipass)
        options.passes.passes = drawing.own_passes;
    return options;
}

// Those that maps are generated from the scene with.
multipass::Options options_of_maps(const Drawing& drawing) {
    multipass::Options options = options_of(drawing).passes;
    if (drawing.renderer.passes) options.passes = passes_of(drawing);
    return options;
}

// The scene with the maps that are generated from it.
scene::Scene with_maps(const Drawing& drawing, const scene::View& view, Machine& machine) {
    return multipass::with_scene_maps(machine, drawing.scene, view, options_of_maps(drawing));
}

// Draws the component's passes, on black if the background is a component of its own. The scene has
// its maps already, because they show all components.
std::vector<Rgba> component(const Drawing& drawing, scene::Scene scene,
                            const multipass::ComponentList& list, const scene::View& view,
                            Machine& machine) {
    if (!list.background) scene.background = vec3(0);
    DrawOptions options = options_of(drawing);
    options.passes.passes = list.passes;
    options.rays.background = drawing.scene.background;
    drawing.renderer.draw(machine, scene, view, options);
    return machine.planes().color;
}

void put_components(const Drawing& drawing, Machine& machine, const scene::View& view,
                    const FrameFiles& files, image::OutputSet& output) {
    const std::string extension = files.picture.extension().string();
    std::set<std::string> taken{"sum"};
    const scene::Scene ready = with_maps(drawing, view, machine);
    const auto put = [&](const std::string& name, const std::vector<Rgba>& color) {
        image::put_picture(output.add(files.components / (name + extension)),
                           picture_of(drawing, color, files.tone));
    };
    const auto images =
        multipass::component_images(multipass::component_lists(drawing.scene, passes_of(drawing)),
                                    [&](const multipass::ComponentList& list) {
                                        return component(drawing, ready, list, view, machine);
                                    });
    for (const auto& image : images) put(file_name(image.name, taken), image.color);
    put("sum", multipass::sum_of(images, drawing.profile));
}

void put_planes(const Drawing& drawing, Machine& machine, const scene::View& view,
                const FrameFiles& files, image::OutputSet& output) {
    image::put_planes(output, files.planes, machine.planes(), drawing.profile);
    machine.execute(scene::id_pass(drawing.scene, view));
    std::vector<std::uint32_t> ids;
    for (const Rgba& color : machine.planes().color) ids.push_back(scene::id_of(color));
    image::put_ids(output, files.planes, ids, view.width, view.height, 0);
}

}  // namespace

Drawing make_drawing(const PictureOptions& options, Session& session) {
    const Profile profile = load_profile(options, session);
    SceneWithPasses loaded = load_scene_with_passes(options, session);
    const Renderer& renderer = renderer_named(options.renderer);
    const std::string warning = left_out(renderer, loaded.scene);
    if (!options.quiet && !warning.empty()) print_warning(warning);
    if (!options.quiet) print_warnings_of(loaded.scene, options.size, renderer.drawn_by);
    return {options, renderer, profile, std::move(loaded.scene), std::move(loaded.passes)};
}

multipass::PassList passes_of(const Drawing& drawing) {
    return pass_list(drawing.renderer, drawing.scene, options_of(drawing));
}

void draw(const Drawing& drawing, const scene::View& view, Machine& machine) {
    const auto draw_scene = [&](const scene::Scene& scene) {
        drawing.renderer.draw(machine, scene, view, options_of(drawing));
    };
    if (multipass::has_scene_maps(drawing.scene, options_of_maps(drawing)))
        draw_scene(with_maps(drawing, view, machine));
    else
        draw_scene(drawing.scene);
}

void draw_frame(const Drawing& drawing, const FrameFiles& files, const Session& session) {
    image::OutputSet output(session.inputs);
    for (const auto& folder : {files.components, files.planes}) {
        if (!folder.empty()) output.make_folder(folder);
    }
    const scene::View view =
        scene::make_view(drawing.scene, drawing.options.size.width, drawing.options.size.height);
    const auto machine = make_machine(drawing.options, drawing.profile, session);
    if (session.recorder) session.recorder->add_parameter_sets(parameter_sets(drawing));
    if (files.manifest.empty()) {
        draw(drawing, view, *machine);
    } else {
        inspect::DigestingMachine digesting(*machine);
        std::vector<CommandList> lists;
        inspect::Recorder recorder(digesting, lists);
        draw(drawing, view, recorder);
        const inspect::Recording recording = recording_of(drawing, std::move(lists));
        output.add(files.manifest).write_text(to_json(manifest_of(recording, machine->passes())));
    }
    if (!drawing.options.quiet)
        print_if_empty(drawing.scene, machine->planes().color, drawing.profile.color_bits);
    if (!files.counters.empty())
        output.add(files.counters)
            .write_text(inspect::totals_json(machine->passes()).dump(2) + "\n");
    const image::Picture picture = picture_of(drawing, machine->planes().color, files.tone);
    image::put_picture(output.add(files.picture), picture);
    if (!files.planes.empty()) put_planes(drawing, *machine, view, files, output);
    if (!files.components.empty()) put_components(drawing, *machine, view, files, output);
    for (const auto& folder : {files.components, files.planes})
        if (!folder.empty()) put_index(output, folder, session);
    output.commit();
}

std::map<std::string, std::string> parameter_sets(const Drawing& drawing) {
    std::map<std::string, std::string> sets;
    if (!drawing.renderer.passes) return sets;
    const multipass::PassModel model = multipass::make_pass_model(drawing.scene);
    for (const multipass::Step& step : multipass::schedule(passes_of(drawing), model))
        sets[multipass::name_of(step, model)] = multipass::to_string(step.pass.material);
    return sets;
}

}  // namespace gw::apps
