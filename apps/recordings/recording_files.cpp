#include "apps/recordings/recording_files.h"

#include "apps/command/command.h"
#include "apps/render/frame_files.h"
#include "gw/error.h"
#include "hiddensurface/run/algorithm.h"
#include "inspect/recording/read_bytes.h"
#include "inspect/replay/forwarding_machine.h"

namespace gw::apps {
namespace {

CommandList hidden_surface_list(const Drawing& drawing, const scene::View& view,
                                const std::string& name) {
    hiddensurface::StepLog none;
    const hiddensurface::Input input =
        hiddensurface::make_input(drawing.scene, view, drawing.profile);
    return hiddensurface::algorithm_named(name).run(input, none).list;
}

}  // namespace

inspect::Recording recording_of(const Drawing& drawing, std::vector<CommandList> lists) {
    inspect::Recording recording;
    recording.producer = "gw " + version();
    recording.scene = drawing.options.scene.string();
    recording.renderer = drawing.renderer.name;
    recording.profile = drawing.profile;
    recording.width = drawing.options.size.width;
    recording.height = drawing.options.size.height;
    for (const auto& [pass, set] : parameter_sets(drawing)) recording.sets.push_back({pass, set});
    recording.lists = std::move(lists);
    return recording;
}

inspect::Recording record(const Drawing& drawing, const Session& session,
                          const std::string& algorithm) {
    const Size size = drawing.options.size;
    const scene::View view = scene::make_view(drawing.scene, size.width, size.height);
    if (!algorithm.empty()) {
        inspect::Recording recording =
            recording_of(drawing, {hidden_surface_list(drawing, view, algorithm)});
        recording.renderer = algorithm;
        recording.sets.clear();
        return recording;
    }
    const auto machine = make_machine(drawing.options, drawing.profile, session);
    std::vector<CommandList> lists;
    inspect::Recorder recorder(*machine, lists);
    draw(drawing, view, recorder);
    return recording_of(drawing, std::move(lists));
}

inspect::Recording load_recording(const std::filesystem::path& file, Session& session) {
    session.inputs.add(file);
    const std::vector<std::uint8_t> bytes = inspect::read_recording_bytes(file);
    try {
        return inspect::decode(bytes);
    } catch (const Error& error) {
        throw Error(file.string(), 0, error.what());
    }
}

void put_manifest(image::OutputSet& output, const std::filesystem::path& file,
                  const inspect::Recording& recording, const inspect::MachineMaker& make,
                  bool with_values) {
    // A device or a pipe has no folder for values beside it.
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
        with_values = false;
    const auto written = replayed_manifest_file(recording, make, file, with_values);
    if (with_values) output.add(inspect::values_file(file)).write(written.values);
    output.add(file).write_text(to_json(written.manifest));
}

}  // namespace gw::apps
