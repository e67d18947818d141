// A machine as Python holds it: it can keep what it executed, as a recording.
#pragma once

#include "inspect/recording/recording.h"
#include "inspect/replay/forwarding_machine.h"
#include "python/binding/casters.h"
#include "python/binding/interpreter/running.h"
#include "python/binding/slices.h"

#include <mutex>
#include <string>

namespace gw::python {

namespace py = pybind11;

class MachineHolder {
public:
    /// `threads` of the fast machine; 0: all.
    MachineHolder(const Profile& profile, int width, int height, bool reference, int threads,
                  bool record);

    /// Without the interpreter's lock. Ctrl-C ends it between two slices of the list.
    void execute(const CommandList& list);
    /// The same for a renderer, which runs beside the thread that looks for Ctrl-C.
    void execute_beside(const CommandList& list);

    /// use(machine) without the interpreter's lock, while no other thread uses it.
    template <class Use>
    decltype(auto) in_turn(const Use& use) {
        return python::in_turn(mutex_, [&]() -> decltype(auto) { return use(machine_); });
    }
    /// For a thread that has it to itself, or asks for what never changes.
    Machine& machine() { return machine_; }
    int width() const { return width_; }
    int height() const { return height_; }
    bool is_reference() const { return reference_; }
    /// Throws Error if it was not asked to record.
    inspect::Recording recording();
    /// Later lists change the planes' memory under the holder of the result.
    std::shared_ptr<void> watch_planes();

private:
    void execute(const CommandList& list, Stop stop);

    SlicedMachine machine_;
    std::vector<CommandList> lists_;
    int width_, height_;
    bool reference_, record_;
    std::shared_ptr<int> watched_ = std::make_shared<int>();  ///< shared with those who watch
    std::mutex mutex_;
};

/// A held machine for renderers, which end when they are cancelled.
class RendererMachine : public inspect::ForwardingMachine {
public:
    explicit RendererMachine(MachineHolder& held)
        : ForwardingMachine(held.machine()), held_(held) {}
    void execute(const CommandList& list) override { held_.execute_beside(list); }

private:
    MachineHolder& held_;
};

/// A row for each pass: {"pass": name, counter: count, ..., "digests": {plane: digest}}.
py::list pass_rows(const std::vector<PassReport>& passes);
/// The plane as an array, a view of the owner's memory; None if there is no such plane.
py::object plane_view(const Planes& planes, Plane plane, py::handle owner);

}  // namespace gw::python
