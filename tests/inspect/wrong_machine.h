// A machine with a fault of our choice: it does something to every list before it executes it.
#pragma once

#include "inspect/compare/compare_machines.h"

namespace gw::inspect {

using Fault = std::function<void(Command&)>;

class WrongMachine : public Machine {
public:
    WrongMachine(std::unique_ptr<Machine> machine, Fault fault)
        : machine_(std::move(machine)), fault_(std::move(fault)) {}
    void execute(const CommandList& list) override {
        CommandList wrong = list;
        for (Command& command : wrong.commands) fault_(command);
        machine_->execute(wrong);
    }
    const Planes& planes() override { return machine_->planes(); }
    const std::vector<PassReport>& passes() override { return machine_->passes(); }
    void reset_passes() override { machine_->reset_passes(); }
    const std::map<std::uint32_t, Readback>& readbacks() override { return machine_->readbacks(); }
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        machine_->read_into(key, values, layout);
    }
    const Profile& profile() const override { return machine_->profile(); }

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
