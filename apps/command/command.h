// The command line: its words, its subcommands and their exit codes. Each subcommand has a file of
// its own: info.cpp, render.cpp, ... Does not know what a subcommand does.
#pragma once

#include "image/output/output_set.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

// CLI11's own header takes a compiler seconds.
namespace CLI {
class App;
}

namespace gw::apps {

class CommandRecorder;

enum ExitCode { Done = 0, Failed = 1, Usage = 2, Differs = 3 };

/// The command line is wrong, independent of any file: exit code 2. Readers and writers throw
/// gw::Error, exit code 1.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// One run of the command line, as its subcommand gets it.
struct Session {
    /// The words after "gw": "maps", "a.gwt", "-o", "dir".
    std::vector<std::string> words;
    /// Records every list that a machine executes; null: no recording.
    CommandRecorder* recorder = nullptr;
    /// Files read so far: no output may replace them.
    image::InputFiles inputs;
    /// Another command runs this one, as gw figures does, and describes the output itself.
    bool is_inner = false;
};

/// A subcommand: parsing fills in its options, then `run` acts on them and returns an ExitCode.
struct Command {
    CLI::App* app = nullptr;
    std::function<int(Session&)> run;
};

Command add_render(CLI::App& app);
Command add_join(CLI::App& app);
Command add_passes(CLI::App& app);
Command add_record(CLI::App& app);
Command add_replay(CLI::App& app);
Command add_verify(CLI::App& app);
Command add_diff(CLI::App& app);
Command add_pixel(CLI::App& app);
Command add_maps(CLI::App& app);
Command add_inspect(CLI::App& app);
Command add_hidden(CLI::App& app);
Command add_play(CLI::App& app);
Command add_quiz(CLI::App& app);
Command add_grade(CLI::App& app);
Command add_autograde(CLI::App& app);
Command add_fragments(CLI::App& app);
Command add_styles(CLI::App& app);
Command add_cast(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_figures(CLI::App& app);
Command add_study(CLI::App& app);
Command add_golden(CLI::App& app);
Command add_conformance(CLI::App& app);
Command add_gl(CLI::App& app);
Command add_irisgl_config(CLI::App& app);
Command add_radiosity(CLI::App& app);
Command add_info(CLI::App& app);
Command add_describe(CLI::App& app);
#ifdef GW_WITH_WINDOW
Command add_view(CLI::App& app);
#endif

/// Parses and runs the session's words. Returns an ExitCode; throws UsageError, Error or another
/// std::exception.
int run_command(Session session);

/// The whole program: parses, runs, prints every error as one line "gw: ..." on stderr.
int run(const std::vector<std::string>& arguments);

/// The number of this version of gw.
std::string version();
/// The commit that was built, "-dirty" behind it if files differed; "unknown" outside a checkout.
std::string commit();

/// The words after "gw" as a line for a shell at the repository's root, quoted where a shell would
/// change them: "build/release/bin/gw render 'my scene.toml'".
std::string shell_command(const std::vector<std::string>& words);

}  // namespace gw::apps
