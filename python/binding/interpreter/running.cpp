#include "python/binding/interpreter/running.h"

#include "gw/error.h"

#include <thread>

namespace gw::python {
namespace {

std::atomic<bool> ending = false;
std::thread::id last_thread;  ///< set before `ending`: the thread that ends the interpreter
std::atomic<int> unlocked = 0;

bool ends_for_this_thread() { return ending && std::this_thread::get_id() != last_thread; }

/// Called by Python's atexit.
void end_unlocked() {
    last_thread = std::this_thread::get_id();
    ending = true;
    const py::gil_scoped_release release;
    while (unlocked > 0) std::this_thread::sleep_for(between_looks);
}

}  // namespace

void check_signals() {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (ends_for_this_thread()) throw Error("the interpreter ends");
}

Unlocked::Count::Count() {
    if (ends_for_this_thread()) throw Error("the interpreter ends");
    ++unlocked;
}

Unlocked::Count::~Count() { --unlocked; }

void end_work_with_interpreter() {
    py::module_::import("atexit").attr("register")(py::cpp_function(&end_unlocked));
}

}  // namespace gw::python
