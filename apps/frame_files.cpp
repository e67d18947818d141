#include "apps/frame_files.h"

#include "apps/digesting_machine.h"
#include "apps/manifest.h"
#include "image/planes.h"
#include "image/write.h"
#include "multipass/driver.h"
#include "scene/draw_commands.h"

#include <algorithm>
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

void put_components(const Drawing& drawing, Machine& machine, const scene::View& view,
                    const image::Picture& sum, const FrameFiles& files, image::OutputSet& output) {
    const std::string extension = files.picture.extension().string();
    std::set<std::string> taken{"sum"};
    const auto images =
        multipass::render_components(machine, drawing.scene, view, {.renderer = *drawing.renderer.passes});
    for (const multipass::ComponentImage& image : images) {
        image::put_picture(output.add(files.components / (file_name(image.name, taken) + extension)),
                           picture_of(drawing, image.color, files.tone));
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

void draw_frame(const Drawing& drawing, const FrameFiles& files) {
    image::OutputSet output;
    for (const auto& folder : {files.components, files.planes}) {
        if (!folder.empty()) output.make_folder(folder);
    }
    const scene::View view =
        scene::make_view(drawing.scene, drawing.options.size.width, drawing.options.size.height);
    const auto machine = make_machine(drawing.options, drawing.profile);
    if (files.manifest.empty()) {
        drawing.renderer.draw(*machine, drawing.scene, view);
    } else {
        DigestingMachine digesting(*machine);
        drawing.renderer.draw(digesting, drawing.scene, view);
        output.add(files.manifest).write_text(manifest(drawing, view, *machine));
    }
    const image::Picture picture = picture_of(drawing, machine->planes().color, files.tone);
    image::put_picture(output.add(files.picture), picture);
    if (!files.planes.empty()) put_planes(drawing, *machine, view, files, output);
    if (!files.components.empty()) put_components(drawing, *machine, view, picture, files, output);
    output.commit();
}

}  // namespace gw::apps
