// What a command executes on its machines, kept: a command runs for its recordings. Does not write
// files.
#pragma once

#include "inspect/recording/recording.h"

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace gw {
class Machine;
}

namespace gw::apps {

/// While one lives, all that is executed on machines that `taped` returns is kept. One at a time;
/// the machines may be used by one thread each.
class Tape {
public:
    Tape();
    ~Tape();
    Tape(const Tape&) = delete;
    Tape& operator=(const Tape&) = delete;

    /// Of every machine, in the order in which they were made; those that executed nothing are left
    /// out.
    /// `scene` and `renderer` are names for the recordings. Gives them away: the tape is empty
    /// afterwards.
    std::vector<inspect::Recording> take(const std::string& scene, const std::string& renderer);
};

/// Where a Tape lives: the recordings' parameter sets, by the passes' names.
void note_parameter_sets(const std::function<std::map<std::string, std::string>()>& sets);

/// The machine as it is, where no Tape lives; else one that keeps what it executes.
std::unique_ptr<Machine> taped(std::unique_ptr<Machine> machine, int width, int height);

}  // namespace gw::apps
