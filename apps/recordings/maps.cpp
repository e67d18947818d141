// gw maps: shows the fate of the fragments at every pixel of a recording, as pictures.
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "image/plane_pictures.h"
#include "image/write.h"
#include "inspect/replay/pixel_history.h"
#include "inspect/replay/player.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace gw::apps {
namespace {

struct MapsOptions {
    RecordingChoice recording;
    std::filesystem::path folder;
    std::string pass;  ///< its name or number; empty: all
    std::uint32_t surface = 0;
    bool quiet = false;
};

/// The number of the first pass of this name; else the word is the number.
std::optional<std::size_t> pass_named(const inspect::Recording& recording,
                                      const std::string& word) {
    if (word.empty()) return {};
    const auto passes = inspect::pass_ranges(recording);
    const auto found =
        std::find_if(passes.begin(), passes.end(), [&](const auto& p) { return p.name == word; });
    if (found != passes.end()) return std::size_t(found - passes.begin());
    if (word.find_first_not_of("0123456789") == word.npos && word.size() < 8 &&
        std::stoul(word) < passes.size())
        return std::stoul(word);
    throw Error(fmt::format("--pass '{}': expected the name of a pass or its number, 0..{}", word,
                            passes.size() - 1));
}

/// The largest count red, over green to blue for the smallest; zero black.
image::Picture count_colors(std::vector<std::uint32_t> counts, int width, int height) {
    for (std::uint32_t& count : counts) count = ~count;
    return image::depth_colors(counts, width, height, 32);
}

/// White: all fragments were written. Red, green, blue: the alpha, stencil or depth test killed
/// most; of equal counts the earlier test. Black: no fragment.
image::Picture why_killed(const inspect::FragmentMaps& maps, int width, int height) {
    constexpr std::uint8_t white = 7;
    std::vector<std::uint8_t> codes(maps.made.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const std::array counts{maps.alpha_killed[i], maps.stencil_killed[i], maps.depth_killed[i]};
        const auto most = std::max_element(counts.begin(), counts.end());
        if (maps.made[i] == 0) continue;
        codes[i] = *most == 0 ? white : static_cast<std::uint8_t>(most - counts.begin() + 1);
    }
    return image::stencil_colors(codes, width, height);
}

void put_maps(const Surface& size, const inspect::FragmentMaps& maps,
              const std::filesystem::path& folder, const Session& session) {
    const int w = size.width, h = size.height;
    image::OutputSet output(session.inputs);
    output.make_folder(folder);
    image::put_picture(output.add(folder / "depth_complexity.png"), count_colors(maps.made, w, h));
    image::put_picture(output.add(folder / "overdraw.png"), count_colors(maps.written, w, h));
    image::put_picture(output.add(folder / "why_killed.png"), why_killed(maps, w, h));
    std::vector<std::uint32_t> values;
    for (std::size_t i = 0; i < maps.made.size(); ++i)
        values.insert(values.end(), {maps.made[i], maps.written[i], maps.alpha_killed[i],
                                     maps.stencil_killed[i], maps.depth_killed[i]});
    image::put_values(output.add(folder / "fragments.exr"),
                      {w,
                       h,
                       {"made", "written", "alpha_killed", "stencil_killed", "depth_killed"},
                       std::move(values)});
    put_index(output, folder, session);
    output.commit();
}

int make_maps(const MapsOptions& options, Session& session) {
    Progress progress("reading", options.quiet);
    const inspect::Recording recording = load_recording(options.recording, session);
    const auto pass = pass_named(recording, options.pass);
    const Surface size = chosen_surface(recording, options.recording, options.surface);
    progress.at("replaying on the reference machine");
    put_maps(size, inspect::fragment_maps(recording, pass, options.surface), options.folder,
             session);
    return Done;
}

}  // namespace

Command add_maps(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "maps", "Overdraw, depth complexity and why fragments died, as pictures");
    const auto options = std::make_shared<MapsOptions>();
    add_recording_options(*command, options->recording);
    add_surface_option(*command, options->surface);
    command
        ->add_option(
            "-o,--output", options->folder,
            "overdraw.png, depth_complexity.png, why_killed.png, and all counts in fragments.exr")
        ->required()
        ->type_name("DIR");
    command->add_option("--pass", options->pass, "One pass, by its name or number (default: all)")
        ->type_name("NAME|N");
    command->add_flag("--quiet", options->quiet, "No progress");
    command->footer(
        "Example:\n  build/release/bin/gw record scenes/rings.toml -o rings.gwt --size 320x240 && "
        "build/release/bin/gw maps rings.gwt -o rings_maps");
    return {command, [options](Session& session) { return make_maps(*options, session); }};
}

}  // namespace gw::apps
