#include "apps/recordings/recording_files.h"

#include "apps/command/command.h"
#include "apps/command/terminal.h"
#include "gw/error.h"
#include "hiddensurface/interface/algorithm.h"
#include "inspect/replay/forwarding_machine.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/report/report.h"
#include "scene/draw/draw_commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>

namespace gw::apps {
namespace {

/// "row 5: polygons 3, 1"; the row is counted from the top.
std::string name_of(const WriteSpans& drawn, int height) {
    std::vector<std::uint32_t> ids;  // each once, in the order drawn
    for (const Rgba& color : drawn.colors)
        if (std::ranges::find(ids, scene::id_of(color)) == ids.end())
            ids.push_back(scene::id_of(color));
    const int y = drawn.spans[0].y;
    const bool is_row =
        std::ranges::all_of(drawn.spans, [y](const Span& span) { return span.y == y; });
    return fmt::format("{}{} {}", is_row ? fmt::format("row {}: ", height - 1 - y) : "",
                       ids.size() == 1 ? "polygon" : "polygons", fmt::join(ids, ", "));
}

/// A pass for each thing drawn, so that a report steps through the drawing. A list of more than a
/// report shows stays one pass.
CommandList in_passes(CommandList list, int height) {
    const auto is_drawn = [](const gw::Command& c) {
        return std::holds_alternative<WriteSpans>(c);
    };
    if (std::ranges::count_if(list.commands, is_drawn) >= std::ptrdiff_t(report::most_passes))
        return list;
    CommandList passes;
    for (gw::Command& command : list.commands) {
        if (const auto* drawn = std::get_if<WriteSpans>(&command))
            passes.add(BeginPass{.name = name_of(*drawn, height)});
        passes.commands.push_back(std::move(command));
    }
    return passes;
}

CommandList hidden_surface_list(const Drawing& drawing, const scene::View& view,
                                const std::string& name) {
    hiddensurface::StepLog none;
    const hiddensurface::Input input =
        hiddensurface::make_input(drawing.scene, view, drawing.profile);
    return in_passes(hiddensurface::algorithm_named(name).run(input, none).list, view.height);
}

/// What a recording says of its drawing.
inspect::Recording heading_of(const Drawing& drawing, const std::string& algorithm) {
    inspect::Recording recording = recording_of(drawing, {});
    if (algorithm.empty()) return recording;
    recording.renderer = algorithm;
    recording.sets.clear();
    return recording;
}

}  // namespace

bool writes_identifiers(const inspect::Recording& recording) {
    const auto names = hiddensurface::algorithm_names();
    return std::ranges::find(names, recording.renderer) != names.end();
}

inspect::Recording recording_of(const Drawing& drawing, std::vector<CommandList> lists) {
    inspect::Recording recording;
    recording.producer = "gw " + version();
    recording.scene = drawing.request.scene.string();
    recording.renderer = drawing.request.renderer;
    recording.profile = drawing.profile;
    recording.width = drawing.request.size.width;
    recording.height = drawing.request.size.height;
    for (const auto& [pass, set] : render::parameter_sets(drawing))
        recording.sets.push_back({pass, set});
    recording.lists = std::move(lists);
    return recording;
}

inspect::Recording record(const Drawing& drawing, const Session& session,
                          const std::string& algorithm) {
    inspect::Recording recording = heading_of(drawing, algorithm);
    const scene::View view = drawing.view();
    if (!algorithm.empty()) {
        recording.lists = {hidden_surface_list(drawing, view, algorithm)};
        return recording;
    }
    const auto machine = make_machine(drawing.request, drawing.profile, session);
    inspect::Recorder recorder(*machine, recording.lists);
    render::draw(drawing, view, recorder);
    return recording;
}

void record_stream(const Drawing& drawing, const Session& session, const std::string& algorithm,
                   std::ostream& out) {
    const std::string window = "picture";
    const Size size = drawing.request.size;
    const scene::View view = drawing.view();
    inspect::StreamWriter writer(out, heading_of(drawing, algorithm));
    writer.open(window, size.width, size.height);
    if (!algorithm.empty()) {
        writer.add(window, hidden_surface_list(drawing, view, algorithm));
    } else {
        const auto machine = make_machine(drawing.request, drawing.profile, session);
        inspect::StreamRecorder recorder(*machine, writer, window);
        render::draw(drawing, view, recorder);
    }
    writer.finish();
}

void add_window_option(CLI::App& command, std::string& window) {
    command
        .add_option("--window", window, "Of a recording with several: its name or number from 0")
        ->type_name("NAME|N");
}

void add_recording_options(CLI::App& command, RecordingChoice& choice) {
    command.add_option("RECORDING", choice.file, "A recording by gw record")
        ->required()
        ->type_name("FILE.gwt");
    add_window_option(command, choice.window);
}

namespace {

inspect::Stream read_stream(const RecordingChoice& choice, Session& session) {
    session.inputs.add(choice.file);
    inspect::Stream stream = inspect::read_recordings(choice.file);
    if (!stream.cut.empty()) print_warning(choice.file.string() + ": " + stream.cut);
    return stream;
}

inspect::Recording chosen(inspect::Stream stream, const RecordingChoice& choice) {
    try {
        return inspect::choose_window(std::move(stream), choice.window);
    } catch (const Error& error) {
        throw Error(choice.file.string(), 0, error.what());
    }
}

}  // namespace

void add_surface_option(CLI::App& command, std::uint32_t& number) {
    command
        .add_option_function<std::string>(
            "--surface",
            [&number](const std::string& word) {
                number = std::uint32_t(whole_number_from("--surface", word, 0, int(max_surfaces)));
            },
            "Of a recording that draws to surfaces: the pixels of this one (default 0: the window)")
        ->type_name("N");
}

Surface chosen_surface(const inspect::Recording& recording, const RecordingChoice& choice,
                       std::uint32_t number) {
    const auto surfaces = inspect::surfaces_of(recording);
    std::string all;
    for (const auto& [other, size] : surfaces)
        all += fmt::format("{}{} ({}x{})", all.empty() ? "" : ", ", other, size.width, size.height);
    if (!surfaces.contains(number))
        throw Error(fmt::format("--surface {}: {} has no such surface; expected one of {}", number,
                                choice.file.string(), all));
    if (number == 0 && surfaces.size() > 1)
        print_warning(
            fmt::format("{}: it draws to surfaces beside the window, whose pixels are "
                        "left out; --surface N shows one of {}",
                        choice.file.string(), all));
    return surfaces.at(number);
}

inspect::Recording load_recording(const RecordingChoice& choice, Session& session) {
    return chosen(read_stream(choice, session), choice);
}

inspect::Stream load_windows(const RecordingChoice& choice, Session& session) {
    inspect::Stream stream = read_stream(choice, session);
    if (choice.window.empty()) return stream;
    inspect::Stream one;
    one.windows.push_back({choice.window, chosen(std::move(stream), choice)});
    return one;
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
