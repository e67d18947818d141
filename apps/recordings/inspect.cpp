// gw inspect: shows a recording as a page with passes, planes, counters, time and pixel histories.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "image/output/output_folder.h"
#include "inspect/report/report.h"
#include "inspect/text/plural.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace gw::apps {
namespace {

struct InspectOptions {
    RecordingChoice recording;
    std::filesystem::path folder, prices;
    std::vector<std::string> words;  ///< the options of add_choices, as given
    report::ReportOptions report;
    bool quiet = false;
};

report::PassSpan span_from(const std::string& option, const std::string& word) {
    const auto [first, last] = range_from(option, word, 0, 99'999'999);
    return {std::size_t(first), std::size_t(last)};
}

void add_choices(CLI::App& command, InspectOptions& options) {
    const auto add = [&](const char* name, const char* type, const char* help, auto take) {
        command
            .add_option_function<std::string>(
                name,
                [name, take, &options](const std::string& word) {
                    take(options.report, name, word);
                    options.words.insert(options.words.end(), {name, word});
                },
                help)
            ->type_name(type);
    };
    add("--passes", "A-B", "Only these passes, numbered from 0 (default: all, at most 1000)",
        [](auto& report, auto name, auto& word) { report.passes = span_from(name, word); });
    add("--history", "A-B|none",
        "Pixel histories of these passes (default: "
        "the first ones, up to 3 million fragments)",
        [](auto& report, auto name, auto& word) {
            if (word == "none")
                report.with_history = false;
            else
                report.history = span_from(name, word);
        });
    add("--limit", "MB", "The largest report in megabytes, 1..100000 (default 500)",
        [](auto& report, auto name, auto& word) {
            report.most_bytes =
                1'000'000 * std::uint64_t(whole_number_from(name, word, 1, 100'000));
        });
    add("--lang", "NAME", "The page's first language; the page can switch it",
        [](auto& report, auto name, auto& word) {
            report.language = one_of(name, word, {"en", "ja"}) == "ja" ? report::Language::Japanese
                                                                       : report::Language::English;
        });
}

void add_options(CLI::App& command, InspectOptions& options) {
    add_recording_options(command, options.recording);
    command
        .add_option("-o,--output", options.folder,
                    "The folder of the report: open its index.html. Replaces an earlier report")
        ->required()
        ->type_name("DIR");
    add_choices(command, options);
    command
        .add_option("--prices", options.prices,
                    "Another price list for the estimated time (default: a VGX's)")
        ->type_name("FILE.toml");
    command.add_flag("--quiet", options.quiet, "No progress");
}

/// Throws UsageError for options that no recording could satisfy.
void check(const report::ReportOptions& options) {
    const auto &passes = options.passes, &history = options.history;
    if (passes && passes->last - passes->first >= report::most_passes)
        throw UsageError(fmt::format("--passes {}-{}: too many for one page; expected at most {}",
                                     passes->first, passes->last, report::most_passes));
    if (passes && history && (history->first < passes->first || history->last > passes->last))
        throw UsageError(fmt::format("--history {}-{}: expected passes of --passes {}-{}",
                                     history->first, history->last, passes->first, passes->last));
}

/// Replaces the temporary folder in the message by the final one.
[[noreturn]] void rethrow_with_final_names(const Error& error, const InspectOptions& options,
                                           const std::filesystem::path& temporary) {
    std::string text = error.what();
    const std::string hidden = escape_controls(temporary.string());
    if (const auto at = text.find(hidden); at != text.npos)
        text.replace(at, hidden.size(), options.folder.string());
    throw Error(text);
}

void print_summary(const InspectOptions& options, const report::ReportSummary& summary) {
    const char* opened = summary.page ? "index.html" : "data.js";
    std::string text = escape_controls((options.folder / opened).string()) + "\n";
    text +=
        fmt::format("{} of {}, {:.1f} MB", summary.passes,
                    inspect::plural(std::uint64_t(summary.passes_of_recording), "pass", "passes"),
                    double(summary.bytes) / 1e6);
    if (summary.history)
        text += fmt::format(", pixel histories of passes {}-{}", summary.history->first,
                            summary.history->last);
    else
        text += ", no pixel histories";
    print(text + "\n");
}

int inspect_recording(InspectOptions& options, Session& session) {
    check(options.report);
    image::OutputFolder folder(options.folder, report::report_files());
    options.report.prices =
        options.prices.empty() ? report::vgx_prices() : report::read_prices(options.prices);
    Progress progress("reading", options.quiet);
    const inspect::Recording recording = load_recording(options.recording, session);
    options.report.file = options.recording.file.string();
    options.report.identifiers = writes_identifiers(recording);
    std::vector<std::string> words{"inspect", options.recording.file.string(), "-o",
                                   options.folder.string()};
    if (!options.recording.window.empty())
        words.insert(words.end(), {"--window", options.recording.window});
    words.insert(words.end(), options.words.begin(), options.words.end());
    options.report.command = shell_command(words);
    options.report.progress = [&](const std::string& what) { progress.at(what); };
    try {
        const auto summary = write_report(recording, folder.temporary(), options.report);
        folder.commit();
        print_summary(options, summary);
    } catch (const Error& error) {
        rethrow_with_final_names(error, options, folder.temporary());
    }
    return Done;
}

}  // namespace

Command add_inspect(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "inspect",
        "A recording as a page: passes, planes, counters, estimated time, pixel histories");
    const auto options = std::make_shared<InspectOptions>();
    add_options(*command, *options);
    command->footer(
        "Example:\n  build/release/bin/gw record scenes/rings.toml -o rings.gwt --size 320x240 && "
        "build/release/bin/gw inspect rings.gwt -o rings_report");
    return {command, [options](Session& session) { return inspect_recording(*options, session); }};
}

}  // namespace gw::apps
