// Forwards to a machine and takes digests of all planes after every pass. Does not execute anything
// itself.
#pragma once

#include "inspect/replay/forwarding_machine.h"

namespace gw::inspect {

class DigestingMachine : public ForwardingMachine {
public:
    using ForwardingMachine::ForwardingMachine;

    void execute(const CommandList& list) override {
        CommandList digesting;
        // What comes before the first BeginPass is counted in a pass named "", which can ask for
        // digests too.
        if (passes().empty() && opens_unnamed_pass(list)) digesting.add(BeginPass{});
        digesting.append(list);
        for (Command& command : digesting.commands)
            if (auto* pass = std::get_if<BeginPass>(&command)) pass->digests = all_planes;
        ForwardingMachine::execute(digesting);
    }

private:
    static bool opens_unnamed_pass(const CommandList& list) {
        for (const Command& command : list.commands)
            if (!std::holds_alternative<SetState>(command))
                return !std::holds_alternative<BeginPass>(command);
        return false;
    }
};

}  // namespace gw::inspect
