// std::bit_cast for the C++ library of Debian's Emscripten, which is older than its compiler.
// Included before every file if the library lacks it (tests/exactness/cross/CMakeLists.txt).
// Does nothing if the library has it.
#pragma once

#include <version>

#ifndef __cpp_lib_bit_cast
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

}  // namespace std
#endif
