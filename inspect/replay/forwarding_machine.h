// Machines that forward every call to another one, and three that override a call: to take digests,
// and to record. They execute nothing themselves.
#pragma once

#include "gw/machine.h"
#include "inspect/recording/stream.h"

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
    void read_into(std::uint32_t key, std::span<std::uint32_t> values, ReadLayout layout) override {
        machine_.read_into(key, values, layout);
    }
    const Profile& profile() const override { return machine_.profile(); }

private:
    Machine& machine_;
};

/// Takes digests of all planes after every pass.
class DigestingMachine : public ForwardingMachine {
public:
    using ForwardingMachine::ForwardingMachine;

    void execute(const CommandList& list) override {
        CommandList digesting;
        // Commands before the first BeginPass are counted in a pass named "", which can ask for
        // digests too.
        if (passes().empty() && opens_unnamed_pass(list)) digesting.add(BeginPass{});
        digesting.append(list);
        for (Command& command : digesting.commands)
            if (auto* pass = std::get_if<BeginPass>(&command)) pass->digests = planes_of(profile());
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

/// Keeps every list that the machine executes. Results that a host computes from read-backs come
/// back in lists, so the lists are the machine's whole input.
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

/// Writes every list that the machine executes to a window of a stream.
class StreamRecorder : public ForwardingMachine {
public:
    /// Refers to both, which must outlive it. The machine is new, and so is the window, of its size.
    StreamRecorder(Machine& machine, StreamWriter& writer, std::string window)
        : ForwardingMachine(machine), writer_(writer), window_(std::move(window)) {}

    void execute(const CommandList& list) override {
        ForwardingMachine::execute(list);
        writer_.add(window_, list);
    }

private:
    StreamWriter& writer_;
    std::string window_;
};

}  // namespace gw::inspect
