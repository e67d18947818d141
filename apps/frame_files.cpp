#include "apps/frame_files.h"

#include "apps/counters_table.h"
#include "apps/digesting_machine.h"
#include "apps/manifest.h"
#include "image/planes.h"
#include "image/write.h"
#include "multipass/driver.h"
#include "scene/draw_commands.h"

#include <cctype>
#include <set>

namespace gw::apps {

namespace {

image::Picture picture_of(const Drawing& drawing, const std::vector<Rgba>& color, const image::Tone& tone) {
    const Size size = drawing.options.size;
    return image::toned(image::picture_of(color, size.width, size.height, drawing.profile.color_bits), tone);
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

// The component's passes as the picture's, on black where the background is a component of its own.
std::vector<Rgba> component(const Drawing& drawing, const multipass::ComponentList& list,
                            const scene::View& view, Machine& machine) {
    scene::Scene scene = drawing.scene;
    if (!list.background) scene.background = vec3(0);
    DrawOptions options = draw_options(drawing.options);
    options.passes.passes = list.passes;
    options.rays.background = drawing.scene.background;
    drawing.renderer.draw(machine, scene, view, options);
    return machine.planes().color;
}

void put_components(const Drawing& drawing, Machine& machine, const scene::View& view,
                    const image::Picture& sum, const FrameFiles& files, image::OutputSet& output) {
    const std::string extension = files.picture.extension().string();
    std::set<std::string> taken{"sum"};
    const multipass::PassList passes =
        pass_list(drawing.renderer, drawing.scene, draw_options(drawing.options));
    for (const multipass::ComponentList& list : multipass::component_lists(drawing.scene, passes)) {
        image::put_picture(output.add(files.components / (file_name(list.name, taken) + extension)),
                           picture_of(drawing, component(drawing, list, view, machine), files.tone));
    }
    image::put_picture(output.add(files.components / ("sum" + extension)), sum);
}

void put_planes(const Drawing& drawing, Machine& machine, const scene::View& view, const FrameFiles& files,
                image::OutputSet& output) {
    image::put_planes(output, files.planes, machine.planes(), drawing.profile);
    machine.execute(scene::id_pass(drawing.scene, view));
    std::vector<std::uint32_t> ids;
    for (const Rgba& color : machine.planes().color) ids.push_back(scene::id_of(color));
    image::put_ids(output, files.planes, ids, view.width, view.height, 0);
}

}  // namespace

void draw(const Drawing& drawing, const scene::View& view, Machine& machine) {
    drawing.renderer.draw(machine, drawing.scene, view, draw_options(drawing.options));
}

void draw_frame(const Drawing& drawing, const FrameFiles& files) {
    image::OutputSet output;
    for (const auto& folder : {files.components, files.planes}) {
        if (!folder.empty()) output.make_folder(folder);
    }
    const scene::View view =
        scene::make_view(drawing.scene, drawing.options.size.width, drawing.options.size.height);
    const auto machine = make_machine(drawing.options, drawing.profile);
    if (files.manifest.empty()) {
        draw(drawing, view, *machine);
    } else {
        DigestingMachine digesting(*machine);
        draw(drawing, view, digesting);
        output.add(files.manifest).write_text(manifest(drawing, view, *machine));
    }
    if (!files.counters.empty())
        output.add(files.counters).write_text(totals_json(machine->passes()).dump(2) + "\n");
    const image::Picture picture = picture_of(drawing, machine->planes().color, files.tone);
    image::put_picture(output.add(files.picture), picture);
    if (!files.planes.empty()) put_planes(drawing, *machine, view, files, output);
    if (!files.components.empty()) put_components(drawing, *machine, view, picture, files, output);
    output.commit();
}

}  // namespace gw::apps
