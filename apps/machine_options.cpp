#include "apps/machine_options.h"

#include "apps/words.h"

namespace gw::apps {

void add_machine_options(CLI::App& command, MachineOptions& options) {
    command
        .add_option_function<std::string>(
            "--machine",
            [&](const std::string& word) {
                options.machine = one_of("--machine", word, {"fast", "reference", "both"});
            },
            "Which machine replays it (default fast); both: compared after each pass, code 3 where they "
            "differ")
        ->type_name("NAME");
    command
        .add_option_function<std::string>(
            "--threads",
            [&](const std::string& word) { options.threads = whole_number_from("--threads", word, 1, 1024); },
            "Threads of the fast machine (default: all)")
        ->type_name("N");
    command.add_flag("--quiet", options.quiet, "No progress");
}

}  // namespace gw::apps
