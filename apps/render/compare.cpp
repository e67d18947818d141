// gw compare: the differences between item buffer and ordinary ray tracing, and their reasons. [K4,
// K4f]
#include "apps/command/command.h"
#include "apps/command/folder_index.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "image/output/output_set.h"
#include "image/write.h"
#include "inspect/text/plural.h"
#include "itembuffer/differences.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

namespace gw::apps {
namespace {

using itembuffer::Reason;

struct CompareOptions {
    PictureOptions picture;
    std::filesystem::path folder;
};

/// Black, red, yellow, grey, blue, green.
Rgba color_of(Reason reason) {
    switch (reason) {
        case Reason::Same: return {0, 0, 0, 255};
        case Reason::Polygon: return {230, 40, 40, 255};
        case Reason::Shadow: return {240, 220, 50, 255};
        case Reason::Rounding: return {80, 80, 80, 255};
        case Reason::Fog: return {60, 110, 240, 255};
        case Reason::Lighting: return {60, 190, 80, 255};
    }
    return {};
}
std::string_view color_name(Reason reason) {
    switch (reason) {
        case Reason::Same: return "black";
        case Reason::Polygon: return "red";
        case Reason::Shadow: return "yellow";
        case Reason::Rounding: return "grey";
        case Reason::Fog: return "blue";
        case Reason::Lighting: return "green";
    }
    return "";
}

std::string counts_table(const itembuffer::Differences& d) {
    std::vector<std::vector<std::string>> rows{
        {"why", "pixels", "share", "mean", "largest", "reasons.png"}};
    for (const Reason reason : itembuffer::reasons) {
        const itembuffer::ReasonCount c = itembuffer::count_of(d, reason);
        rows.push_back({std::string(name_of(reason)), std::to_string(c.pixels),
                        fmt::format("{:.2f} %", 100 * double(c.pixels) / double(d.reason.size())),
                        fmt::format("{:.2f}", c.mean), std::to_string(c.largest),
                        std::string(color_name(reason))});
    }
    return table(rows) +
           fmt::format(
               "\nmean and largest in units of the frame buffer; colours are added by {}\n"
               "away from edges {} pixels, of them another polygon: {}\n",
               inspect::plural(std::uint64_t(d.passes), "pass", "passes"), d.away_from_edges,
               d.another_polygon_there);
}

std::string counts_csv(const itembuffer::Differences& d) {
    std::string text = "why,pixels,mean_units,largest_units\n";
    for (const Reason reason : itembuffer::reasons) {
        const itembuffer::ReasonCount c = itembuffer::count_of(d, reason);
        text += fmt::format("{},{},{:.4f},{}\n", name_of(reason), c.pixels, c.mean, c.largest);
    }
    return text;
}

int compare(const CompareOptions& options, Session& session) {
    const Progress progress("drawing both ways", options.picture.quiet);
    const Profile profile = load_profile(options.picture, session);
    const scene::Scene scene =
        load_scene(options.picture, session,
                   {scene::DrawnBy::Depth, {"motion", "aperture", "soft lights", "glare"}});
    const Size size = options.picture.size;
    image::OutputSet output(session.inputs);
    output.make_folder(options.folder);
    const auto machine = make_machine(options.picture, profile, session);
    const itembuffer::Differences d =
        differences(*machine, scene, scene::make_view(scene, size.width, size.height),
                    render::ray_options(options.picture));
    const auto put = [&](const char* name, const std::vector<Rgba>& color, int bits) {
        image::put_picture(output.add(options.folder / name),
                           image::picture_of(color, size.width, size.height, bits));
    };
    std::vector<Rgba> why, sixteen_times;
    const int most = (1 << profile.color_bits) - 1;
    for (std::size_t i = 0; i < d.reason.size(); ++i) {
        why.push_back(color_of(d.reason[i]));
        const auto v = static_cast<std::uint16_t>(std::min(16 * d.units[i], most));
        sixteen_times.push_back({v, v, v, static_cast<std::uint16_t>(most)});
    }
    put("item_buffer.png", d.by_passes, profile.color_bits);
    put("ray_tracing.png", d.by_rays, profile.color_bits);
    put("difference.png", sixteen_times, profile.color_bits);
    put("reasons.png", why, 8);
    output.add(options.folder / "differences.csv").write_text(counts_csv(d));
    put_index(output, options.folder, session);
    output.commit();
    print(counts_table(d));
    return Done;
}

}  // namespace

Command add_compare(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "compare", "The differences of item buffer and ordinary ray tracing, and their reasons");
    const auto options = std::make_shared<CompareOptions>();
    add_picture_options(*command, options->picture);
    for (const char* unused :
         {"--renderer", "--samples", "--averaging", "--translucency", "--reflections"})
        command->remove_option(command->get_option(unused));
    command
        ->add_option("-o,--output", options->folder,
                     "Folder of both pictures, sixteen times their difference, its reasons, "
                     "the table as CSV")
        ->required()
        ->type_name("DIR");
    command->footer("Example:\n  build/release/bin/gw compare scenes/fig9.toml -o differences");
    return {command, [options](Session& session) { return compare(*options, session); }};
}

}  // namespace gw::apps
