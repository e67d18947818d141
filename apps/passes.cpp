// gw passes: the parameter sets of a scene as the paper writes them, with what the machine counted.
#include "apps/command.h"
#include "apps/counters_table.h"
#include "apps/frame_files.h"
#include "apps/progress.h"
#include "apps/terminal.h"
#include "multipass/schedule.h"

#include <fmt/format.h>

#include <map>

namespace gw::apps {

namespace {

enum class Form { Text, Json, Csv };

struct PassesOptions {
    PictureOptions picture;
    Form form = Form::Text;
};

/// A pass that ran, and its parameter set; none for passes that the driver adds.
struct RunPass {
    PassReport report;
    std::string set;
};

std::map<std::string, std::string> sets_by_name(const scene::Scene& scene, multipass::Renderer renderer) {
    const multipass::Model model = multipass::make_model(scene);
    std::map<std::string, std::string> sets;
    for (const multipass::Step& step : multipass::schedule(multipass::passes_for(scene, renderer), model)) {
        sets[multipass::name_of(step, model)] = multipass::to_string(step.pass.material);
    }
    return sets;
}

std::vector<RunPass> run_passes(const PictureOptions& options) {
    const Progress progress("drawing", options.quiet);
    const Drawing drawing{options, renderer_named(options.renderer), load_profile(options),
                          load_scene(options)};
    const auto sets = sets_by_name(drawing.scene, *drawing.renderer.passes);
    const auto machine = make_machine(options, drawing.profile);
    draw(drawing, scene::make_view(drawing.scene, options.size.width, options.size.height), *machine);
    std::vector<RunPass> passes;
    for (const PassReport& report : machine->passes()) {
        const auto set = sets.find(report.name);
        passes.push_back({report, set == sets.end() ? "" : set->second});
    }
    return passes;
}

Counters sum_of(const std::vector<RunPass>& passes) {
    Counters sum;
    for (const RunPass& pass : passes) sum += pass.report.counters;
    return sum;
}

std::string text(const std::vector<RunPass>& passes) {
    std::string out;
    for (const auto& [report, set] : passes) {
        out += fmt::format("{:<20}{}\n    {}\n", report.name, set, text_of(report.counters));
    }
    return out + fmt::format("{} passes\n    {}\n", passes.size(), text_of(sum_of(passes)));
}

std::string json(const std::vector<RunPass>& passes) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& [report, set] : passes) {
        list.push_back({{"name", report.name}, {"set", set}, {"counters", json_of(report.counters)}});
    }
    return nlohmann::ordered_json{{"passes", list}, {"sum", json_of(sum_of(passes))}}.dump(2) + "\n";
}

// Names may hold anything but are one field.
std::string quoted(const std::string& text) {
    std::string field = "\"";
    for (char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + "\"";
}

std::string csv(const std::vector<RunPass>& passes) {
    std::string out = "name,set";
    for (const auto& [name, count] : counter_names()) out += std::string(",") + name;
    out += "\n";
    for (const auto& [report, set] : passes) {
        out += quoted(report.name) + "," + quoted(set);
        for (const auto& [name, count] : counter_names()) out += fmt::format(",{}", report.counters.*count);
        out += "\n";
    }
    return out;
}

int print_passes(const PassesOptions& options) {
    if (!renderer_named(options.picture.renderer).passes) {
        throw UsageError("renderer " + options.picture.renderer +
                         " has no passes; expected hardware or multipass");
    }
    const std::vector<RunPass> passes = run_passes(options.picture);
    print(options.form == Form::Json ? json(passes) : options.form == Form::Csv ? csv(passes) : text(passes));
    return done;
}

}  // namespace

Command add_passes(CLI::App& app) {
    CLI::App* command = app.add_subcommand("passes", "The parameter sets that make a picture, with counters");
    const auto options = std::make_shared<PassesOptions>();
    add_picture_options(*command, options->picture);
    CLI::Option* json_flag = command->add_flag_callback(
        "--json", [options] { options->form = Form::Json; }, "As JSON");
    command
        ->add_flag_callback(
            "--csv", [options] { options->form = Form::Csv; }, "As comma-separated values")
        ->excludes(json_flag);
    command->footer("Example:\n  build/release/bin/gw passes scenes/rings.toml");
    return {command, [options] { return print_passes(*options); }};
}

}  // namespace gw::apps
