// A machine that executes long lists in slices and looks between them whether to stop. The bits,
// counters and digests are those of the whole list.
#pragma once

#include "inspect/replay/forwarding_machine.h"

#include <functional>
#include <memory>

namespace gw::python {

/// Throws what ends the work; may do nothing.
using Stop = std::function<void()>;

class SlicedMachine : public inspect::ForwardingMachine {
public:
    SlicedMachine(std::unique_ptr<Machine> machine, bool reference, int width, int height);

    /// Looks before the list and between its slices. The commands before a stop are done.
    Stop stop;
    /// All that was executed is kept there; null: nowhere.
    std::vector<CommandList>* kept = nullptr;

    void execute(const CommandList& list) override;

private:
    /// About how long a command takes, in pixels.
    double cost(const Command& command) const;
    std::size_t end_of_slice(const CommandList& list, std::size_t first) const;
    void execute_whole(const CommandList& list);
    void execute_slice(const CommandList& list, std::size_t first, std::size_t end);

    std::unique_ptr<Machine> machine_;
    int width_, height_;
    double most_;          ///< cost of a slice
    ListContext context_;  ///< of the next list
};

}  // namespace gw::python
