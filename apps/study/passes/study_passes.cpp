#include "apps/study/passes/study_passes.h"

#include "apps/command/early_end.h"
#include "apps/command/folder_index.h"
#include "apps/command/option_values.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/recordings/recording_files.h"
#include "apps/study/passes/plots.h"
#include "gw/error.h"
#include "inspect/recording/content.h"
#include "render/options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>

namespace gw::apps {
namespace {

struct SweepPlan {
    const render::Sweep* sweep = nullptr;
    std::vector<int> values;
    bool asked = false;  ///< by its name
};

std::vector<std::string> sweep_words() {
    std::vector<std::string> names;
    for (const render::Sweep& sweep : render::sweeps()) names.push_back(sweep.name);
    return names;
}

/// "lights" or "lights=1,4,16"
SweepPlan plan_from(const std::string& words) {
    const std::size_t equals = words.find('=');
    const std::string name = one_of("--sweep", words.substr(0, equals), sweep_words());
    const render::Sweep& sweep = render::sweep_named(name);
    if (equals == words.npos) return {&sweep, sweep.values, true};
    SweepPlan plan{&sweep, {}, true};
    for (std::size_t from = equals + 1;;) {
        const std::size_t comma = std::min(words.find(',', from), words.size());
        plan.values.push_back(whole_number_from("--sweep " + name, words.substr(from, comma - from),
                                                sweep.low, sweep.high));
        if (comma == words.size()) break;
        from = comma + 1;
    }
    std::ranges::sort(plan.values);
    plan.values.erase(std::unique(plan.values.begin(), plan.values.end()), plan.values.end());
    return plan;
}

std::vector<SweepPlan> plans_of(const PassStudyOptions& options) {
    std::vector<SweepPlan> plans;
    for (const std::string& words : options.sweeps) {
        SweepPlan plan = plan_from(words);
        if (std::ranges::find(plans, plan.sweep, &SweepPlan::sweep) != plans.end())
            throw UsageError("--sweep '" + plan.sweep->name +
                             "': given twice; expected each once, as in lights=1,4,16");
        plans.push_back(std::move(plan));
    }
    if (plans.empty())
        for (const render::Sweep& sweep : render::sweeps())
            plans.push_back({&sweep, sweep.values, false});
    return plans;
}

std::vector<report::PriceList> lists_of(const std::filesystem::path& folder, Session& session) {
    if (folder.empty()) return report::built_in_prices();
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    if (error || files.empty())
        throw Error(folder.string() + ": no price lists; expected a folder of TOML files");
    std::ranges::sort(files);
    std::vector<report::PriceList> lists;
    for (const auto& file : files) {
        session.inputs.add(file);
        lists.push_back(report::read_prices(file));
        report::extremes(lists.back());  // refuses lists with too many limits before long work
    }
    return lists;
}

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Measures row by row and writes what is finished.
class Runner {
public:
    Runner(const PassStudyOptions& options, const Drawing& drawing, study::PassStudy& study,
           Session& session)
        : options_(options), drawing_(drawing), study_(study), session_(session) {}

    void run(const SweepPlan& plan) {
        const render::Sweep& sweep = *plan.sweep;
        if (const std::string why = sweep.refusal(drawing_); !why.empty()) {
            study_.omissions.push_back({sweep.name, why});
            return;
        }
        std::vector<double> seconds;
        double last_x = -1;
        for (const int value : plan.values) {
            const double next = next_seconds(seconds);
            if (next > options_.limit) {
                study_.omissions.push_back(
                    {sweep.name, fmt::format("ended before {}, which would take about {:.0f} s; "
                                             "the limit is {:g} s",
                                             value, next, options_.limit)});
                return;
            }
            const double start = now();
            try {
                render::StudyRow row =
                    render::measured(sweep, value, drawing_, options_.runs,
                                     [&](const std::string& what) { progress_.at(what); });
                // An object that no more fits leaves the share as it was.
                if (row.x != last_x) study_.add(std::move(row));
                last_x = study_.rows.back().x;
            } catch (const render::OptionError& error) {
                study_.omissions.push_back({sweep.name, error.what()});
                return;
            }
            seconds.push_back(now() - start);
            interruption_.say(fmt::format("gw: interrupted; finished rows are in {}\n",
                                          options_.output.string()));
            write();
        }
    }

private:
    /// From the ratio of the last two rows.
    static double next_seconds(const std::vector<double>& s) {
        if (s.size() < 2) return 0;
        return s.back() * std::clamp(s.back() / s[s.size() - 2], 1.0, 8.0);
    }

