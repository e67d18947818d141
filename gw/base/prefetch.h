// Asks the processor for memory that is read soon. Changes no result. g++ 12 takes a function that
// only prefetches for one without effect and leaves its calls out, hence always_inline.
#pragma once

#include <algorithm>
#include <cstddef>

namespace gw {

inline constexpr std::size_t cache_line = 64;

[[gnu::always_inline]] inline void prefetch(const void* first, std::size_t bytes) {
    const char* const p = static_cast<const char*>(first);
    for (std::size_t i = 0; i < bytes; i += cache_line) __builtin_prefetch(p + i);
}

/// The first elements of a vector.
template <class Vector>
[[gnu::always_inline]] inline void prefetch_elements(const Vector& v) {
    constexpr std::size_t most_bytes = 128;
    if (!v.empty()) prefetch(v.data(), std::min(most_bytes, v.size() * sizeof(v[0])));
}

/// The element that a loop over `all` reaches a few steps after i.
template <class Span>
[[gnu::always_inline]] inline void prefetch_ahead(const Span& all, std::size_t i, std::size_t steps,
                                                  std::size_t bytes) {
    if (i + steps < all.size()) prefetch(&all[i + steps], bytes);
}

}  // namespace gw
