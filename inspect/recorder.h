// A machine that keeps every list that it is given and otherwise is the one it is made of. Whatever a host
// computes from read-backs comes back in lists, so that these are all that entered the machine.
#pragma once

#include "gw/machine.h"

namespace gw::inspect {

class Recorder : public Machine {
public:
    /// Refers to `machine`, which must outlive it and be new: nothing executed before is in the recording.
    explicit Recorder(Machine& machine) : machine_(machine) {}

    const std::vector<CommandList>& lists() const { return lists_; }

    void execute(const CommandList& list) override {
        machine_.execute(list);
        lists_.push_back(list);
    }
    const Planes& planes() override { return machine_.planes(); }
    const std::vector<PassReport>& passes() override { return machine_.passes(); }
    void reset_passes() override { machine_.reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks(); }
    const Profile& profile() const override { return machine_.profile(); }

private:
    Machine& machine_;
    std::vector<CommandList> lists_;
};

}  // namespace gw::inspect
