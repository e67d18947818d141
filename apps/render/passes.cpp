// gw passes: a scene's parameter sets as the paper writes them, with the machine's counters.
#include "apps/command/command.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/picture/picture_options.h"
#include "gw/names.h"
#include "inspect/manifest/json_of.h"
#include "inspect/report/prices.h"
#include "inspect/text/plural.h"
#include "multipass/frame/driver.h"
#include "multipass/passes/pass_toml.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace gw::apps {
namespace {

enum class Form { Text, Json, Csv, Toml };

struct PassesOptions {
    PictureOptions picture;
    Form form = Form::Text;
    std::filesystem::path prices;  ///< empty: a VGX's
};

/// A pass that ran, and its parameter set; none for passes that the driver adds.
struct RunPass {
    PassReport report;
    std::string set;
    double seconds = 0;  ///< estimated
};

/// The list as the paper writes it, and the passes that ran.
struct Printout {
    multipass::PassList list;
    report::PriceList prices;
    std::vector<RunPass> runs;
    Counters sum;
    double seconds = 0;  ///< estimated
};

Printout run_passes(const PassesOptions& wanted, Session& session) {
    const PictureOptions& options = wanted.picture;
    auto prices = wanted.prices.empty() ? report::vgx_prices() : report::read_prices(wanted.prices);
    const Progress progress("drawing", options.quiet);
    const Drawing drawing = make_drawing(options, session);
    Printout printout{render::pass_list(drawing), std::move(prices), {}, {}};
    const auto sets = render::parameter_sets(drawing);
    const auto machine = make_machine(options, drawing.profile, session);
    render::draw(drawing, drawing.view(), *machine);
    for (const PassReport& report : machine->passes()) {
        const auto set = sets.find(report.name);
        const double seconds = estimated_seconds(report.counters, printout.prices);
        printout.runs.push_back({report, set == sets.end() ? "" : set->second, seconds});
        printout.sum += report.counters;
        printout.seconds += seconds;
    }
    return printout;
}

std::string text(const Printout& printout) {
    std::vector<std::string> header{"ran"};
    std::vector<CounterName> shown;
    for (const CounterName& counter : counter_names()) {
        if (printout.sum.*counter.count == 0) continue;
        shown.push_back(counter);
        header.push_back(counter.name);
    }
    header.push_back("estimated");
    std::vector<std::vector<std::string>> rows{header};
    const auto add_row = [&](const std::string& name, const Counters& counters, double seconds) {
        rows.push_back({name});
        for (const CounterName& counter : shown)
            rows.back().push_back(std::to_string(counters.*counter.count));
        rows.back().push_back(fmt::format("{:.4f} s", seconds));
    };
    for (const RunPass& run : printout.runs)
        add_row(run.report.name, run.report.counters, run.seconds);
    add_row(inspect::plural(printout.runs.size(), "pass", "passes"), printout.sum,
            printout.seconds);
    return multipass::print_passes(printout.list) + "\n" + table(rows) +
           fmt::format("\nestimated: time by a price list, of {}\n", printout.prices.machine);
}

std::string json(const Printout& printout) {
    auto list = nlohmann::ordered_json::array(), runs = list;
    for (const multipass::Pass& pass : printout.list) list.push_back(multipass::to_string(pass));
    for (const auto& [report, set, seconds] : printout.runs) {
        runs.push_back({{"name", report.name},
                        {"set", set},
                        {"counters", inspect::json_of(report.counters)},
                        {"estimated_seconds", seconds}});
    }
    return nlohmann::ordered_json{{"list", list},
                                  {"passes", runs},
                                  {"sum", inspect::json_of(printout.sum)},
                                  {"estimated_seconds", printout.seconds},
                                  {"estimated_machine", printout.prices.machine}}
               .dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) +
           "\n";
}

// A name with any characters as one field.
std::string csv_field(const std::string& text) {
    std::string field = "\"";
    for (char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + "\"";
}

std::string csv(const Printout& printout) {
    std::string out = "name,set";
    for (const auto& [name, count] : counter_names()) out += std::string(",") + name;
    out += ",estimated_seconds\n";
    for (const auto& [report, set, seconds] : printout.runs) {
        out += csv_field(report.name) + "," + csv_field(set);
        for (const auto& [name, count] : counter_names())
            out += fmt::format(",{}", report.counters.*count);
        out += fmt::format(",{}\n", seconds);
    }
    return out;
}

int print_passes(const PassesOptions& options, Session& session) {
    if (!render::renderer_named(options.picture.renderer).pass_owner) {
        throw UsageError("renderer " + options.picture.renderer +
                         " has no passes; expected hardware or multipass");
    }
    if (options.form == Form::Toml) {
        print(multipass::to_toml(render::pass_list(make_drawing(options.picture, session))));
        return Done;
    }
    const Printout printout = run_passes(options, session);
    print(options.form == Form::Json  ? json(printout)
          : options.form == Form::Csv ? csv(printout)
                                      : text(printout));
    return Done;
}

}  // namespace

Command add_passes(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("passes", "The parameter sets that make a picture, with counters");
    const auto options = std::make_shared<PassesOptions>();
    add_picture_options(*command, options->picture);
    const auto add_form = [&](const char* name, Form form, const char* help) {
        return command->add_flag_callback(
            name, [options, form] { options->form = form; }, help);
    };
    CLI::Option* json_flag = add_form("--json", Form::Json, "As JSON");
    CLI::Option* csv_flag =
        add_form("--csv", Form::Csv, "As comma-separated values")->excludes(json_flag);
    add_form("--toml", Form::Toml, "The list alone, as a scene file holds it; nothing is drawn")
        ->excludes(json_flag)
        ->excludes(csv_flag);
    command
        ->add_option("--prices", options->prices,
                     "Another price list for the estimated time (default: a VGX's)")
        ->type_name("FILE.toml");
    command->footer("Example:\n  build/release/bin/gw passes scenes/rings.toml");
    return {command, [options](Session& session) { return print_passes(*options, session); }};
}

}  // namespace gw::apps
