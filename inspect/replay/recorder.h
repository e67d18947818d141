// Forwards to a machine and keeps every list that it executes. Whatever a host computes from
// read-backs comes back in lists, so the lists are all that entered the machine.
#pragma once

#include "inspect/replay/forwarding_machine.h"

namespace gw::inspect {

class Recorder : public ForwardingMachine {
public:
    /// Refers to both, which must outlive it. The machine is new: nothing executed before is in the
    /// lists.
    Recorder(Machine& machine, std::vector<CommandList>& lists)
        : ForwardingMachine(machine), lists_(lists) {}

    void execute(const CommandList& list) override {
        ForwardingMachine::execute(list);
        lists_.push_back(list);
    }

private:
    std::vector<CommandList>& lists_;
};

}  // namespace gw::inspect
