#include "apps/render/frame_files.h"

#include "apps/command/command_recorder.h"
#include "apps/command/folder_index.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "apps/recordings/recording_files.h"
#include "image/planes.h"
#include "image/write.h"
#include "inspect/manifest/json_of.h"
#include "inspect/manifest/manifest.h"
#include "inspect/replay/forwarding_machine.h"
#include "scene/draw/draw_commands.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <set>

namespace gw::apps {
namespace {

image::Picture picture_of(const Drawing& drawing, const std::vector<Rgba>& color,
                          const image::Tone& tone) {
    const Size size = drawing.request.size;
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

void put_components(const Drawing& drawing, Machine& machine, const scene::View& view,
                    const FrameFiles& files, image::OutputSet& output) {
    const std::string extension = files.picture.extension().string();
    std::set<std::string> taken{"sum"};
    const auto put = [&](const std::string& name, const std::vector<Rgba>& color) {
        image::put_picture(output.add(files.components / (name + extension)),
                           picture_of(drawing, color, files.tone));
    };
    const auto images = render::components(drawing, view, machine);
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

std::filesystem::path numbered(const std::filesystem::path& file, int number) {
    std::filesystem::path name = file.stem();
    name += fmt::format("_{:03}", number);
    name += file.extension();
    return file.parent_path() / name;
}

void draw_frame(const Drawing& drawing, const FrameFiles& files, const Session& session,
                bool quiet) {
    image::OutputSet output(session.inputs);
    for (const auto& folder : {files.components, files.planes}) {
        if (!folder.empty()) output.make_folder(folder);
    }
    const scene::View view = drawing.view();
    const auto machine = make_machine(drawing.request, drawing.profile, session);
    if (session.recorder) session.recorder->add_parameter_sets(render::parameter_sets(drawing));
    if (files.manifest.empty()) {
        render::draw(drawing, view, *machine);
    } else {
        inspect::DigestingMachine digesting(*machine);
        std::vector<CommandList> lists;
        inspect::Recorder recorder(digesting, lists);
        render::draw(drawing, view, recorder);
        const inspect::Recording recording = recording_of(drawing, std::move(lists));
        output.add(files.manifest).write_text(to_json(manifest_of(recording, machine->passes())));
    }
    if (!quiet) print_warnings({render::empty_warning(drawing, *machine)});
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

}  // namespace gw::apps