    void write() {
        image::OutputSet output(session_.inputs);
        output.make_folder(options_.output);
        const auto put = [&](const std::string& name, const std::string& text) {
            output.add(options_.output / name).write_text(text);
        };
        put("counts.csv", study::counts_csv(study_));
        put("estimates.csv", study::estimates_csv(study_));
        put("times.csv", study::times_csv(study_));
        put("errors.csv", study::errors_csv(study_));
        put("results.json", study::results_json(study_));
        put("index.html", study::page(study_));
        for (const std::string& name : study_.sweep_names())
            for (const study::StudyPlot& plot : study::plots(study_, name))
                put(plot.name + ".svg", plot::svg(plot.plot));
        put_index(output, options_.output, session_);
        output.commit();
    }

    const PassStudyOptions& options_;
    const Drawing& drawing_;
    study::PassStudy& study_;
    Session& session_;
    Progress progress_{"measuring", options_.picture.quiet};
    Interruption interruption_;
};

void print_study(const study::PassStudy& study) {
    for (const std::string& name : study.sweep_names()) {
        print("By " + render::sweep_named(name).label + ":\n" +
              table(study::table_of(study, name)));
        for (const std::string& line : study::crossings(study, name)) print(line + "\n");
        print("\n");
    }
    for (const study::Omission& o : study.omissions) print(o.sweep + ": " + o.why + "\n");
}

}  // namespace

void add_pass_study_options(CLI::App& command, PassStudyOptions& options) {
    command
        .add_option("--sweep", options.sweeps,
                    "passes: lights, samples, share, polygons, resolution or depth, with values as "
                    "in lights=1,4,16; several times for several (default: all)")
        ->allow_extra_args(false)
        ->type_name("NAME[=N,...]");
    command
        .add_option_function<std::string>(
            "--runs",
            [&options](const std::string& word) {
                options.runs = whole_number_from("--runs", word, 0, 1000);
            },
            "passes: timed runs of each method, in turn (default 3); 0: counts alone")
        ->type_name("N");
    for (const render::Option& option : render::options())
        if (option.name == "size" || option.name == "depth" || option.name == "profile")
            command
                .add_option_function<std::string>(
                    "--" + option.name,
                    [&](const std::string& word) {
                        try {
                            option.set(options.picture, word);
                        } catch (const render::OptionError& error) {
                            throw UsageError(std::string("--") + error.what());
                        }
                    },
                    "passes: " + option.about)
                ->type_name(option.type);
}

int study_passes(const PassStudyOptions& options, Session& session) {
    const std::vector<SweepPlan> plans = plans_of(options);
    study::PassStudy study;
    study.lists = lists_of(options.prices, session);
    const Drawing drawing = make_drawing(options.picture, session);
    for (const SweepPlan& plan : plans)
        if (const std::string why = plan.sweep->refusal(drawing); plan.asked && !why.empty())
            throw Error(options.picture.scene.string() + ": " + why + "; expected no --sweep " +
                        plan.sweep->name);
    study.scene = options.picture.scene.filename().string();
    study.scene_hash = to_string(inspect::scene_content(record(drawing, session, "")));
    study.profile = drawing.profile.name;
    study.command = shell_command(session.words);
    study.runs = options.runs;
    study.color_bits = drawing.profile.color_bits;
    {
        Runner runner(options, drawing, study, session);
        runner.run({&render::no_sweep(), render::no_sweep().values, false});
        for (const SweepPlan& plan : plans) runner.run(plan);
    }
    print_study(study);
    return Done;
}

}  // namespace gw::apps
