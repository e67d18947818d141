// Long work without the interpreter's lock, which Ctrl-C ends. Does not start threads for work that
// cannot be cancelled.
#pragma once

#include "python/binding/casters.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <future>

namespace gw::python {

namespace py = pybind11;

/// Throws KeyboardInterrupt if Ctrl-C was pressed. Takes the interpreter's lock.
inline void check_signals() {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// Runs `work` without the lock. Ctrl-C is seen when it ends.
template <class Work>
decltype(auto) without_lock(const Work& work) {
    const py::gil_scoped_release release;
    return work();
}

/// Runs `work` without the lock, in another thread; `work` looks at `cancel`. After Ctrl-C it is
/// cancelled, and KeyboardInterrupt thrown.
template <class Work>
auto cancelable(std::atomic<bool>& cancel, const Work& work) {
    const py::gil_scoped_release release;
    cancel = false;
    auto result = std::async(std::launch::async, work);
    while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
        try {
            check_signals();
        } catch (...) {
            cancel = true;
            result.wait();
            throw;
        }
    }
    return result.get();
}

}  // namespace gw::python
