// A variable of each thread that a program's exit handlers may still use, after the thread's other
// variables are gone.
#pragma once

#include "gl/context/current.h"

#include <memory>
#include <utility>

namespace gw::gl {

/// The calling thread's. When the thread ends, no context is current and `leave` is called; later
/// calls get an empty one.
template <class Binding>
Binding& thread_binding() {
    static constinit thread_local Binding* binding = nullptr;
    struct End {
        ~End() {
            const std::unique_ptr<Binding> ended(std::exchange(binding, nullptr));
            if (!ended || !ended->context) return;
            current = nullptr;
            ended->leave();
        }
    };
    thread_local End end;
    if (binding == nullptr) binding = new Binding;
    return *binding;
}

}  // namespace gw::gl
