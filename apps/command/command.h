// What the files of the subcommands and main have in common. One file per subcommand: info.cpp,
// render.cpp, ... Does not know what any of them does.
#pragma once

#include "apps/command/cli_fwd.h"
#include "apps/command/session.h"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace gw::apps {

enum ExitCode { Done = 0, Failed = 1, Usage = 2, Differs = 3 };

/// The command line is wrong, whatever the files hold: exit code 2. Readers and writers throw
/// gw::Error: 1.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A subcommand: its options, which parsing fills in, and what to do then; `run` returns an
/// ExitCode.
struct Command {
    CLI::App* app = nullptr;
    std::function<int(Session&)> run;
};

Command add_render(CLI::App& app);
Command add_passes(CLI::App& app);
Command add_record(CLI::App& app);
Command add_replay(CLI::App& app);
Command add_verify(CLI::App& app);
Command add_diff(CLI::App& app);
Command add_pixel(CLI::App& app);
Command add_maps(CLI::App& app);
Command add_inspect(CLI::App& app);
Command add_hidden(CLI::App& app);
Command add_styles(CLI::App& app);
Command add_cast(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_figures(CLI::App& app);
Command add_study(CLI::App& app);
Command add_golden(CLI::App& app);
Command add_conformance(CLI::App& app);
Command add_radiosity(CLI::App& app);
Command add_info(CLI::App& app);
Command add_describe(CLI::App& app);

/// Parses and runs the session's words, and returns an ExitCode. Throws UsageError, Error and what
/// else goes wrong.
int run_command(Session session);

/// The whole program: parses, runs, prints every error as one line "gw: ..." on stderr.
int run(const std::vector<std::string>& arguments);

}  // namespace gw::apps
