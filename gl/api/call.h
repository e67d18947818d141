// From an entry point to the call that carries it out: the current context, its open display list
// and the rule of Begin and End are asked here, once for all functions.
#pragma once

#include "generated/gl/functions.h"
#include "gl/api/kind.h"
#include "gl/context/context.h"
#include "gl/context/current.h"

#include <type_traits>
#include <utility>

namespace gw::gl {

namespace detail {

template <Kind kind, auto execute, class Signature>
struct Caller;
template <Kind kind, auto execute, class Result, class... Values>
struct Caller<kind, execute, Result (*)(Context&, Values...)> {
    template <class... Arguments>
    static Result call(Function function, Arguments&&... arguments) {
        return run(function, static_cast<std::decay_t<Values>>(arguments)...);
    }

private:
    static Result run(Function function, const std::decay_t<Values>&... values) {
        Context* const context = current;
        if (context == nullptr) return Result();
        Context& c = *context;
        if constexpr (is_listed(kind)) {
            if (c.lists.open) [[unlikely]] {
                c.lists.open->template add<execute>(function, values...);
                if (c.lists.mode == GL_COMPILE) return Result();
            }
        }
        if constexpr (!may_stand_inside(kind)) {
            if (c.assembler.inside) [[unlikely]] {
                set_error(c, GL_INVALID_OPERATION);
                return Result();
            }
        }
        return guarded(c, [&] { return execute(c, values...); });
    }
};

}  // namespace detail

/// Carries out one call of an entry point.
template <Kind kind, auto execute, class... Arguments>
auto call(Function function, Arguments&&... arguments) {
    return detail::Caller<kind, execute, decltype(execute)>::call(
        function, std::forward<Arguments>(arguments)...);
}

}  // namespace gw::gl
