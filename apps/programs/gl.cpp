// gw gl: runs a program that draws with OpenGL or IRIS GL on the machine.
#include "apps/command/command.h"
#include "apps/command/option_values.h"
#include "apps/command/terminal.h"
#include "apps/programs/program.h"
#include "apps/programs/results.h"
#include "gw/error.h"
#include "gw/profile_text.h"
#include "image/output/output_set.h"
#include "image/write.h"
#include "scene/toml/read_profile.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdlib>

namespace gw::apps {
namespace {

namespace fs = std::filesystem;

struct GlOptions {
    std::vector<std::string> program;
    std::string profile, machine, frames;
    int threads = 0;
    fs::path recording, picture;
    bool statistics = false, environment = false;
};

void add_machine(CLI::App& command, GlOptions& options) {
    command
        .add_option("--profile", options.profile,
                    "vgx, reality, ideal, opengl (default), or a TOML file")
        ->type_name("NAME|FILE");
    command
        .add_option_function<std::string>(
            "--threads",
            [&](const std::string& word) {
                options.threads = whole_number_from("--threads", word, 1, 256);
            },
            "Threads of the machine (default: all)")
        ->type_name("N");
    command
        .add_option_function<std::string>(
            "--machine",
            [&](const std::string& word) {
                options.machine = one_of("--machine", word, {"fast", "reference"});
            },
            "The machine: fast (default) or reference")
        ->type_name("NAME");
}

void add_options(CLI::App& command, GlOptions& options) {
    command
        .add_option("PROGRAM", options.program,
                    "The program and its arguments; -- before it, so that its options are its own")
        ->type_name("WORD...");
    add_machine(command, options);
    command.add_option("--record", options.recording, "Everything that is drawn, as a recording")
        ->type_name("FILE.gwt");
    command
        .add_option_function<std::string>(
            "--frames",
            [&](const std::string& word) {
                const auto [first, last] = range_from("--frames", word, 0, 999'999'999);
                options.frames = fmt::format("{}-{}", first, last);
            },
            "Record, count and show only these frames of each window, from 0; the program is ended "
            "when a window has shown frame B")
        ->type_name("A-B");
    command
        .add_option("--screenshot", options.picture, "The last frame that was shown, as a picture")
        ->type_name("IMAGE");
    command.add_flag(
        "--stats", options.statistics,
        "On stderr: frames a second, here and estimated on a VGX; draws, fragments and "
        "barriers of a frame");
    command.add_flag("--env", options.environment,
                     "Run nothing; print the variables as a shell sets them, for every program "
                     "that it starts from then on");
}

Profile profile_of(const std::string& word, Session& session) {
    if (fs::path(word).extension() == ".toml") {
        session.inputs.add(word);
        return scene::read_profile(word);
    }
    std::vector<std::string> names;
    for (const Profile& profile : profiles()) names.push_back(profile.name);
    return profile_named(one_of("--profile", word, names));
}

/// LD_LIBRARY_PATH with our libraries first.
std::string library_path() {
    const char* const others = std::getenv("LD_LIBRARY_PATH");
    const std::string ours =
        folder_beside({"lib/opengl", GW_INSTALLED_OPENGL}, "libGL.so.1").string();
    return others != nullptr && *others != '\0' ? ours + ":" + others : ours;
}

using Variables = std::vector<std::pair<std::string, std::string>>;

Variables variables_of(const GlOptions& options, Session& session) {
    Variables all{{"LD_LIBRARY_PATH", library_path()}};
    if (!options.profile.empty())
        all.emplace_back("GW_PROFILE", profile_text(profile_of(options.profile, session)));
    if (options.threads != 0) all.emplace_back("GW_THREADS", std::to_string(options.threads));
    if (!options.machine.empty()) all.emplace_back("GW_MACHINE", options.machine);
    if (!options.frames.empty()) all.emplace_back("GW_FRAMES", options.frames);
    return all;
}

/// Prints how fast the program draws, once a second, on one line of a terminal.
class Rate {
public:
    explicit Rate(fs::path file) : file_(std::move(file)) {}
    ~Rate() {
        if (shown_) clear_error_line();
    }
    Rate(const Rate&) = delete;
    Rate& operator=(const Rate&) = delete;

