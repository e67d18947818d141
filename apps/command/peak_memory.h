// The peak memory of a process.
#pragma once

#include <sys/resource.h>

#include <cstddef>

namespace gw {

/// In bytes: the largest resident set, programs and libraries included.
inline std::size_t peak_memory(const rusage& usage) {
#ifdef __APPLE__
    return std::size_t(usage.ru_maxrss);
#else
    return std::size_t(usage.ru_maxrss) * 1024;
#endif
}
inline std::size_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return peak_memory(usage);
}

}  // namespace gw
