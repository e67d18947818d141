// gw autograde: a class's own hidden-surface algorithms, in any language, run, drawn and graded.
#include "apps/command/command.h"
#include "apps/command/early_end.h"
#include "apps/command/folder_index.h"
#include "apps/command/table.h"
#include "apps/command/terminal.h"
#include "apps/grading/grade_submission.h"
#include "apps/hidden/options.h"
#include "apps/programs/results.h"
#include "gw/base/parallel.h"
#include "gw/error.h"
#include "gw/escape_controls.h"
#include "hiddensurface/faces/flat_colors.h"
#include "hiddensurface/run/play.h"
#include "image/write.h"
#include "inspect/recording/content.h"
#include "scene/draw/view.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;
namespace hs = hiddensurface;

struct AutogradeOptions {
    fs::path submissions, output;
    std::vector<fs::path> scenes, tools;
    Size size{320, 240};
    int seconds = 10, memory = 1024, disk = 64, processes = 64, points = 10, jobs = 0;
    Isolation isolation = Isolation::Namespaces;
    std::string command, language = "en";
    bool single = false, resume = false, quiet = false;
    Form form = Form::Text;
};

/// Adds an option that takes a whole number.
void add_number(CLI::App& command, const std::string& name, int& value, int least, int most,
                const std::string& about) {
    command
        .add_option_function<std::string>(
            name,
            [&value, name, least, most](const std::string& word) {
                value = whole_number_from(name, word, least, most);
            },
            fmt::format("{}, {}..{} (default {})", about, least, most, value))
        ->type_name("N");
}

void add_limits(CLI::App& command, AutogradeOptions& options) {
    add_number(command, "--time", options.seconds, 1, 3600,
               "Seconds that a program may compute on a scene; by the clock four times as many");
    add_number(command, "--memory", options.memory, 16, 65536, "Megabytes that it may use");
    add_number(command, "--disk", options.disk, 1, 4096, "Megabytes of its files");
    add_number(command, "--processes", options.processes, 1, 4096, "Its processes and threads");
    command
        .add_option_function<std::string>(
            "--isolation",
            [&](const std::string& word) {
                options.isolation =
                    one_of("--isolation", word, {"namespaces", "limits"}) == "limits"
                        ? Isolation::Limits
                        : Isolation::Namespaces;
            },
            "namespaces (default): bubblewrap, with no network and no file but its own; limits: as "
            "another user, for a container of one submission")
        ->type_name("NAME");
    command
        .add_option("--tools", options.tools,
                    "A folder that programs may read, with bin/ in it: a compiler of your own")
        ->type_name("DIR");
}

void add_options(CLI::App& command, AutogradeOptions& options) {
    command
        .add_option("SUBMISSIONS", options.submissions,
                    "A folder with a folder or a program file for each student")
        ->required()
        ->type_name("DIR");
    command.add_option("--scene", options.scenes, "A scene; several are graded one by one")
        ->required()
        ->type_name("SCENE");
    command.add_option("-o,--output", options.output, "The folder of the marks")
        ->required()
        ->type_name("DIR");
    command
        .add_option_function<std::string>(
            "--size", [&](const std::string& word) { options.size = size_from("--size", word); },
            "Pixels, both sides 1..4096 (default 320x240)")
        ->type_name("WxH");
    command
        .add_option(
            "--run", options.command,
            "How every submission is run, instead of by its file's name: a shell's command; "
            "$1 is the file of the polygons")
        ->type_name("COMMAND");
    command
        .add_option_function<std::string>(
            "--language",
            [&](const std::string& word) {
                options.language = one_of("--language", word, {"en", "ja"});
            },
            "Of the feedback and of the class's page, en or ja (default en)")
        ->type_name("NAME");
    command.add_flag("--single", options.single,
                     "SUBMISSIONS is one submission, and its results.json is in DIR");
    add_number(command, "--points", options.points, 1, 1000, "Points of a scene");
    add_number(command, "--jobs", options.jobs, 0, 256,
               "Submissions at a time; 0: as many as cores");
    command.add_flag("--resume", options.resume,
                     "Keep the marks in DIR of submissions that have not changed");
    add_limits(command, options);
    command.add_flag("--quiet", options.quiet, "No progress, no warnings");
    add_form_options(command, options.form, true);
}

/// The polygons as a program gets them; what they are decides the marks.
std::string polygons_of(const fs::path& scene_file, const AutogradeOptions& options,
                        Session& session) {
    PictureOptions picture = polygon_options();
    picture.scene = scene_file;
    picture.size = options.size;
    picture.quiet = options.quiet;
    const Profile profile = load_profile(picture, session);
    const scene::Scene scene = load_scene(picture, session);
    const scene::View view = scene::make_view(scene, options.size.width, options.size.height);
    const hs::Input input = hs::make_input(scene, view, profile);
    return hs::polygons_json(input, hs::hex_colors(input));
}

