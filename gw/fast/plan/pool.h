// Objects whose memory the next segment reuses. Does not know their contents.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>

namespace gw::fast {

/// T has clear() and bytes(). Elements keep their addresses until the next release().
template <class T>
class Pool {
public:
    T& next() {
        if (used_ == all_.size()) all_.emplace_back();
        return all_[used_++];
    }
    /// Takes all elements back. Keeps their memory, but no more than 16 MB beyond four times what
    /// was in use.
    void release() {
        std::size_t in_use = 0;
        for (std::size_t i = 0; i < used_; ++i) {
            in_use += all_[i].bytes() + sizeof(T);
            all_[i].clear();
        }
        kept_ = std::max(kept_, in_use);
        if (kept_ > 4 * in_use + spare_bytes || all_.size() > 4 * used_ + spare_elements) {
            all_.clear();
            kept_ = 0;
        }
        used_ = 0;
    }

private:
    static constexpr std::size_t spare_bytes = std::size_t{16} << 20, spare_elements = 4096;

    std::deque<T> all_;
    std::size_t used_ = 0, kept_ = 0;  ///< kept_: bytes of all elements, at least
};

}  // namespace gw::fast
