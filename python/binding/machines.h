// A machine as Python holds it: it can keep what it executed, as a recording.
#pragma once

#include "gw/machine.h"
#include "inspect/recording/recording.h"
#include "inspect/replay/forwarding_machine.h"
#include "python/binding/casters.h"

#include <mutex>
#include <string>

namespace gw::python {

namespace py = pybind11;

class MachineHolder {
public:
    /// `threads` of the fast machine; 0: all.
    MachineHolder(const Profile& profile, int width, int height, bool reference, int threads,
                  bool record);

    /// Without the interpreter's lock. Ctrl-C ends it between two commands on the reference machine,
    /// after the list on the fast one.
    void execute(const CommandList& list);
    /// The same for a renderer, which runs without the lock and looks for Ctrl-C between lists.
    void execute_whole(const CommandList& list);

    Machine& machine() { return *machine_; }
    int width() const { return width_; }
    int height() const { return height_; }
    bool is_reference() const { return reference_; }
    /// Throws Error if it was not asked to record.
    inspect::Recording recording() const;
    std::mutex& mutex() { return mutex_; }

private:
    void execute_one_by_one(const CommandList& list);

    std::unique_ptr<Machine> machine_;
    std::vector<CommandList> lists_;
    ListContext context_;  ///< of the reference machine's next list
    int width_, height_;
    bool reference_, record_;
    std::mutex mutex_;
};

/// A held machine for renderers: Ctrl-C ends them before the next list.
class RendererMachine : public inspect::ForwardingMachine {
public:
    explicit RendererMachine(MachineHolder& held)
        : ForwardingMachine(held.machine()), held_(held) {}
    void execute(const CommandList& list) override { held_.execute_whole(list); }

private:
    MachineHolder& held_;
};

/// A row for each pass: {"pass": name, counter: count, ..., "digests": {plane: digest}}.
py::list pass_rows(const std::vector<PassReport>& passes);
/// The plane as an array, a view of the owner's memory; None if there is no such plane.
py::object plane_view(const Planes& planes, Plane plane, py::handle owner);

}  // namespace gw::python