    void show() {
        const std::uint64_t frames = frames_in(bytes_of_file(file_));
        clear_error_line();
        print_error(fmt::format("gw: {} frames, {} in the last second", frames,
                                frames - std::min(before_, frames)));
        before_ = frames;
        shown_ = true;
    }

private:
    fs::path file_;
    std::uint64_t before_ = 0;
    bool shown_ = false;
};

/// The output that was asked for and is missing; "" if none is.
std::string missing(const GlOptions& options, const image::OutputFile* recording,
                    const fs::path& statistics, const fs::path& picture) {
    std::error_code ignored;
    if (recording != nullptr && !recording->temporary().empty() &&
        fs::file_size(recording->temporary(), ignored) == 0)
        return "recording";
    if (!options.picture.empty() && !fs::exists(picture)) return "screenshot";
    if (options.statistics && bytes_of_file(statistics).empty()) return "statistics";
    return "";
}

/// Word as a shell reads it.
std::string for_shell(const std::string& word) {
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

int print_environment(const GlOptions& options, Session& session) {
    if (!options.program.empty() || !options.recording.empty() || !options.picture.empty() ||
        options.statistics)
        throw UsageError(
            "--env takes no program, --record, --screenshot or --stats; expected GW_RECORD, "
            "GW_SCREENSHOT or GW_STATS in the shell");
    for (const auto& [name, value] : variables_of(options, session))
        print(fmt::format("export {}={}\n", name, for_shell(value)));
    return Done;
}

int run_gl(const GlOptions& options, Session& session) {
    if (options.environment) return print_environment(options, session);
    if (options.program.empty()) throw UsageError("PROGRAM is required");
    if (!options.picture.empty()) check_picture_target(options.picture);
    Variables variables = variables_of(options, session);
    const ScratchFolder folder;
    const fs::path statistics = folder.path() / "statistics", picture = folder.path() / "shown.ppm";
    image::OutputSet output(session.inputs);
    image::OutputFile* recording = nullptr;
    if (!options.recording.empty()) {
        recording = &output.add(options.recording);
        const fs::path& file =
            recording->temporary().empty() ? recording->real_target() : recording->temporary();
        variables.emplace_back("GW_RECORD", fs::absolute(file).string());
    }
    image::OutputFile* screenshot =
        options.picture.empty() ? nullptr : &output.add(options.picture);
    if (screenshot != nullptr) variables.emplace_back("GW_SCREENSHOT", picture.string());
    if (options.statistics) variables.emplace_back("GW_STATS", statistics.string());

    int code = Done;
    {
        Rate rate(statistics);
        const bool live = options.statistics && error_is_terminal();
        code = run_program(options.program, variables, [&] {
            if (live) rate.show();
        });
    }
    const std::string lacking = missing(options, recording, statistics, picture);
    if (!lacking.empty()) {
        print_error(fmt::format("gw: {}: showed no frame on the machine: no {}\n",
                                as_one_line(options.program.front()), lacking));
        return code != Done ? code : Failed;
    }
    if (options.statistics) print_error("gw: " + bytes_of_file(statistics));
    if (screenshot != nullptr) put_picture(*screenshot, picture_of_ppm(bytes_of_file(picture)));
    output.commit();
    return code;
}

}  // namespace

Command add_gl(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "gl", "Runs a program that draws with OpenGL 1.5 or IRIS GL on the machine");
    const auto options = std::make_shared<GlOptions>();
    add_options(*command, *options);
    command->footer(
        "Exit code: the program's; 128 + n if signal n ended it; 1 or 2 with a line of gw's.\n"
        "Example:\n"
        "  build/release/bin/gw gl --frames 10-12 --record gears.gwt --screenshot gears.png -- "
        "xvfb-run -a glxgears");
    return {command, [options](Session& session) { return run_gl(*options, session); }};
}

}  // namespace gw::apps
