// A table that every thread may use until the process is gone, other threads' exit handlers included.
#pragma once

#include <utility>

namespace gw {

/// The value, never destroyed. For static variables of functions.
template <class T>
const T& leaked_static(T value) {
    return *new const T(std::move(value));
}

}  // namespace gw
