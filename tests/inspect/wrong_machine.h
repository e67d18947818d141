// A machine with a fault of our choice: it does something to every list before it executes it.
#pragma once

#include "inspect/compare/compare_machines.h"
#include "inspect/replay/forwarding_machine.h"

namespace gw::inspect {

using Fault = std::function<void(Command&)>;

class WrongMachine : public ForwardingMachine {
public:
    WrongMachine(std::unique_ptr<Machine> machine, Fault fault)
        : ForwardingMachine(*machine), machine_(std::move(machine)), fault_(std::move(fault)) {}
    void execute(const CommandList& list) override {
        CommandList wrong = list;
        for (Command& command : wrong.commands) fault_(command);
        ForwardingMachine::execute(wrong);
    }

private:
    std::unique_ptr<Machine> machine_;
    Fault fault_;
};

/// The reference machine with a fault.
inline MachineMaker wrong(const Fault& fault) {
    return [fault](const Recording& r) {
        return std::make_unique<WrongMachine>(make_reference(r.profile, r.width, r.height), fault);
    };
}

}  // namespace gw::inspect
