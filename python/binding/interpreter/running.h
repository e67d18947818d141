// Runs long work without the interpreter's lock; Ctrl-C ends it. Python's threads that share an
// object take turns. Does not start threads for short work.
#pragma once

#include "gw/base/cancel.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <memory>
#include <mutex>

namespace gw::python {

namespace py = pybind11;

/// How soon Ctrl-C is seen.
inline constexpr std::chrono::milliseconds between_looks{50};

/// Throws KeyboardInterrupt if Ctrl-C was pressed, Error in a daemon thread when the interpreter
/// ends. Takes the interpreter's lock.
void check_signals();

/// While it lives, this thread does not have the interpreter's lock. The interpreter's end waits for
/// it: a thread that asks for the lock later would end the process. From then on, other threads than
/// the one that ends it get an Error.
class Unlocked {
public:
    Unlocked() = default;

private:
    struct Count {
        Count();
        ~Count();
        Count(const Count&) = delete;
    };
    Count count_;
    py::gil_scoped_release release_;  // ends first
};

/// Called once, when the module is made.
void end_work_with_interpreter();

/// Runs `work` without the lock. Ctrl-C is seen when it ends.
template <class Work>
decltype(auto) without_lock(const Work& work) {
    const Unlocked unlocked;
    return work();
}

/// Runs `work` without the lock while no other thread uses `in_turn`.
template <class Work>
decltype(auto) in_turn(std::mutex& turn, const Work& work) {
    const Unlocked unlocked;
    const std::lock_guard lock(turn);
    return work();
}

/// Runs `work` in another thread, while this one looks for Ctrl-C; without the interpreter's lock.
/// After Ctrl-C `work` is cancelled, and KeyboardInterrupt thrown.
template <class Work>
auto watched_for_signals(std::atomic<bool>& cancel, const Work& work) {
    cancel = false;
    auto result = std::async(std::launch::async, [&] {
        const CancelScope scope(&cancel);
        return work();
    });
    while (result.wait_for(between_looks) != std::future_status::ready) {
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

/// The same with a flag of its own.
template <class Work>
auto cancelable(const Work& work) {
    const Unlocked unlocked;
    std::atomic<bool> cancel = false;
    return watched_for_signals(cancel, work);
}

/// The same while no other thread uses `turn`; `cancel` belongs to it.
template <class Work>
auto cancelable(std::mutex& turn, std::atomic<bool>& cancel, const Work& work) {
    const Unlocked unlocked;
    const std::lock_guard lock(turn);
    return watched_for_signals(cancel, work);
}

}  // namespace gw::python
