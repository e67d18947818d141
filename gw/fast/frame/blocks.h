// The blocks of a plane, of zeros at first. Pages that nobody touches take no memory: a surface has
// planes that it never uses. Does not know what a block is.
#pragma once

#include "gw/base/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace gw::fast {

template <typename Block>
class Blocks {
    static_assert(std::is_trivially_copyable_v<Block>);

public:
    /// Makes so many, all 0. There were none.
    void resize(std::size_t count) {
        const std::size_t bytes = count * sizeof(Block);
        const bool is_large = bytes >= least_large;
        const std::size_t alignment = is_large ? large_page : alignof(Block);
        memory_.reset(std::calloc(bytes + alignment, 1));
        if (!memory_) throw std::bad_alloc();
        const auto address = reinterpret_cast<std::uintptr_t>(memory_.get());
        const std::size_t past = address % alignment;
        first_ = reinterpret_cast<Block*>(static_cast<std::byte*>(memory_.get()) +
                                          (past == 0 ? 0 : alignment - past));
        size_ = count;
        if (is_large) use_large_pages(first_, bytes - bytes % large_page);
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    Block& operator[](std::size_t i) { return first_[i]; }
    const Block& operator[](std::size_t i) const { return first_[i]; }

private:
    /// Smaller planes have few faults, and would keep much more memory than they touch.
    static constexpr std::size_t least_large = 16 * large_page;

    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };
    std::unique_ptr<void, Free> memory_;
    Block* first_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace gw::fast
