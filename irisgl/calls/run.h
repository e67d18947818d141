// What each entry point does: keeps its call in the open object, or carries it out.
#pragma once

#include "gl/drawable/call_trace.h"
#include "irisgl/calls/values.h"
#include "irisgl/state/objects.h"
#include "irisgl/state/program.h"

#include <cstdio>
#include <exception>
#include <type_traits>
#include <utility>

namespace gw::irisgl {

/// "gw: color: no window is open; expected winopen before it", once for each function.
void report_no_window(const char* function);
/// "gw: feedback is not offered: ...", once for each function. Returns 0.
long left_out(const char* function, const char* reason);

/// A call of the program, while it is carried out: recordings name it for all that is drawn meanwhile.
class CallScope {
public:
    /// Both never die; `source` is the place in the program.
    CallScope(const char* function, const void* source) {
        if (gl::calls_are_kept) [[unlikely]]
            begin(function, source);
    }
    ~CallScope() {
        if (began_) [[unlikely]]
            end();
    }
    CallScope(const CallScope&) = delete;
    CallScope& operator=(const CallScope&) = delete;

private:
    void begin(const char* function, const void* source);
    void end();

    bool began_ = false;
    gl::CallPlace place_;
};

/// The calls of an object, while it is called.
class ObjectScope {
public:
    explicit ObjectScope(Object name);
    ~ObjectScope();
    ObjectScope(const ObjectScope&) = delete;
    ObjectScope& operator=(const ObjectScope&) = delete;
    /// The object's call `number`, until the next one.
    void at(std::size_t number, const char* function);

private:
    const gl::CallPlace* outer_;
    gl::CallPlace place_;
};

template <class Call>
auto run_free(const char* function, Call&& call) -> std::invoke_result_t<Call> {
    using Result = std::invoke_result_t<Call>;
    try {
        return call();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gw: %s: %s\n", function, error.what());
        return Result();
    }
}

template <class Call>
auto run_now(const char* function, Call&& call) -> std::invoke_result_t<Call> {
    using Result = std::invoke_result_t<Call>;
    if (program().current == nullptr) {
        report_no_window(function);
        return Result();
    }
    return run_free(function, std::forward<Call>(call));
}

template <class Call>
void run_kept(const char* function, Call call) {
    if (OpenObject& open = program().objects.open; open.is_open())
        open.add({function, [function, kept = std::move(call)] { run_now(function, kept); }});
    else
        run_now(function, call);
}

}  // namespace gw::irisgl
