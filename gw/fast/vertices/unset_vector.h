// A vector whose new elements have no value until somebody writes one: of lists that are written as
// a whole. Does not know what they hold.
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace gw::fast {

template <class T>
struct UnsetAllocator : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>);
    template <class U>
    struct rebind {
        using other = UnsetAllocator<U>;
    };
    template <class U>
    void construct(U*) noexcept {}
    template <class U, class... Args>
    void construct(U* at, Args&&... args) {
        ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
    }
};

template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace gw::fast
