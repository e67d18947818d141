#include "apps/recording_files.h"

#include "apps/parameter_sets.h"
#include "apps/versions.h"
#include "gw/error.h"
#include "hiddensurface/algorithm.h"
#include "inspect/read_bytes.h"
#include "inspect/recorder.h"

namespace gw::apps {

namespace {

CommandList hidden_surface_list(const Drawing& drawing, const scene::View& view, const std::string& name) {
    hiddensurface::StepLog none;
    const hiddensurface::Input input = hiddensurface::make_input(drawing.scene, view, drawing.profile);
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

inspect::Recording record(const Drawing& drawing, const std::string& algorithm) {
    const Size size = drawing.options.size;
    const scene::View view = scene::make_view(drawing.scene, size.width, size.height);
    if (!algorithm.empty()) {
        inspect::Recording recording = recording_of(drawing, {hidden_surface_list(drawing, view, algorithm)});
        recording.renderer = algorithm;
        recording.sets.clear();
        return recording;
    }
    const auto machine = make_machine(drawing.options, drawing.profile);
    inspect::Recorder recorder(*machine);
    draw(drawing, view, recorder);
    return recording_of(drawing, recorder.lists());
}

inspect::Recording load_recording(const std::filesystem::path& file) {
    const std::vector<std::uint8_t> bytes = inspect::read_bytes(file);
    try {
        return inspect::decode(bytes);
    } catch (const Error& error) {
        throw Error(file.string(), 0, error.what());
    }
}

ManifestFile load_manifest(const std::filesystem::path& file) {
    namespace fs = std::filesystem;
    const std::vector<std::uint8_t> bytes = inspect::read_bytes(file);
    ManifestFile result;
    try {
        result.manifest =
            inspect::manifest_from_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const Error& error) {
        throw Error(file.string(), 0, error.what());
    }
    const std::string& name = result.manifest.values;
    if (name != fs::path(name).filename())
        throw Error(file.string(), 0, "'values' is no name of a file beside it");
    if (!name.empty() && fs::exists(file.parent_path() / name))
        result.values = inspect::read_bytes(file.parent_path() / name);
    return result;
}

void put_manifest(image::OutputSet& output, const std::filesystem::path& file,
                  const inspect::Recording& recording, const inspect::MachineMaker& make, bool with_values) {
    inspect::ValuesWriter values(recording.width, recording.height);
    inspect::Manifest manifest = replayed_manifest(recording, make, with_values ? &values : nullptr);
    if (with_values) {
        const auto values_file = std::filesystem::path(file).replace_extension(".values");
        manifest.values = values_file.filename().string();
        output.add(values_file).write(values.finish());
    }
    output.add(file).write_text(to_json(manifest));
}

}  // namespace gw::apps
