// Work that its caller may end early: a caller opens a CancelScope, and long loops ask. Does not end
// anything by itself.
#pragma once

#include <atomic>
#include <utility>

namespace gw {

/// Thrown by work that was asked to end. What it was making is not complete.
struct Canceled {};

/// Set by the caller; null: nobody asks.
using CancelFlag = const std::atomic<bool>*;

namespace detail {
inline thread_local CancelFlag cancel_flag = nullptr;
}

/// The flag of this thread's work, for the threads that it starts.
inline CancelFlag cancel_flag() { return detail::cancel_flag; }

/// Throws Canceled if asked to end.
inline void end_if_canceled(CancelFlag cancel = cancel_flag()) {
    if (cancel != nullptr && cancel->load(std::memory_order_relaxed)) throw Canceled{};
}

/// While it lives, the work of this thread ends when `cancel` says so.
class CancelScope {
public:
    explicit CancelScope(CancelFlag cancel) : before_(std::exchange(detail::cancel_flag, cancel)) {}
    ~CancelScope() { detail::cancel_flag = before_; }
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;

private:
    CancelFlag before_;
};

}  // namespace gw
