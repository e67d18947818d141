// A machine that takes digests of all planes after every pass and otherwise is the one it is made of.
// Does not execute anything itself.
#pragma once

#include "gw/machine.h"

namespace gw::apps {

class DigestingMachine : public Machine {
public:
    /// Refers to `machine`, which must outlive it.
    explicit DigestingMachine(Machine& machine) : machine_(machine) {}

    void execute(const CommandList& list) override;
    const Planes& planes() override { return machine_.planes(); }
    const std::vector<PassReport>& passes() override { return machine_.passes(); }
    void reset_passes() override { machine_.reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks(); }
    const Profile& profile() const override { return machine_.profile(); }

private:
    Machine& machine_;
};

}  // namespace gw::apps
