// What a library finds when its program ends.
#pragma once

namespace gw::gl {

/// Windows ends a program's other threads before its libraries end: they may be in the middle of
/// anything, and nobody can wait for them. Elsewhere they still run.
#ifdef _WIN32
inline constexpr bool other_threads_are_gone = true;
#else
inline constexpr bool other_threads_are_gone = false;
#endif

}  // namespace gw::gl