std::string digest_of_text(const std::string& text) {
    return to_string(inspect::digest_of_bytes(
        {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

std::vector<GradingTask> tasks_of(const AutogradeOptions& options, const fs::path& scratch,
                                  Session& session, std::string& about) {
    std::vector<GradingTask> tasks;
    std::set<std::string> names;
    for (const fs::path& scene : options.scenes) {
        const std::string name = scene.stem();
        if (!names.insert(name).second)
            throw UsageError("--scene '" + scene.string() + "'; expected another name than " +
                             name);
        const std::string polygons = polygons_of(scene, options, session);
        const fs::path file = scratch / fmt::format("polygons_{}.json", tasks.size());
        image::write_file(file, polygons);
        fs::permissions(file, fs::perms(0644));
        tasks.push_back({name, fs::absolute(scene), file});
        about += name + polygons;
    }
    return tasks;
}

Grading grading_of(const AutogradeOptions& options, const fs::path& scratch, Session& session) {
    constexpr std::size_t megabyte = std::size_t{1} << 20;
    Grading grading;
    std::string about = fmt::format("{} {} {} {} {} {} {} {} {}", version(), options.seconds,
                                    options.memory, options.disk, options.processes, options.points,
                                    int(options.isolation), options.language, options.command);
    grading.tasks = tasks_of(options, scratch, session, about);
    grading.allowance = {options.isolation,
                         options.seconds,
                         megabyte * std::size_t(options.memory),
                         megabyte * std::size_t(options.disk),
                         options.processes,
                         {}};
    for (const fs::path& folder : options.tools)
        grading.allowance.tools.push_back(fs::absolute(folder));
    grading.size = fmt::format("{}x{}", options.size.width, options.size.height);
    grading.command = options.command;
    grading.points = options.points;
    grading.language = options.language;
    grading.about = digest_of_text(about);
    grading.scratch = scratch;
    return grading;
}

/// The class while it is graded. Its files are complete after every submission.
class Class {
public:
    Class(const AutogradeOptions& options, const Grading& grading,
          const std::vector<Submission>& submissions)
        : options_(options) {
        for (const GradingTask& task : grading.tasks) scenes_.push_back(task.name);
        for (const Submission& submission : submissions)
            all_.push_back({submission.name, "", {}, ""});
    }

    fs::path folder_of(std::size_t i) const {
        return options_.single ? options_.output
                               : options_.output / folder_of_student(all_[i].name);
    }
    void make_folders() const {
        make_folder(options_.output);
        if (options_.single) return;
        make_folder(options_.output / "students");
        for (std::size_t i = 0; i < all_.size(); ++i) make_folder(folder_of(i));
    }
    void add(std::size_t i, GradedSubmission graded, Progress& progress, Interruption& end) {
        const std::lock_guard lock(mutex_);
        all_[i] = std::move(graded);
        done_ += 1;
        write();
        const std::string state = fmt::format("{} of {} submissions graded", done_, all_.size());
        progress.at(state);
        end.say(fmt::format("\ngw: {}; --resume goes on\n", state));
    }
    std::vector<std::vector<std::string>> rows() const { return grade_rows(all_, scenes_); }
    std::string json() const {
        nlohmann::ordered_json json = nlohmann::ordered_json::object();
        for (const GradedSubmission& graded : all_)
            json[graded.name] = nlohmann::ordered_json::parse(results_json(graded));
        return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    }
    /// What the student of one submission reads; of several, a table.
    std::string text() const {
        if (!options_.single) return table(rows());
        std::string text;
        for (const GradedScene& scene : all_[0].scenes)
            text += fmt::format("{}: {}, {} of {}\n{}", scene.scene, scene.outcome, scene.points,
                                scene.of, scene.feedback) +
                    (scene.feedback.ends_with('\n') ? "\n" : "\n\n");
        return without_controls(text);
    }
    /// It is not the students' fault.
    void warn_of_lacking_programs() const {
        std::map<std::string, std::string> names;
        for (const GradedSubmission& graded : all_)
            if (!graded.lacks.empty()) names[graded.lacks] += " " + graded.name;
        for (const auto& [program, students] : names)
            print_warning(
                fmt::format("{}: no such program, so these were not run:{}; expected it "
                            "installed, or a folder by --tools; then --resume runs them",
                            program, escape_controls(students, "")));
    }
    bool is_all_right() const {
        return std::ranges::all_of(
            all_, [](const GradedSubmission& graded) { return graded.points() == graded.of(); });
    }

private:
    void write() const {
        if (options_.single) return;
        image::OutputSet output;
        output.add(options_.output / "grades.csv").write_text(grades_csv(rows()));
        output.add(options_.output / "junit.xml").write_text(junit_xml(all_));
        output.add(options_.output / "index.html")
            .write_text(class_page(all_, scenes_, options_.language));
        output.commit();
    }

    const AutogradeOptions& options_;
    std::vector<std::string> scenes_;
    std::vector<GradedSubmission> all_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

int autograde(const AutogradeOptions& options, Session& session) {
    const ScratchFolder scratch;
    fs::permissions(scratch.path(), fs::perms(0711));
    Progress progress("reading", options.quiet);
    const Grading grading = grading_of(options, scratch.path(), session);
    const std::vector<Submission> submissions =
        options.single ? std::vector<Submission>{{"submission", options.submissions}}
                       : submissions_in(options.submissions);
    check_isolation(grading.allowance);
    Class all(options, grading, submissions);
    all.make_folders();
    {
        Interruption end;
        const int jobs = options.jobs == 0 ? hardware_threads() : options.jobs;
        parallel_for(submissions.size(), jobs, [&](std::size_t i, int slot) {
            all.add(
                i,
                grade_submission(grading, submissions[i], all.folder_of(i), options.resume, slot),
                progress, end);
        });
    }
    all.warn_of_lacking_programs();
    print(options.form == Form::Json  ? all.json()
          : options.form == Form::Csv ? grades_csv(all.rows())
                                      : all.text());
    return all.is_all_right() ? Done : Differs;
}

}  // namespace

Command add_autograde(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "autograde", "Runs and grades a class's hidden-surface algorithms, in any language");
    const auto options = std::make_shared<AutogradeOptions>();
    add_options(*command, *options);
    command->footer(
        "Exit code 3 unless all are right.\n"
        "Example:\n"
        "  build/release/bin/gw autograde examples/autograder/class --scene "
        "scenes/hidden/cycle.toml -o grades --time 2 || test $? = 3");
    return {command, [options](Session& session) { return autograde(*options, session); }};
}

}  // namespace gw::apps
