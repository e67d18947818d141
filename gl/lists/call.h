// Leads from an entry point to its call. Asks for the current context, its open display list and
// the rule of Begin and End, once for all functions.
#pragma once

#include "generated/gl/functions.h"
#include "gl/api/calls.h"
#include "gl/api/convert.h"
#include "gl/api/kind.h"
#include "gl/context/context.h"
#include "gl/context/current.h"
#include "gl/drawable/call_trace.h"
#include "gl/lists/display_list.h"

#include <tuple>
#include <type_traits>
#include <utility>

namespace gw::gl {

namespace detail {

template <auto execute>
inline constexpr bool may_be_for_proxy = false;
template <>
inline constexpr bool may_be_for_proxy<execute::tex_image_1d> = true;
template <>
inline constexpr bool may_be_for_proxy<execute::tex_image_2d> = true;
template <>
inline constexpr bool may_be_for_proxy<execute::tex_image_3d> = true;

/// [GL11] 5.4: the images of proxies are set at once, while a list is open too.
template <auto execute, class... Values>
bool is_for_proxy(const Values&... values) {
    if constexpr (may_be_for_proxy<execute>)
        return is_proxy_target(std::get<0>(std::forward_as_tuple(values...)));
    return false;
}

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
        Context* const bound = bound_context();
        if (bound == nullptr) return Result();
        Context& context = *bound;
        if constexpr (is_listed(kind)) {
            if (context.lists.open && !is_for_proxy<execute>(values...)) [[unlikely]] {
                guarded(context, [&] {
                    context.lists.open->template add<kind, execute>(function, values...);
                });
                if (context.lists.mode == GL_COMPILE) return Result();
            }
        }
        if constexpr (!may_stand_inside(kind)) {
            if (context.assembler.inside) [[unlikely]] {
                set_error(context, GL_INVALID_OPERATION);
                return Result();
            }
        }
        return guarded(context, [&] { return execute(context, values...); });
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
