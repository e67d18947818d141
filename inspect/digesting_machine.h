// A machine that takes digests of all planes after every pass and otherwise is the one it is made of.
// Does not execute anything itself.
#pragma once

#include "gw/machine.h"

namespace gw::inspect {

class DigestingMachine : public Machine {
public:
    /// Refers to `machine`, which must outlive it.
    explicit DigestingMachine(Machine& machine) : machine_(machine) {}

    void execute(const CommandList& list) override {
        CommandList digesting;
        // What comes before the first BeginPass is counted in a pass named "", which can ask for digests too.
        if (machine_.passes().empty() && opens_unnamed_pass(list)) digesting.add(BeginPass{});
        digesting.append(list);
        for (Command& command : digesting.commands)
            if (auto* pass = std::get_if<BeginPass>(&command)) pass->digests = all_planes;
        machine_.execute(digesting);
    }
    const Planes& planes() override { return machine_.planes(); }
    const std::vector<PassReport>& passes() override { return machine_.passes(); }
    void reset_passes() override { machine_.reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks(); }
    const Profile& profile() const override { return machine_.profile(); }

private:
    static bool opens_unnamed_pass(const CommandList& list) {
        for (const Command& command : list.commands)
            if (!std::holds_alternative<SetState>(command))
                return !std::holds_alternative<BeginPass>(command);
        return false;
    }

    Machine& machine_;
};

}  // namespace gw::inspect
