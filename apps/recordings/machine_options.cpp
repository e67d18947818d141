#include "apps/recordings/machine_options.h"

#include "apps/command/option_values.h"

#include <CLI/CLI.hpp>

namespace gw::apps {

void add_threads_option(CLI::App& command, int& threads, const char* about) {
    command
        .add_option_function<std::string>(
            "--threads",
            [&threads](const std::string& word) {
                threads = whole_number_from("--threads", word, 1, 1024);
            },
            about)
        ->type_name("N");
}

void add_machine_options(CLI::App& command, MachineOptions& options) {
    command
        .add_option_function<std::string>(
            "--machine",
            [&](const std::string& word) {
                options.machine = one_of("--machine", word, {"fast", "reference", "both"});
            },
            "The machine that replays it (default fast); both: compared after each pass, exit code 3 "
            "if they differ")
        ->type_name("NAME");
    add_threads_option(command, options.threads);
    command.add_flag("--quiet", options.quiet, "No progress");
}

}  // namespace gw::apps
