// Forwards every call to another machine; subclasses override one. Does not execute anything.
#pragma once

#include "gw/machine.h"

namespace gw::inspect {

class ForwardingMachine : public Machine {
public:
    /// Refers to `machine`, which must outlive it.
    explicit ForwardingMachine(Machine& machine) : machine_(machine) {}

    void execute(const CommandList& list) override { machine_.execute(list); }
    const Planes& planes() override { return machine_.planes(); }
    const std::vector<PassReport>& passes() override { return machine_.passes(); }
    void reset_passes() override { machine_.reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_.readbacks(); }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values) override {
        machine_.read_into(key, values);
    }
    const Profile& profile() const override { return machine_.profile(); }

private:
    Machine& machine_;
};

}  // namespace gw::inspect
