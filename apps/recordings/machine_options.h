// The options of commands that replay recordings: the machine and its threads. Does not replay.
#pragma once

#include "apps/command/command.h"
#include "inspect/compare/compare_machines.h"

#include <string>

namespace gw::apps {

struct MachineOptions {
    std::string machine = "fast";  ///< or "reference", or "both"
    int threads = 0;               ///< of the fast machine; 0: all
    bool quiet = false;

    bool both() const { return machine == "both"; }
    /// Makes the wanted machine; for "both" the fast one.
    inspect::MachineMaker make() const {
        return inspect::maker_of(both() ? "fast" : machine, threads);
    }
    /// Makes the other machine.
    inspect::MachineMaker make_other() const {
        return inspect::maker_of(machine == "reference" ? "fast" : "reference", threads);
    }
};

/// Adds --threads, 1..1024; 0 if it is not given.
void add_threads_option(CLI::App& command, int& threads,
                        const char* about = "Threads of the fast machine (default: all)");

/// Adds --machine, --threads, --quiet.
void add_machine_options(CLI::App& command, MachineOptions& options);

}  // namespace gw::apps
