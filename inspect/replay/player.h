// Executing a recording on a machine, whole or step by step. Commands are counted through all of
// its lists, from 0. Does not compare.
#pragma once

#include "gw/machine.h"
#include "inspect/recording/recording.h"

#include <functional>
#include <memory>

namespace gw::inspect {

/// Makes a new machine for a recording, of its profile and size.
using MachineMaker = std::function<std::unique_ptr<Machine>(const Recording&)>;

/// Commands first .. end - 1 are counted in one pass. The pass is that of the same place in
/// Machine::passes().
struct PassRange {
    std::string name;
    std::size_t first = 0, end = 0;
};

/// The passes of a recording, in order. Commands before the first BeginPass are in a pass named "",
/// if there is more among them than SetState.
std::vector<PassRange> pass_ranges(const Recording& recording);

std::size_t command_count(const Recording& recording);
/// Command `index` < command_count.
const Command& command_at(const Recording& recording, std::size_t index);

class Player {
public:
    /// Refers to both, which must outlive it. The machine is new, of the recording's profile and
    /// size.
    Player(const Recording& recording, Machine& machine)
        : recording_(recording), machine_(machine) {}

    /// Executes the commands up to and without command `end`. A list of which only a part is
    /// executed is validated whole before, so that a refusal names the command's number in it.
    void play_to(std::size_t end);
    /// Executes the remaining commands.
    void play();

private:
    const Recording& recording_;
    Machine& machine_;
    ListContext context_;  ///< of lists[list_], or of the next list while one is in execution
    std::size_t list_ = 0, command_ = 0;  ///< the next one: of lists[list_]
    std::size_t done_ = 0;
};

/// Executes all passes on a new machine of this recording and calls `after(pass)` at the end of
/// each.
void play_by_pass(const Recording& recording, Machine& machine,
                  const std::function<void(std::size_t)>& after);

}  // namespace gw::inspect
