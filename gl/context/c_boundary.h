// Stops exceptions at the C boundary.
#pragma once

#include <cstdio>
#include <exception>

namespace gw::gl {

/// Carries out a call of the program's; an exception becomes one line on stderr and the result 0.
template <class Call>
auto at_c_boundary(Call call) -> decltype(call()) {
    try {
        return call();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gw: %s\n", error.what());
        return decltype(call())();
    }
}

}  // namespace gw::gl
