#include "tests/gl/peer/trace.h"

#include <fmt/format.h>

#include <type_traits>

namespace gw::gl_peer {

namespace {

Gl carried_out;

/// Vectors by their first four numbers, enumerations and flags as hexadecimal numbers.
template <class T>
std::string shown(T value) {
    if constexpr (std::is_pointer_v<T>) {
        using Number = std::remove_const_t<std::remove_pointer_t<T>>;
        if constexpr (std::is_floating_point_v<Number>)
            if (value != nullptr)
                return fmt::format("[{} {} {} {}]", value[0], value[1], value[2], value[3]);
        return "memory";
    } else if constexpr (std::is_same_v<T, GLenum>) {
        return fmt::format("{:#x}", value);
    } else {
        return fmt::format("{}", value);
    }
}

template <auto member, class Function>
struct Traced;
template <auto member, class Result, class... Values>
struct Traced<member, Result (*)(Values...)> {
    static inline const char* name = "";
    static Result call(Values... values) {
        fmt::print("  {}(", name);
        (fmt::print("{} ", shown(values)), ...);
        fmt::print(")\n");
        return (carried_out.*member)(values...);
    }
};

template <auto member, class Function>
void trace(Function& function, const char* name) {
    Traced<member, Function>::name = name;
    function = &Traced<member, Function>::call;
}

}  // namespace

Gl traced(const Gl& gl) {
    carried_out = gl;
    Gl out = gl;
#define GW_GL_FUNCTION(name) trace<&Gl::name>(out.name, #name);
#include "generated/gl/names.inc"
#undef GW_GL_FUNCTION
    return out;
}

}  // namespace gw::gl_peer
